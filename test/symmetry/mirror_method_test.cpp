#include "base/bounding_box.h"
#include "base/vector_math.h"
#include "cloud/clouds.h"
#include "support/boxes.h"
#include "support/prepared.h"
#include "support/scattered.h"
#include "support/shapes.h"
#include "symmetry/mirror_method.h"
#include "symmetry/surface/surface_preparation.h"

#include <gtest/gtest.h>

#include <algorithm>
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

/** Of one diagonal in twelve from 1.55 on the tolerance becomes larger when it is multiplied by it and divided again. */
TEST(MirrorPlanesOfACloud, APlaneOfAPartIsFoundWhateverTheDiagonal)
{
  Surface chair = chairOfBoxes();
  addBox(chair, {0.3F, -0.25F, 0.4F}, {0.7F, 0.2F, 0.45F});
  const std::vector<Vector3> points = scattered(chair, 8000).points;
  const float tolerance = PlaneSearchSettings{}.tolerance;
  int rounded = 0;
  for (int k = 0; k < 200 && rounded < 3; ++k) {
    Surface cloud;
    cloud.points = points;
    for (Vector3& p : cloud.points) {
      p[1] *= 1.8F + 0.001F * static_cast<float>(k);
    }
    const PreparedSurface prepared = prepareAsItStands(cloud, SymmetryParameters{}, nearestNeighbours);
    const auto diagonal = static_cast<float>(boundingBox(prepared.points).diagonal());
    if (tolerance * diagonal / diagonal <= tolerance) {
      continue;
    }
    ++rounded;
    const std::vector<MirrorFit> planes = mirrorPlanesOf(prepared, usual_samples, MirrorSettings{});
    ASSERT_EQ(planes.size(), 1U) << k;
    EXPECT_TRUE(planes[0].is_of_part);
  }
  EXPECT_EQ(rounded, 3);
}

TEST(MirrorPlanesOfACloud, StrayPointsDoNotOutweighTheRest)
{
  std::vector<Vector3> corners = splitTwice(chairOfBoxes()).points;
  for (int i = 0; i < 6; ++i) {
    corners.push_back({0.5F + 0.2F * static_cast<float>(i), 0.3F, 0.3F * static_cast<float>(i % 3)});
  }
  EXPECT_EQ(planesOfCloud(corners).size(), 1U);
}

/** A trunk with two bars, one of which is raised and one lowered: posed limbs; and with two between them that lie in the
 * plane. */
class PosedBars : public testing::Test {
protected:
  static constexpr float raised = 0.25F;

  PosedBars() : surface_(preparedMesh(mesh())), sampled_(sampleSurface(surface_, {}, Metric::Geodesic, timer_))
  {
    fit_.plane = {{1.0F, 0.0F, 0.0F}, 0.0F};
  }

  static Surface
  mesh()
  {
    Surface mesh;
    addBox(mesh, {-0.3F, -0.2F, -0.5F}, {0.3F, 0.2F, 0.5F});
    addBox(mesh, {-0.9F, -0.1F, raised - 0.1F}, {-0.29F, 0.1F, raised + 0.1F});
    addBox(mesh, {0.29F, -0.1F, -raised - 0.1F}, {0.9F, 0.1F, -raised + 0.1F});
    addBox(mesh, {-0.1F, 0.19F, -raised - 0.1F}, {0.1F, 0.8F, -raised + 0.1F});
    addBox(mesh, {-0.1F, -0.8F, raised - 0.1F}, {0.1F, -0.19F, raised + 0.1F});
    return splitTwice(splitTwice(mesh));
  }

  /** The map of the samples that sends each to the point nearest to a place. */
  template <typename Place>
  SampleEstimate
  sending(Place place) const
  {
    SampleEstimate samples;
    for (const Vector3& p : sampled_.coarse.points) {
      const Vector3 there = place(p);
      const auto nearer = [&there](const Vector3& a, const Vector3& b) {
        return distance(a, there) < distance(b, there);
      };
      const auto nearest = std::min_element(surface_.points.begin(), surface_.points.end(), nearer);
      samples.partners.push_back(static_cast<Index>(nearest - surface_.points.begin()));
      samples.map.push_back(sampled_.coarse.cells.owner[samples.partners.back()]);
    }
    for (std::size_t i = 0; i < sampled_.landmarks.size(); ++i) {
      samples.landmark_map.push_back(sampled_.landmarks.nearest_landmark[samples.map[i]]);
    }
    return samples;
  }

