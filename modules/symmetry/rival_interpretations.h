/** \file
 * \brief Interpretations of one surface that contradict each other, and the one that convinces most.
 */
#pragma once

#include "symmetry/interpretation_maps.h"

#include <optional>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief How interpretations that agree or contradict each other count. */
enum class Pooling : char {
  /** Of a cloud: all that have the same map vote for it, each as far as it can be trusted, since noise and contacts make
   * any one uncertain, and wrong ones are wrong in different ways. Refused maps have no vote. A map of a part is the same
   * as one of the whole that agrees with it there. */
  Votes,
  /** Of a mesh, whose faces tell what is connected: the best one speaks for its map, refused or not, since what goes
   * wrong in one (a hypothesis is missing, limbs in contact are one part) tells nothing of the others. Distinct maps
   * exclude each other: the confidence of one is its odds over those of all and of none. */
  Odds
};

/** \brief Interpretations of one surface that contradict each other.
 *
 * Of interpretations with the same map one is kept that explains the whole surface, and one that explains a part. */
class RivalInterpretations {
public:
  explicit RivalInterpretations(Pooling pooling = Pooling::Votes) : pooling_(pooling)
  {
  }

  /** \brief Adds an interpretation to those with the same map, or as a new rival. */
  void
  add(Interpretation interpretation);

  /** \brief Whether the best interpretation is beyond doubt, or the others agree with it, or there is nothing to read. False
   * where there is none.
   *
   * They agree by votes where most of them are sure of its map together; by odds where three have found it, none another one,
   * and it is more likely right than not: further ones find it again. A map of a part settles nothing, as one of those to
   * come may explain the whole. */
  bool
  isSettled() const;

  /** \brief The one for whose map most speaks. There must be one. */
  const Interpretation&
  best() const;

  /** \brief The maps found so far, those for which most speaks first, on another interpretation of the same input: partner
   * of each of its points, no_index where there is none. */
  std::vector<std::vector<Index>>
  mapsOn(const PreparedSurface& surface) const;

  /** \brief Hands over the best one, with the verdict.
   *
   * By odds see Pooling; a map in doubt must have been found by more than half of the interpretations: each is told the maps
   * of those before, and where they choose different ones all the same, none of these is better than the others. By votes its
   * confidence becomes the geometric mean of its own and the mean of all interpretations, in which those that found another map
   * or none count 0: out of many tries at a body without symmetry one may look like some. No symmetry was found if less than
   * 0.25 is left, of a cloud with noise or with points at random places 0.15. Where nothing is left, but closer looks at two of
   * the maps leave out mostly the same part of the surface, the later one of them is handed over, or the earlier one where that
   * is the most trusted of all on what is left (MapEstimate::trust_of_part). */
  Interpretation
  takeBest();

private:
  /** Interpretations with the same map that explain the whole surface, or a part of it. */
  struct Kind {
    std::optional<Interpretation> kept; ///< by odds the most trusted one, by votes that of the least misfit
    std::vector<Vector3> images;        ///< see imagesOfProbes ()
    float trust = 0.0F;                 ///< the largest in any of them
    float evidence = 0.0F;              ///< by odds the largest trust, by votes the sum
    /** The same, but that by votes each counts as its map fits: half as much where distances change twice as much. Whether
     * a part has no counterpart is best told by those that understood best what is connected. */
    float fitting_evidence = 0.0F;
  };

  /** Interpretations with the same map. */
  struct Rival {
    Kind whole;
    Kind part;
    std::size_t interpretations = 0; ///< that found it, refused or not

    /** What the surface is: symmetric as a whole or in part. */
    const Kind&
    kind() const
    {
      const bool is_whole = whole.kept && whole.fitting_evidence >= part.fitting_evidence;
      return is_whole || !part.kept ? whole : part;
    }
  };

  float
  evidenceOf(const Rival& rival) const;

  float
  shareOfOdds(std::size_t rival) const;

  std::size_t
  bestRival() const;

  bool
  isSettledByOdds() const;

  bool
  isSettledByVotes() const;

  void
  addCloserLook(const Interpretation& interpretation);

  Pooling pooling_;
  std::vector<Rival> rivals_;
  std::size_t interpretations_ = 0; ///< added so far
  /** Closer looks at refused maps, what each leaves out: a mark for every point of the input. The maps themselves are large:
   * only two are kept, the most trusted one, and the most trusted one of those found with another look. */
  std::vector<std::vector<char>> left_out_;
  std::optional<Interpretation> looked_at_;
  std::size_t look_at_it_ = 0; ///< number of its look
  std::optional<Interpretation> part_;
};

} // namespace symmetry
} // namespace pcl
