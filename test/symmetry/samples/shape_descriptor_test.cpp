#include "support/human.h"
#include "symmetry/samples/shape_descriptor.h"

#include <Eigen/QR>
#include <gtest/gtest.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr int dimensions = 12;

const ShapeDescriptor&
descriptor()
{
  static const ShapeDescriptor described = describeShape(human().coarse, human().basis, dimensions, {});
  return described;
}

float
varianceOf(const Eigen::MatrixXf& part)
{
  return part.squaredNorm() / static_cast<float>(part.rows());
}

TEST(ShapeDescriptor, PartsHaveTheVarianceOfTheirWeights)
{
  const DescriptorWeights weights;
  EXPECT_EQ(descriptor().spectral.cols(), dimensions);
  EXPECT_EQ(descriptor().orientation.cols(), 15); // pairs of 6
  EXPECT_EQ(descriptor().curvature.cols(), 3);
  EXPECT_NEAR(varianceOf(descriptor().spectral), 1.0F, 1e-3F);
  EXPECT_NEAR(varianceOf(descriptor().orientation), weights.orientation * weights.orientation, 1e-3F);
  EXPECT_NEAR(varianceOf(descriptor().curvature), weights.curvature * weights.curvature, 1e-3F);
}

/** The same functions on the mirror image of the surface: only what tells left from right may change. */
TEST(ShapeDescriptor, OnTheMirrorImageOnlyTheOrientationIsTurnedOver)
{
  CoarseSurface mirrored = human().coarse;
  for (std::vector<Vector3>* vectors : {&mirrored.points, &mirrored.normals}) {
    for (Vector3& v : *vectors) {
      v[0] = -v[0];
    }
  }
  const ShapeDescriptor other = describeShape(mirrored, human().basis, dimensions, {});
  EXPECT_EQ(other.spectral, descriptor().spectral);
  EXPECT_LT((other.curvature - descriptor().curvature).cwiseAbs().maxCoeff(), 1e-3F);
  EXPECT_GT(descriptor().orientation.cwiseAbs().maxCoeff(), 0.1F);
  EXPECT_LT((other.orientation + descriptor().orientation).norm(), 0.01F * descriptor().orientation.norm());
}

/** A turned body is the same to look at. */
TEST(ShapeDescriptor, OfATurnedSurfaceIsTheSame)
{
  CoarseSurface turned = human().coarse;
  for (std::vector<Vector3>* vectors : {&turned.points, &turned.normals}) {
    for (Vector3& v : *vectors) {
      v = {-v[1], v[0], v[2]};
    }
  }
  const ShapeDescriptor other = describeShape(turned, human().basis, dimensions, {});
  EXPECT_LT((other.orientation - descriptor().orientation).norm(), 0.01F * descriptor().orientation.norm());
}

/** How the true map acts on the spectral coordinates, and with it what the partners' descriptors should be. */
TEST(ShapeDescriptor, ThePartnersOfAReflectionHaveTheMirroredDescriptors)
{
  const SampleMap map = human().trueMap();
  const auto rows = static_cast<Eigen::Index>(map.size());
  const Eigen::MatrixXf own = descriptor().spectral.topRows(rows);
  const Eigen::MatrixXf own_orientation = descriptor().orientation.topRows(rows);
  Eigen::MatrixXf partners(rows, own.cols());
  Eigen::MatrixXf orientation(rows, own_orientation.cols());
  for (Eigen::Index i = 0; i < rows; ++i) {
    partners.row(i) = own.row(map[static_cast<std::size_t>(i)]);
    orientation.row(i) = own_orientation.row(map[static_cast<std::size_t>(i)]);
  }
  const Eigen::MatrixXf action = own.colPivHouseholderQr().solve(partners).transpose();
  const Eigen::MatrixXf expected = descriptor().mirroredLocalParts(action, rows).leftCols(orientation.cols());
  EXPECT_LT((orientation - expected).norm(), 0.7F * orientation.norm()); // samples have no exact partners
  EXPECT_GT((orientation + expected).norm(), 1.5F * orientation.norm()); // what a rotation would do
  EXPECT_EQ(descriptor().mirrored(action, rows).rightCols(expected.cols() + 3),
            descriptor().mirroredLocalParts(action, rows));
}

TEST(ShapeDescriptor, JoinsItsParts)
{
  const Eigen::MatrixXf joined = descriptor().joined(50);
  ASSERT_EQ(joined.rows(), 50);
  ASSERT_EQ(joined.cols(), dimensions + 15 + 3);
  EXPECT_EQ(joined.leftCols(dimensions), descriptor().spectral.topRows(50));
  EXPECT_EQ(joined.rightCols(18), descriptor().localParts(50));
  EXPECT_EQ(joined.rightCols(3), descriptor().curvature.topRows(50));
}

} // namespace
