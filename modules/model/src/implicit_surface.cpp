#include "model/implicit_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

constexpr double reach = 12.0;      // in units of the blend: what lies farther adds less than exp (-12)
constexpr int cells_along_box = 40; // of the index, along the longest side
constexpr int newton_steps = 3;

} // namespace

RoundCone::RoundCone(const Eigen::Vector3d& start, double start_radius, const Eigen::Vector3d& end, double end_radius)
    : start_(start), end_(end), start_radius_(start_radius), end_radius_(end_radius), length_((end - start).norm())
{
  if (length_ == 0.0)
    return;
  direction_ = (end - start) / length_;
  taper_ = (start_radius - end_radius) / length_;
  lean_ = taper_ / std::sqrt(1.0 - taper_ * taper_);
}

double
RoundCone::signedDistance(const Eigen::Vector3d& point, Eigen::Vector3d& gradient) const
{
  // The cone is the union of spheres with centre c (t) and radius r (t); |p - c (t)| - r (t) is convex in t, and least
  // where the line from the centre to the point is a normal of the mantle.
  const Eigen::Vector3d offset = point - start_;
  const double along = offset.dot(direction_);
  const double across = std::sqrt(std::max(offset.squaredNorm() - along * along, 0.0));
  const double t = std::clamp(along - across * lean_, 0.0, length_);
  gradient = offset - t * direction_;
  const double distance = gradient.norm();
  gradient /= std::max(distance, std::numeric_limits<double>::min());
  return distance - (start_radius_ - t * taper_);
}

ImplicitSurface::ImplicitSurface(std::vector<RoundCone> cones, double blend) : cones_(std::move(cones)), blend_(blend)
{
  all_.resize(cones_.size());
  std::iota(all_.begin(), all_.end(), std::uint16_t{0});
  measureBox();
  indexCones();
}

void
ImplicitSurface::measureBox()
{
  lowest_.setConstant(std::numeric_limits<double>::max());
  highest_ = -lowest_;
  for (const RoundCone& cone : cones_) {
    lowest_ = lowest_.cwiseMin((cone.start().array() - cone.startRadius()).matrix());
    lowest_ = lowest_.cwiseMin((cone.end().array() - cone.endRadius()).matrix());
    highest_ = highest_.cwiseMax((cone.start().array() + cone.startRadius()).matrix());
    highest_ = highest_.cwiseMax((cone.end().array() + cone.endRadius()).matrix());
  }
  // The soft minimum swells the union by at most this much.
  const double swelling = blend_ * std::log(static_cast<double>(cones_.size()));
  lowest_.array() -= swelling;
  highest_.array() += swelling;
}

void
ImplicitSurface::indexCones()
{
  const Eigen::Vector3d extent = highest_ - lowest_;
  cell_ = extent.maxCoeff() / cells_along_box;
  cells_ = (extent.array() / cell_).ceil().cast<int>().max(1);
  const double slack = std::sqrt(3.0) * cell_ + reach * blend_; // twice the half diagonal: both distances may change
  std::vector<double> distances(cones_.size());
  Eigen::Vector3d unused;
  for (int z = 0; z < cells_.z(); ++z)
    for (int y = 0; y < cells_.y(); ++y)
      for (int x = 0; x < cells_.x(); ++x) {
        const Eigen::Vector3d centre = lowest_ + cell_ * Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5);
        for (std::size_t i = 0; i < cones_.size(); ++i)
          distances[i] = cones_[i].signedDistance(centre, unused);
        const double limit = *std::min_element(distances.begin(), distances.end()) + slack;
        std::vector<std::uint16_t>& cell = near_.emplace_back();
        for (std::size_t i = 0; i < cones_.size(); ++i)
          if (distances[i] <= limit)
            cell.push_back(static_cast<std::uint16_t>(i));
      }
}

const std::vector<std::uint16_t>&
ImplicitSurface::conesNear(const Eigen::Vector3d& point) const
{
  const Eigen::Array3i cell = ((point - lowest_).array() / cell_).floor().cast<int>();
  if ((cell < 0).any() || (cell >= cells_).any())
    return all_;
  return near_[static_cast<std::size_t>((cell.z() * cells_.y() + cell.y()) * cells_.x() + cell.x())];
}

double
ImplicitSurface::value(const Eigen::Vector3d& point) const
{
  Eigen::Vector3d unused;
  return value(point, unused);
}

double
ImplicitSurface::value(const Eigen::Vector3d& point, Eigen::Vector3d& gradient) const
{
  const std::vector<std::uint16_t>& cones = conesNear(point);
  thread_local std::vector<double> distances;
  thread_local std::vector<Eigen::Vector3d> gradients;
  distances.resize(cones.size());
  gradients.resize(cones.size());
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < cones.size(); ++i) {
    distances[i] = cones_[cones[i]].signedDistance(point, gradients[i]);
    nearest = std::min(nearest, distances[i]);
  }
  // Which cones count is decided by the point alone, so that the value does not depend on the cell of the index.
  double sum = 0.0;
  gradient.setZero();
  for (std::size_t i = 0; i < cones.size(); ++i) {
    const double excess = (distances[i] - nearest) / blend_;
    if (excess > reach)
      continue;
    const double weight = std::exp(-excess);
    sum += weight;
    gradient += weight * gradients[i];
  }
  gradient /= sum;
  return nearest - blend_ * std::log(sum);
}

Eigen::Vector3d
ImplicitSurface::project(Eigen::Vector3d point) const
{
  Eigen::Vector3d gradient;
  for (int step = 0; step < newton_steps; ++step) {
    const double distance = value(point, gradient);
    // In a crease the slopes cancel; a lower bound keeps the step within twice the distance.
    point -= distance * gradient / std::max(gradient.squaredNorm(), 0.25);
  }
  return point;
}

} // namespace symmetry
} // namespace pcl
