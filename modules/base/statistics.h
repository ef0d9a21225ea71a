/** \file
 * \brief Median and quantiles of numbers.
 */
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The number that a share of them, rounded down, is below; the largest of them where all are; 0 of none. */
template <typename Number>
Number
quantile(std::vector<Number> values, double share)
{
  if (values.empty()) {
    return Number{};
  }
  const auto rank = std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())));
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/** \brief The upper one of the middle two; 0 of none. */
template <typename Number>
Number
median(std::vector<Number> values)
{
  return quantile(std::move(values), 0.5);
}

} // namespace symmetry
} // namespace pcl
