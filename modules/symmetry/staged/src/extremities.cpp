#include "symmetry/staged/extremities.h"

#include "base/parallel.h"
#include "geodesic/farthest_point_sampling.h"
#include "geodesic/vertex_functions.h"
#include "symmetry/staged/staged_settings.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr ExtremitySettings settings{};

Index
farthest(const std::vector<float>& field)
{
  return static_cast<Index>(std::max_element(field.begin(), field.end()) - field.begin());
}

/** Mean over the rows, in blocks of columns. */
std::vector<float>
meanField(const DistanceFields& fields, unsigned threads)
{
  constexpr std::size_t block = 4096;
  std::vector<float> mean(fields.columns, 0.0F);
  parallelBlocks(fields.columns, block, threads, [&] {
    return [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = 0; row < fields.rows(); ++row) {
        const float* field = fields.row(row);
        for (std::size_t v = begin; v < end; ++v) {
          mean[v] += field[v];
        }
      }
    };
  });
  for (float& value : mean) {
    value /= static_cast<float>(std::max<std::size_t>(fields.rows(), 1));
  }
  return mean;
}

/** How differently the distances from two points (rows of fields) to the landmarks are distributed: the area between
 * the two distribution functions. */
float
distributionDistance(const DistanceFields& fields, std::size_t a, std::size_t b, const std::vector<Index>& landmarks)
{
  std::vector<float> from_a;
  std::vector<float> from_b;
  for (const Index landmark : landmarks) {
    from_a.push_back(fields.row(a)[landmark]);
    from_b.push_back(fields.row(b)[landmark]);
  }
  std::sort(from_a.begin(), from_a.end());
  std::sort(from_b.begin(), from_b.end());
  float sum = 0.0F;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    sum += std::abs(from_a[i] - from_b[i]);
  }
  return sum;
}

/** Of the three ways to make two pairs of four points the one whose partners see the surface most alike. */
std::array<std::size_t, 4>
groupByDistribution(const DistanceFields& fields, const std::vector<Index>& landmarks)
{
  const std::array<std::array<std::size_t, 4>, 3> groupings = {{{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}}};
  std::array<float, 3> costs{};
  for (std::size_t i = 0; i < groupings.size(); ++i) {
    const auto [a, b, c, d] = groupings[i];
    costs[i] = distributionDistance(fields, a, b, landmarks) + distributionDistance(fields, c, d, landmarks);
  }
  return groupings[static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin())];
}

} // namespace

SurfaceGraph
embeddedGraph(const SurfaceGraph& graph, const SpectralEmbedding& embedding)
{
  SurfaceGraph embedded = graph;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      float squared = 0.0F;
      for (int a = 0; a < embedding.dimensions; ++a) {
        const float d = embedding.at(v)[a] - embedding.at(static_cast<std::size_t>(graph.neighbours[e]))[a];
        squared += d * d;
      }
      embedded.lengths[e] = std::sqrt(squared);
    }
  }
  return embedded;
}

std::vector<Index>
mutuallyFarthestVertices(const SurfaceGraph& graph, Index start, std::size_t count)
{
  std::vector<Index> points = farthestPointSampling(graph, farthest(distanceField(graph, start)), count).vertices;
  bool moved = points.size() > 1;
  for (int round = 0; moved && round < settings.maximum_rounds; ++round) {
    moved = false;
    for (Index& point : points) {
      std::vector<Index> others;
      std::copy_if(points.begin(), points.end(), std::back_inserter(others), [&](Index v) { return v != point; });
      const std::vector<float> field = distanceField(graph, others);
      const Index better = farthest(field);
      if (field[better] > field[point]) {
        point = better;
        moved = true;
      }
    }
  }
  return points;
}

ExtremityFunctions
extremityFunctions(const SurfaceGraph& embedded, Index start, std::size_t samples, float separation, unsigned threads)
{
  ExtremityFunctions functions;
  const FarthestPointSamples sampling = farthestPointSampling(embedded, start, samples);
  functions.average = smoothOverRings(
      embedded, meanField(distanceFields(embedded, sampling.vertices, threads), threads), settings.smoothing_rounds);
  functions.average_maxima =
      separated(embedded, localMaxima(embedded, functions.average), functions.average, separation);
  functions.minimal = distanceField(embedded, functions.average_maxima);
  functions.minimal_maxima =
      separated(embedded, localMaxima(embedded, functions.minimal), functions.minimal, separation);
  return functions;
}

const std::vector<float>&
pairingFeature(const ExtremityFunctions& functions, PairingFeature feature)
{
  const bool large = functions.average.size() >= settings.points_of_large_surface;
  return feature == PairingFeature::MinimalGeodesicDistance || (feature == PairingFeature::BySurfaceSize && large)
             ? functions.minimal
             : functions.average;
}

ExtremePairs
pairExtremePoints(const std::array<Index, 4>& points,
                  const std::vector<float>& feature,
                  const SurfaceMetric& metric,
                  const std::vector<Index>& landmarks,
                  unsigned threads)
{
  std::array<Index, 4> sorted = points;
  std::sort(sorted.begin(), sorted.end(),
            [&feature](Index a, Index b) { return feature[a] != feature[b] ? feature[a] < feature[b] : a < b; });
  const DistanceFields fields = metric.fields({sorted.begin(), sorted.end()}, threads);

  const float smallest_step = settings.clear_step * feature[sorted.back()];
  const auto step = [&](std::size_t i) {
    return feature[sorted[i + 1]] - feature[sorted[i]];
  };
  const bool clear = step(1) >= std::max({step(0), step(2), smallest_step});
  const auto [h1, h2, f1, f2] = clear ? std::array<std::size_t, 4>{0, 1, 2, 3} : groupByDistribution(fields, landmarks);
  const float straight = fields.row(h1)[sorted[f1]] + fields.row(h2)[sorted[f2]];
  const float across = fields.row(h1)[sorted[f2]] + fields.row(h2)[sorted[f1]];
  ExtremePairs pairs{sorted[h1], sorted[h2], sorted[f1], sorted[f2]};
  if (across < straight) {
    std::swap(pairs.f1, pairs.f2);
  }
  return pairs;
}

} // namespace symmetry
} // namespace pcl
