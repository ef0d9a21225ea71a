#include "symmetry/samples/rigid_reflection.h"

#include "base/tangent_frame.h"
#include "base/vector_math.h"
#include "symmetry/samples/sample_settings.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr SlideSettings settings{};

Eigen::Vector3f
toEigen(const Vector3& v)
{
  return {v[0], v[1], v[2]};
}

Vector3
fromEigen(const Eigen::Vector3f& v)
{
  return {v.x(), v.y(), v.z()};
}

/** The orthogonal matrix of determinant -1 with the largest trace of its product with the transpose of \a covariance.
 */
Eigen::Matrix3f
nearestReflection(const Eigen::Matrix3f& covariance)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> solver;
  solver.computeDirect(covariance.transpose() * covariance);
  const Vector3 v1 = fromEigen(solver.eigenvectors().col(2));
  const Vector3 v2 = fromEigen(solver.eigenvectors().col(1));
  const Vector3 v3 = cross(v1, v2);
  Vector3 u1 = normalized(fromEigen(covariance * toEigen(v1)));
  if (dot(u1, u1) == 0.0F) {
    u1 = v1;
  }
  Vector3 u2 = fromEigen(covariance * toEigen(v2));
  u2 = normalized(u2 - dot(u2, u1) * u1);
  if (dot(u2, u2) == 0.0F) {
    u2 = tangentFrame(u1).u;
  }
  const Vector3 u3 = cross(u2, u1);
  return toEigen(u1) * toEigen(v1).transpose() + toEigen(u2) * toEigen(v2).transpose() +
         toEigen(u3) * toEigen(v3).transpose();
}

/** Normal equations of a small motion: a turn about a centre, then a shift. */
class MotionEquations {
public:
  /** Asks that a place (relative to the centre) comes to lie in a plane \a distance below it. */
  void
  addPlane(const Vector3& place, const Vector3& normal, float distance, float weight)
  {
    const Vector3 moment = cross(place, normal);
    const float row[6] = {moment[0], moment[1], moment[2], normal[0], normal[1], normal[2]};
    for (int i = 0; i < 6; ++i) {
      const float weighted = weight * row[i];
      for (int j = 0; j <= i; ++j) {
        matrix_(i, j) += weighted * row[j];
      }
      right_side_(i) -= weighted * distance;
    }
  }

  /** Asks that all places stay where they are, given their inertia about the centre and their weight: they have been
   * fitted to their images as well as a rigid motion can. */
  void
  addRest(const Eigen::Matrix3f& second_moments, float weight, float stiffness)
  {
    const float trace = second_moments.trace();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j <= i; ++j) {
        matrix_(i, j) += stiffness * ((i == j ? trace : 0.0F) - second_moments(i, j));
      }
      matrix_(i + 3, i + 3) += stiffness * weight;
    }
  }

  Eigen::Matrix<float, 6, 1>
  solve() const
  {
    Eigen::Matrix<float, 6, 6> regular = matrix_;
    regular.diagonal() *= 1.001F;
    regular.diagonal().array() += 1e-12F;
    return regular.ldlt().solve(right_side_); // reads the lower half
  }

private:
  Eigen::Matrix<float, 6, 6> matrix_ = Eigen::Matrix<float, 6, 6>::Zero();
  Eigen::Matrix<float, 6, 1> right_side_ = Eigen::Matrix<float, 6, 1>::Zero();
};

/** Lets the images slide along the planes at the places where they should be. */
void
slideAlongPlanes(const std::vector<OrientedMatch>& matches, const Vector3& centre, RigidReflection& reflection)
{
  MotionEquations equations;
  Eigen::Matrix3f moments = Eigen::Matrix3f::Zero();
  float total = 0.0F;
  for (const OrientedMatch& match : matches) {
    const Vector3 image = reflection(match.from);
    const Vector3 arm = image - centre;
    equations.addPlane(arm, match.to_normal, dot(match.to_normal, image - match.to), match.weight);
    moments += match.weight * toEigen(arm) * toEigen(arm).transpose();
    total += match.weight;
  }
  equations.addRest(moments, total, settings.stiffness);
  const Eigen::Matrix<float, 6, 1> motion = equations.solve();
  const Eigen::Vector3f turn = motion.head<3>();
  const float angle = turn.norm();
  if (!motion.allFinite() || angle > settings.maximum_angle) {
    return;
  }
  Eigen::Matrix3f rotation = Eigen::Matrix3f::Identity();
  if (angle > 0.0F) {
    rotation = Eigen::AngleAxisf(angle, turn / angle).toRotationMatrix();
  }
  reflection.shift = rotation * (reflection.shift - toEigen(centre)) + toEigen(centre) + motion.tail<3>();
  reflection.linear = (rotation * reflection.linear).eval();
}

} // namespace

Vector3
RigidReflection::operator()(const Vector3& place) const
{
  return fromEigen(linear * toEigen(place) + shift);
}

Vector3
RigidReflection::turned(const Vector3& direction) const
{
  return fromEigen(linear * toEigen(direction));
}

RigidReflection
fitReflection(const std::vector<OrientedMatch>& matches, float normal_reach)
{
  RigidReflection reflection;
  Vector3 from{0.0F, 0.0F, 0.0F};
  Vector3 to{0.0F, 0.0F, 0.0F};
  float total = 0.0F;
  for (const OrientedMatch& match : matches) {
    from = from + match.weight * match.from;
    to = to + match.weight * match.to;
    total += match.weight;
  }
  if (total <= 0.0F) {
    return reflection;
  }
  from = (1.0F / total) * from;
  to = (1.0F / total) * to;
  Eigen::Matrix3f covariance = Eigen::Matrix3f::Zero();
  for (const OrientedMatch& match : matches) {
    covariance +=
        match.weight * toEigen(match.to - to) * toEigen(match.from - from).transpose() +
        match.weight * normal_reach * normal_reach * toEigen(match.to_normal) * toEigen(match.from_normal).transpose();
  }
  reflection.linear = nearestReflection(covariance);
  reflection.shift = toEigen(to) - reflection.linear * toEigen(from);
  slideAlongPlanes(matches, to, reflection);
  for (const OrientedMatch& match : matches) {
    const Vector3 off = reflection(match.from) - match.to;
    reflection.error += match.weight / total * dot(off, off);
  }
  return reflection;
}

} // namespace symmetry
} // namespace pcl
