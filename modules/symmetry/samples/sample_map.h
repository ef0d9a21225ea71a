/** \file
 * \brief A map among the samples of a surface.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Partner of every sample (or of every landmark): a map as plain numbers. */
using SampleMap = std::vector<Index>;

} // namespace symmetry
} // namespace pcl
