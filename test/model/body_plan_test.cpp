#include "model/body_plan.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace pcl::symmetry;
using V = Eigen::Vector3d;

namespace {

/** A trunk in the plane x = 0 with one arm of two bones, then mirrored. */
BodyPlan
twoArms()
{
  BodyPlan plan(0.02, 0.05);
  const int trunk = plan.addBone("trunk", -1, V::Zero(), V::Zero(), V::Zero());
  const int arm = plan.addBone("left arm", trunk, V(1, 2, 0), V(-10, -20, -30), V(40, 50, 60));
  const int hand = plan.addBone("left hand", arm, V(2, 2, 0), V::Zero(), V::Zero());
  plan.addFlesh(trunk, V(0, 0, 0), 0.3, V(0, 2, 0), 0.2);
  plan.addFlesh(arm, V(1, 2, 0), 0.1, V(2, 2, 0.5), 0.05);
  plan.addFlesh(hand, V(2, 2, 0.5), 0.05, V(2.5, 2, 0.5), 0.01);
  plan.mirror();
  return plan;
}

TEST(BodyPlan, TheMirrorImageOfALimbHangsOnThatOfItsParent)
{
  const BodyPlan plan = twoArms();
  ASSERT_EQ(plan.bones().size(), 5U);
  const auto bone = [&](const char* name) {
    return plan.bones()[static_cast<std::size_t>(plan.find(name))];
  };
  EXPECT_EQ(bone("right arm").parent, plan.find("trunk"));
  EXPECT_EQ(bone("right hand").parent, plan.find("right arm"));
  EXPECT_EQ(bone("right hand").joint, V(-2, 2, 0));
}

TEST(BodyPlan, AMirroredTurnAboutYOrZHasTheOtherSense)
{
  const BodyPlan plan = twoArms();
  const Bone& arm = plan.bones()[static_cast<std::size_t>(plan.find("right arm"))];
  EXPECT_EQ(arm.lowest_turn, V(-10, -50, -60));
  EXPECT_EQ(arm.highest_turn, V(40, 20, 30));
}

TEST(BodyPlan, FleshInTheMirrorPlaneIsNotDoubled)
{
  const BodyPlan plan = twoArms();
  ASSERT_EQ(plan.flesh().size(), 5U);
  EXPECT_EQ(plan.flesh()[3].bone, plan.find("right arm"));
  EXPECT_EQ(plan.flesh()[3].cone.end(), V(-2, 2, 0.5));
  EXPECT_EQ(plan.flesh()[3].cone.endRadius(), 0.05);
}

TEST(BodyPlan, WhatHangsOnARemovedBoneGoesToo)
{
  BodyPlan plan = twoArms();
  plan.remove("left arm");
  ASSERT_EQ(plan.bones().size(), 3U);
  EXPECT_EQ(plan.flesh().size(), 3U);
  EXPECT_THROW(plan.find("left hand"), std::invalid_argument);
  EXPECT_EQ(plan.bones()[static_cast<std::size_t>(plan.find("right hand"))].parent, plan.find("right arm"));
  for (const Flesh& piece : plan.flesh()) {
    EXPECT_LE(piece.cone.start().x(), 0.0);
  }
  EXPECT_THROW(plan.remove("tail"), std::invalid_argument);
}

TEST(BodyPlan, SymmetricPlansAreTheirOwnMirrorImages)
{
  for (const BodyPlan& plan : {humanPlan(), quadrupedPlan(), spiderPlan(), birdPlan()}) {
    const ImplicitSurface surface = plan.surface();
    for (const double x : {0.05, 0.2, 0.5}) {
      for (const double y : {0.3, 0.9, 1.5}) {
        EXPECT_NEAR(surface.value(V(x, y, 0.1)), surface.value(V(-x, y, 0.1)), 1e-12);
      }
    }
  }
}

} // namespace
