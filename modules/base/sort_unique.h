/** \file
 * \brief A list as a set.
 */
#pragma once

#include <algorithm>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Sorts a list and leaves one of those that are equal. */
template <typename Value>
void
sortUnique(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace symmetry
} // namespace pcl
