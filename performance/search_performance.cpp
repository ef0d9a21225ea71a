#include "bodies.h"
#include "symmetry/search/functional_map.h"
#include "symmetry/search/map_score.h"
#include "symmetry/search/symmetry_search.h"

#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::performance;

namespace {

Eigen::MatrixXf
randomMatrix(Eigen::Index rows, Eigen::Index columns, unsigned seed)
{
  std::mt19937 random(seed);
  return Eigen::MatrixXf::NullaryExpr(rows, columns,
                                      [&random] { return static_cast<float>(random() % 20001U) / 10000.0F - 1.0F; });
}

/** Arguments: rows, columns; as many queries as targets. */
void
nearest(benchmark::State& state)
{
  const Eigen::MatrixXf queries = randomMatrix(state.range(0), state.range(1), 1);
  const RowSearch search(randomMatrix(state.range(0), state.range(1), 2));
  for (auto _ : state) {
    benchmark::DoNotOptimize(search.nearest(queries));
  }
}
BENCHMARK(nearest)->ArgNames({"rows", "columns"})->Args({300, 26})->Args({600, 88})->Args({1500, 60});

/** The same by a matrix product and a pass over it. */
void
nearestByProduct(benchmark::State& state)
{
  const Eigen::MatrixXf queries = randomMatrix(state.range(0), state.range(1), 1);
  const Eigen::MatrixXf targets = randomMatrix(state.range(0), state.range(1), 2);
  SampleMap map(static_cast<std::size_t>(queries.rows()));
  for (auto _ : state) {
    const Eigen::VectorXf half_norms = 0.5F * targets.rowwise().squaredNorm();
    const Eigen::MatrixXf products = targets * queries.transpose();
    for (Eigen::Index i = 0; i < queries.rows(); ++i) {
      Eigen::Index best = 0;
      (half_norms - products.col(i)).minCoeff(&best);
      map[static_cast<std::size_t>(i)] = static_cast<Index>(best);
    }
    benchmark::DoNotOptimize(map.data());
  }
}
BENCHMARK(nearestByProduct)->ArgNames({"rows", "columns"})->Args({300, 26})->Args({600, 88})->Args({1500, 60});

void
involution(benchmark::State& state)
{
  const Eigen::MatrixXf matrix = randomMatrix(state.range(0), state.range(0), 1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(nearestInvolution(matrix));
  }
}
BENCHMARK(involution)->ArgName("functions")->Arg(14)->Arg(40)->Arg(60);

/** Arguments: vertices, threads. */
void
hypotheses(benchmark::State& state)
{
  const SampledSurface sampled = sampledHuman(state.range(0));
  const ThreadScope threads(static_cast<unsigned>(state.range(1)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(searchSymmetries(sampled, {}));
  }
}
BENCHMARK(hypotheses)
    ->ArgNames({"vertices", "threads"})
    ->ArgsProduct({{12500, 60000}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
