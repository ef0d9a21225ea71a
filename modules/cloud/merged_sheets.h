/** \file
 * \brief Layers of points where two sheets of a surface have merged, since parts of the body touch there.
 */
#pragma once

#include "cloud/outside_space.h"
#include "geodesic/neighbour_graph.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What is on the two sides of a layer of points. */
enum class Sides {
  Alike,   ///< the outside is as near on both: a thin part
  Outside, ///< one side is outside
  Inside   ///< neither is: two parts touch here
};

/** \brief Both sides of the layer at each of some places. */
struct LayerSides {
  std::vector<Sides> sides;     ///< empty where the surface encloses nothing
  std::vector<Vector3> normals; ///< turned outwards where that can be told
  float clearance = 0.0F;       ///< how near to the surface the outside can be told from the inside
};

/** \brief Looks from places along their normals for the outside.
 *
 * Cubes of the space become larger, and close wider holes, until nine of ten places have an inside.
 *
 * \param[in] surface that may enclose a body
 * \param[in] normals of either sign
 * \param[in] spacing of the places */
LayerSides
lookToBothSides(const std::vector<Surfel>& surface,
                const std::vector<Vector3>& places,
                std::vector<Vector3> normals,
                float spacing);

/** \brief The first k neighbours of each place whose normals do not oppose its own: those on its own sheet.
 * \param[in] lists of more neighbours, nearest first */
NeighbourLists
neighboursOnOwnSheet(const NeighbourLists& lists, const std::vector<Vector3>& normals, std::size_t k);

} // namespace symmetry
} // namespace pcl
