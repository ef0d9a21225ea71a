#include "bodies.h"

using namespace pcl::symmetry;
using namespace pcl::symmetry::performance;

namespace {

void
meshGraph(benchmark::State& state)
{
  const PreparedSurface& surface = human(state.range(0)).surface;
  for (auto _ : state) {
    benchmark::DoNotOptimize(buildMeshGraph(surface.points, surface.triangles));
  }
}
BENCHMARK(meshGraph)->Apply(onAllSizes);

void
prepare(benchmark::State& state)
{
  const Surface& input = human(state.range(0)).input;
  for (auto _ : state) {
    benchmark::DoNotOptimize(prepareSurface(input, {}, {}));
  }
}
BENCHMARK(prepare)->Apply(onAllSizes);

} // namespace
