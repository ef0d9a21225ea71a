#include "symmetry/refine/point_map.h"

#include "base/parallel.h"
#include "base/vector_math.h"
#include "symmetry/refine/bidirectional_matches.h"
#include "symmetry/samples/greedy_descent.h"

#include <algorithm>
#include <limits>
#include <numeric>

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
probeCells(const SampleInterpolation& interpolation,
           const CellMembers& members,
           const RowMatrix& functions,
           unsigned threads)
{
  // In a dense cell a part of the points is enough: the fit of the points around averages what is lost.
  constexpr std::uint32_t most_per_cell = 48;
  CellProbes probes{thinnedMembers(members, most_per_cell), {}};
  const std::vector<Index>& points = probes.members.points;
  probes.functions.setZero(static_cast<Eigen::Index>(points.size()), functions.cols());
  parallelFor(
      points.size(), threads,
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
nearestPoint(const PreparedSurface& surface,
             const CellMembers& members,
             const std::vector<Index>& cells,
             const Vector3& position)
{
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

CellMembers
membersOfCells(const CoarseSurface& coarse)
{
  CellMembers members;
  members.offsets.assign(coarse.size() + 1, 0);
  for (const Index owner : coarse.cells.owner) {
    ++members.offsets[owner + 1];
  }
  std::partial_sum(members.offsets.begin(), members.offsets.end(), members.offsets.begin());
  members.points.resize(coarse.cells.owner.size());
  std::vector<std::uint32_t> next(members.offsets.begin(), members.offsets.end() - 1);
  for (std::size_t v = 0; v < coarse.cells.owner.size(); ++v) {
    members.points[next[coarse.cells.owner[v]]++] = static_cast<Index>(v);
  }
  return members;
}

CellMembers
thinnedMembers(const CellMembers& members, std::uint32_t most_per_cell)
{
  CellMembers thinned;
  thinned.offsets.push_back(0);
  for (std::size_t cell = 0; cell + 1 < members.offsets.size(); ++cell) {
    const std::uint32_t size = members.offsets[cell + 1] - members.offsets[cell];
    const std::uint32_t step = std::max(1U, (size + most_per_cell - 1) / most_per_cell);
    for (std::uint32_t e = members.offsets[cell]; e < members.offsets[cell + 1]; e += step) {
      thinned.points.push_back(members.points[e]);
    }
    thinned.offsets.push_back(static_cast<std::uint32_t>(thinned.points.size()));
  }
  return thinned;
}

std::vector<Index>
partnersOfSamples(const CoarseSurface& coarse,
                  const LaplacianBasis& basis,
                  const SampleInterpolation& interpolation,
                  const CellMembers& members,
                  const SampleMap& map,
                  const Eigen::MatrixXf& matrix,
                  unsigned threads)
{
  const Eigen::MatrixXf functions = basis.functions.leftCols(matrix.cols());
  const RowMatrix wanted = functions * matrix;
  const CellProbes probes = probeCells(interpolation, members, functions, threads);
  std::vector<Index> partners(coarse.size());
  parallelFor(
      coarse.size(), threads,
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
mutualPartners(const PreparedSurface& surface,
               const CoarseSurface& coarse,
               const CellMembers& members,
               std::vector<Index> sample_partners,
               int rounds,
               unsigned threads)
{
  for (int round = 0; round < rounds; ++round) {
    const PlaceMatches matches(surface, coarse, sample_partners);
    parallelFor(
        coarse.size(), threads,
        [&](std::size_t i) {
          const Index home = coarse.cells.owner[sample_partners[i]];
          sample_partners[i] = nearestPoint(surface, members, cellAndNeighbours(coarse.graph, home),
                                            matches.imageOf(coarse.cells.vertices[i]));
        },
        64);
  }
  return sample_partners;
}

std::vector<Index>
partnersOfPoints(const PreparedSurface& surface,
                 const CoarseSurface& coarse,
                 const CellMembers& members,
                 const std::vector<Index>& sample_partners,
                 unsigned threads)
{
  const PlaceMatches matches(surface, coarse, sample_partners);
  std::vector<Index> partners(surface.size());
  parallelFor(
      surface.size(), threads,
      [&](std::size_t v) {
        const Index home = coarse.cells.owner[sample_partners[coarse.cells.owner[v]]];
        partners[v] = nearestPoint(surface, members, cellAndNeighbours(coarse.graph, home),
                                   matches.imageOf(static_cast<Index>(v)));
      },
      256);
  return partners;
}

} // namespace symmetry
} // namespace pcl
