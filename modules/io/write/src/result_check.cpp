#include "io/write/result_check.h"

#include <pcl/symmetry/impl/plain_exception.h>

#include <pcl/exceptions.h>

#include <cmath>
#include <string>

namespace pcl {
namespace symmetry {
namespace {

void
checkSize(const char* name, std::size_t size, std::size_t points)
{
  if (size != points)
    throw detail::PlainException<BadArgumentException>(std::string("the result has ") + std::to_string(size) + " " +
                                                       name + " for " + std::to_string(points) + " points");
}

void
checkIndex(const char* name, Index index, Index least, std::size_t points)
{
  if (index < least || (index >= 0 && static_cast<std::size_t>(index) >= points))
    throw detail::PlainException<BadArgumentException>(std::string("the result has ") + name + " " +
                                                       std::to_string(index) + " for " + std::to_string(points) +
                                                       " points");
}

void
checkNumbers(const char* name, const std::vector<float>& values)
{
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw detail::PlainException<BadArgumentException>(std::string("the result has ") + name + " " +
                                                         std::to_string(values[i]) + " for point " + std::to_string(i));
}

template <typename Enum>
void
checkLabels(const char* name, const std::vector<Enum>& labels, Enum last)
{
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] > last)
      throw detail::PlainException<BadArgumentException>(
          std::string("the result has ") + name + " " + std::to_string(static_cast<int>(labels[i])) + " for point " +
          std::to_string(i) + ", allowed are 0 to " + std::to_string(static_cast<int>(last)));
}

} // namespace

void
checkResult(const SymmetryResult& result, std::size_t points)
{
  checkSize("partners", result.partners.size(), points);
  checkSize("confidences", result.confidences.size(), points);
  checkSize("support values", result.support.size(), points);
  checkSize("sides", result.sides.size(), points);
  checkSize("regions", result.regions.size(), points);
  checkNumbers("confidence", result.confidences);
  checkNumbers("support", result.support);
  checkLabels("side", result.sides, Side::Axis);
  checkLabels("region", result.regions, Region::Centre);
  for (const Index partner : result.partners)
    checkIndex("partner", partner, no_index, points);
  for (const SymmetricMatch& match : result.matches) {
    checkIndex("source", match.source, 0, points);
    checkIndex("target", match.target, 0, points);
    checkIndex("midpoint", match.midpoint, no_index, points);
  }
  for (const Polyline& line : result.axis) {
    for (const Index index : line.points)
      checkIndex("axis point", index, 0, points);
    for (const AxisPoint& point : line.curve)
      checkIndex("axis point", point.nearest, 0, points);
  }
}

} // namespace symmetry
} // namespace pcl
