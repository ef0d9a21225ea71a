#include "symmetry/refine/point_map.h"

#include "base/parallel.h"
#include "base/vector_math.h"
#include "symmetry/refine/bidirectional_matches.h"
#include "symmetry/samples/greedy_descent.h"

#include <algorithm>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** The cell and those adjacent to it, ascending. */
std::vector<Index>
cellAndNeighbours(const SurfaceGraph& graph, Index cell)
{
  std::vector<Index> cells{cell};
  cells.insert(cells.end(), graph.neighbours.begin() + graph.offsets[cell],
               graph.neighbours.begin() + graph.offsets[cell + 1]);
  std::sort(cells.begin(), cells.end());
  return cells;
}

using RowMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/** Points of each cell among which partners are searched, with the eigenfunctions there. */
struct CellProbes {
  CellMembers members;
  RowMatrix functions; ///< one row per point of \a members
};

CellProbes
probeCells(const SampledSurface& sampled, const RowMatrix& functions)
{
  const SampleInterpolation& interpolation = sampled.interpolation;
  // In a dense cell a part of the points is enough: the fit of the points around averages what is lost.
  constexpr std::uint32_t maximum_per_cell = 48;
  CellProbes probes{thinnedMembers(sampled.members, maximum_per_cell), {}};
  const std::vector<Index>& points = probes.members.points;
  probes.functions.setZero(static_cast<Eigen::Index>(points.size()), functions.cols());
  parallelFor(
      points.size(),
      [&](std::size_t p) {
        auto row = probes.functions.row(static_cast<Eigen::Index>(p));
        const Index point = points[p];
        for (std::uint32_t e = interpolation.offsets[point]; e < interpolation.offsets[point + 1]; ++e) {
          row += interpolation.weights[e] * functions.row(interpolation.samples[e]);
        }
      },
      256);
  return probes;
}

/** The point nearest to a position: the nearest member of the given cells, and from there on over the surface. */
Index
nearestPoint(const SampledSurface& sampled, const std::vector<Index>& cells, const Vector3& position)
{
  const PreparedSurface& surface = sampled.surface;
  const CellMembers& members = sampled.probes;
  const auto cost = [&](Index v) {
    const Vector3 offset = surface.points[v] - position;
    return dot(offset, offset);
  };
  Index best = no_index;
  float least = std::numeric_limits<float>::infinity();
  for (const Index cell : cells) {
    for (std::uint32_t e = members.offsets[cell]; e < members.offsets[cell + 1]; ++e) {
      const float squared = cost(members.points[e]);
      if (squared < least) {
        least = squared;
        best = members.points[e];
      }
    }
  }
  return walkDown(surface.graph, best, cost);
}

} // namespace

std::vector<Index>
partnersOfSamples(const SampledSurface& sampled, const SampleMap& map, const Eigen::MatrixXf& matrix)
{
  const CoarseSurface& coarse = sampled.coarse;
  const Eigen::MatrixXf functions = sampled.basis.functions.leftCols(matrix.cols());
  const RowMatrix wanted = functions * matrix;
  const CellProbes probes = probeCells(sampled, functions);
  std::vector<Index> partners(coarse.size());
  parallelFor(
      coarse.size(),
      [&](std::size_t i) {
        float least = std::numeric_limits<float>::infinity();
        for (const Index cell : cellAndNeighbours(coarse.graph, map[i])) {
          for (std::uint32_t p = probes.members.offsets[cell]; p < probes.members.offsets[cell + 1]; ++p) {
            const float squared = (probes.functions.row(p) - wanted.row(static_cast<Eigen::Index>(i))).squaredNorm();
            if (squared < least) {
              least = squared;
              partners[i] = probes.members.points[p];
            }
          }
        }
      },
      16);
  return partners;
}

std::vector<Index>
mutualPartners(const SampledSurface& sampled, std::vector<Index> sample_partners, int rounds)
{
  const CoarseSurface& coarse = sampled.coarse;
  for (int round = 0; round < rounds; ++round) {
    const BidirectionalMatches matches(sampled.surface, coarse, sample_partners);
    parallelFor(
        coarse.size(),
        [&](std::size_t i) {
          const Index home = coarse.cells.owner[sample_partners[i]];
          sample_partners[i] =
              nearestPoint(sampled, cellAndNeighbours(coarse.graph, home), matches.imageOf(coarse.cells.vertices[i]));
        },
        64);
  }
  return sample_partners;
}

std::vector<Index>
partnersOfPoints(const SampledSurface& sampled, const std::vector<Index>& sample_partners)
{
  const CoarseSurface& coarse = sampled.coarse;
  const BidirectionalMatches matches(sampled.surface, coarse, sample_partners);
  std::vector<Index> partners(sampled.surface.size());
  parallelFor(
      partners.size(),
      [&](std::size_t v) {
        const Index home = coarse.cells.owner[sample_partners[coarse.cells.owner[v]]];
        partners[v] =
            nearestPoint(sampled, cellAndNeighbours(coarse.graph, home), matches.imageOf(static_cast<Index>(v)));
      },
      256);
  return partners;
}

} // namespace symmetry
} // namespace pcl
