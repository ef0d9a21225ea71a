// Surfaces in several connected components: all of an object takes part, or the largest component alone.
#include "support/shapes.h"

#include <pcl/symmetry/symmetry.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr std::size_t of_body = 1026;
constexpr std::size_t of_knob = 258;

/** An ellipsoid, and a knob above it in the plane x = 0. */
Surface
bodyWithKnob(float gap)
{
  Surface both = scaled(sphereMesh(3), {0.1F, 0.1F, 0.1F});
  for (Vector3& p : both.points) {
    p[2] += 0.7F + gap;
  }
  const Surface body = scaled(sphereMesh(4), {1.0F, 0.8F, 0.6F});
  const auto first = static_cast<Index>(both.size());
  both.points.insert(both.points.end(), body.points.begin(), body.points.end());
  for (const Triangle& t : body.triangles) {
    both.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  return both;
}

std::size_t
partnersAmong(const SymmetryResult& result, std::size_t first, std::size_t last)
{
  return static_cast<std::size_t>(std::count_if(result.partners.begin() + static_cast<std::ptrdiff_t>(first),
                                                result.partners.begin() + static_cast<std::ptrdiff_t>(last),
                                                [](Index v) { return v != no_index; }));
}

class ComponentsTest : public testing::TestWithParam<bool> {
protected:
  SymmetryResult
  estimate(ComponentUse use) const
  {
    constexpr float wider_than_points_are_apart = 0.2F; // what is nearer is one component of a cloud
    Surface surface = bodyWithKnob(GetParam() ? wider_than_points_are_apart : 0.0F);
    if (GetParam()) {
      surface.triangles.clear();
    }
    SymmetryParameters parameters;
    parameters.components = use;
    return estimateIntrinsicSymmetry(surface, parameters);
  }
};

INSTANTIATE_TEST_SUITE_P(MeshAndCloud, ComponentsTest, testing::Bool(), [](const testing::TestParamInfo<bool>& tested) {
  return tested.param ? "Cloud" : "Mesh";
});

TEST_P(ComponentsTest, AllTakePartUnlessOneIsAskedFor)
{
  const SymmetryResult result = estimate(ComponentUse::All);
  ASSERT_TRUE(hasMap(result.status)) << result.message;
  EXPECT_EQ(result.input.used, of_body + of_knob);
  EXPECT_EQ(partnersAmong(result, 0, of_knob), of_knob);
}

TEST_P(ComponentsTest, TheLargestAloneIsTakenWhereItIsAskedFor)
{
  const SymmetryResult result = estimate(ComponentUse::Largest);
  ASSERT_TRUE(hasMap(result.status)) << result.message;
  EXPECT_EQ(result.input.components, 2U);
  EXPECT_EQ(result.input.used, of_body);
  EXPECT_EQ(result.input.other_components, of_knob);
  EXPECT_EQ(partnersAmong(result, 0, of_knob), 0U);
  EXPECT_EQ(partnersAmong(result, of_knob, of_knob + of_body), of_body);
  EXPECT_EQ(result.message.find("lie apart"), std::string::npos) << "what was not asked for is no loss";
}

/** An ellipsoid of of_body points, and others of of_knob points far from it and each other. */
SymmetryResult
estimateFarApart(int others)
{
  Surface all = scaled(sphereMesh(4), {1.0F, 0.8F, 0.6F});
  for (int i = 0; i < others; ++i) {
    Surface other = scaled(sphereMesh(3), {0.5F, 0.4F, 0.3F});
    const auto first = static_cast<Index>(all.points.size());
    for (const Vector3& p : other.points) {
      all.points.push_back(
          {p[0] + 20.0F + 20.0F * static_cast<float>(i), p[1], p[2] + 7.0F * static_cast<float>(i * i)});
    }
    for (const Triangle& t : other.triangles) {
      all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  return estimateIntrinsicSymmetry(all);
}

TEST(PartsFarApart, MakeTheSymmetryThatOfAPart)
{
  const SymmetryResult result = estimateFarApart(1);
  ASSERT_EQ(result.input.used, of_body) << result.message;
  EXPECT_EQ(result.status, SymmetryStatus::PartlySymmetric);
  EXPECT_LE(result.confidence, 1026.0F / 1284.0F);
  EXPECT_NE(result.message.find("20 % of the points lie apart"), std::string::npos) << result.message;
}

TEST(PartsFarApart, LeaveNoSymmetryWhereTheyAreMost)
{
  const SymmetryResult result = estimateFarApart(5);
  ASSERT_EQ(result.input.used, of_body) << result.message;
  EXPECT_EQ(result.status, SymmetryStatus::NoSymmetry);
  EXPECT_NE(result.message.find("largest component"), std::string::npos) << result.message;
}

} // namespace
