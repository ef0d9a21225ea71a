/** \file
 * \brief Moves a plane until the mirror images of samples lie on the surface.
 */
#pragma once

#include "cloud/point_grid.h"
#include "symmetry/mirror/area_samples.h"
#include "symmetry/mirror/plane_reflection.h"
#include "symmetry/mirror/surface_distance.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

inline Eigen::Vector3d
toEigen(const Vector3& v)
{
  return {v[0], v[1], v[2]};
}

inline Vector3
fromEigen(const Eigen::Vector3d& v)
{
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

/** \brief How the images of samples are drawn onto what is nearest to them. Lengths are shares of the diagonal. */
struct AlignmentSettings {
  float reach;
  float first_scale; ///< of the gaps that still count,
  float last_scale;  ///< falling from round to round
  double slide;      ///< weight of gaps along the surface next to those across it
};

/** \brief From a direction 6 degrees off to what is left between samples; they slide along the surface (Y. Chen,
 * G. Medioni, 1992 \cite chen1992modelling). */
constexpr AlignmentSettings onto_samples{0.1F, 0.04F, 0.005F, 0.1};
/** \brief From there to the points themselves: where points were mirrored too, the gaps vanish. */
constexpr AlignmentSettings onto_points{0.02F, 0.01F, 0.001F, 1.0};
/** \brief To the surface between the points, from as far as points are apart. */
constexpr AlignmentSettings onto_surface{0.04F, 0.02F, 0.002F, 0.0};

/** \brief Points that images are drawn onto. */
struct AlignmentTargets {
  const std::vector<Vector3>& points;
  const std::vector<Vector3>& normals;
};

/** \brief Aligns with the points nearest to the images; all that is given is referred to, not copied. */
class PointAlignment {
public:
  PointAlignment(const AreaSamples& samples,
                 const AlignmentTargets& targets,
                 const AlignmentSettings& settings,
                 float diagonal);

  /** \brief Steps of Gauss and Newton that close the gaps between the images and the points nearest to them. */
  PlaneReflection
  run(PlaneReflection plane, int rounds) const;

private:
  Index
  nearestTarget(const Vector3& place) const;

  const AreaSamples& samples_;
  AlignmentTargets targets_;
  AlignmentSettings settings_;
  float diagonal_;
  PointGrid grid_;
};

/** \brief Aligns with the surface itself: what lies on it may slide, and what is beyond its border is drawn back. For
 * sheets, whose inner points tell nothing of a plane across them. */
class SurfaceAlignment {
public:
  SurfaceAlignment(const AreaSamples& samples,
                   const PreparedSurface& surface,
                   const AlignmentSettings& settings,
                   float diagonal);

  /** \brief Steps of Gauss and Newton that shorten the distances of the images from the surface. */
  PlaneReflection
  run(PlaneReflection plane, int rounds) const;

private:
  const AreaSamples& samples_;
  SurfaceDistance surface_;
  AlignmentSettings settings_;
  float diagonal_;
};

} // namespace symmetry
} // namespace pcl
