#include "bodies.h"
#include "geodesic/farthest_point_sampling.h"

using namespace pcl::symmetry;
using namespace pcl::symmetry::performance;

namespace {

void
farthestPoints(benchmark::State& state)
{
  const SurfaceGraph& graph = human(state.range(0)).surface.graph;
  for (auto _ : state) {
    benchmark::DoNotOptimize(farthestPointSampling(graph, 0, 1500));
  }
}
BENCHMARK(farthestPoints)->Apply(onAllSizes);

void
coarsen(benchmark::State& state)
{
  const PreparedSurface& surface = human(state.range(0)).surface;
  for (auto _ : state) {
    benchmark::DoNotOptimize(coarsenSurface(surface, 1500));
  }
}
BENCHMARK(coarsen)->Apply(onAllSizes);

} // namespace
