/** \file
 * \brief Images as PNG.
 */
#pragma once

#include "picture/rasterizer.h"

#include <string>

namespace pcl {
namespace symmetry {

/** \brief The bytes of a PNG file, 8 bits per channel. */
std::string
encodePng(const Image& image);

} // namespace symmetry
} // namespace pcl
