#include "symmetry/search/map_score.h"

#include "base/vector_math.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr float floor = 2e-3F; // sampling noise: no map is better than this
/** Displacement from which on a landmark is moved. Of 0.03 to 0.3, an open fit with each set left out in turn: see "By the
 * geometric mean" in doc/decisions/what-moves-little.md. */
constexpr float enough = 0.2F;

/** Mean |d (i, j) - d (m (i), m (j))| over the first \a queries landmarks j, share of the diameter. */
float
distanceChange(const LandmarkSurface& landmarks, const SampleMap& map, std::size_t i, std::size_t queries)
{
  float sum = 0.0F;
  const float* from = landmarks.distances.col(static_cast<Eigen::Index>(i)).data();
  const float* to = landmarks.distances.col(map[i]).data();
  for (std::size_t j = 0; j < queries; ++j) {
    sum += std::abs(from[j] - to[map[j]]);
  }
  return sum / (static_cast<float>(queries) * landmarks.diameter);
}

/** Fills in the measures of isometry. */
void
measureIsometry(const LandmarkSurface& landmarks, const SampleMap& map, std::size_t queries, MapScore& score)
{
  constexpr float much = 0.08F; // share of the diameter: twice what poses change distances by; by hand
  double sum = 0.0;
  std::size_t distorted = 0;
  for (std::size_t i = 0; i < queries; ++i) {
    const float change = distanceChange(landmarks, map, i, queries);
    sum += change;
    distorted += change > much ? 1U : 0U;
  }
  score.isometry = static_cast<float>(sum / static_cast<double>(queries));
  score.distorted = static_cast<float>(distorted) / static_cast<float>(queries);
}

/** Area of the triangles that the map turns over, as a share of the area of all: an image counts by its own area, at
 * most by that of the original, so that the slivers that sampling noise turns over do not. */
float
reversedShare(const LandmarkSurface& landmarks, const SampleMap& map)
{
  double reversed = 0.0;
  double total = 0.0;
  const auto mapped = [&](Index v) {
    return static_cast<std::size_t>(v) < map.size() ? map[v] : no_index;
  };
  for (const Triangle& t : landmarks.triangles) {
    const Triangle image{mapped(t[0]), mapped(t[1]), mapped(t[2])};
    if (image[0] == no_index || image[1] == no_index || image[2] == no_index) {
      continue;
    }
    const Vector3& p = landmarks.points[t[0]];
    const float area = norm(cross(landmarks.points[t[1]] - p, landmarks.points[t[2]] - p));
    const Vector3& q = landmarks.points[image[0]];
    const Vector3 facing = cross(landmarks.points[image[1]] - q, landmarks.points[image[2]] - q);
    const Vector3 normal =
        normalized(landmarks.normals[image[0]] + landmarks.normals[image[1]] + landmarks.normals[image[2]]);
    reversed += std::clamp(-dot(facing, normal), -area, area);
    total += area;
  }
  return total > 0.0 ? static_cast<float>(0.5 + 0.5 * reversed / total) : 0.5F;
}

/** Mean squared difference of curvature between partners, in units of its variance over the surface. At a hole there is
 * no telling how the surface goes on. */
float
curvatureError(const LandmarkSurface& landmarks, const ShapeDescriptor& descriptor, const SampleMap& map)
{
  const std::vector<char> comparable = comparableLandmarks(landmarks, map);
  const float variance = descriptor.curvature.squaredNorm() / static_cast<float>(descriptor.curvature.rows());
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (comparable[i] == 0) {
      continue;
    }
    ++count;
    sum += (descriptor.curvature.row(static_cast<Eigen::Index>(i)) - descriptor.curvature.row(map[i])).squaredNorm();
  }
  return variance > 0.0F ? static_cast<float>(sum / static_cast<double>(count)) / variance : 0.0F;
}

/** All measures but the value. */
MapScore
measureMap(const LandmarkSurface& landmarks,
           const ShapeDescriptor& descriptor,
           const SampleMap& map,
           const SampleMap& inverse,
           std::size_t queries,
           float resolution)
{
  MapScore score;
  measureIsometry(landmarks, map, std::min(queries, map.size()), score);
  double involution = 0.0;
  double displacement = 0.0;
  double log_displacement = 0.0;
  constexpr float hardly = 0.06F; // share of the diameter: as far as landmarks are apart; by hand
  std::size_t fixed = 0;
  std::vector<float> ways;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const float moved = landmarks.distances(row, map[i]) / landmarks.diameter;
    displacement += moved;
    log_displacement += std::log(std::min(moved, enough) + resolution);
    ways.push_back(moved);
    fixed += moved < hardly ? 1U : 0U;
    if (static_cast<std::size_t>(map[i]) < map.size()) {
      involution += landmarks.distances(row, inverse[map[i]]) / landmarks.diameter;
    }
  }
  const auto count = static_cast<double>(map.size());
  score.involution = static_cast<float>(involution / count);
  score.displacement = static_cast<float>(displacement / count);
  score.log_displacement = static_cast<float>(log_displacement / count);
  score.fixed = static_cast<float>(static_cast<double>(fixed) / count);
  const auto nearest = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 50);
  std::nth_element(ways.begin(), nearest, ways.end());
  score.nearest_image = *nearest;
  score.reversal = reversedShare(landmarks, map);
  score.curvature = curvatureError(landmarks, descriptor, map);
  return score;
}

/** \param[in] oriented share of the area whose orientation comes out as it should */
float
valueOf(const MapScore& score, float oriented, const ScoreWeights& weights)
{
  constexpr float largest_fixed = 0.3F; // a reflection keeps only a curve
  return std::log(score.isometry + 0.5F * score.involution + floor) - weights.displacement * score.log_displacement +
         weights.reversal * (1.0F - oriented) + weights.fixed * std::max(0.0F, score.fixed - largest_fixed) +
         weights.curvature * score.curvature;
}

} // namespace

MapScore
scoreMap(const LandmarkSurface& landmarks,
         const ShapeDescriptor& descriptor,
         const SampleMap& map,
         std::size_t queries,
         const ScoreWeights& weights)
{
  MapScore score = measureMap(landmarks, descriptor, map, map, queries, weights.resolution);
  score.value =
      valueOf(score, score.reversal, weights) + weights.axis * std::max(0.0F, score.nearest_image - axis_reach);
  return score;
}

MapScore
scoreRotation(const LandmarkSurface& landmarks,
              const ShapeDescriptor& descriptor,
              const SampleMap& map,
              const SampleMap& inverse,
              const ScoreWeights& weights)
{
  MapScore score = measureMap(landmarks, descriptor, map, inverse, map.size(), weights.resolution);
  score.value = valueOf(score, 1.0F - score.reversal, weights);
  return score;
}

bool
isExchanged(const LandmarkSurface& landmarks, const SampleMap& map, Index landmark, float far)
{
  constexpr float near = 0.04F; // share of the diameter: a landmark beside it; by hand
  const Index image = map[landmark];
  return landmarks.distances(landmark, image) > far * landmarks.diameter &&
         landmarks.distances(landmark, map[image]) < near * landmarks.diameter;
}

float
mapDifference(const LandmarkSurface& landmarks, const SampleMap& a, const SampleMap& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += landmarks.distances(a[i], b[i]);
  }
  return static_cast<float>(sum / static_cast<double>(a.size())) / landmarks.diameter;
}

} // namespace symmetry
} // namespace pcl
