/** \file
 * \brief Median and quantiles of numbers.
 */
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief quantile (), with the numbers left in another order: for loops that keep the memory from one to the next. */
template <typename Number>
Number
quantileInPlace(std::vector<Number>& values, double share)
{
  if (values.empty()) {
    return Number{};
  }
  const auto rank = std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())));
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/** \brief The number that a share of them, rounded down, is below; the largest of them where all are; 0 of none. */
template <typename Number>
Number
quantile(std::vector<Number> values, double share)
{
  return quantileInPlace(values, share);
}

/** \brief median (), with the numbers left in another order. */
template <typename Number>
Number
medianInPlace(std::vector<Number>& values)
{
  return quantileInPlace(values, 0.5);
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
