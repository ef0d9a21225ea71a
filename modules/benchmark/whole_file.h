/** \file
 * \brief Writes a file that appears whole or not at all.
 */
#pragma once

#include <string>

namespace pcl {
namespace symmetry {

/** \brief Writes \a content beside \a path and renames it, so that nobody ever sees a part of it.
 * \throws pcl::IOException cannot be written; what stood at \a path is unchanged then
 */
void
writeWholeFile(const std::string& path, const std::string& content);

} // namespace symmetry
} // namespace pcl
