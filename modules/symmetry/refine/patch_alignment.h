/** \file
 * \brief Refinement of a map by the shape of the surface: patch upon mirrored patch.
 */
#pragma once

#include "symmetry/samples/rigid_reflection.h"
#include "symmetry/samples/sampled_surface.h"
#include "symmetry/samples/surface_patch.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Patches of one size. */
struct PatchSize {
  float radius;        ///< geodesic, share of the diameter
  std::size_t patches; ///< centred at the first samples; every sample should lie in a dozen of them
};

/** \brief How far a patch and its image are from mirror images of each other. */
struct PatchFit {
  float distance; ///< root mean square distance after the best reflection, share of the diameter
  float turn;     ///< mean of 1 - cosine between the normals
};

/** \brief The mean of both measures; 0 without fits. */
PatchFit
meanOf(const std::vector<PatchFit>& fits);

/** \brief PatchFit::distance that 98 % of the patches do not reach. */
float
worstDistance(const std::vector<PatchFit>& fits);

/** \brief Slides the partners of samples to where the shape of the surface fits best.
 *
 * Poses bend a body, but between the joints they move it rigidly: a patch is a nearly exact mirror image of its partner
 * patch. In each round a reflection is fitted to every patch and its image; each sample goes to the mean of where the
 * reflections of the patches around it put it, better fits counting more, then to the nearest place of the surface that
 * faces the right way. It is the iterative closest point algorithm (P. Besl, N. McKay, 1992
 * \cite besl1992registration; Y. Chen, G. Medioni, 1992 \cite chen1992modelling)
 * with a reflection that varies over the surface. What is smooth and round (a forearm) stays as the map has it; a nose,
 * an ear or a knee pulls its surroundings into place.
 */
class PatchAlignment {
public:
  /** \param[in] sampled referred to, not copied */
  PatchAlignment(const SampledSurface& sampled, const PatchSize& size);

  /** \brief Improves partners (partner point of every sample) in so many rounds, each followed by one of
   * mutualPartners (). */
  std::vector<Index>
  align(std::vector<Index> partners, int rounds) const;

  /** \brief How well each patch fits its image. */
  std::vector<PatchFit>
  fits(const std::vector<Index>& partners) const;

private:
  /** Where the patches around a sample put its partner. */
  struct WantedPlace {
    Vector3 place{0.0F, 0.0F, 0.0F};
    Vector3 normal{0.0F, 0.0F, 0.0F};
    float weight = 0.0F;
  };

  std::vector<OrientedMatch>
  matchesOf(const SurfacePatch& patch, const std::vector<Index>& partners) const;

  std::vector<WantedPlace>
  wantedPlaces(const std::vector<Index>& partners) const;

  Index
  nearestFacing(Index partner, const WantedPlace& wanted) const;

  const SampledSurface& sampled_;
  const PreparedSurface& surface_;
  const CoarseSurface& coarse_;
  float spacing_; ///< mean distance between adjacent samples
  std::vector<SurfacePatch> patches_;
  std::vector<std::vector<Index>> surroundings_; ///< of each cell: itself and the cells within two steps, ascending
};

} // namespace symmetry
} // namespace pcl
