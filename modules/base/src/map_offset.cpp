#include "base/map_offset.h"

#include "base/vector_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

constexpr double float_step = double{std::numeric_limits<float>::epsilon()};

/** \brief Middle and spread of the bulk along one axis. */
struct Bulk {
  double middle = 0.0;
  double spread = 0.0;
};

Bulk
findBulk(std::vector<float> values)
{
  if (values.empty())
    return {};
  std::sort(values.begin(), values.end());
  const std::size_t last = values.size() - 1;
  const std::size_t tail = last / 20; // stray points, for instance zeros where a scanner saw nothing
  return {double{values[last / 2]}, double{values[last - tail]} - double{values[tail]}};
}

} // namespace

std::array<double, 3>
findOffset(const std::vector<Vector3>& points)
{
  constexpr std::size_t sample = 10000;
  constexpr double farthest = 256.0;
  const std::size_t step = points.size() / sample + 1;
  std::array<Bulk, 3> bulks;
  double spread = 0.0;
  double distance = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<float> values;
    for (std::size_t i = 0; i < points.size(); i += step)
      if (isFinite(points[i]))
        values.push_back(points[i][axis]);
    bulks[axis] = findBulk(std::move(values));
    spread = std::max(spread, bulks[axis].spread);
    distance = std::max(distance, std::abs(bulks[axis].middle));
  }

  std::array<double, 3> offset = {0.0, 0.0, 0.0};
  if (distance <= farthest * spread)
    return offset;
  // Rounded to floats the spread may have vanished.
  const double unit = std::exp2(std::floor(std::log2(std::max(spread, distance * float_step))));
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::abs(bulks[axis].middle) > spread)
      offset[axis] = std::round(bulks[axis].middle / unit) * unit;
  return offset;
}

double
stepsAcross(const Surface& surface)
{
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  double farthest = 0.0;
  for (const Vector3& p : surface.points) {
    if (!isFinite(p))
      continue;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], double{p[k]});
      high[k] = std::max(high[k], double{p[k]});
      farthest = std::max(farthest, std::abs(double{p[k]} + surface.offset[k]));
    }
  }
  const double extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  return extent > 0.0 && farthest > 0.0 ? extent / (farthest * float_step) : HUGE_VAL;
}

} // namespace symmetry
} // namespace pcl
