/** \file
 * \brief Interpretations of one surface that contradict each other, and the one that convinces most.
 */
#pragma once

#include "symmetry/map_estimate.h"
#include "symmetry/surface/prepared_surface.h"

#include <optional>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A surface as it was understood, and its symmetry. */
struct Interpretation {
  PreparedSurface surface;
  MapEstimate estimate;
};

/** \brief How interpretations that agree or contradict each other count. */
enum class Pooling : char {
  /** Of a cloud: all that have the same map vote for it, since noise and contacts make any one uncertain, and wrong
   * ones are wrong in different ways. Refused maps have no vote. */
  Votes,
  /** Of a mesh, whose faces tell what is connected: the best one speaks for its map, refused or not, since what goes
   * wrong in one (a hypothesis is missing, limbs in contact are one part) tells nothing of the others. Distinct maps
   * exclude each other: the confidence of one is its odds over those of all and of none. */
  Odds
};

/** \brief Interpretations of one surface that contradict each other.
 *
 * Of interpretations with the same map only the one with the highest confidence is kept. */
class RivalInterpretations {
public:
  explicit RivalInterpretations(Pooling pooling = Pooling::Votes) : pooling_(pooling)
  {
  }

  /** \brief Adds an interpretation to those with the same map, or as a new rival. */
  void
  add(Interpretation interpretation);

  /** \brief Whether the best interpretation is beyond doubt, or (by votes) most of those added are sure of its map
   * together, or there is nothing to read. False where there is none. */
  bool
  isSettled() const;

  /** \brief The one with the highest sum of confidences; of several that found no symmetry the one closest to it. There
   * must be one. */
  const Interpretation&
  best() const;

  /** \brief Hands over the best one, with the verdict.
   *
   * By odds see Pooling. By votes its confidence becomes the geometric mean of its own and the mean of all
   * interpretations, in which those that found another map or none count 0: out of many tries at a body without symmetry
   * one may look like some. No symmetry was found if less than 0.25 is left, of a mesh with many holes 0.2, of a cloud
   * with noise or with points at random places 0.15. */
  Interpretation
  takeBest();

private:
  void
  takeVotes(Interpretation& interpretation, float evidence) const;

  static void
  takeOdds(Interpretation& interpretation, float confidence);

  float
  shareOfOdds(std::size_t rival) const;

  struct Rival {
    Interpretation interpretation;
    std::vector<Vector3> images; ///< of some points of the input; empty if there is no dense map
    bool is_found = false;       ///< there is a map that counts
    float confidence = 0.0F;     ///< of the interpretation that is kept
    float evidence = 0.0F;       ///< sum of confidences, 0 without symmetry; by odds the largest of them
  };

  std::size_t
  bestRival() const;

  Pooling pooling_;
  std::vector<Rival> rivals_;
  std::optional<Interpretation> partial_; ///< by votes: the one with the most trusted partial map
  std::size_t interpretations_ = 0;       ///< added so far
};

} // namespace symmetry
} // namespace pcl
