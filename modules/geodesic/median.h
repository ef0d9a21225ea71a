/** \file
 * \brief Median of numbers.
 */
#pragma once

#include <algorithm>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The upper one of the middle two; 0 of none. */
template <typename Number>
Number
median(std::vector<Number> values)
{
  if (values.empty()) {
    return Number{};
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace symmetry
} // namespace pcl
