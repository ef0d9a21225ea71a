#include "io/write/result_check.h"

#include <pcl/exceptions.h>

#include <string>

namespace pcl {
namespace symmetry {
namespace {

void
checkSize(const char* name, std::size_t size, std::size_t points)
{
  if (size != points)
    throw BadArgumentException(std::string("the result has ") + std::to_string(size) + " " + name + " for " +
                               std::to_string(points) + " points");
}

void
checkIndex(const char* name, Index index, Index least, std::size_t points)
{
  if (index < least || (index >= 0 && static_cast<std::size_t>(index) >= points))
    throw BadArgumentException(std::string("the result has ") + name + " " + std::to_string(index) + " for " +
                               std::to_string(points) + " points");
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
