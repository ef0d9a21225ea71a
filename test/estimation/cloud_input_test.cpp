// The PCL class with clouds: holes, searches, normals.
#include "model/disturb.h"
#include "support/known_body.h"
#include "support/pcl_input.h"

#include <pcl/symmetry/intrinsic_symmetry.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>
#include <pcl/search/brute_force.h>
#include <pcl/search/organized.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

template <typename PointT>
pcl::IntrinsicSymmetryResult
compute(const pcl::shared_ptr<pcl::PointCloud<PointT>>& cloud, const SymmetryParameters& parameters = {})
{
  pcl::IntrinsicSymmetryEstimation<PointT> estimation;
  estimation.setParameters(parameters);
  estimation.setInputCloud(cloud);
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  return result;
}

TEST(CloudInput, ReplacesAMesh)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setInputMesh(meshOf(bentHuman().surface));
  const auto cloud = cloudOf(bentHuman().surface.points);
  estimation.setInputCloud(cloud);
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  EXPECT_EQ(result.input.faces, 0U);
  EXPECT_EQ(result.partners, compute(cloud).partners);
}

TEST(CloudInput, MayBeOrganisedWithHoles)
{
  // Rows of 64 points, of which every seventh is a hole; is_dense says otherwise.
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::vector<Index> position;
  const auto add_hole = [&] {
    cloud->push_back({not_a_number, not_a_number, not_a_number});
  };
  for (const Vector3& p : bentHuman().surface.points) {
    if (cloud->size() % 7 == 3) {
      add_hole();
    }
    position.push_back(static_cast<Index>(cloud->size()));
    cloud->push_back({p[0], p[1], p[2]});
  }
  while (cloud->size() % 64 != 0) {
    add_hole();
  }
  cloud->height = static_cast<std::uint32_t>(cloud->size() / 64);
  cloud->width = 64;
  cloud->is_dense = true;
  const pcl::IntrinsicSymmetryResult result = compute(cloud);
  const pcl::IntrinsicSymmetryResult without_holes = compute(cloudOf(bentHuman().surface.points));
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric) << result.message;
  EXPECT_EQ(result.input.non_finite, cloud->size() - position.size());
  for (std::size_t v = 0; v < position.size(); ++v) {
    ASSERT_EQ(result.partners[position[v]], position[without_holes.partners[v]]);
  }
}

TEST(CloudInput, AnotherExactSearchGivesTheSameMap)
{
  const auto cloud = cloudOf(bentHuman().surface.points);
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  const auto search = pcl::make_shared<pcl::search::BruteForce<pcl::PointXYZ>>(true);
  estimation.setSearchMethod(search);
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  EXPECT_EQ(result.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(result.partners, compute(cloud).partners);
  EXPECT_TRUE(search->getInputCloud()); // it was used
}

pcl::PointCloud<pcl::PointNormal>::Ptr
humanWithNormals()
{
  const auto cloud = cloudOf<pcl::PointNormal>(bentHuman().surface.points);
  for (const Triangle& t : bentHuman().surface.triangles) {
    const Vector3& p = bentHuman().surface.points[t[0]];
    const Vector3 normal = cross(bentHuman().surface.points[t[1]] - p, bentHuman().surface.points[t[2]] - p);
    for (const Index v : t) {
      (*cloud)[v].getNormalVector3fMap() += Eigen::Vector3f(normal[0], normal[1], normal[2]);
    }
  }
  for (pcl::PointNormal& point : *cloud) {
    point.getNormalVector3fMap().normalize();
  }
  return cloud;
}

TEST(CloudInput, NormalsOfThePointsAreUsedWhenAskedFor)
{
  SymmetryParameters parameters;
  parameters.normals = NormalSource::Given;
  const pcl::IntrinsicSymmetryResult result = compute(humanWithNormals(), parameters);
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric) << result.message;
  EXPECT_GE(correspondenceRate(mapErrors(bentHuman(), result.partners)), 0.95);
}

TEST(CloudInput, GivenNormalsNeedNoUnitLength)
{
  SymmetryParameters parameters;
  parameters.normals = NormalSource::Given;
  const auto cloud = humanWithNormals();
  const pcl::IntrinsicSymmetryResult result = compute(cloud, parameters);
  for (std::size_t v = 0; v < cloud->size(); ++v) {
    (*cloud)[v].getNormalVector3fMap() *= v % 3 == 0 ? 1e-30F : (v % 3 == 1 ? 2.0F : 1e30F);
  }
  const pcl::IntrinsicSymmetryResult scaled = compute(cloud, parameters);
  EXPECT_NEAR(scaled.confidence, result.confidence, 0.02F); // but for rounding
  EXPECT_GE(correspondenceRate(mapErrors(bentHuman(), scaled.partners)), 0.95);
}

