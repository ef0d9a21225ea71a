/** \file
 * \brief Which places are outside the body that a cloud is the surface of.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A disc of surface around a point \cite pfister2000surfels. */
struct Surfel {
  Vector3 centre{};
  Vector3 normal{};
  float radius = 0.0F;
};

/** \brief The space that can be reached from far away without passing through a surface.
 *
 * A grid of cubes is flooded from its border through the sides of cubes that no surfel meets. Where the surface has a
 * hole wider than a cube the flood gets in, and nothing is inside. */
class OutsideSpace {
public:
  /** \param[in] surfels all finite
   * \param[in] cube edge of a cube; larger where more than a few million cubes would be needed */
  OutsideSpace(const std::vector<Surfel>& surfels, float cube);

  bool
  contains(const Vector3& place) const;

  /** \brief Edge of a cube. */
  float
  cube() const
  {
    return cube_;
  }

private:
  enum class Cube : std::uint8_t { Free, Occupied, Outside };

  std::array<std::ptrdiff_t, 3>
  cubeAt(const Vector3& place) const;

  bool
  isWithin(const std::array<std::ptrdiff_t, 3>& c) const;

  std::size_t
  number(const std::array<std::ptrdiff_t, 3>& c) const;

  void
  occupy(const Surfel& surfel);

  void
  flood();

  float cube_;
  Vector3 low_{};
  std::array<std::ptrdiff_t, 3> counts_{};
  std::vector<Cube> cubes_;
};

} // namespace symmetry
} // namespace pcl
