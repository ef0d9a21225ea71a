#include "base/centroid.h"

#include "base/vector_math.h"

#include <algorithm>
#include <array>

namespace pcl {
namespace symmetry {

Vector3
centroid(const std::vector<Vector3>& points)
{
  std::array<double, 3> sum{0.0, 0.0, 0.0};
  for (const Vector3& p : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += p[k];
    }
  }
  Vector3 mean{};
  for (std::size_t k = 0; k < 3; ++k) {
    mean[k] = static_cast<float>(sum[k] / static_cast<double>(points.size()));
  }
  return mean;
}

Index
farthestFromCentroid(const std::vector<Vector3>& points)
{
  const Vector3 centre = centroid(points);
  const auto is_nearer = [&centre](const Vector3& a, const Vector3& b) {
    return distance(a, centre) < distance(b, centre);
  };
  return static_cast<Index>(std::max_element(points.begin(), points.end(), is_nearer) - points.begin());
}

} // namespace symmetry
} // namespace pcl
