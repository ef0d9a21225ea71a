/** \file
 * \brief Reads a symmetric map from the CSV file that the programs write.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Reads lines `vertex,partner[,...]`, 0-based; partner -1 or an absent vertex: no partner.
 *
 * Commas, semicolons or blanks separate; lines that begin with # are skipped, and so is a header in the first of the
 * others. The last line of a vertex counts.
 * \param[in] path file to read
 * \param[in] vertices points of the surface that the map belongs to
 * \return one partner per point
 * \throws pcl::IOException cannot be read, is no such table, or an index is out of range
 */
std::vector<Index>
readMap(const std::string& path, std::size_t vertices);

} // namespace symmetry
} // namespace pcl
