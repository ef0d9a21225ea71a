#include "symmetry/sides/mirror_plane.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

Eigen::Vector3d
toEigen(const Vector3& v)
{
  return {v[0], v[1], v[2]};
}

/** Points that have partners, and these, less their means. */
struct Pairs {
  Eigen::Matrix3Xd points;
  Eigen::Matrix3Xd partners;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();             ///< of the points
  Eigen::Vector3d mean_of_partners = Eigen::Vector3d::Zero(); ///< of these
};

Pairs
centredPairs(const std::vector<Vector3>& points, const std::vector<Index>& partners)
{
  Pairs pairs;
  pairs.points.resize(3, static_cast<Eigen::Index>(points.size()));
  pairs.partners.resize(3, static_cast<Eigen::Index>(points.size()));
  Eigen::Index count = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (partners[v] != no_index) {
      pairs.points.col(count) = toEigen(points[v]);
      pairs.partners.col(count) = toEigen(points[partners[v]]);
      ++count;
    }
  }
  pairs.points.conservativeResize(3, count);
  pairs.partners.conservativeResize(3, count);
  if (count > 0) {
    pairs.mean = pairs.points.rowwise().mean();
    pairs.mean_of_partners = pairs.partners.rowwise().mean();
    pairs.points.colwise() -= pairs.mean;
    pairs.partners.colwise() -= pairs.mean_of_partners;
  }
  return pairs;
}

/** The shortest turn that brings the normal to the x axis, then the shift that brings the plane to x = 0. */
std::array<std::array<double, 4>, 3>
motionToX(const Eigen::Vector3d& normal, double offset)
{
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond::FromTwoVectors(normal, Eigen::Vector3d::UnitX()).normalized().toRotationMatrix();
  std::array<std::array<double, 4>, 3> rows{};
  for (int i = 0; i < 3; ++i) {
    rows[static_cast<std::size_t>(i)] = {turn(i, 0), turn(i, 1), turn(i, 2), i == 0 ? -offset : 0.0};
  }
  return rows;
}

/** Plus one if the normal points to the source side, minus one if to the other. */
double
towardsSource(const std::vector<Vector3>& points,
              const std::vector<Side>& sides,
              const Eigen::Vector3d& normal,
              double offset)
{
  double sum = 0.0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const double height = normal.dot(toEigen(points[v])) - offset;
    sum += sides[v] == Side::Source ? height : sides[v] == Side::Target ? -height : 0.0;
  }
  return sum < 0.0 ? -1.0 : 1.0;
}

} // namespace

MirrorPlane
fitMirrorPlane(const std::vector<Vector3>& points, const std::vector<Index>& partners, const std::vector<Side>& sides)
{
  MirrorPlane plane;
  const Pairs pairs = centredPairs(points, partners);
  if (pairs.points.cols() == 0) {
    return plane;
  }
  const Eigen::Matrix3d moments = pairs.points * pairs.partners.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments + moments.transpose());
  const Eigen::Vector3d middle = 0.5 * (pairs.mean + pairs.mean_of_partners);
  Eigen::Vector3d normal = solver.eigenvectors().col(0);
  normal *= towardsSource(points, sides, normal, normal.dot(middle));
  // The plane makes up for what the means lie apart along the normal, not along the plane.
  const Eigen::Matrix3d reflection = Eigen::Matrix3d::Identity() - 2.0 * normal * normal.transpose();
  const Eigen::Vector3d apart = pairs.mean_of_partners - middle - reflection * (pairs.mean - middle);
  const double squares = ((pairs.partners - reflection * pairs.points).colwise() + apart).squaredNorm();
  plane.normal = {normal.x(), normal.y(), normal.z()};
  plane.offset = normal.dot(middle);
  plane.rms = std::sqrt(squares / static_cast<double>(pairs.points.cols()));
  plane.to_x = motionToX(normal, plane.offset);
  return plane;
}

MirrorPlane
movedPlane(const MirrorPlane& plane, double scale, const std::array<double, 3>& shift)
{
  MirrorPlane moved = plane;
  const Eigen::Vector3d normal(plane.normal[0], plane.normal[1], plane.normal[2]);
  if (normal.isZero()) {
    return plane;
  }
  moved.offset = scale * plane.offset + normal.dot(Eigen::Vector3d(shift[0], shift[1], shift[2]));
  moved.rms = scale * plane.rms;
  moved.to_x = motionToX(normal, moved.offset);
  return moved;
}

} // namespace symmetry
} // namespace pcl
