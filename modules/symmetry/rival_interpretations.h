/** \file
 * \brief Interpretations of one surface that contradict each other, and the one that convinces most.
 */
#pragma once

#include "symmetry/map_estimate.h"
#include "symmetry/surface/prepared_surface.h"

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

} // namespace symmetry
} // namespace pcl
