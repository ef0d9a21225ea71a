#include "symmetry/mirror/distance_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** Squared distances along a line from given ones: the lower envelope of parabolas (P. Felzenszwalb,
 * D. Huttenlocher, 2012 \cite felzenszwalb2012distance). */
class LineTransform {
public:
  explicit LineTransform(std::size_t size) : roots_(size), borders_(size + 1), values_(size)
  {
  }

  /** The values, to be set before and read afterwards. */
  std::vector<float>&
  values()
  {
    return values_;
  }

  void
  run()
  {
    const std::vector<float> before = values_;
    std::size_t last = 0;
    roots_[0] = 0;
    borders_[0] = -far;
    borders_[1] = far;
    for (std::size_t q = 1; q < before.size(); ++q) {
      float border = crossing(before, q, roots_[last]);
      while (border <= borders_[last]) {
        --last;
        border = crossing(before, q, roots_[last]);
      }
      ++last;
      roots_[last] = q;
      borders_[last] = border;
      borders_[last + 1] = far;
    }
    std::size_t k = 0;
    for (std::size_t q = 0; q < before.size(); ++q) {
      while (borders_[k + 1] < static_cast<float>(q)) {
        ++k;
      }
      const float apart = static_cast<float>(q) - static_cast<float>(roots_[k]);
      values_[q] = apart * apart + before[roots_[k]];
    }
  }

private:
  static constexpr float far = 1e12F;

  static float
  crossing(const std::vector<float>& f, std::size_t q, std::size_t r)
  {
    const auto x = static_cast<float>(q);
    const auto y = static_cast<float>(r);
    return (f[q] + x * x - f[r] - y * y) / (2.0F * (x - y));
  }

  std::vector<std::size_t> roots_;
  std::vector<float> borders_;
  std::vector<float> values_;
};

constexpr float nowhere = 1e8F; // cubes squared, more than any grid holds

} // namespace

DistanceGrid::DistanceGrid(const std::vector<Vector3>& points, std::size_t cells)
{
  const BoundingBox box = boundingBox(points);
  low_ = box.low;
  const auto longest = static_cast<float>(box.longestSide());
  cell_ = longest > 0.0F ? longest / static_cast<float>(cells) : 1.0F;
  std::size_t all = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    size_[k] = static_cast<std::size_t>((box.high[k] - box.low[k]) / cell_) + 1;
    all *= size_[k];
  }
  squared_.assign(all, nowhere);
  for (const Vector3& p : points) {
    std::array<std::size_t, 3> c{};
    for (std::size_t k = 0; k < 3; ++k) {
      c[k] = std::min(size_[k] - 1, static_cast<std::size_t>(std::max(0.0F, (p[k] - low_[k]) / cell_)));
    }
    squared_[(c[2] * size_[1] + c[1]) * size_[0] + c[0]] = 0.0F;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    transformAlong(axis);
  }
}

void
DistanceGrid::transformAlong(std::size_t axis)
{
  const std::array<std::size_t, 3> strides{1, size_[0], size_[0] * size_[1]};
  const std::size_t a = (axis + 1) % 3;
  const std::size_t b = (axis + 2) % 3;
  LineTransform line(size_[axis]);
  for (std::size_t i = 0; i < size_[a]; ++i) {
    for (std::size_t j = 0; j < size_[b]; ++j) {
      const std::size_t first = i * strides[a] + j * strides[b];
      for (std::size_t q = 0; q < size_[axis]; ++q) {
        line.values()[q] = squared_[first + q * strides[axis]];
      }
      line.run();
      for (std::size_t q = 0; q < size_[axis]; ++q) {
        squared_[first + q * strides[axis]] = line.values()[q];
      }
    }
  }
}

float
DistanceGrid::at(const Vector3& place) const
{
  std::array<std::size_t, 3> c{};
  float outside = 0.0F;
  for (std::size_t k = 0; k < 3; ++k) {
    const float position = (place[k] - low_[k]) / cell_;
    const float last = static_cast<float>(size_[k]) - 1e-3F;
    const float inside = std::clamp(position, 0.0F, last);
    outside += (position - inside) * (position - inside);
    c[k] = static_cast<std::size_t>(inside);
  }
  return cell_ * (std::sqrt(squared_[(c[2] * size_[1] + c[1]) * size_[0] + c[0]]) + std::sqrt(outside));
}

} // namespace symmetry
} // namespace pcl
