#include "cloud/outside_space.h"

#include "base/bounding_box.h"
#include "base/heartbeat.h"
#include "base/tangent_frame.h"
#include "base/vector_math.h"
#include "cloud/cloud_settings.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr SheetSettings settings{};

} // namespace

OutsideSpace::OutsideSpace(const std::vector<Surfel>& surfels, float cube) : cube_(cube)
{
  BoundingBox box;
  for (const Surfel& surfel : surfels) {
    const Vector3 reach{surfel.radius, surfel.radius, surfel.radius};
    box.extend(surfel.centre - reach);
    box.extend(surfel.centre + reach);
  }
  low_ = box.low;
  const auto cubes_of_edge = [&](float edge) {
    double product = 1.0;
    for (int k = 0; k < 3; ++k) {
      product *= std::ceil(double{box.high[k] - low_[k]} / double{edge}) + 2.0;
    }
    return product;
  };
  while (cubes_of_edge(cube_) > settings.maximum_cubes) {
    cube_ *= settings.cube_growth;
  }
  // One layer of cubes around all, where the flood begins.
  for (int k = 0; k < 3; ++k) {
    low_[k] -= cube_;
  }
  counts_ = cubeAt(box.high);
  for (std::ptrdiff_t& count : counts_) {
    count += 2;
  }
  cubes_.assign(static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]), Cube::Free);
  for (const Surfel& surfel : surfels) {
    heartbeat();
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
  constexpr float steep = 0.6F;
  const auto [u, v] = tangentFrame(surfel.normal, steep);
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
  constexpr std::size_t beat_every = 4096;
  for (std::size_t flooded = 0; !front.empty(); ++flooded) {
    if (flooded % beat_every == 0) {
      heartbeat();
    }
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
