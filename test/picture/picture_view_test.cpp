// Where a surface is seen from: both sides in view, nothing cut off, and a picture that turns with the surface.
#include "base/vector_math.h"
#include "picture/picture_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace pcl::symmetry;

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/** A plate: x from -1 to 1 is left and right, y from 0 to 3 is up; hardly any depth. */
struct Plate {
  Surface surface;
  SymmetryResult result;

  Plate()
  {
    constexpr int half = 10;
    constexpr int rows = 30;
    for (int j = 0; j <= rows; ++j)
      for (int i = -half; i <= half; ++i) {
        surface.points.push_back({0.1F * static_cast<float>(i), 0.1F * static_cast<float>(j), 0.0F});
        result.sides.push_back(i < 0 ? Side::Source : i > 0 ? Side::Target : Side::Axis);
        result.partners.push_back(j * (2 * half + 1) + half - i);
        result.confidences.push_back(1.0F);
      }
  }

  PictureView
  view() const
  {
    return chooseView(surface, result, findPartnerPairs(surface, result));
  }
};

void
expectOrthonormal(const PictureView& view)
{
  for (const Vector3& direction : {view.right, view.up, view.toward})
    EXPECT_NEAR(norm(direction), 1.0F, 1e-5F);
  EXPECT_NEAR(dot(view.right, view.up), 0.0F, 1e-5F);
  EXPECT_NEAR(dot(view.right, view.toward), 0.0F, 1e-5F);
  EXPECT_NEAR(dot(view.up, view.toward), 0.0F, 1e-5F);
  EXPECT_NEAR(dot(cross(view.right, view.up), view.toward), 1.0F, 1e-5F) << "right-handed: not mirrored";
}

TEST(PictureView, LooksAtRightAnglesToThePlaneBetweenTheSides)
{
  // Pairs that lead aslant, as where partners are the nearest of few vertices: the plane says where the sides face.
  Plate plate;
  plate.result.plane.normal = {-1.0, 0.0, 0.0};
  for (std::size_t v = 0; v < plate.surface.size(); ++v) {
    plate.surface.points[v][2] = plate.surface.points[v][0] > 0.0F ? 0.4F : 0.0F;
  }
  const PictureView view = plate.view();
  expectOrthonormal(view);
  EXPECT_NEAR(view.toward[0], 0.0F, 1e-5F);
  EXPECT_NEAR(std::abs(view.right[0]), 1.0F, 1e-5F);
}

TEST(PictureView, ShowsAPlateFromTheFrontAndAllOfIt)
{
  const Plate plate;
  const PictureView view = plate.view();
  expectOrthonormal(view);
  EXPECT_GT(std::abs(view.toward[2]), 0.95F) << "from where it is largest";
  EXPECT_GT(view.up[1], 0.95F) << "the line from side to side is level";
  for (const Vector3& point : plate.surface.points) {
    EXPECT_LE(std::abs(dot(point - view.centre, view.right)), 0.5F * view.width);
    EXPECT_LE(std::abs(dot(point - view.centre, view.up)), 0.5F * view.height);
  }
  EXPECT_LT(view.height, 1.2F * 3.0F) << "and not much around it";
}

TEST(PictureView, ShowsASheetFromTheFrontWhicheverWayItWouldStand)
{
  // On its tip it would fall over, on its back it would not: but then there is nothing to be seen of it.
  Plate rhombus;
  for (Vector3& p : rhombus.surface.points) {
    p[0] *= 1.0F - std::abs(p[1] - 1.5F) / 1.6F;
  }
  EXPECT_GT(std::abs(rhombus.view().toward[2]), 0.95F);
}

TEST(PictureView, DoesNotDependOnPlaceAndSize)
{
  const Plate plate;
  Plate moved;
  for (Vector3& point : moved.surface.points)
    point = 4.0F * point + Vector3{16.0F, -8.0F, 32.0F};
  const PictureView view = plate.view();
  const PictureView other = moved.view();
  EXPECT_NEAR(other.width, 4.0F * view.width, 1e-3F);
  EXPECT_NEAR(other.height, 4.0F * view.height, 1e-3F);
  EXPECT_LT(distance(other.centre, 4.0F * view.centre + Vector3{16.0F, -8.0F, 32.0F}), 1e-3F);
  EXPECT_LT(distance(other.toward, view.toward), 1e-3F);
}

TEST(PictureView, FromBehindIsTurnedAboutTheUpright)
{
  const PictureView view = Plate().view();
  const PictureView behind = view.fromBehind();
  expectOrthonormal(behind);
  EXPECT_EQ(behind.up, view.up);
  EXPECT_EQ(behind.toward, -1.0F * view.toward);
  EXPECT_EQ(behind.width, view.width);
  EXPECT_EQ(behind.fromBehind().right, view.right);
}

TEST(PictureView, StandsPointsThatCannotBeSeen)
{
  Plate plate;
  plate.surface.points[5] = {nan, 0.0F, 0.0F};
  const PictureView view = plate.view();
  expectOrthonormal(view);
  EXPECT_TRUE(std::isfinite(view.width) && view.width > 0.0F);
  Surface lone;
  lone.points = {{1.0F, 2.0F, 3.0F}};
  SymmetryResult none;
  none.sides = {Side::None};
  none.partners = {no_index};
  const PictureView single = chooseView(lone, none, {});
  expectOrthonormal(single);
  EXPECT_GT(single.width, 0.0F);
  EXPECT_LT(distance(single.centre, lone.points[0]), 1e-5F);
}

TEST(PartnerPairs, GoFromTheSourceSideOnce)
{
  Plate plate;
  plate.result.partners[0] = no_index;                          // on the source side
  plate.surface.points[21] = {nan, 0.0F, 0.0F};                 // another one
  plate.surface.points[plate.surface.size() - 1] = {nan, 0, 0}; // a partner
  const std::vector<PartnerPair> pairs = findPartnerPairs(plate.surface, plate.result);
  EXPECT_EQ(pairs.size(), 31U * 10U - 3U);
  for (const PartnerPair& pair : pairs) {
    EXPECT_EQ(plate.result.sides[static_cast<std::size_t>(pair.source)], Side::Source);
    EXPECT_EQ(plate.result.partners[static_cast<std::size_t>(pair.source)], pair.target);
  }
}

TEST(PartnerPairs, AreTheMatchesWhereThereIsNoMap)
{
  Plate plate;
  plate.result.partners.assign(plate.surface.size(), no_index);
  plate.result.matches = {{0, 20, 10, 0.0F}, {1, no_index, no_index, 0.0F}};
  const std::vector<PartnerPair> pairs = findPartnerPairs(plate.surface, plate.result);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].source, 0);
  EXPECT_EQ(pairs[0].target, 20);
}

} // namespace
