#include "model/terrain.h"

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <vector>

namespace pcl {
namespace symmetry {
namespace {

constexpr int hill_count = 24;

struct Hill {
  Eigen::Vector2d top;
  double height = 0.0;
  double width = 0.0;
};

std::vector<Hill>
randomHills(RandomNumbers& random)
{
  std::vector<Hill> hills(hill_count);
  for (Hill& hill : hills) {
    hill.top = {random.uniform(), random.uniform()};
    hill.height = random.uniform(-0.2, 0.3);
    hill.width = random.uniform(0.05, 0.16);
  }
  return hills;
}

double
heightAt(const std::vector<Hill>& hills, const Eigen::Vector2d& place)
{
  double height = 0.0;
  for (const Hill& hill : hills)
    height += hill.height * std::exp(-(place - hill.top).squaredNorm() / (2.0 * hill.width * hill.width));
  return height;
}

} // namespace

Surface
makeTerrain(std::size_t vertices, RandomNumbers& random)
{
  const auto width = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(vertices))));
  const std::size_t depth = (vertices + width / 2) / width;
  const std::vector<Hill> hills = randomHills(random);
  std::array<Eigen::Vector2d, 4> corners = {
      {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1), Eigen::Vector2d(1, 1)}};
  for (Eigen::Vector2d& corner : corners)
    corner += Eigen::Vector2d(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));

  Surface surface;
  surface.points.reserve(width * depth);
  for (std::size_t row = 0; row < depth; ++row)
    for (std::size_t column = 0; column < width; ++column) {
      const double u = static_cast<double>(column) / static_cast<double>(width - 1);
      const double v = static_cast<double>(row) / static_cast<double>(depth - 1);
      const Eigen::Vector2d place =
          (1 - v) * ((1 - u) * corners[0] + u * corners[1]) + v * ((1 - u) * corners[2] + u * corners[3]);
      surface.points.push_back(
          {static_cast<float>(place.x()), static_cast<float>(heightAt(hills, place)), static_cast<float>(-place.y())});
    }
  for (std::size_t row = 0; row + 1 < depth; ++row)
    for (std::size_t column = 0; column + 1 < width; ++column) {
      const auto a = static_cast<Index>(row * width + column);
      const Index b = a + 1;
      const Index c = a + static_cast<Index>(width);
      const Index d = c + 1;
      // Diagonals alternate, so that distances are alike along both.
      if ((row + column) % 2 == 0)
        surface.triangles.insert(surface.triangles.end(), {{a, b, d}, {a, d, c}});
      else
        surface.triangles.insert(surface.triangles.end(), {{a, b, c}, {b, d, c}});
    }
  return surface;
}

} // namespace symmetry
} // namespace pcl
