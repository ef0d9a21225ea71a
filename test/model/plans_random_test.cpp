#include "model/body_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace pcl::symmetry;

namespace {

constexpr std::uint64_t seeds = 200;

/** Whether a piece of flesh has its mirror image among the others, which may be itself. */
bool
isMirrored(const Flesh& piece, const std::vector<Flesh>& all)
{
  const auto image = [](Eigen::Vector3d p) {
    p.x() = -p.x();
    return p;
  };
  return std::any_of(all.begin(), all.end(), [&](const Flesh& other) {
    return other.cone.start() == image(piece.cone.start()) && other.cone.end() == image(piece.cone.end()) &&
           other.cone.startRadius() == piece.cone.startRadius() && other.cone.endRadius() == piece.cone.endRadius();
  });
}

bool
isItsOwnMirrorImage(const BodyPlan& plan)
{
  return std::all_of(plan.flesh().begin(), plan.flesh().end(),
                     [&](const Flesh& piece) { return isMirrored(piece, plan.flesh()); });
}

TEST(RandomPlans, CreaturesAreTheirOwnMirrorImageAndTheOthersAreNot)
{
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    EXPECT_TRUE(isItsOwnMirrorImage(creaturePlan(seed))) << seed;
    EXPECT_FALSE(isItsOwnMirrorImage(lameCreaturePlan(seed))) << seed;
    EXPECT_FALSE(isItsOwnMirrorImage(askewCreaturePlan(seed))) << seed;
  }
}

TEST(RandomPlans, ALameCreatureIsThatOfTheSameSeedWithoutALimb)
{
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const BodyPlan whole = creaturePlan(seed);
    const BodyPlan lame = lameCreaturePlan(seed);
    std::vector<std::string> missing;
    for (const Bone& bone : whole.bones()) {
      if (std::none_of(lame.bones().begin(), lame.bones().end(), [&](const Bone& b) { return b.name == bone.name; })) {
        missing.push_back(bone.name);
      }
    }
    ASSERT_FALSE(missing.empty()) << seed;
    EXPECT_EQ(whole.bones().size(), lame.bones().size() + missing.size()) << seed;
    for (const std::string& name : missing) {
      EXPECT_EQ(name.rfind(missing[0].substr(0, missing[0].size() - 1), 0), 0U) << name << " of another limb";
    }
  }
}

TEST(RandomPlans, NoBallHoldsTheOtherEndOfItsPiece)
{
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    for (const BodyPlan& plan : {creaturePlan(seed), askewCreaturePlan(seed)}) {
      for (const Flesh& piece : plan.flesh()) {
        EXPECT_LT(std::abs(piece.cone.startRadius() - piece.cone.endRadius()),
                  (piece.cone.end() - piece.cone.start()).norm())
            << seed << ": no cone goes around both";
      }
    }
  }
}

} // namespace
