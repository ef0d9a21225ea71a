/** \file
 * \brief Maps of interpretations of one input, whose points differ, compared and carried over.
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

/** \brief Partner of every point of the input, no_index where there is none. */
std::vector<Index>
mapOfInput(const Interpretation& interpretation);

/** \brief A mark for every point of the input that has no counterpart (MapEstimate::is_unsupported); none for those that
 * take no part. */
std::vector<char>
unsupportedInInput(const Interpretation& interpretation);

/** \brief Partner of every point of another interpretation of the same input, no_index where there is none. */
std::vector<Index>
mapOnSurface(const PreparedSurface& surface, const Interpretation& interpretation);

/** \brief Where points go whose partners are these; not a number where they go nowhere. */
std::vector<Vector3>
imagesOf(const PreparedSurface& surface, const std::vector<Index>& partners);

/** \brief Which part of a map is asked for. */
enum class MapPart : char {
  Whole,
  Supported ///< what has a counterpart
};

/** \brief Where some evenly numbered points of the input go; not a number where they go nowhere. Empty without a dense map. */
std::vector<Vector3>
imagesOfProbes(const Interpretation& interpretation, MapPart part);

/** \brief Whether most of those points go to the same places in both; so they do where there are none. */
bool
areAlike(const std::vector<Vector3>& a, const std::vector<Vector3>& b);

} // namespace symmetry
} // namespace pcl
