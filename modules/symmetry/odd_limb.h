/** \file
 * \brief A body with a limb that has no counterpart, understood without that limb.
 */
#pragma once

#include "symmetry/interpretation_maps.h"
#include "symmetry/step_timer.h"
#include "symmetry/surface/limb.h"

#include <pcl/symmetry/symmetry_parameters.h>

#include <optional>

namespace pcl {
namespace symmetry {

/** \brief A limb that may be odd. */
struct CandidateLimb {
  Limb limb;
  bool has_twin = false; ///< whether the map of the whole exchanges its end and that of a limb of its size
};

/** \brief Cuts off a limb and searches the rest.
 * \return the partial map, in numbers of the whole; none where the limb is not odd, see mapWithoutOddLimb () */
std::optional<MapEstimate>
mapWithoutLimb(const CandidateLimb& candidate,
               const Interpretation& whole,
               const SymmetryParameters& parameters,
               StepTimer& timer);

/** \brief Moves the place where an odd limb is cut off towards its end, a tenth at a time, as long as the rest fits better
 * all the same: at the hip a body is narrowest where more is cut off than what is odd. Not the other way: of less surface the
 * rest fits better anyway.
 * \param[in,out] found map of the rest */
void
giveBack(CandidateLimb candidate,
         const Interpretation& whole,
         const SymmetryParameters& parameters,
         StepTimer& timer,
         MapEstimate& found);

/** \brief Looks for a limb without which the surface is symmetric, where its map is refused, partial or in doubt.
 *
 * A limb that has no counterpart spoils the map of all the rest: hypotheses pair it with something, distances and
 * eigenfunctions around its root are none of the other side. So one limb after another is cut off, and the rest is searched
 * anew, with the map of the whole among the hypotheses. The limb is odd where
 * - the search explains the rest better than it did the whole: maps are refined only there,
 * - the rest is symmetric as a whole,
 * - its map sends the place where the limb was rooted elsewhere: a head has its counterpart in itself,
 * - the map of the whole does not pair it with another one of its size; or that map is refused or partial, is another one,
 *   and fits half as well,
 * - it fits twice as well as the map of the whole (MapEstimate::misfit); or it is more likely right than not, and fits better
 *   if that one leaves something out, too, or has ten times its odds.
 *
 * Of several such limbs the one is taken whose rest fits best; the search ends where that is beyond doubt. Then what
 * was cut off too deep is given back.
 * Cost: one search for each limb, and for each step back; refinements, twice as long, of about half of them.
 * \param[in] best interpretation of the surface so far, with the verdict
 * \return the partial map; none where no limb is odd */
std::optional<Interpretation>
mapWithoutOddLimb(const Interpretation& best, const SymmetryParameters& parameters, StepTimer& timer);

} // namespace symmetry
} // namespace pcl
