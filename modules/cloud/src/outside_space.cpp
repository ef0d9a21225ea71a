#include "cloud/outside_space.h"

#include "base/vector_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {

OutsideSpace::OutsideSpace(const std::vector<Surfel>& surfels, float cube) : cube_(cube)
{
  constexpr double most_cubes = 1.6e7;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  low_ = {infinity, infinity, infinity};
  Vector3 high{-infinity, -infinity, -infinity};
  for (const Surfel& surfel : surfels) {
    for (int k = 0; k < 3; ++k) {
      low_[k] = std::min(low_[k], surfel.centre[k] - surfel.radius);
      high[k] = std::max(high[k], surfel.centre[k] + surfel.radius);
    }
  }
  const auto cubes_of_edge = [&](float edge) {
    double product = 1.0;
    for (int k = 0; k < 3; ++k) {
      product *= std::ceil(double{high[k] - low_[k]} / double{edge}) + 2.0;
    }
    return product;
  };
  while (cubes_of_edge(cube_) > most_cubes) {
    cube_ *= 1.1F;
  }
  // One layer of cubes around all, where the flood begins.
  for (int k = 0; k < 3; ++k) {
    low_[k] -= cube_;
  }
  counts_ = cubeAt(high);
  for (std::ptrdiff_t& count : counts_) {
    count += 2;
  }
  cubes_.assign(static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]), Cube::Free);
  for (const Surfel& surfel : surfels) {
    occupy(surfel);
  }
  flood();
}

bool
OutsideSpace::contains(const Vector3& place) const
{
  const auto c = cubeAt(place);
  return !isWithin(c) || cubes_[number(c)] == Cube::Outside;
}

std::array<std::ptrdiff_t, 3>
OutsideSpace::cubeAt(const Vector3& place) const
{
  std::array<std::ptrdiff_t, 3> c{};
  for (int k = 0; k < 3; ++k) {
    c[k] = static_cast<std::ptrdiff_t>(std::floor((place[k] - low_[k]) / cube_));
  }
  return c;
}

bool
OutsideSpace::isWithin(const std::array<std::ptrdiff_t, 3>& c) const
{
  return c[0] >= 0 && c[0] < counts_[0] && c[1] >= 0 && c[1] < counts_[1] && c[2] >= 0 && c[2] < counts_[2];
}

std::size_t
OutsideSpace::number(const std::array<std::ptrdiff_t, 3>& c) const
{
  return static_cast<std::size_t>((c[2] * counts_[1] + c[1]) * counts_[0] + c[0]);
}

void
OutsideSpace::occupy(const Surfel& surfel)
{
  const Vector3& n = surfel.normal;
  const Vector3 across = std::abs(n[0]) < 0.6F ? Vector3{1.0F, 0.0F, 0.0F} : Vector3{0.0F, 1.0F, 0.0F};
  const Vector3 u = normalized(cross(n, across));
  const Vector3 v = cross(n, u);
  const auto steps = static_cast<int>(std::ceil(2.0F * surfel.radius / cube_));
  const float step = surfel.radius / static_cast<float>(std::max(1, steps));
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      if (i * i + j * j <= steps * steps) {
        cubes_[number(cubeAt(surfel.centre + static_cast<float>(i) * step * u + static_cast<float>(j) * step * v))] =
            Cube::Occupied;
      }
    }
  }
}

void
OutsideSpace::flood()
{
  std::vector<std::array<std::ptrdiff_t, 3>> front{{0, 0, 0}};
  cubes_[0] = Cube::Outside;
  while (!front.empty()) {
    const std::array<std::ptrdiff_t, 3> c = front.back();
    front.pop_back();
    for (int k = 0; k < 3; ++k) {
      for (const std::ptrdiff_t step : {-1, 1}) {
        std::array<std::ptrdiff_t, 3> next = c;
        next[k] += step;
        if (isWithin(next) && cubes_[number(next)] == Cube::Free) {
          cubes_[number(next)] = Cube::Outside;
          front.push_back(next);
        }
      }
    }
  }
}

} // namespace symmetry
} // namespace pcl
