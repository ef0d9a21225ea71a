#include "base/vector_math.h"
#include "support/symmetric_shapes.h"
#include "symmetry/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

const Surface&
table()
{
  static const Surface mesh = tableMesh(0.6, 0.6);
  return mesh;
}

SymmetryResult
estimate(int alternatives)
{
  SymmetryParameters parameters;
  parameters.alternatives = alternatives;
  StepTimer timer;
  return runPipeline(table(), parameters, NeighbourSearch{}, timer);
}

const SymmetryResult&
allSymmetries()
{
  static const SymmetryResult result = estimate(8);
  return result;
}

/** Mean distance between the partners and where the table's own symmetry about the vertical axis takes the points. */
float
meanError(const std::vector<Index>& partners, bool reflect, int quarter_turns)
{
  const double turn = full_turn * quarter_turns / 4;
  const auto c = static_cast<float>(std::cos(turn));
  const auto s = static_cast<float>(std::sin(turn));
  float sum = 0.0F;
  for (std::size_t v = 0; v < partners.size(); ++v) {
    const Vector3& p = table().points[v];
    const float x = reflect ? -p[0] : p[0];
    sum += distance(table().points[partners[v]], Vector3{c * x + s * p[2], p[1], -s * x + c * p[2]});
  }
  return sum / static_cast<float>(partners.size());
}

std::size_t
countFound(const std::vector<AlternativeMap>& maps, bool reflect, int first_turn)
{
  constexpr float side = 1.2F;
  std::size_t found = 0;
  for (int turns = first_turn; turns < 4; ++turns) {
    found += std::any_of(maps.begin(), maps.end(), [&](const AlternativeMap& map) {
      return meanError(map.partners, reflect, turns) < 0.08F * side;
    });
  }
  return found;
}

TEST(Alternatives, AreTheReflectionsOfTheSurfaceAndApartFromThemItsRotations)
{
  const SymmetryResult& result = allSymmetries();
  ASSERT_EQ(result.alternatives.size(), 4U);
  ASSERT_EQ(result.rotations.size(), 3U);
  EXPECT_EQ(countFound(result.alternatives, true, 0), 4U);
  EXPECT_EQ(countFound(result.rotations, false, 1), 3U);
  for (const AlternativeMap& map : result.alternatives) {
    EXPECT_TRUE(map.reverses_orientation);
  }
  for (const AlternativeMap& map : result.rotations) {
    EXPECT_FALSE(map.reverses_orientation);
  }
}

TEST(Alternatives, BeginWithTheResultAndAreSortedByScore)
{
  const SymmetryResult& result = allSymmetries();
  ASSERT_FALSE(result.alternatives.empty());
  EXPECT_EQ(result.alternatives[0].partners, result.partners);
  EXPECT_EQ(result.alternatives[0].confidence, result.confidence);
  for (const std::vector<AlternativeMap>* maps : {&result.alternatives, &result.rotations}) {
    EXPECT_TRUE(std::is_sorted(maps->begin(), maps->end(),
                               [](const AlternativeMap& a, const AlternativeMap& b) { return a.score < b.score; }));
  }
}

TEST(Alternatives, AreLeftOutUnlessAskedFor)
{
  const SymmetryResult result = estimate(1);
  EXPECT_EQ(result.status, SymmetryStatus::Symmetric);
  EXPECT_TRUE(result.alternatives.empty());
  EXPECT_TRUE(result.rotations.empty());
}

} // namespace
