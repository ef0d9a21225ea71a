/** \file
 * \brief Strict readers of surfaces and writers of labelled results; component `io`.
 *
 * Every writer makes its file appear whole or not at all: it writes beside the place, waits for the disk and renames at
 * the end; a link is followed. What cannot be replaced is written to directly: a device, a pipe, "-", which is standard
 * output (all but pictures and files whose format follows from the ending), and descriptors that are open already
 * (/dev/stdout). All functions may be called from several
 * threads at once, as long as no two of them write the same file. Cost is linear in the size of the file unless said
 * otherwise.
 */
#pragma once

#include <pcl/symmetry/export.h>
#include <pcl/symmetry/name_reference.h>
#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_parameters.h>
#include <pcl/symmetry/symmetry_result.h>

#include <string>

namespace pcl {
namespace symmetry {

/** \brief Ending of the last part of \a path with its dot, in small letters (".ply"); empty where it has none.
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS std::string
fileEnding(const std::string& path);

/** \brief Reads a surface from a .pcd, .ply, .obj, .off, .stl, .vtk or .xyz (.txt, .asc, .pts) file, any letter case of the
 * ending, also compressed by gzip with .gz behind.
 *
 * - PCD: ascii, binary and binary_compressed; fields x y z and normal_x normal_y normal_z of any number type.
 * - PLY: ascii and binary of both byte orders; x y z and nx ny nz of any type, faces, triangle strips.
 * - OBJ: v, f and fo in all forms, and vn where each point has the normal of its own number.
 * - OFF: text and binary, with the prefixes ST, C, N, 4 and n.
 * - XYZ: rows of numbers, x y z and perhaps normal, colour and others, with or without names of the columns.
 * - VTK: legacy files of polygons or of cells that are polygons, ascii and binary.
 * - Where the library is built with assimp: .glb, .gltf and .3mf.
 * - STL: ascii and binary; equal positions become one point, numbered in the order of their first appearance.
 *
 * Common dialects are read as well: doc/formats.md. Other fields of the points are kept in Surface::fields (PCD, PLY);
 * other elements and keywords are passed over, and Surface::notes says what else was.
 *
 * Positions far from the origin for their spread, as in map coordinates, are read in double precision, and an offset is
 * subtracted: Surface::offset. Such a file is read twice.
 *
 * Points keep their number and order (but in STL), and
 * duplicates, unused and non-finite points are kept: nan and inf are numbers, and what is too large for a float is
 * infinite. Polygons become triangle fans around their first corner. Faces of fewer than three corners, and triangles
 * with two equal corners, have no area and are left out.
 *
 * \param[in] path a regular file; "-" is standard input, which needs a format
 *
 * \return at least one point; normals where the file has one per point
 *
 * \throws pcl::IOException cannot be opened, has another ending, is empty, truncated or malformed, holds floats too far
 * from the origin for their precision, promises more than it can hold, unpacks to more than 64 MB and 32 times its size,
 * or has a face with a point that is not there; the message names file, line (from 1) or byte (from 0), and reason
 *
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS Surface
readSurface(const std::string& path);

/** \brief As above, where the name does not tell the format.
 * \param[in] format pcd, ply, obj, off, stl, vtk or xyz, whatever the ending; compressed by gzip or not. Empty: by the ending
 * \throws pcl::IOException as above
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS Surface
readSurface(const std::string& path, const std::string& format);

/** \brief Reads a surface that writeLabelledSurface() wrote, for others to take the names of their sides from.
 *
 * Of other programs' files integer fields \a label (1 and 2: the sides) and \a partner (0-based, -1: none) are enough.
 * \param[in] path a .ply or .pcd file, also compressed by gzip
 * \param[in] threads 0: all cores
 * \throws pcl::IOException as readSurface(), or the file has no such fields, or NameReference refuses what it holds
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS NameReference
readNameReference(const std::string& path, unsigned threads = 0);

/** \brief Throws unless a file can be made at \a path, or be replaced; leaves all as it was.
 *
 * For programs that compute long before they write. Nothing ensures that writing succeeds later.
 * \throws pcl::IOException the folder is missing or cannot be written to; names file and reason
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS void
checkWritable(const std::string& path);

/** \brief Removes what the writers of this process have begun and not ended, for handlers of signals that end it.
 *
 * May be called from a signal handler: it calls nothing but unlink (). The process must not write afterwards. The library
 * handles no signal itself. What stays behind after a SIGKILL, a hidden file beside the one that was to be written, is
 * removed by the next writer of the same file.
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS void
removeUnfinishedFiles() noexcept;

/** \brief Writes the labelled surface as binary .ply (with faces) or .pcd.
 *
 * Per point: x y z, its normal where the surface has normals, colour of the side, label (uint, see Side), partner (int,
 * -1: none), confidence (float), region (uchar, see Region), and the fields of the input: one that has a name of ours
 * gets "input_" in front. pcl::io::loadPCDFile and loadPLYFile read it into PointXYZL and PointXYZRGBL. Where the surface
 * has an offset it is added again, and x y z are doubles: floats would not reach. PCL's point types do not take those;
 * pcl::PCLPointCloud2 does.
 * \throws pcl::IOException cannot be written, or the ending is neither .ply nor .pcd
 * \throws pcl::BadArgumentException the result does not belong to the surface: another number of points, or an index
 * out of range
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS void
writeLabelledSurface(const std::string& path, const Surface& surface, const SymmetryResult& result);

/** \brief Writes `vertex,partner,confidence`, one line per input point, 0-based, partner -1 where there is none.
 * Numbers read back as they were.
 *
 * \throws pcl::IOException cannot be written
 *
 * \throws pcl::BadArgumentException the arrays of the result differ in length, or an index is out of range
 *
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS void
writeMap(const std::string& path, const SymmetryResult& result);

/** \brief Writes the sparse matches `source,target,midpoint,cost`, 0-based, midpoint -1 where there is none.
 * \throws pcl::IOException cannot be written
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS void
writeCorrespondences(const std::string& path, const SymmetryResult& result);

/** \brief Writes the axis curve as binary .ply (vertices and edges; a closed polyline has the edge that closes it),
 * .pcd or .csv.
 *
 * The places of Polyline::curve in the order of the polylines. Positions are as in writeLabelledSurface(). Each has the
 * normal of the surface, the direction across the curve towards the source side, the arc length, \a index, the number
 * of the nearest point of the surface, and \a curve, the number of its polyline; in CSV also whether that is closed.
 * Without an axis the file has no places.
 * \throws pcl::IOException cannot be written, or the ending is none of .ply, .pcd and .csv
 * \throws pcl::BadArgumentException the result does not belong to the surface
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS void
writeAxis(const std::string& path, const Surface& surface, const SymmetryResult& result);

/** \brief Writes the report: one JSON object.
 *
 * Keys: status, message, confidence, diameter, input, map, matches (their number), mirror_plane (where there is a dense
 * map), side_names (where they are those of a reference), alternatives and rotations (only
 * where there are several reflections; see SymmetryResult), parameters, seconds (steps in order, and their sum as
 * total), version. A number that is not finite is null.
 *
 * \param[in] path file to write
 *
 * \param[in] input_file name of the input as it is to appear in the report; what is not UTF-8 is replaced
 *
 * \param[in] parameters all that were in force
 * \param[in] result what was found, with the seconds per step, and in InputSummary::notes those of the reader
 * \throws pcl::IOException cannot be written
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS void
writeReport(const std::string& path,
            const std::string& input_file,
            const SymmetryParameters& parameters,
            const SymmetryResult& result);

/** \brief Writes the report of a run that ended before there was a result, such as of a file that cannot be read: keys
 * status ("failed"), message, input (file), parameters and version.
 * \throws pcl::IOException cannot be written
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS void
writeFailureReport(const std::string& path,
                   const std::string& input_file,
                   const SymmetryParameters& parameters,
                   const std::string& reason);

/** \brief Renders front and back of the surface side by side as .png: sides, axis, about forty partner lines. Needs no
 * display.
 *
 * Source side blue, target side orange, both paler where the confidence is low; axis dark red; grey where there is no
 * side. The view is chosen so that both sides are seen.
 * \throws pcl::IOException cannot be written, or the ending is not .png
 * \throws pcl::BadArgumentException the result does not belong to the surface
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS void
writePicture(const std::string& path, const Surface& surface, const SymmetryResult& result);

} // namespace symmetry
} // namespace pcl
