/** \file
 * \brief What the class template hands its work to; not for direct use.
 */
#pragma once

#include <pcl/symmetry/export.h>
#include <pcl/symmetry/symmetry.h>

#include <pcl/PolygonMesh.h>

#include <functional>
#include <vector>

namespace pcl {
namespace symmetry {
namespace detail {

/** \brief The k nearest neighbours of every point: n * k indices, nearest first, -1 where there are fewer. */
using NeighbourSearchFunction = std::function<std::vector<Index>(const std::vector<Vector3>& points, int k)>;

/** \brief Estimates the symmetry of the selected points.
 * \param[in] selection points that take part, each once; null: all
 * \param[in] search for clouds; empty: PCL's kd-tree
 * \throws pcl::BadArgumentException a parameter, an index of the selection or of a triangle is out of range */
PCL_SYMMETRY_EXPORTS SymmetryResult
estimateSelected(const Surface& surface,
                 const std::vector<Index>* selection,
                 const SymmetryParameters& parameters,
                 const NeighbourSearchFunction& search,
                 const ProgressCallback& progress);

/** \brief Polygons as triangle fans.
 * \throws pcl::BadArgumentException a polygon refers to a point that is not there */
PCL_SYMMETRY_EXPORTS std::vector<Triangle>
triangulatePolygons(const PolygonMesh& mesh);

} // namespace detail
} // namespace symmetry
} // namespace pcl
