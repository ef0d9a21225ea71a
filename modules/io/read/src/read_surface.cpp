#include "io/read/readers.h"

#include <pcl/symmetry/surface_io.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace pcl {
namespace symmetry {
namespace {

Surface
readByEnding(const FileContent& file, const std::string& ending)
{
  if (ending == ".ply")
    return readPly(file);
  if (ending == ".pcd")
    return readPcd(file);
  if (ending == ".obj")
    return readObj(file);
  if (ending == ".off")
    return readOff(file);
  if (ending == ".stl")
    return readStl(file);
  file.fail("unknown ending '" + ending + "': a surface is read from .pcd, .ply, .obj, .off or .stl");
}

/** Refuses points so far from the origin that as floats few steps are left across them: map coordinates, usually. */
void
checkResolution(const FileContent& file, const Surface& surface)
{
  constexpr double fewest_steps = 500.0;
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  double farthest = 0.0;
  for (const Vector3& p : surface.points) {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      continue;
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], double{p[k]});
      high[k] = std::max(high[k], double{p[k]});
      farthest = std::max(farthest, std::abs(double{p[k]}));
    }
  }
  const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  const double step = farthest * double{std::numeric_limits<float>::epsilon()};
  if (extent > 0.0 && extent < fewest_steps * step) {
    std::ostringstream message;
    message << "the points are too far from the origin (" << farthest << ") for their extent (" << extent
            << "): single precision leaves too few digits; move them to the origin";
    file.fail(message.str());
  }
}

} // namespace

Surface
readSurface(const std::string& path)
{
  const FileContent file(path);
  Surface surface = readByEnding(file, fileEnding(path));
  if (surface.points.empty())
    file.fail("holds no point");
  checkResolution(file, surface);
  return surface;
}

} // namespace symmetry
} // namespace pcl
