/** \file
 * \brief Changes of a model that must not change its symmetry.
 */
#pragma once

#include "benchmark/disturbance.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What is changed; in the order in which a few of them are taken. */
enum class Variant : char {
  AsItIs,       ///< nothing
  Shuffled,     ///< vertices and faces in random order
  Half,         ///< edges collapsed, the shortest first, to half of the vertices
  Noisy,        ///< vertices moved by a thousandth of the bounding box's diagonal (standard deviation)
  MoreSamples,  ///< a fifth more samples than usual
  Stretched,    ///< 3 % longer along a random direction
  Third,        ///< as Half, to a third of the vertices
  FewerSamples, ///< a fifth fewer samples than usual
  Mirrored,     ///< the mirror image, faces turned over
  Smoothed,     ///< every vertex halfway towards the mean of its neighbours
  Subdivided    ///< each face into four
};

/** \brief Its name in tables; empty for the one that changes nothing. */
const char*
toString(Variant variant);

/** \brief How many there are, without the one that changes nothing. */
constexpr std::size_t variant_count = 10;

/** \brief Number of samples of the estimation, as a multiple of the usual one. */
float
samplesOf(Variant variant);

/** \brief A changed surface, and which point stands for which. */
struct VariedSurface {
  Surface surface;
  std::vector<Index> origins;   ///< per point of \a surface: the point before that it is nearest to
  std::vector<Index> stand_ins; ///< per point before: the point of \a surface that stands for it
};

/** \brief Changes a mesh; the same seed gives the same bytes.
 *
 * Edges on a boundary and where the mesh is no manifold are not collapsed. Cost: n log n. */
VariedSurface
vary(const Surface& mesh, Variant variant, std::uint64_t seed);

} // namespace symmetry
} // namespace pcl
