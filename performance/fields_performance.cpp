// Shortest-path fields, with two yardsticks on the same graph: Boost's Dijkstra on a compressed sparse row graph, and
// Dijkstra with a binary heap that keeps outdated entries.
#include "base/parallel.h"
#include "bodies.h"
#include "geodesic/bucket_queue.h"
#include "geodesic/min_plus_factor.h"
#include "geodesic/shortest_paths.h"

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <queue>
#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::performance;

namespace {

constexpr std::size_t bulk = 100;

std::vector<Index>
randomVertices(const SurfaceGraph& graph, std::size_t count)
{
  std::mt19937 random(3);
  std::vector<Index> vertices(count);
  for (Index& v : vertices) {
    v = static_cast<Index>(random() % graph.size());
  }
  return vertices;
}

struct BoostEdge {
  float length;
};

using BoostGraph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, BoostEdge>;

BoostGraph
boostGraph(const SurfaceGraph& graph)
{
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  std::vector<BoostEdge> lengths;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      edges.emplace_back(v, graph.neighbours[e]);
      lengths.push_back({graph.lengths[e]});
    }
  }
  return {boost::edges_are_sorted, edges.begin(), edges.end(), lengths.begin(), graph.size()};
}

void
boostField(const BoostGraph& graph, Index source, float* field)
{
  const auto distance = boost::make_iterator_property_map(field, boost::get(boost::vertex_index, graph));
  boost::dijkstra_shortest_paths(
      graph, static_cast<std::size_t>(source),
      boost::weight_map(boost::get(&BoostEdge::length, graph)).distance_map(distance).distance_inf(unreachable));
}

void
heapField(const SurfaceGraph& graph, Index source, float* field)
{
  using Entry = std::pair<float, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  std::fill_n(field, graph.size(), unreachable);
  field[source] = 0.0F;
  heap.push({0.0F, source});
  while (!heap.empty()) {
    const auto [d, v] = heap.top();
    heap.pop();
    if (d > field[v]) {
      continue;
    }
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      const Index w = graph.neighbours[e];
      const float candidate = d + graph.lengths[e];
      if (candidate < field[w]) {
        field[w] = candidate;
        heap.push({candidate, w});
      }
    }
  }
}

void
searchField(const SurfaceGraph& graph, Index source, float* field)
{
  const std::vector<float> found = distanceField(graph, source);
  std::copy(found.begin(), found.end(), field);
}

/** Runs field (source, row) for each source, on the threads of the scope. */
template <typename Field>
std::vector<float>
fieldByField(const SurfaceGraph& graph, const std::vector<Index>& sources, Field field)
{
  std::vector<float> rows(sources.size() * graph.size());
  parallelFor(sources.size(), [&](std::size_t i) { field(sources[i], rows.data() + i * graph.size()); });
  return rows;
}

/** Arguments: vertices, threads. Everything that is set up for the fields counts. */
void
bulkFields(benchmark::State& state)
{
  const ThreadScope threads(static_cast<unsigned>(state.range(1)));
  const SurfaceGraph& graph = human(state.range(0)).surface.graph;
  const std::vector<Index> sources = randomVertices(graph, bulk);
  for (auto _ : state) {
    benchmark::DoNotOptimize(distanceFields(graph, sources));
  }
}

void
bulkFieldsByBoost(benchmark::State& state)
{
  const ThreadScope threads(static_cast<unsigned>(state.range(1)));
  const SurfaceGraph& graph = human(state.range(0)).surface.graph;
  const std::vector<Index> sources = randomVertices(graph, bulk);
  for (auto _ : state) {
    const BoostGraph boost_graph = boostGraph(graph);
    benchmark::DoNotOptimize(
        fieldByField(graph, sources, [&](Index source, float* field) { boostField(boost_graph, source, field); }));
  }
}

void
bulkFieldsByHeap(benchmark::State& state)
{
  const ThreadScope threads(static_cast<unsigned>(state.range(1)));
  const SurfaceGraph& graph = human(state.range(0)).surface.graph;
  const std::vector<Index> sources = randomVertices(graph, bulk);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        fieldByField(graph, sources, [&](Index source, float* field) { heapField(graph, source, field); }));
  }
}

void
bulkFieldsBySearch(benchmark::State& state)
{
  const ThreadScope threads(static_cast<unsigned>(state.range(1)));
  const SurfaceGraph& graph = human(state.range(0)).surface.graph;
  const std::vector<Index> sources = randomVertices(graph, bulk);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        fieldByField(graph, sources, [&](Index source, float* field) { searchField(graph, source, field); }));
  }
}

void
onAllSizesAndThreads(benchmark::internal::Benchmark* step)
{
  step->ArgNames({"vertices", "threads"})
      ->ArgsProduct({{12500, 27000, 52000, 60000}, {1, 2}})
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

BENCHMARK(bulkFields)->Apply(onAllSizesAndThreads);
BENCHMARK(bulkFieldsByBoost)->Apply(onAllSizesAndThreads);
BENCHMARK(bulkFieldsByHeap)->Apply(onAllSizesAndThreads);
BENCHMARK(bulkFieldsBySearch)->Apply(onAllSizesAndThreads);

/** One field after the other, from sources all over the surface. */
template <typename Field>
void
singleFields(benchmark::State& state, Field field)
{
  const SurfaceGraph& graph = human(state.range(0)).surface.graph;
  const std::vector<Index> sources = randomVertices(graph, bulk);
  std::vector<float> row(graph.size());
  std::size_t i = 0;
  for (auto _ : state) {
    field(graph, sources[i++ % bulk], row.data());
    benchmark::DoNotOptimize(row.data());
  }
}
BENCHMARK_CAPTURE(singleFields, bucketQueue, searchField)->Apply(onAllSizes);
BENCHMARK_CAPTURE(singleFields, binaryHeap, heapField)->Apply(onAllSizes);

/** The parts of bulkFields: dissection and boundaries, the factor, fields from it. */
void
analysis(benchmark::State& state)
{
  const SurfaceGraph& graph = human(state.range(0)).surface.graph;
  for (auto _ : state) {
    benchmark::DoNotOptimize(MinPlusFactor(graph, 1e30));
  }
}
BENCHMARK(analysis)->Apply(onAllSizes);

void
factorization(benchmark::State& state)
{
  const SurfaceGraph& graph = human(state.range(0)).surface.graph;
  MinPlusFactor factor(graph, 1e30);
  for (auto _ : state) {
    factor.factorize();
  }
}
BENCHMARK(factorization)->Apply(onAllSizes);

void
fieldsFromFactor(benchmark::State& state)
{
  const SurfaceGraph& graph = human(state.range(0)).surface.graph;
  const std::vector<Index> sources = randomVertices(graph, bulk);
  MinPlusFactor factor(graph, 1e30);
  factor.factorize();
  std::vector<float> rows(bulk * graph.size());
  for (auto _ : state) {
    factor.fields(sources, rows.data());
    benchmark::DoNotOptimize(rows.data());
  }
}
BENCHMARK(fieldsFromFactor)->Apply(onAllSizes);

} // namespace
