/** \file
 * \brief Writers of plain surfaces and of ground truth; each file appears whole or not at all.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Throws unless the name ends in .ply, .off, .obj or .pcd, in any letter case.
 *  \throws std::invalid_argument names the ending and those there are */
void
checkSurfaceFileName(const std::string& path);

/** \brief Writes points and triangles: PLY and PCD in binary, OFF and OBJ as text that reads back to the same floats.
 *
 * A PCD file holds the points only. Normals are not written.
 * \throws std::invalid_argument as checkSurfaceFileName
 * \throws std::runtime_error the file cannot be written; the message names it and the reason */
void
writePlainSurface(const std::string& path, const Surface& surface);

/** \brief Writes a line `i s(i)`, counted from 1, for each point i that has a partner s(i).
 *  \throws std::runtime_error the file cannot be written; the message names it and the reason */
void
writeTruth(const std::string& path, const std::vector<Index>& partners);

} // namespace symmetry
} // namespace pcl
