/** \file
 * \brief Rigid shapes with several known symmetries.
 */
#pragma once

#include "model/implicit_surface.h"
#include "model/polygonize.h"

#include <pcl/symmetry/surface.h>

#include <cmath>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

constexpr double full_turn = 6.283185307179586;

inline Surface
skinOf(std::vector<RoundCone> cones, double cell)
{
  const TriangleMesh mesh = polygonize(ImplicitSurface(std::move(cones), 0.02), cell, Extent::Whole);
  Surface surface;
  for (const Eigen::Vector3d& p : mesh.points) {
    surface.points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
  }
  surface.triangles = mesh.triangles;
  return surface;
}

/** \brief A table with four legs whose plate has these half sides; y points up. */
inline Surface
tableMesh(double half_x, double half_z)
{
  using V = Eigen::Vector3d;
  std::vector<RoundCone> cones;
  constexpr int bars = 6;
  for (int i = 0; i <= bars; ++i) {
    const double z = half_z * (2.0 * i / bars - 1.0);
    cones.emplace_back(V(-half_x, 0.0, z), 0.09, V(half_x, 0.0, z), 0.09);
    const double x = half_x * (2.0 * i / bars - 1.0);
    cones.emplace_back(V(x, 0.0, -half_z), 0.09, V(x, 0.0, half_z), 0.09);
  }
  for (const double x : {-half_x, half_x}) {
    for (const double z : {-half_z, half_z}) {
      cones.emplace_back(V(x, 0.0, z), 0.07, V(x, -0.8, z), 0.06);
    }
  }
  return skinOf(std::move(cones), 0.05);
}

/** \brief Equal arms all around a dome; y points up, one arm along z. */
inline Surface
octopusMesh(int arms)
{
  using V = Eigen::Vector3d;
  std::vector<RoundCone> cones;
  cones.emplace_back(V(0.0, 0.0, 0.0), 0.25, V(0.0, 0.35, 0.0), 0.3);
  for (int k = 0; k < arms; ++k) {
    const double angle = full_turn * k / arms;
    const V out(std::sin(angle), 0.0, std::cos(angle));
    const V elbow = 0.55 * out - 0.1 * V::UnitY();
    cones.emplace_back(0.15 * out, 0.12, elbow, 0.09);
    cones.emplace_back(elbow, 0.09, out + 0.05 * V::UnitY(), 0.05);
  }
  return skinOf(std::move(cones), 0.05);
}

/** \brief A body of revolution, thicker below, with a handle at z > 0. */
inline Surface
mugMesh()
{
  using V = Eigen::Vector3d;
  std::vector<RoundCone> cones;
  cones.emplace_back(V(0.0, 0.0, 0.0), 0.45, V(0.0, 0.9, 0.0), 0.3);
  cones.emplace_back(V(0.0, 0.1, 0.35), 0.07, V(0.0, 0.15, 0.85), 0.07);
  cones.emplace_back(V(0.0, 0.15, 0.85), 0.07, V(0.0, 0.75, 0.75), 0.06);
  cones.emplace_back(V(0.0, 0.75, 0.75), 0.06, V(0.0, 0.8, 0.25), 0.06);
  return skinOf(std::move(cones), 0.05);
}

/** \brief Two rims, a bridge along x and two temples towards z < 0. */
inline Surface
glassesMesh()
{
  using V = Eigen::Vector3d;
  std::vector<RoundCone> cones;
  constexpr int pieces = 16;
  for (const double side : {-1.0, 1.0}) {
    const auto rim = [&](int k) -> V {
      const double angle = full_turn * k / pieces;
      return {side * 0.45 + 0.33 * std::cos(angle), 0.26 * std::sin(angle), 0.0};
    };
    for (int k = 0; k < pieces; ++k) {
      cones.emplace_back(rim(k), 0.05, rim(k + 1), 0.05);
    }
    cones.emplace_back(V(side * 0.78, 0.12, 0.0), 0.05, V(side * 0.85, 0.12, -1.0), 0.045);
    cones.emplace_back(V(side * 0.85, 0.12, -1.0), 0.045, V(side * 0.85, -0.05, -1.25), 0.045);
  }
  cones.emplace_back(V(-0.12, 0.06, 0.0), 0.05, V(0.12, 0.06, 0.0), 0.05);
  return skinOf(std::move(cones), 0.03);
}

/** \brief A rounded box of three different sides. */
inline Surface
boxMesh()
{
  using V = Eigen::Vector3d;
  std::vector<RoundCone> cones;
  for (int j = 0; j <= 5; ++j) {
    for (int k = 0; k <= 3; ++k) {
      const double y = 0.2 * (j - 2.5);
      const double z = 0.2 * (k - 1.5);
      cones.emplace_back(V(-1.0, y, z), 0.1, V(1.0, y, z), 0.1);
    }
  }
  return skinOf(std::move(cones), 0.06);
}

} // namespace test
} // namespace symmetry
} // namespace pcl
