#include "cloud/clouds.h"
#include "support/boxes.h"
#include "support/shapes.h"
#include "symmetry/mirror_method.h"
#include "symmetry/surface/surface_preparation.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr std::size_t usual_samples = 1500;

Surface
splitTwice(const Surface& mesh)
{
  return finer(finer(mesh));
}

std::vector<MirrorFit>
planesOfCloud(const std::vector<Vector3>& points)
{
  Surface cloud;
  cloud.points = points;
  return mirrorPlanesOf(prepareAsItStands(cloud, SymmetryParameters{}, nearestNeighbours), usual_samples,
                        MirrorSettings{});
}

/** Fewer corners than samples, so that all of them are samples: what counts is the area that each stands for. */
TEST(MirrorPlanesOfACloud, ManyCornersOfASmallPartDoNotOutweighAFewOfALargeOne)
{
  std::vector<Vector3> corners = splitTwice(chairOfBoxes()).points;
  const std::size_t of_chair = corners.size();
  const std::vector<Vector3> lever = sphereCloud(of_chair / 8, 0.015F, {0.2F, 0.1F, 0.41F}); // below the seat
  corners.insert(corners.end(), lever.begin(), lever.end());
  ASSERT_LT(corners.size(), usual_samples);
  const std::vector<MirrorFit> planes = planesOfCloud(corners);
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_GT(std::abs(planes[0].plane.normal[0]), 0.999F);
  EXPECT_GT(planes[0].share, 0.95F);
}

TEST(MirrorPlanesOfACloud, APartAsLargeAsOthersCounts)
{
  Surface chair = chairOfBoxes();
  addBox(chair, {0.3F, -0.25F, 0.4F}, {0.7F, 0.2F, 0.45F}); // a table at one arm
  const std::vector<MirrorFit> planes = planesOfCloud(splitTwice(chair).points);
  EXPECT_TRUE(planes.empty() || planes[0].is_of_part);
}

TEST(MirrorPlanesOfACloud, StrayPointsDoNotOutweighTheRest)
{
  std::vector<Vector3> corners = splitTwice(chairOfBoxes()).points;
  for (int i = 0; i < 6; ++i) {
    corners.push_back({0.5F + 0.2F * static_cast<float>(i), 0.3F, 0.3F * static_cast<float>(i % 3)});
  }
  EXPECT_EQ(planesOfCloud(corners).size(), 1U);
}

} // namespace
