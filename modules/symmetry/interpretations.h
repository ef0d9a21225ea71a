/** \file
 * \brief Ways to understand an input: which points touch, which are connected, and where the surface is.
 */
#pragma once

#include "cloud/cloud_surface.h"
#include "geodesic/neighbour_graph.h"
#include "symmetry/rival_interpretations.h"
#include "symmetry/surface/input_cleaning.h"

#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_parameters.h>

#include <optional>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Remembers how a surface was read: however the noise is read, often the same points come out. */
class PastInterpretations {
public:
  /** \brief Whether this is the first time. */
  bool
  isNew(const PreparedSurface& surface, const ContactTest& contact);

private:
  struct PastSurface {
    std::vector<Vector3> points;
    std::vector<Vector3> normals;
    std::vector<ContactTest> contacts;
  };

  std::vector<PastSurface> surfaces_;
};

/** \brief Prepares a surface in one way after another, the one that is usually right first, until there is no need.
 *
 * A mesh is taken as it is; in doubt, if there are holes in it, also as the cloud of its vertices: holes part what
 * belongs together and lead distances astray. A cloud leaves open which points touch and which are connected, and a
 * noisy one also where the surface is. What comes out the same as before is not tried again. */
class InterpretationPlan {
public:
  /** All that is given is referred to, not copied.
   * \param[in] search of the neighbours of a cloud */
  InterpretationPlan(const Surface& surface, const SymmetryParameters& parameters, const NeighbourSearch& search);

  /** \brief The surface prepared in the next way; none where the rivals are settled or nothing is left to try.
   * \param[in] rivals the interpretations so far, each with its estimate */
  std::optional<PreparedSurface>
  next(const RivalInterpretations& rivals);

private:
  /** Ways that differ in the contact test alone: the usable points are the same. */
  struct Stage {
    NoiseInterpretation noise;
    FaceUse faces;
    std::vector<float> depths; ///< see ContactTest; none: as density and noise allow
  };

  std::vector<Stage>
  furtherStages(const RivalInterpretations& rivals) const;

  const Surface& surface_;
  const SymmetryParameters& parameters_;
  const NeighbourSearch& search_;
  std::vector<Stage> stages_; ///< yet to come, the next one last
  bool is_first_ = true;
  UsablePoints usable_;               ///< of the current stage
  std::vector<ContactTest> contacts_; ///< of the current stage, yet to come, the next one last
  PastInterpretations past_;
};

} // namespace symmetry
} // namespace pcl
