/** \file
 * \brief From a map of the samples to a map of every point.
 */
#pragma once

#include "symmetry/samples/coarse_surface.h"
#include "symmetry/samples/laplacian_basis.h"
#include "symmetry/samples/sample_interpolation.h"
#include "symmetry/search/functional_map.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Points of each cell: cell i owns entries [offsets[i], offsets[i + 1]) of points, ascending. */
struct CellMembers {
  std::vector<std::uint32_t> offsets;
  std::vector<Index> points;
};

CellMembers
membersOfCells(const CoarseSurface& coarse);

/** \brief At most so many points of each cell, evenly picked. */
CellMembers
thinnedMembers(const CellMembers& members, std::uint32_t most_per_cell);

/** \brief Partner point of every sample, to the precision of the surface instead of that of the samples.
 *
 * Searched by eigenfunctions among the points of the cells around the image of the sample.
 * \param[in] map partner sample of every sample
 * \param[in] matrix its action on the leading eigenfunctions
 */
std::vector<Index>
partnersOfSamples(const CoarseSurface& coarse,
                  const LaplacianBasis& basis,
                  const SampleInterpolation& interpolation,
                  const CellMembers& members,
                  const SampleMap& map,
                  const Eigen::MatrixXf& matrix,
                  unsigned threads);

/** \brief Partners of the samples drawn towards a map that is its own inverse and smooth.
 *
 * In each round every sample goes to where its own match and those around it, read both ways, put its partner.
 * \param[in] sample_partners partner point of every sample */
std::vector<Index>
mutualPartners(const PreparedSurface& surface,
               const CoarseSurface& coarse,
               const CellMembers& members,
               std::vector<Index> sample_partners,
               int rounds,
               unsigned threads);

/** \brief Partner of every point: where the matches of the samples around it put it, the nearest point of the surface.
 * Smooth wherever the partners of the samples are. */
std::vector<Index>
partnersOfPoints(const PreparedSurface& surface,
                 const CoarseSurface& coarse,
                 const CellMembers& members,
                 const std::vector<Index>& sample_partners,
                 unsigned threads);

} // namespace symmetry
} // namespace pcl
