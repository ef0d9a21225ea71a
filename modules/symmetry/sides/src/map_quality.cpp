#include "symmetry/sides/map_quality.h"

#include "base/vector_math.h"
#include "geodesic/farthest_point_sampling.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/sides/side_settings.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr QualitySettings settings{};

bool
isNextTo(const SurfaceGraph& graph, Index v, Index other)
{
  const auto around = graph.neighboursOf(v);
  return std::find(around.begin(), around.end(), other) != around.end();
}

/** Whether a side of a face has another length in the image; sides of a coarse mesh are long, and their ends have images
 * at vertices only. */
bool
isTorn(const PreparedSurface& surface, const Triangle& face, const Triangle& image, float diameter)
{
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const float length = distance(surface.points[face[k]], surface.points[face[next]]);
    const float of_image = distance(surface.points[image[k]], surface.points[image[next]]);
    if (std::abs(of_image - length) > std::max(settings.torn_side * diameter, settings.torn_share * length)) {
      return true;
    }
  }
  return false;
}

/** Share of the matched points v with |v - m (m (v))| below 2 % of the diameter, or next to v: points of a coarse mesh are
 * farther apart. */
float
involutionShare(const PreparedSurface& surface, const std::vector<Index>& partners, float diameter, std::size_t matched)
{
  std::size_t close = 0;
  for (std::size_t v = 0; v < partners.size(); ++v) {
    const Index back = partners[v] == no_index ? no_index : partners[partners[v]];
    if (back != no_index &&
        (distance(surface.points[v], surface.points[back]) < settings.involution_tolerance * diameter ||
         isNextTo(surface.graph, static_cast<Index>(v), back))) {
      ++close;
    }
  }
  return matched == 0 ? 0.0F : static_cast<float>(close) / static_cast<float>(matched);
}

/** Shares of the faces that are torn apart, and of those not torn that keep facing the way a rotation would make them.
 */
void
measureFaces(const PreparedSurface& surface, const std::vector<Index>& partners, float diameter, MapSummary& summary)
{
  std::size_t torn = 0;
  std::size_t inverted = 0;
  std::size_t mapped = 0;
  // Pieces of a face that was split are torn less than the face.
  for (const Triangle& t : surface.unsplit.empty() ? surface.triangles : surface.unsplit) {
    const Triangle image{partners[t[0]], partners[t[1]], partners[t[2]]};
    if (image[0] == no_index || image[1] == no_index || image[2] == no_index) {
      continue;
    }
    ++mapped;
    const Vector3& a = surface.points[image[0]];
    const Vector3& b = surface.points[image[1]];
    const Vector3& c = surface.points[image[2]];
    if (isTorn(surface, t, image, diameter)) {
      ++torn;
    }
    else if (dot(cross(b - a, c - a), surface.normals[image[0]]) > 0.0F) {
      ++inverted; // a reflection turns every face over
    }
  }
  if (mapped > 0) {
    summary.torn_faces = static_cast<float>(torn) / static_cast<float>(mapped);
    summary.inverted_faces = static_cast<float>(inverted) / static_cast<float>(mapped);
  }
}

/** Mean |d (p, q) - d (m (p), m (q))| over pairs of a few landmarks, share of the diameter. */
float
isometryError(const PreparedSurface& surface, const std::vector<Index>& partners, float diameter)
{
  std::vector<Index> sources;
  std::vector<Index> images;
  for (const Index landmark : farthestPointSampling(surface.graph, 0, settings.landmarks).vertices) {
    if (partners[landmark] != no_index) {
      sources.push_back(landmark);
      images.push_back(partners[landmark]);
    }
  }
  const DistanceFields from = distanceFields(surface.graph, sources);
  const DistanceFields to = distanceFields(surface.graph, images);
  double sum = 0.0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    for (std::size_t j = 0; j < sources.size(); ++j) {
      sum += std::abs(from.row(i)[sources[j]] - to.row(i)[images[j]]);
    }
  }
  return sources.empty() ? 0.0F
                         : static_cast<float>(sum / static_cast<double>(sources.size() * sources.size()) / diameter);
}

} // namespace

MapSummary
measureMap(const PreparedSurface& surface, const std::vector<Index>& partners, float diameter)
{
  MapSummary summary;
  for (const Index partner : partners) {
    summary.matched += partner == no_index ? 0U : 1U;
  }
  if (summary.matched == 0) {
    return summary;
  }
  summary.involution = involutionShare(surface, partners, diameter, summary.matched);
  measureFaces(surface, partners, diameter, summary);
  summary.isometry_error = isometryError(surface, partners, diameter);
  return summary;
}

} // namespace symmetry
} // namespace pcl
