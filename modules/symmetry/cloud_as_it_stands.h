/** \file
 * \brief A cloud that is looked at as it stands in space, before anything is said of what touches what.
 */
#pragma once

#include "geodesic/neighbour_graph.h"
#include "symmetry/rival_interpretations.h"
#include "symmetry/step_timer.h"

#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_parameters.h>

#include <optional>

namespace pcl {
namespace symmetry {

/** \brief A cloud with no faces to tell what touches what, understood as it stands in space. */
class CloudAsItStands {
public:
  /** The parameters are referred to, not copied. */
  CloudAsItStands(const Surface& cloud, const SymmetryParameters& parameters, const NeighbourSearch& search);

  /** \brief Whether its points are in parts even by their nearest neighbours: those of an object, more likely than of a
   * body. */
  bool
  isInParts() const;

  /** \brief The map that its mirror plane makes, if there is one that is more certain than a confidence. May be called
   * once. */
  std::optional<Interpretation>
  mirrored(float confidence, StepTimer& timer);

private:
  const SymmetryParameters& parameters_;
  PreparedSurface surface_;
};

} // namespace symmetry
} // namespace pcl
