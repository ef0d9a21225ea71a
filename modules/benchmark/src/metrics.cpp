#include "benchmark/metrics.h"

#include "geodesic/shortest_paths.h"
#include "geodesic/surface_graph.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

namespace pcl {
namespace symmetry {
namespace {

/** Distance fields kept in memory at a time. */
constexpr std::size_t fields_at_once = 64;

constexpr double pi = 3.14159265358979323846;

double
triangleArea(const Vector3& a, const Vector3& b, const Vector3& c)
{
  std::array<double, 3> u{};
  std::array<double, 3> v{};
  for (std::size_t i = 0; i < 3; ++i) {
    u[i] = static_cast<double>(b[i]) - a[i];
    v[i] = static_cast<double>(c[i]) - a[i];
  }
  return 0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
}

double
surfaceArea(const Surface& mesh)
{
  const auto point = [&mesh](Index i) -> const Vector3& {
    return mesh.points[static_cast<std::size_t>(i)];
  };
  double area = 0.0;
  for (const Triangle& t : mesh.triangles)
    area += triangleArea(point(t[0]), point(t[1]), point(t[2]));
  return area;
}

/** The reachable vertex that is farthest from \a source, and its distance. */
std::pair<Index, double>
farthestVertex(const SurfaceGraph& graph, Index source)
{
  std::vector<float> field = distanceField(graph, source);
  for (float& distance : field)
    if (!std::isfinite(distance))
      distance = -1.0F;
  const auto farthest = std::max_element(field.begin(), field.end());
  return {static_cast<Index>(farthest - field.begin()), *farthest};
}

double
surfaceDiameter(const SurfaceGraph& graph, Index start)
{
  Index end = farthestVertex(graph, start).first;
  double diameter = 0.0;
  for (int sweep = 0; sweep < 3; ++sweep)
    std::tie(end, diameter) = farthestVertex(graph, end);
  return diameter;
}

void
checkArguments(const Surface& mesh, const GroundTruth& truth, const std::vector<Index>& partners)
{
  const auto require = [](bool condition, const std::string& reason) {
    if (!condition)
      throw pcl::BadArgumentException("scoreMap: " + reason);
  };
  const auto is_vertex = [&mesh](Index i) {
    return i >= 0 && static_cast<std::size_t>(i) < mesh.size();
  };
  require(mesh.hasFaces(), "the surface has no faces to measure distances on");
  require(!truth.empty(), "the ground truth is empty");
  require(partners.size() == mesh.size(),
          std::to_string(partners.size()) + " partners for " + std::to_string(mesh.size()) + " points");
  for (const Triangle& t : mesh.triangles)
    for (const Index i : t)
      require(is_vertex(i), "a face refers to vertex " + std::to_string(i));
  for (const TruePartner& pair : truth)
    require(is_vertex(pair.vertex) && is_vertex(pair.partner), "the ground truth refers to vertices " +
                                                                   std::to_string(pair.vertex) + " and " +
                                                                   std::to_string(pair.partner));
  for (const Index i : partners)
    require(i == no_index || is_vertex(i), "the map refers to vertex " + std::to_string(i));
}

/** Distance from the computed to the true partner; the diameter where there is none or no way between them. */
std::vector<double>
measureDistances(const SurfaceGraph& graph,
                 const GroundTruth& truth,
                 const std::vector<Index>& partners,
                 double diameter)
{
  std::vector<double> distances(truth.size(), diameter);
  for (std::size_t begin = 0; begin < truth.size(); begin += fields_at_once) {
    const std::size_t end = std::min(begin + fields_at_once, truth.size());
    std::vector<Index> sources;
    for (std::size_t i = begin; i < end; ++i)
      sources.push_back(truth[i].partner);
    const DistanceFields fields = distanceFields(graph, sources);
    for (std::size_t i = begin; i < end; ++i) {
      const Index partner = partners[static_cast<std::size_t>(truth[i].vertex)];
      if (partner != no_index)
        distances[i] = std::min<double>(fields.row(i - begin)[partner], diameter);
    }
  }
  return distances;
}

std::size_t
countMatched(const std::vector<Index>& partners)
{
  return static_cast<std::size_t>(
      std::count_if(partners.begin(), partners.end(), [](Index partner) { return partner != no_index; }));
}

} // namespace

double
MapAccuracy::correspondenceRate() const
{
  const auto right = std::count_if(errors.begin(), errors.end(), [](const VertexError& e) { return e.right; });
  return errors.empty() ? 0.0 : static_cast<double>(right) / static_cast<double>(errors.size());
}

double
MapAccuracy::meanGeodesicError() const
{
  double sum = 0.0;
  for (const VertexError& error : errors)
    sum += error.geodesic;
  return errors.empty() ? 1.0 : sum / static_cast<double>(errors.size());
}

double
MapAccuracy::shareBelow(double threshold) const
{
  const auto below =
      std::count_if(errors.begin(), errors.end(), [threshold](const VertexError& e) { return e.geodesic < threshold; });
  return errors.empty() ? 0.0 : static_cast<double>(below) / static_cast<double>(errors.size());
}

GroundTruth
subsampleTruth(const GroundTruth& truth)
{
  constexpr std::size_t maximum_pairs = 200;
  const std::size_t step = truth.size() > maximum_pairs ? truth.size() / maximum_pairs + 1 : 1;
  GroundTruth sample;
  for (std::size_t i = 0; i < truth.size(); i += step)
    sample.push_back(truth[i]);
  return sample;
}

MapAccuracy
scoreMap(const Surface& mesh, const GroundTruth& truth, const std::vector<Index>& partners)
{
  checkArguments(mesh, truth, partners);
  const SurfaceGraph graph = buildMeshGraph(mesh.points, mesh.triangles);
  const GroundTruth sample = subsampleTruth(truth);

  MapAccuracy score;
  score.vertices = mesh.size();
  score.map_size = countMatched(partners);
  score.area = surfaceArea(mesh);
  score.radius = std::sqrt(score.area / (20.0 * pi));
  score.diameter = surfaceDiameter(graph, truth.front().vertex);
  if (!(score.diameter > 0.0))
    throw pcl::BadArgumentException("scoreMap: the mesh has no extent around vertex " +
                                    std::to_string(truth.front().vertex));

  const std::vector<double> distances = measureDistances(graph, sample, partners, score.diameter);
  score.errors.reserve(sample.size());
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const Index vertex = sample[i].vertex;
    score.matched += partners[static_cast<std::size_t>(vertex)] != no_index ? 1 : 0;
    score.errors.push_back({vertex, distances[i] / score.diameter, distances[i] < score.radius});
  }
  return score;
}

} // namespace symmetry
} // namespace pcl
