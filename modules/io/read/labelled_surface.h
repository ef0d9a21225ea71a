/** \file
 * \brief Reads the files that writeLabelledSurface() writes, with what they say about each point.
 */
#pragma once

#include <pcl/PolygonMesh.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A surface with the fields that the result of an estimation adds to it. */
struct LabelledSurface {
  PolygonMesh mesh;                   ///< without polygons for a point cloud
  std::vector<std::int64_t> partners; ///< -1: none
  std::vector<std::int64_t> labels;   ///< values of Side
};

/** \brief Reads a labelled surface, .ply or .pcd in any letter case.
 * \return at least one point; partners and labels are in their ranges
 * \throws pcl::IOException cannot be read, was not written by pcl_intrinsic_symmetry, or holds a number out of range;
 * the message begins with the name of the file
 */
LabelledSurface
readLabelledSurface(const std::string& path);

} // namespace symmetry
} // namespace pcl
