/** \file
 * \brief The ending of a file's name, which says its format.
 */
#pragma once

#include <string>

namespace pcl {
namespace symmetry {

/** \brief Ending of the last part of \a path with its dot, in small letters (".ply"); empty where it has none. */
std::string
fileEnding(const std::string& path);

} // namespace symmetry
} // namespace pcl
