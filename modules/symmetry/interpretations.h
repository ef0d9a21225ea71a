/** \file
 * \brief Ways to read a surface, and the one whose symmetry convinces most.
 */
#pragma once

#include "cloud/cloud_surface.h"
#include "geodesic/neighbour_graph.h"
#include "symmetry/map_estimate.h"
#include "symmetry/step_timer.h"
#include "symmetry/surface/prepared_surface.h"

#include <pcl/symmetry/symmetry_parameters.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A surface as it was understood, and its symmetry. */
struct Interpretation {
  PreparedSurface surface;
  MapEstimate estimate;
};

/** \brief Interpretations of one surface that contradict each other.
 *
 * Of interpretations with the same map only the one with the highest confidence is kept, but all speak for it: noise
 * and contacts make any one interpretation uncertain, and wrong ones are wrong in different ways. */
class RivalInterpretations {
public:
  /** \brief Adds an interpretation to those with the same map, or as a new rival. */
  void
  add(Interpretation interpretation);

  /** \brief Whether the best interpretation is beyond doubt, or most of those added are sure of its map together, or
   * there is nothing to read. False where there is none. */
  bool
  isSettled() const;

  /** \brief The one with the highest sum of confidences; of several that found no symmetry the one closest to it. There
   * must be one. */
  const Interpretation&
  best() const;

  /** \brief Hands over the best one.
   *
   * Its confidence becomes the geometric mean of its own and the mean of all interpretations, in which those that found
   * another map or none count 0: out of many tries at a body without symmetry one may look like some. No symmetry was
   * found if less than 0.25 is left, of a mesh with many holes 0.2, of a cloud with noise or with points at random
   * places 0.15. */
  Interpretation
  takeBest();

private:
  struct Rival {
    Interpretation interpretation;
    std::vector<Vector3> images; ///< of some points of the input; empty if there is no dense map
    float evidence = 0.0F;       ///< sum of confidences, 0 without symmetry
  };

  std::size_t
  bestRival() const;

  std::vector<Rival> rivals_;
  std::size_t interpretations_ = 0; ///< added so far
};

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

/** \brief Reads a surface in one way after another until the result is settled.
 *
 * A mesh is read once; in doubt, if there are holes in it, also as the cloud of its vertices: holes part what belongs
 * together and lead distances astray. A cloud leaves open which points touch and which are connected, and a noisy one
 * also where the surface is.
 *
 * \param[out] summary what was used, also if the timer cancels
 * \throws Cancelled by the timer */
Interpretation
bestInterpretation(const Surface& surface,
                   const SymmetryParameters& parameters,
                   const NeighbourSearch& search,
                   StepTimer& timer,
                   InputSummary& summary);

} // namespace symmetry
} // namespace pcl
