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
meanField(const DistanceFields& fields)
{
  constexpr std::size_t block = 4096;
  std::vector<float> mean(fields.columns, 0.0F);
  parallelBlocks(fields.columns, block, [&] {
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
extremityFunctions(const SurfaceGraph& embedded, Index start, std::size_t samples, float separation)
{
  ExtremityFunctions functions;
  const FarthestPointSamples sampling = farthestPointSampling(embedded, start, samples);
  functions.average =
      smoothOverRings(embedded, meanField(distanceFields(embedded, sampling.vertices)), settings.smoothing_rounds);
  functions.average_maxima =
      separated(embedded, localMaxima(embedded, functions.average), functions.average, separation);
  functions.minimal = distanceField(embedded, functions.average_maxima);
  functions.minimal_maxima =
      separated(embedded, localMaxima(embedded, functions.minimal), functions.minimal, separation);
  return functions;
}

} // namespace symmetry
} // namespace pcl
