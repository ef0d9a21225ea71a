/** \file
 * \brief Strict readers of surfaces and writers of labelled results; component `io`.
 */
#pragma once

#include <pcl/symmetry/export.h>
#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_parameters.h>
#include <pcl/symmetry/symmetry_result.h>

#include <string>

namespace pcl {
namespace symmetry {

/** \brief Reads a surface from a .pcd, .ply, .obj, .off or .stl file, any letter case.
 *
 * Faces are read where the file has them, polygons become triangle fans, normals are kept where the file has one per
 * point. Vertices keep their number and order, except in STL files, where equal positions become one vertex.
 * \param[in] path file to read
 * \throws pcl::IOException cannot be opened, is no such file, is truncated, has a face with a vertex that is not there;
 * the message names the file, the line or byte, and the reason
 */
PCL_SYMMETRY_EXPORTS Surface
readSurface(const std::string& path);

/** \brief Writes the labelled surface as .ply (with faces) or .pcd: x y z, rgb, label, partner, confidence, region.
 *
 * As every writer here: the file appears whole or not at all (it is written beside its place and then renamed).
 * \throws pcl::IOException cannot be written, or the ending is neither .ply nor .pcd
 */
PCL_SYMMETRY_EXPORTS void
writeLabelledSurface(const std::string& path, const Surface& surface, const SymmetryResult& result);

/** \brief Writes `vertex,partner,confidence`, one line per input point, 0-based, partner -1 where there is none.
 * \throws pcl::IOException */
PCL_SYMMETRY_EXPORTS void
writeMap(const std::string& path, const SymmetryResult& result);

/** \brief Writes the sparse matches `source,target,midpoint,cost`.
 * \throws pcl::IOException */
PCL_SYMMETRY_EXPORTS void
writeCorrespondences(const std::string& path, const SymmetryResult& result);

/** \brief Writes the axis curve as .ply (vertices and edges) or .pcd (points in order).
 * \throws pcl::IOException */
PCL_SYMMETRY_EXPORTS void
writeAxis(const std::string& path, const Surface& surface, const SymmetryResult& result);

/** \brief Writes the report: one JSON object.
 * \param[in] path file to write
 * \param[in] input_file name of the input as it is to appear in the report
 * \param[in] parameters all that were in force
 * \param[in] result what was found, with the seconds per step
 * \throws pcl::IOException */
PCL_SYMMETRY_EXPORTS void
writeReport(const std::string& path,
            const std::string& input_file,
            const SymmetryParameters& parameters,
            const SymmetryResult& result);

/** \brief Renders front and back of the surface side by side: sides, axis, partner lines. Needs no display.
 * \throws pcl::IOException */
PCL_SYMMETRY_EXPORTS void
writePicture(const std::string& path, const Surface& surface, const SymmetryResult& result);

} // namespace symmetry
} // namespace pcl