TEST(CloudInput, PointsWithoutANormalAreNoObstacle)
{
  SymmetryParameters parameters;
  parameters.normals = NormalSource::Given;
  const auto cloud = humanWithNormals();
  for (std::size_t v = 0; v < cloud->size(); v += 7) {
    (*cloud)[v].getNormalVector3fMap().setConstant(v % 2 == 0 ? not_a_number : 0.0F);
  }
  const pcl::IntrinsicSymmetryResult result = compute(cloud, parameters);
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric) << result.message;
  EXPECT_GT(result.confidence, 0.5F);
  EXPECT_EQ(result.input.used, cloud->size());
  EXPECT_GE(correspondenceRate(mapErrors(bentHuman(), result.partners)), 0.95);
}

TEST(CloudInput, NormalsThatNobodyEstimatedAreRefused)
{
  SymmetryParameters parameters;
  parameters.normals = NormalSource::Given;
  EXPECT_THROW(compute(cloudOf<pcl::PointNormal>(bentHuman().surface.points), parameters), pcl::BadArgumentException);
}

TEST(CloudInput, SparseResultsComeFromTheSameMap)
{
  SymmetryParameters parameters;
  const auto cloud = cloudOf(bentHuman().surface.points);
  const pcl::IntrinsicSymmetryResult dense = compute(cloud, parameters);
  parameters.sparse_only = true;
  const pcl::IntrinsicSymmetryResult sparse = compute(cloud, parameters);
  EXPECT_EQ(sparse.confidence, dense.confidence);
  EXPECT_EQ(sparse.sides, dense.sides);
  EXPECT_EQ(sparse.matches.size(), dense.matches.size());
  EXPECT_EQ(std::count(sparse.partners.begin(), sparse.partners.end(), no_index),
            static_cast<std::ptrdiff_t>(cloud->size()));
}

TEST(CloudInput, ASearchForRastersIsRefused)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  EXPECT_THROW(estimation.setSearchMethod(pcl::make_shared<pcl::search::OrganizedNeighbor<pcl::PointXYZ>>()),
               pcl::BadArgumentException);
}

TEST(CloudInput, GivenNormalsOfPointsWithoutAreRefused)
{
  SymmetryParameters parameters;
  parameters.normals = NormalSource::Given;
  EXPECT_THROW(compute(cloudOf(bentHuman().surface.points), parameters), pcl::BadArgumentException);
}

TEST(CloudInput, DuplicatedPointsAreKept)
{
  std::vector<Vector3> points = bentHuman().surface.points;
  const std::size_t n = points.size();
  for (std::size_t v = 0; v < n; v += 5) {
    const Vector3 copy = points[v];
    points.push_back(copy);
  }
  const pcl::IntrinsicSymmetryResult result = compute(cloudOf(points));
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric) << result.message;
  EXPECT_EQ(result.input.used, points.size());
  std::vector<Index> partners(result.partners.begin(), result.partners.begin() + static_cast<std::ptrdiff_t>(n));
  for (Index& partner : partners) {
    partner = partner < static_cast<Index>(n) ? partner : 5 * (partner - static_cast<Index>(n));
  }
  EXPECT_GE(correspondenceRate(mapErrors(bentHuman(), partners)), 0.95);
}

/** A cloud of the points of a body that are kept, run, and the rate of right partners. */
double
rateOfPart(const Model& whole, const std::vector<char>& keep)
{
  std::vector<Vector3> points;
  std::vector<Index> vertices;
  for (std::size_t v = 0; v < keep.size(); ++v) {
    if (keep[v] != 0) {
      points.push_back(whole.surface.points[v]);
      vertices.push_back(static_cast<Index>(v));
    }
  }
  const pcl::IntrinsicSymmetryResult result = compute(cloudOf(points));
  EXPECT_EQ(result.status, SymmetryStatus::Symmetric) << result.message;
  Model part = whole;
  std::vector<Index> partners(whole.surface.size(), no_index);
  std::fill(part.partners.begin(), part.partners.end(), no_index); // of vertices that are not asked for
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Index partner = result.partners[i];
    partners[vertices[i]] = partner == no_index ? no_index : vertices[partner];
    part.partners[vertices[i]] = whole.partners[vertices[i]];
  }
  return correspondenceRate(mapErrors(part, partners));
}

Model
fineHuman()
{
  ModelParameters parameters;
  parameters.vertices = 10000;
  parameters.seed = 4;
  return makeModel(parameters);
}

TEST(CloudInput, FewPointsAtRandomPlacesAreEnough)
{
  const Model whole = fineHuman();
  std::vector<char> keep(whole.surface.size(), 0);
  std::mt19937 random(3); // NOLINT(cert-msc51-cpp): the same every time
  std::generate(keep.begin(), keep.end(), [&] { return static_cast<char>(random() % 4 == 0); });
  EXPECT_GE(rateOfPart(whole, keep), 0.95);
}

TEST(CloudInput, MayBeTenTimesDenserAtOneEnd)
{
  const Model whole = fineHuman();
  EXPECT_GE(rateOfPart(whole, markThinnedOut(whole.surface.points, 10.0, 5)), 0.95);
}

} // namespace
