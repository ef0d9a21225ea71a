#include "bodies.h"
#include "geodesic/farthest_point_sampling.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/staged/dense_matcher.h"

using namespace pcl::symmetry;
using namespace pcl::symmetry::performance;

namespace {

/** Distances of every vertex to 100 vertices, and to the true partners of these. */
struct MirroredFeatures {
  FeatureVectors own;
  FeatureVectors mirrored;
};

MirroredFeatures
mirroredFeatures(const Human& body)
{
  constexpr std::size_t features = 100;
  std::vector<Index> base;
  std::vector<Index> partners;
  for (const Index v : farthestPointSampling(body.surface.graph, 0, 2 * features).vertices) {
    if (base.size() < features && body.partners[v] != no_index) {
      base.push_back(v);
      partners.push_back(body.partners[v]);
    }
  }
  const auto per_vertex = [&](const std::vector<Index>& sources) {
    const DistanceFields fields = distanceFields(body.surface.graph, sources);
    FeatureVectors vectors;
    vectors.dimensions = sources.size();
    for (std::size_t v = 0; v < fields.columns; ++v) {
      for (std::size_t i = 0; i < fields.rows(); ++i) {
        vectors.values.push_back(fields.row(i)[v]);
      }
    }
    return vectors;
  };
  return {per_vertex(base), per_vertex(partners)};
}

/** Every vertex matched with all vertices, the tree's construction included. */
void
denseMatching(benchmark::State& state)
{
  const MirroredFeatures features = mirroredFeatures(human(state.range(0)));
  const std::vector<float> floors = featureFloors(features.own);
  for (auto _ : state) {
    benchmark::DoNotOptimize(DenseMatcher(features.mirrored, floors).match(features.own));
  }
}
BENCHMARK(denseMatching)->Apply(onAllSizes);

} // namespace
