#include "geodesic/shortest_paths.h"

#include "base/large_memory.h"
#include "base/parallel.h"
#include "geodesic/bucket_queue.h"
#include "geodesic/min_plus_factor.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

const auto ignore_improvement = [](Index, Index) {
};

/** Of the neighbours that are nearer to the source than v, the one through which the way to v is shortest (ties: the
 * lowest). Not all fields are sums along paths to the last bit, so lengths are compared with each other, not with the
 * field at v. */
Index
predecessor(const SurfaceGraph& graph, const float* field, Index v)
{
  Index best = no_index;
  float least = unreachable;
  for (const auto [w, length] : graph.edges(v)) {
    if (field[w] < field[v] && field[w] + length < least) {
      least = field[w] + length;
      best = w;
    }
  }
  return best;
}

/** What the two ways to many fields cost, in nanoseconds on one core, as measured on meshes of 10^4 to 10^5 vertices
 * and clouds of 10^6. Fixed numbers, not measured anew: which way is taken must not depend on the machine. */
struct EngineCosts {
  static constexpr double search_per_edge = 6.0; // of a bucket queue, per direction of an edge
  static constexpr double analysis_per_vertex = 400.0;
  static constexpr double minima_per_vertex = 20.0; // of a surface's factor, times the root of the number of vertices
  static constexpr double factor_per_minimum = 0.08;
  static constexpr double field_per_minimum = 0.06;
  static constexpr double field_per_vertex = 1.0;
};

void
searchFields(const SurfaceGraph& graph, const std::vector<Index>& sources, float* rows)
{
  parallelBlocks(sources.size(), 1, [&] {
    return [&, queue = BucketQueue(graph)](std::size_t begin, std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        float* field = rows + i * graph.size();
        std::fill_n(field, graph.size(), unreachable);
        field[sources[i]] = 0.0F;
        queue.relax({sources[i]}, field, ignore_improvement);
      }
    };
  });
}

} // namespace

std::vector<float>
distanceField(const SurfaceGraph& graph, const std::vector<Index>& sources)
{
  std::vector<float> field(graph.size(), unreachable);
  for (const Index source : sources) {
    field[source] = 0.0F;
  }
  BucketQueue(graph).relax(sources, field.data(), ignore_improvement);
  return field;
}

std::vector<float>
distanceField(const SurfaceGraph& graph, Index source)
{
  return distanceField(graph, std::vector<Index>{source});
}

DistanceFieldSolver::DistanceFieldSolver(const SurfaceGraph& graph) : graph_(graph)
{
}

DistanceFieldSolver::~DistanceFieldSolver() = default;

/** Whether there is a factor; makes it once it is expected to be faster for all sources so far than searching. */
bool
DistanceFieldSolver::isFactorized()
{
  constexpr std::size_t minimum_sources = 24; // below, not even the analysis pays
  const auto count = static_cast<double>(sources_);
  const auto vertices = static_cast<double>(graph_.size());
  const double search = EngineCosts::search_per_edge * static_cast<double>(graph_.neighbours.size());
  const double elimination =
      vertices * (EngineCosts::analysis_per_vertex +
                  EngineCosts::factor_per_minimum * EngineCosts::minima_per_vertex * std::sqrt(vertices));
  if (factorized_ || sources_ < minimum_sources || search * count < elimination) {
    return factorized_;
  }
  if (factor_ == nullptr) {
    factor_ = std::make_unique<MinPlusFactor>(graph_, search / EngineCosts::field_per_minimum);
  }
  const double field =
      EngineCosts::field_per_minimum * factor_->cost().field + EngineCosts::field_per_vertex * vertices;
  if (factor_->feasible() &&
      EngineCosts::factor_per_minimum * factor_->cost().factor + count * field < search * count) {
    factor_->factorize();
    factorized_ = true;
  }
  return factorized_;
}

DistanceFields
DistanceFieldSolver::fields(const std::vector<Index>& sources)
{
  constexpr std::size_t minimum_eliminated = 4; // a sweep costs as much for one source as for many
  DistanceFields fields;
  fields.columns = graph_.size();
  fields.values.reserve(sources.size() * graph_.size());
  preferLargePages(fields.values.data(), sources.size() * graph_.size() * sizeof(float));
  fields.values.resize(sources.size() * graph_.size());
  sources_ += sources.size();
  if (isFactorized() && sources.size() >= minimum_eliminated) {
    factor_->fields(sources, fields.values.data());
  }
  else {
    searchFields(graph_, sources, fields.values.data());
  }
  return fields;
}

DistanceFields
distanceFields(const SurfaceGraph& graph, const std::vector<Index>& sources)
{
  return DistanceFieldSolver(graph).fields(sources);
}

std::vector<Index>
shortestPath(const SurfaceGraph& graph, Index source, Index target)
{
  std::vector<float> field(graph.size(), unreachable);
  std::vector<Index> previous(graph.size(), no_index);
  field[target] = 0.0F;
  // Searched from the target, so that following `previous` runs from the source to the target.
  BucketQueue(graph).relax({target}, field.data(), [&previous](Index v, Index from) { previous[v] = from; });
  std::vector<Index> path;
  if (field[source] == unreachable) {
    return path;
  }
  for (Index v = source; v != no_index; v = previous[v]) {
    path.push_back(v);
  }
  return path;
}

std::vector<Index>
shortestPath(const SurfaceGraph& graph, const float* field, Index target)
{
  std::vector<Index> path;
  if (!(field[target] < unreachable)) {
    return path;
  }
  Index v = target;
  while (v != no_index && field[v] > 0.0F) {
    path.push_back(v);
    v = predecessor(graph, field, v);
  }
  if (v == no_index) {
    // Edges too short to make a difference to the distance: the field does not tell where the path came from.
    const auto source = std::find(field, field + graph.size(), 0.0F);
    return shortestPath(graph, static_cast<Index>(source - field), target);
  }
  path.push_back(v);
  std::reverse(path.begin(), path.end());
  return path;
}

Index
pathMidpoint(const SurfaceGraph& graph, const std::vector<Index>& path)
{
  std::vector<double> along(path.size(), 0.0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    along[i] = along[i - 1] + edgeLength(graph, path[i - 1], path[i]);
  }
  std::size_t best = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (std::abs(along[i] - 0.5 * along.back()) < std::abs(along[best] - 0.5 * along.back())) {
      best = i;
    }
  }
  return path.empty() ? no_index : path[best];
}

} // namespace symmetry
} // namespace pcl
