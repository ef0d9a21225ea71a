/** \file
 * \brief What the class template hands its work to; not for direct use.
 */
#pragma once

#include <pcl/symmetry/export.h>
#include <pcl/symmetry/symmetry.h>

#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>
#include <pcl/types.h>

#include <array>
#include <functional>
#include <optional>
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

/** \brief Appends the answer of a search method for one point to the lists of all: k entries, nearest first, -1 where
 * fewer were found. An answer that is not in order is put in order.
 * \param[in] count as the search returned it
 * \throws pcl::BadArgumentException more neighbours than were asked for, or none of the points */
PCL_SYMMETRY_EXPORTS void
appendNeighbours(const std::vector<Vector3>& points,
                 int k,
                 int count,
                 const Indices& found,
                 const std::vector<float>& squared_distances,
                 std::vector<Index>& neighbours);

/** \brief Refuses a cloud whose bytes are not laid out as its fields, sizes and steps say, or that has no float
 * or double x y z.
 * \throws pcl::BadArgumentException says what is wrong */
PCL_SYMMETRY_EXPORTS void
checkLayout(const PCLPointCloud2& cloud);

/** \brief A cloud with float positions, and what was subtracted from them. */
struct MovedCloud {
  PCLPointCloud2 cloud;
  std::array<double, 3> offset{};
};

/** \brief Goes over from double positions to float ones, near the origin where these are map coordinates. Other fields
 * stay as they are.
 * \param[in] cloud see checkLayout ()
 * \return nothing where the positions are floats */
PCL_SYMMETRY_EXPORTS std::optional<MovedCloud>
withFloatPositions(const PCLPointCloud2& cloud);

/** \brief Polygons as triangle fans.
 * \throws pcl::BadArgumentException a polygon refers to a point that is not there */
PCL_SYMMETRY_EXPORTS std::vector<Triangle>
triangulatePolygons(const PolygonMesh& mesh);

} // namespace detail
} // namespace symmetry
} // namespace pcl
