#include "bodies.h"

using namespace pcl::symmetry;
using namespace pcl::symmetry::performance;

namespace {

void
eigenfunctions(benchmark::State& state)
{
  const CoarseSurface& coarse = sampledHuman(state.range(0)).coarse;
  for (auto _ : state) {
    benchmark::DoNotOptimize(laplacianBasis(coarse, 60));
  }
}
BENCHMARK(eigenfunctions)->Apply(onAllSizes);

void
hubDistances(benchmark::State& state)
{
  const CoarseSurface& coarse = sampledHuman(state.range(0)).coarse;
  for (auto _ : state) {
    benchmark::DoNotOptimize(makeLandmarkSurface(coarse, 600, Metric::Geodesic));
  }
}
BENCHMARK(hubDistances)->Apply(onAllSizes);

} // namespace
