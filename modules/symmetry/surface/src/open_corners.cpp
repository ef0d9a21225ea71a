#include "symmetry/surface/open_corners.h"

#include "base/vector_math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {

double
lengthBetween(const Vector3& a, const Vector3& b)
{
  return std::hypot(double{a[0]} - double{b[0]}, double{a[1]} - double{b[1]}, double{a[2]} - double{b[2]});
}

Vector3
FaceCorner::bisector() const
{
  return normalized(first + second);
}

bool
FaceCorner::contains(const Vector3& direction) const
{
  const Vector3 normal = normalized(cross(first, second));
  const Vector3 middle = bisector();
  return isDirection(normal) && std::abs(dot(direction, normal)) < parallel_faces &&
         dot(direction, middle) > dot(first, middle) + parallel_faces * norm(cross(first, middle));
}

OpenCorners::OpenCorners(const PreparedSurface& surface, const std::vector<OpenSide>& sides)
    : places_(surface.points), open_(surface.size(), surface.triangles, sides), tolerances_(open_.points().size())
{
  for (std::size_t i = 0; i < size(); ++i) {
    double shortest = std::numeric_limits<double>::infinity();
    open_.visitTriangles(i, [&](Index b, Index c) {
      shortest = std::min({shortest, lengthBetween(place(i), places_[b]), lengthBetween(place(i), places_[c]),
                           lengthBetween(places_[b], places_[c])});
    });
    tolerances_[i] = rounding_share * shortest;
  }
}

std::vector<FaceCorner>
OpenCorners::facesAround(std::size_t i) const
{
  std::vector<FaceCorner> faces;
  open_.visitTriangles(i, [&](Index b, Index c) {
    faces.push_back({unitOrZero(places_[b] - place(i)), unitOrZero(places_[c] - place(i))});
  });
  return faces;
}

bool
OpenCorners::lieOver(std::size_t i, std::size_t j) const
{
  const std::vector<FaceCorner> of_i = facesAround(i);
  const std::vector<FaceCorner> of_j = facesAround(j);
  return std::any_of(of_i.begin(), of_i.end(), [&](const FaceCorner& a) {
    return std::any_of(of_j.begin(), of_j.end(),
                       [&](const FaceCorner& b) { return a.contains(b.bisector()) || b.contains(a.bisector()); });
  });
}

} // namespace symmetry
} // namespace pcl
