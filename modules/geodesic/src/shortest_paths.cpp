#include "geodesic/shortest_paths.h"

#include "geodesic/bucket_queue.h"
#include "geodesic/parallel.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

const auto ignore_improvement = [](Index, Index) {
};

/** The lowest neighbour through which a shortest path comes to v and which is nearer to the source than v itself. */
Index
predecessor(const SurfaceGraph& graph, const float* field, Index v)
{
  for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
    const Index w = graph.neighbours[e];
    if (field[w] < field[v] && field[w] + graph.lengths[e] == field[v]) {
      return w;
    }
  }
  return no_index;
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

DistanceFields
distanceFields(const SurfaceGraph& graph, const std::vector<Index>& sources, unsigned threads)
{
  DistanceFields fields;
  fields.columns = graph.size();
  fields.values.assign(sources.size() * graph.size(), unreachable);
  parallelBlocks(sources.size(), 1, threads, [&] {
    return [&, queue = BucketQueue(graph)](std::size_t begin, std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        float* field = fields.values.data() + i * fields.columns;
        field[sources[i]] = 0.0F;
        queue.relax({sources[i]}, field, ignore_improvement);
      }
    };
  });
  return fields;
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
