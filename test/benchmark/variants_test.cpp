#include "base/vector_math.h"
#include "benchmark/data_set.h"
#include "benchmark/variants.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace pcl {
namespace symmetry {
namespace {

const Surface&
egg()
{
  static const Surface surface = test::scaled(test::sphereMesh(4), {1.0F, 1.5F, 2.0F});
  return surface;
}

/** Twice the volume of a closed mesh times three: positive where its faces look outwards. */
float
orientedVolume(const Surface& surface)
{
  float volume = 0.0F;
  for (const Triangle& t : surface.triangles)
    volume +=
        dot(surface.points[static_cast<std::size_t>(t[0])],
            cross(surface.points[static_cast<std::size_t>(t[1])], surface.points[static_cast<std::size_t>(t[2])]));
  return volume;
}

/** How far a point has moved, the largest way. */
float
largestWay(const VariedSurface& varied)
{
  float largest = 0.0F;
  for (std::size_t v = 0; v < varied.surface.size(); ++v)
    largest = std::max(largest,
                       distance(varied.surface.points[v], egg().points[static_cast<std::size_t>(varied.origins[v])]));
  return largest;
}

class EveryVariantTest : public ::testing::TestWithParam<std::size_t> {};

TEST_P(EveryVariantTest, IsAClosedMeshOfWhichEachPointHasItsPlaceOnTheOldOne)
{
  const VariedSurface varied = vary(egg(), static_cast<Variant>(GetParam()), 3);
  ASSERT_EQ(varied.origins.size(), varied.surface.size());
  ASSERT_EQ(varied.stand_ins.size(), egg().size());
  for (const Index origin : varied.origins)
    EXPECT_LT(static_cast<std::size_t>(origin), egg().size());
  for (const Index stand_in : varied.stand_ins)
    ASSERT_LT(static_cast<std::size_t>(stand_in), varied.surface.size());
  EXPECT_EQ(2 * (varied.surface.size() - 2), varied.surface.triangles.size()) << "Euler's formula for a sphere";
  EXPECT_NEAR(orientedVolume(varied.surface) / orientedVolume(egg()), 1.0F, 0.06F) << "and its faces look outwards";
}

INSTANTIATE_TEST_SUITE_P(All, EveryVariantTest, ::testing::Range(std::size_t{0}, variant_count + 1));

TEST(VariantsTest, ShuffledIsTheSameSurfaceInAnotherOrder)
{
  const VariedSurface varied = vary(egg(), Variant::Shuffled, 5);
  EXPECT_NE(varied.surface.points, egg().points);
  EXPECT_EQ(largestWay(varied), 0.0F);
  for (std::size_t v = 0; v < egg().size(); ++v)
    EXPECT_EQ(varied.origins[static_cast<std::size_t>(varied.stand_ins[v])], static_cast<Index>(v));
  EXPECT_EQ(vary(egg(), Variant::Shuffled, 5).origins, varied.origins);
  EXPECT_NE(vary(egg(), Variant::Shuffled, 6).origins, varied.origins);
}

TEST(VariantsTest, CoarserMeshesHaveTheirShareOfTheVerticesAndStayInPlace)
{
  const VariedSurface half = vary(egg(), Variant::Half, 1);
  const VariedSurface third = vary(egg(), Variant::Third, 1);
  EXPECT_EQ(half.surface.size(), egg().size() / 2);
  EXPECT_EQ(third.surface.size(), egg().size() / 3);
  const float edge = distance(egg().points[static_cast<std::size_t>(egg().triangles[0][0])],
                              egg().points[static_cast<std::size_t>(egg().triangles[0][1])]);
  EXPECT_LT(largestWay(third), 3.0F * edge);
  for (std::size_t v = 0; v < egg().size(); ++v)
    EXPECT_LT(distance(egg().points[v], third.surface.points[static_cast<std::size_t>(third.stand_ins[v])]),
              5.0F * edge);
}

TEST(VariantsTest, OthersMoveThePointsAsFarAsTheySay)
{
  const VariedSurface finer = vary(egg(), Variant::Subdivided, 1);
  EXPECT_EQ(finer.surface.triangles.size(), 4 * egg().triangles.size());
  const float noise = largestWay(vary(egg(), Variant::Noisy, 1));
  EXPECT_GT(noise, 1e-3F);
  EXPECT_LT(noise, 0.05F) << "a thousandth of the diagonal of 5.4, several times that at most";
  const float stretched = largestWay(vary(egg(), Variant::Stretched, 1));
  EXPECT_GT(stretched, 0.03F * 0.9F);
  EXPECT_LE(stretched, 0.03F * 2.01F);
  const VariedSurface mirrored = vary(egg(), Variant::Mirrored, 1);
  EXPECT_EQ(mirrored.surface.points[7][0], -egg().points[7][0]);
  EXPECT_LT(largestWay(vary(egg(), Variant::Smoothed, 1)), 0.05F);
  EXPECT_GT(largestWay(vary(egg(), Variant::Smoothed, 1)), 0.0F);
}

TEST(VariantsTest, SomeTakeOtherSamples)
{
  EXPECT_EQ(samplesOf(Variant::AsItIs), 1.0F);
  EXPECT_GT(samplesOf(Variant::MoreSamples), 1.0F);
  EXPECT_LT(samplesOf(Variant::FewerSamples), 1.0F);
}

TEST(VariantsTest, FollowTheirModels)
{
  std::vector<BenchmarkModel> models(2);
  models[0].name = "a";
  models[1].name = "b";
  addVariants(models, variant_count);
  ASSERT_EQ(models.size(), 2 * (variant_count + 1));
  EXPECT_EQ(models[0].name, "a");
  EXPECT_EQ(models[1].name, "a~shuffled");
  EXPECT_EQ(models[variant_count + 1].name, "b");
  std::set<std::string> names;
  for (const BenchmarkModel& model : models)
    names.insert(model.name);
  EXPECT_EQ(names.size(), models.size()) << "each its own";
}

} // namespace
} // namespace symmetry
} // namespace pcl
