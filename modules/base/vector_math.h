/** \file
 * \brief Arithmetic on Vector3, for code that includes neither PCL nor Eigen.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <cmath>

namespace pcl {
namespace symmetry {

inline Vector3
operator+(const Vector3& a, const Vector3& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Vector3
operator-(const Vector3& a, const Vector3& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Vector3
operator*(float s, const Vector3& a)
{
  return {s * a[0], s * a[1], s * a[2]};
}

inline float
dot(const Vector3& a, const Vector3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3
cross(const Vector3& a, const Vector3& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline float
norm(const Vector3& a)
{
  return std::sqrt(dot(a, a));
}

inline float
distance(const Vector3& a, const Vector3& b)
{
  return norm(a - b);
}

/** \brief The vector at length 1; zero stays zero. */
inline Vector3
normalized(const Vector3& a)
{
  const float length = norm(a);
  return length > 0.0F ? (1.0F / length) * a : a;
}

/** \brief A direction at length 1; zero where the vector has none, being zero or not finite. In double: no length is
 * too large or too small. */
inline Vector3
unitOrZero(const Vector3& a)
{
  const double length = std::hypot(double{a[0]}, double{a[1]}, double{a[2]});
  if (!(length > 0.0) || !std::isfinite(length)) {
    return {0.0F, 0.0F, 0.0F};
  }
  return {static_cast<float>(a[0] / length), static_cast<float>(a[1] / length), static_cast<float>(a[2] / length)};
}

/** \brief Whether the vector is not zero. */
inline bool
isDirection(const Vector3& a)
{
  return a[0] != 0.0F || a[1] != 0.0F || a[2] != 0.0F;
}

inline bool
isFinite(const Vector3& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

} // namespace symmetry
} // namespace pcl
