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
  isNew(const PreparedSurface& surface, const ContactTest& contact, float samples = 1.0F);

private:
  struct PastSurface {
    float samples;
    std::vector<Vector3> points;
    std::vector<Vector3> normals;
    std::vector<ContactTest> contacts;
  };

  std::vector<PastSurface> surfaces_;
};

/** \brief Prepares a surface in one way after another, the one that is usually right first, until there is no need.
 *
 * A mesh is taken as it is; in doubt also as the cloud of its vertices, which tests contacts and has no holes (limbs
 * that are glued together and holes lead distances astray), then with fewer and with more samples, among which other
 * hypotheses are made. A cloud leaves open which points touch and which are connected, and a
 * noisy one also where the surface is. What comes out the same as before is not tried again. */
class InterpretationPlan {
public:
  /** \brief A surface prepared in one way, and the share of the usual number of samples that it is to get. */
  struct Attempt {
    PreparedSurface surface;
    float samples = 1.0F;
  };

  /** All that is given is referred to, not copied.
   * \param[in] search of the neighbours of a cloud */
  InterpretationPlan(const Surface& surface, const SymmetryParameters& parameters, const NeighbourSearch& search);

  /** \brief How interpretations of such an input count. */
  Pooling
  pooling() const;

  /** \brief The surface prepared in the next way; none where the rivals are settled or nothing is left to try.
   * \param[in] rivals the interpretations so far, each with its estimate */
  std::optional<Attempt>
  next(const RivalInterpretations& rivals);

private:
  /** Ways that differ in the contact test alone: the usable points are the same. */
  struct Stage {
    NoiseInterpretation noise;
    FaceUse faces;
    std::vector<float> depths; ///< see ContactTest; none: as density and noise allow
    float samples = 1.0F;      ///< see Attempt
  };

  std::vector<Stage>
  furtherStages(const RivalInterpretations& rivals) const;

  const Surface& surface_;
  const SymmetryParameters& parameters_;
  const NeighbourSearch& search_;
  std::vector<Stage> stages_; ///< yet to come, the next one last
  bool is_first_ = true;
  UsablePoints usable_; ///< of the current stage
  /** That of the first stage of a mesh in doubt: cleaning and linking take as long as all the rest where many parts cross. */
  std::optional<PreparedSurface> connected_;
  float samples_ = 1.0F;              ///< of the current stage
  std::vector<ContactTest> contacts_; ///< of the current stage, yet to come, the next one last
  PastInterpretations past_;
};

} // namespace symmetry
} // namespace pcl
