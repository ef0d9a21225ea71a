#include "symmetry/mirror/plane_alignment.h"

#include "base/heartbeat.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t sources = 500; // the first samples are spread over the whole surface

/** One step of Gauss and Newton over gaps between images and what they are drawn onto. */
class AlignmentStep {
public:
  AlignmentStep(const PlaneReflection& plane, float scale)
      : plane_(plane),
        scale_(scale),
        normal_(toEigen(plane.normal)),
        t1_(normal_.unitOrthogonal()),
        t2_(normal_.cross(t1_))
  {
  }

  /** \param[in] metric how much gaps count in each direction */
  void
  add(const Vector3& sample, float area, const Eigen::Vector3d& gap, const Eigen::Matrix3d& metric)
  {
    // The weights of the robust estimator of Geman and McClure.
    const double size = gap.dot(metric * gap) / (double{scale_} * double{scale_});
    const double weight = double{area} / ((1.0 + size) * (1.0 + size));
    // How the image moves with the offset and with turns of the normal towards t1 and t2.
    const Eigen::Vector3d p = toEigen(sample);
    const double height = plane_.height(sample);
    Eigen::Matrix3d motion;
    motion.col(0) = 2.0 * normal_;
    motion.col(1) = -2.0 * (t1_.dot(p) * normal_ + height * t1_);
    motion.col(2) = -2.0 * (t2_.dot(p) * normal_ + height * t2_);
    system_ += weight * motion.transpose() * metric * motion;
    right_ -= weight * motion.transpose() * metric * gap;
  }

  PlaneReflection
  moved() const
  {
    const Eigen::Vector3d change = system_.ldlt().solve(right_);
    const Eigen::Vector3d turned = (normal_ + change[1] * t1_ + change[2] * t2_).normalized();
    return {fromEigen(turned), static_cast<float>(plane_.offset + change[0])};
  }

private:
  PlaneReflection plane_;
  float scale_;
  Eigen::Vector3d normal_;
  Eigen::Vector3d t1_;
  Eigen::Vector3d t2_;
  Eigen::Matrix3d system_ = 1e-9 * Eigen::Matrix3d::Identity(); // regular also where hardly a gap counts
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

/** Where the image of a sample is drawn from. */
struct Gap {
  Vector3 vector;
  Eigen::Matrix3d metric; ///< how much it counts in each direction
};

/** Steps in rounds with falling scales; gap (plane, i, image) is that of the image of sample i, if it has one. */
template <typename FindGap>
PlaneReflection
closeGaps(PlaneReflection plane,
          int rounds,
          const AreaSamples& samples,
          const AlignmentSettings& settings,
          float diagonal,
          FindGap gap)
{
  for (int round = 0; round < rounds; ++round) {
    const float part = static_cast<float>(round) / static_cast<float>(std::max(1, rounds - 1));
    AlignmentStep step(plane,
                       diagonal * settings.first_scale * std::pow(settings.last_scale / settings.first_scale, part));
    for (std::size_t i = 0; i < std::min(sources, samples.size()); ++i) {
      heartbeat();
      if (const std::optional<Gap> found = gap(plane, i, plane.image(samples.points[i]))) {
        step.add(samples.points[i], samples.areas[i], toEigen(found->vector), found->metric);
      }
    }
    plane = step.moved();
  }
  return plane;
}

} // namespace

/** Cubes are smaller than the reach by so much: where points are crowded few of them are met. */
constexpr float fineness = 4.0F;

PointAlignment::PointAlignment(const AreaSamples& samples,
                               const AlignmentTargets& targets,
                               const AlignmentSettings& settings,
                               float diagonal)
    : samples_(samples),
      targets_(targets),
      settings_(settings),
      diagonal_(diagonal),
      grid_(targets.points, settings.reach * diagonal / fineness)
{
}

PlaneReflection
PointAlignment::run(PlaneReflection plane, int rounds) const
{
  const auto gap = [this](const PlaneReflection& /*from*/, std::size_t /*sample*/, const Vector3& image) {
    const Index q = nearestTarget(image);
    if (q == no_index) {
      return std::optional<Gap>();
    }
    const Eigen::Vector3d facing = toEigen(targets_.normals[q]);
    const Eigen::Matrix3d metric =
        (1.0 - settings_.slide) * facing * facing.transpose() + settings_.slide * Eigen::Matrix3d::Identity();
    return std::optional<Gap>({image - targets_.points[q], metric});
  };
  return closeGaps(plane, rounds, samples_, settings_, diagonal_, gap);
}

Index
PointAlignment::nearestTarget(const Vector3& place) const
{
  Index best = no_index;
  float least = settings_.reach * diagonal_;
  grid_.visitNearest(place, least, [&](Index v) {
    const float apart = distance(targets_.points[v], place);
    if (apart < least || (apart == least && v < best)) {
      least = apart;
      best = v;
    }
    return least;
  });
  return best;
}

SurfaceAlignment::SurfaceAlignment(const AreaSamples& samples,
                                   const PreparedSurface& surface,
                                   const AlignmentSettings& settings,
                                   float diagonal)
    : samples_(samples), surface_(surface, settings.reach * diagonal), settings_(settings), diagonal_(diagonal)
{
}

PlaneReflection
SurfaceAlignment::run(PlaneReflection plane, int rounds) const
{
  const auto gap = [this](const PlaneReflection& from, std::size_t sample, const Vector3& image) {
    const std::optional<SurfaceDistance::Nearest> near = surface_.nearest(image);
    if (!near) {
      return std::optional<Gap>();
    }
    // Along the gap alone, where there is one: across its border a sheet pulls in its own plane.
    constexpr float rounding = 1e-6F; // surfaces are at unit scale
    const Vector3 way =
        near->distance > rounding ? normalized(image - near->place) : from.turned(samples_.normals[sample]);
    const Eigen::Vector3d facing = toEigen(way);
    return std::optional<Gap>({image - near->place, facing * facing.transpose()});
  };
  return closeGaps(plane, rounds, samples_, settings_, diagonal_, gap);
}

} // namespace symmetry
} // namespace pcl
