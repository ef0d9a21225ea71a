#include "io/read/surface_builder.h"

namespace pcl {
namespace symmetry {
namespace {

void
appendTriangle(Index a, Index b, Index c, std::vector<Triangle>& triangles)
{
  if (a != b && b != c && c != a)
    triangles.push_back({a, b, c});
}

} // namespace

void
appendPolygon(const std::vector<Index>& corners, std::vector<Triangle>& triangles)
{
  for (std::size_t i = 2; i < corners.size(); ++i)
    appendTriangle(corners[0], corners[i - 1], corners[i], triangles);
}

void
appendStrip(const std::vector<Index>& corners, std::vector<Triangle>& triangles)
{
  std::size_t begin = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] == no_index)
      begin = i + 1;
    else if (i >= begin + 2 && (i - begin) % 2 == 0)
      appendTriangle(corners[i - 2], corners[i - 1], corners[i], triangles);
    else if (i >= begin + 2)
      appendTriangle(corners[i - 1], corners[i - 2], corners[i], triangles);
  }
}

} // namespace symmetry
} // namespace pcl
