#include "model/pose.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace pcl::symmetry;

namespace {

using V = Eigen::Vector3d;

/** \brief Two bones along x with the joint between them at (1, 0, 0), which turns about z. */
BodyPlan
arm()
{
  BodyPlan plan(0.02, 0.05);
  const int upper = plan.addBone("upper", -1, V(0, 0, 0), V(0, 0, 0), V(0, 0, 0));
  plan.addFlesh(upper, V(0, 0, 0), 0.1, V(1, 0, 0), 0.1);
  const int lower = plan.addBone("lower", upper, V(1, 0, 0), V(0, 0, 10), V(0, 0, 90));
  plan.addFlesh(lower, V(1, 0, 0), 0.1, V(2, 0, 0), 0.1);
  return plan;
}

TEST(BodyPlan, MirrorAddsTheOtherSide)
{
  BodyPlan plan(0.02, 0.05);
  const int trunk = plan.addBone("trunk", -1, V(0, 0, 0), V::Zero(), V::Zero());
  plan.addFlesh(trunk, V(0, 0, 0), 0.2, V(0, 1, 0), 0.2);
  const int limb = plan.addBone("left limb", trunk, V(0.2, 0, 0), V(-1, -2, -3), V(4, 5, 6));
  plan.addFlesh(limb, V(0.2, 0, 0), 0.1, V(1, 0, 0), 0.1);
  plan.mirror();
  ASSERT_EQ(plan.bones().size(), 3U);
  ASSERT_EQ(plan.flesh().size(), 3U);
  const Bone& right = plan.bones()[static_cast<std::size_t>(plan.find("right limb"))];
  EXPECT_EQ(right.joint, V(-0.2, 0, 0));
  EXPECT_EQ(right.lowest_turn, V(-1, -5, -6));
  EXPECT_EQ(right.highest_turn, V(4, 2, 3));
}

TEST(BodyPlan, RemoveTakesWhatHangsOnTheBone)
{
  BodyPlan plan = humanPlan();
  const std::size_t bones = plan.bones().size();
  plan.remove("left upper arm");
  EXPECT_EQ(plan.bones().size(), bones - 3);
  EXPECT_THROW(plan.find("left hand"), std::invalid_argument);
  EXPECT_NO_THROW(plan.find("right hand"));
  for (const Flesh& piece : plan.flesh())
    EXPECT_LT(piece.bone, static_cast<int>(plan.bones().size()));
}

TEST(Pose, AnglesStayWithinTheLimitsTimesTheBend)
{
  const BodyPlan plan = humanPlan();
  RandomNumbers random(8);
  for (int round = 0; round < 50; ++round) {
    const Pose pose = randomPose(plan, 0.5, random);
    for (std::size_t i = 0; i < pose.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        EXPECT_GE(pose[i][k], 0.5 * plan.bones()[i].lowest_turn[k]);
        EXPECT_LE(pose[i][k], 0.5 * plan.bones()[i].highest_turn[k]);
      }
  }
}

TEST(Pose, StraightPoseMovesNothing)
{
  std::vector<V> points = {V(0.3, 0.1, 0), V(1, 0.1, 0), V(1.7, 0, 0.1)};
  const std::vector<V> rest = points;
  bendBody(arm(), Pose(2, V::Zero()), points);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR((points[i] - rest[i]).norm(), 0.0, 1e-12);
}

TEST(Pose, LimbsTurnRigidlyAboutTheirJoint)
{
  std::vector<V> points = {V(0.2, 0.1, 0), V(2.1, 0, 0), V(1.7, 0.1, 0)};
  bendBody(arm(), {V::Zero(), V(0, 0, 90)}, points);
  EXPECT_NEAR((points[0] - V(0.2, 0.1, 0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((points[1] - V(1, 1.1, 0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR((points[2] - V(0.9, 0.7, 0)).norm(), 0.0, 1e-6);
}

TEST(Pose, ChildrenFollowTheirParents)
{
  // A quarter turn at the root and one at the joint: x becomes y, then the tip points back along -x.
  std::vector<V> points = {V(2.1, 0, 0)};
  bendBody(arm(), {V(0, 0, 90), V(0, 0, 90)}, points);
  EXPECT_NEAR((points[0] - V(-1.1, 1, 0)).norm(), 0.0, 1e-6);
}

TEST(Pose, SkinAroundAJointKeepsItsThickness)
{
  // On the joint's axis of rotation the skin must not collapse, as it does with blended matrices.
  std::vector<V> points = {V(1, 0, 0.1)};
  bendBody(arm(), {V::Zero(), V(0, 0, 90)}, points);
  EXPECT_NEAR(points[0].z(), 0.1, 1e-9);
  EXPECT_NEAR((points[0] - V(1, 0, 0.1)).norm(), 0.0, 1e-6);
}

} // namespace