  bool
  isOfBar(const Vector3& p) const
  {
    return std::abs(p[0]) > 0.32F * surface_.scale;
  }

  StepTimer timer_;
  PreparedSurface surface_;
  SampledSurface sampled_;
  MirrorFit fit_;
};

TEST_F(PosedBars, AreExchangedByAMapThatAgreesWithThePlaneElsewhere)
{
  const PlaneComparison compared =
      compareWithPlane(sampled_, sending([this](const Vector3& p) {
                         const float way = isOfBar(p) ? std::copysign(2.0F * raised * surface_.scale, p[0]) : 0.0F;
                         return Vector3{-p[0], p[1], p[2] + way};
                       }),
                       fit_, {});
  EXPECT_FALSE(compared.contradicts);
  EXPECT_TRUE(compared.exchanges);
  EXPECT_TRUE(compared.is_pose);
}

TEST_F(PosedBars, AreNotExchangedWhereEachStaysAtItsPlace)
{
  const PlaneComparison compared =
      compareWithPlane(sampled_, sending([this](const Vector3& p) {
                         return isOfBar(p) ? Vector3{p[0], -p[1], p[2]} : Vector3{-p[0], p[1], p[2]};
                       }),
                       fit_, {});
  EXPECT_FALSE(compared.contradicts);
  EXPECT_FALSE(compared.exchanges);
  EXPECT_FALSE(compared.is_pose);
}

/** Each bar changes places with one that lies in the plane and is its own image: they are no pair of limbs. */
TEST_F(PosedBars, AreNotExchangedWithWhatThePlaneCarriesOntoTheSurface)
{
  const float trunk = 0.2F * surface_.scale;
  const float shift = 0.1F * surface_.scale;
  const PlaneComparison compared = compareWithPlane(sampled_, sending([=](const Vector3& p) -> Vector3 {
                                                      if (isOfBar(p)) {
                                                        return {p[1], p[0] - std::copysign(shift, p[0]), p[2]};
                                                      }
                                                      if (std::abs(p[1]) > 1.05F * trunk) {
                                                        return {p[1] + std::copysign(shift, p[1]), p[0], p[2]};
                                                      }
                                                      return {-p[0], p[1], p[2]};
                                                    }),
                                                    fit_, {});
  EXPECT_FALSE(compared.exchanges);
}

TEST_F(PosedBars, AMapThatTurnsTheTrunkAnotherWayContradicts)
{
  const PlaneComparison compared = compareWithPlane(sampled_, sending([](const Vector3& p) {
                                                      return Vector3{p[0], -p[1], p[2]};
                                                    }),
                                                    fit_, {});
  EXPECT_TRUE(compared.contradicts);
  EXPECT_FALSE(compared.moves_farther);
}

/** A plane through the broad sides of a board exchanges them; a map that exchanges its ends moves it much farther. */
TEST_F(PosedBars, AMapThatMovesTheTrunkMuchFartherSaysSo)
{
  fit_.plane = {{0.0F, 1.0F, 0.0F}, 0.0F};
  const auto upside_down = sending([](const Vector3& p) { return Vector3{p[0], p[1], -p[2]}; });
  const PlaneComparison compared = compareWithPlane(sampled_, upside_down, fit_, {});
  EXPECT_TRUE(compared.contradicts);
  EXPECT_TRUE(compared.moves_farther);
}

/** The sides are named by the shape: not by the direction of the normal, which depends on how a surface lies. */
TEST_F(PosedBars, SidesAreNamedAlikeWhicheverWayTheNormalPoints)
{
  MirrorFit turned = fit_;
  turned.plane = {{-1.0F, 0.0F, 0.0F}, 0.0F};
  const MapEstimate first = estimateByMirror(sampled_, {fit_}, {}, {});
  const MapEstimate second = estimateByMirror(sampled_, {turned}, {}, {});
  EXPECT_EQ(first.side_function, second.side_function);
}

} // namespace
