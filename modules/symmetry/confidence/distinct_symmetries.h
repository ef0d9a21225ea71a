/** \file
 * \brief Several symmetries of one surface: its reflections, and the rotations that follow from them.
 */
#pragma once

#include "symmetry/search/symmetry_search.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A reflection with what speaks for it. */
struct DistinctReflection {
  SymmetryCandidate candidate;
  float confidence = 0.0F; ///< in [0, 1]
};

/** \brief A symmetry that keeps the orientation: one reflection after another, as in a kaleidoscope. */
struct DistinctRotation {
  std::size_t first = 0;  ///< reflection that is applied first,
  std::size_t second = 0; ///< and the one after it: numbers in DistinctSymmetries::reflections
  SampleMap map;          ///< image of every landmark
  MapScore score;         ///< as a rotation
  float confidence = 0.0F;
};

/** \brief Best first; any two reflections, and any two rotations, differ by SearchSettings::distinct at least. */
struct DistinctSymmetries {
  std::vector<DistinctReflection> reflections;
  std::vector<DistinctRotation> rotations;
};

/** \brief Sorts symmetries out of the candidates of a search.
 *
 * A candidate counts as a reflection where it is one by its score (isReflection ()), has nine tenths of the first one's
 * confidence at least, turns the surface over nearly everywhere, and has an axis; a turn that also swaps the two faces
 * of a thin plate, or a reflection in a point, is none. The first candidate is taken as it is: it is the result of the
 * estimation. Rotations are composed of two reflections each, in either order; the identity is none.
 * \param[in] candidates distinct, best first
 * \param[in] most reflections, and rotations, at most
 * Cost: the measures of one map for each candidate and each ordered pair of reflections.
 */
DistinctSymmetries
distinctSymmetries(const LandmarkSurface& landmarks,
                   const ShapeDescriptor& descriptor,
                   const std::vector<SymmetryCandidate>& candidates,
                   const SearchSettings& settings,
                   std::size_t most);

} // namespace symmetry
} // namespace pcl
