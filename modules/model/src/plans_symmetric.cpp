// Lengths are about those of an adult person in metres; only the left side is written down.
#include "model/body_plan.h"

#include <cmath>
#include <string>

namespace pcl {
namespace symmetry {
namespace {

using V = Eigen::Vector3d;

void
addHumanTrunk(BodyPlan& plan)
{
  const int pelvis = plan.addBone("pelvis", -1, V(0, 0.98, 0), V(-5, -10, -5), V(5, 10, 5));
  plan.addFlesh(pelvis, V(0.075, 0.94, 0.005), 0.100, V(0.060, 1.06, 0.005), 0.092);
  plan.addFlesh(pelvis, V(0, 0.97, 0.010), 0.090, V(0, 1.06, 0.010), 0.090);
  plan.addFlesh(pelvis, V(0.075, 0.93, -0.055), 0.080, V(0.070, 0.96, -0.055), 0.078);
  const int spine = plan.addBone("spine", pelvis, V(0, 1.08, 0), V(-10, -20, -12), V(30, 20, 12));
  plan.addFlesh(spine, V(0.055, 1.09, 0.010), 0.090, V(0.065, 1.22, 0.010), 0.094);
  plan.addFlesh(spine, V(0, 1.09, 0.015), 0.092, V(0, 1.22, 0.010), 0.096);
  const int chest = plan.addBone("chest", spine, V(0, 1.22, 0), V(-8, -18, -8), V(15, 18, 8));
  plan.addFlesh(chest, V(0.070, 1.26, 0.005), 0.098, V(0.095, 1.38, -0.010), 0.085);
  plan.addFlesh(chest, V(0, 1.26, 0.005), 0.100, V(0, 1.39, -0.015), 0.090);
  plan.addFlesh(chest, V(0.075, 1.33, 0.070), 0.050, V(0.085, 1.31, 0.072), 0.048);
  plan.addFlesh(chest, V(0.040, 1.45, -0.015), 0.058, V(0.165, 1.425, -0.015), 0.058);
  const int neck = plan.addBone("neck", chest, V(0, 1.47, -0.01), V(-10, -20, -10), V(15, 20, 10));
  plan.addFlesh(neck, V(0, 1.45, -0.015), 0.056, V(0, 1.57, 0.005), 0.050);
  const int head = plan.addBone("head", neck, V(0, 1.57, 0), V(-15, -25, -10), V(20, 25, 10));
  plan.addFlesh(head, V(0, 1.68, -0.020), 0.092, V(0, 1.66, 0.025), 0.080);
  plan.addFlesh(head, V(0, 1.59, 0.050), 0.045, V(0, 1.62, 0.030), 0.060);
  plan.addFlesh(head, V(0, 1.655, 0.100), 0.012, V(0, 1.622, 0.120), 0.016);
  plan.addFlesh(head, V(0.092, 1.660, -0.010), 0.016, V(0.100, 1.625, -0.005), 0.011);
}

void
addHumanLeg(BodyPlan& plan)
{
  const int pelvis = plan.find("pelvis");
  const int thigh = plan.addBone("left thigh", pelvis, V(0.105, 0.91, 0), V(-50, -15, -4), V(20, 15, 22));
  plan.addFlesh(thigh, V(0.108, 0.88, 0), 0.086, V(0.150, 0.50, 0.005), 0.058);
  const int shin = plan.addBone("left shin", thigh, V(0.150, 0.50, 0.005), V(5, 0, 0), V(80, 0, 0));
  plan.addFlesh(shin, V(0.150, 0.50, 0.005), 0.057, V(0.180, 0.11, -0.020), 0.038);
  plan.addFlesh(shin, V(0.158, 0.40, -0.020), 0.052, V(0.165, 0.30, -0.025), 0.044);
  const int foot = plan.addBone("left foot", shin, V(0.180, 0.10, -0.02), V(-20, -10, -5), V(25, 10, 5));
  plan.addFlesh(foot, V(0.180, 0.045, -0.045), 0.042, V(0.195, 0.035, 0.130), 0.032);
  plan.addFlesh(foot, V(0.182, 0.080, -0.015), 0.040, V(0.190, 0.045, 0.080), 0.036);
}

/** \brief An arm of the human body whose shoulder is at \a shoulder, tilted forward about it by \a tilt degrees. */
void
addHumanArm(BodyPlan& plan, const std::string& name, const V& shoulder, double tilt)
{
  const auto at = [&](double x, double y, double z) -> V {
    const double c = std::cos(tilt * degree);
    const double s = std::sin(tilt * degree);
    return shoulder + V(x * c - z * s, y, x * s + z * c);
  };
  const int chest = plan.find("chest");
  const int upper = plan.addBone(name + " upper arm", chest, at(0, 0, 0), V(-25, -70, -35), V(25, 20, 55));
  plan.addFlesh(upper, at(0, 0, 0), 0.052, at(0.230, -0.120, -0.005), 0.041);
  const int lower = plan.addBone(name + " lower arm", upper, at(0.230, -0.120, -0.005), V(-30, -85, 0), V(30, -5, 35));
  plan.addFlesh(lower, at(0.230, -0.120, -0.005), 0.041, at(0.440, -0.235, 0.010), 0.029);
  plan.addFlesh(lower, at(0.270, -0.140, 0.000), 0.040, at(0.320, -0.170, 0.003), 0.036);
  const int hand = plan.addBone(name + " hand", lower, at(0.445, -0.238, 0.010), V(-15, -20, -25), V(15, 20, 25));
  plan.addFlesh(hand, at(0.460, -0.246, 0.020), 0.028, at(0.530, -0.285, 0.034), 0.026);
  plan.addFlesh(hand, at(0.460, -0.248, 0.000), 0.027, at(0.530, -0.287, -0.006), 0.025);
  plan.addFlesh(hand, at(0.530, -0.286, 0.014), 0.028, at(0.600, -0.328, 0.018), 0.020);
  plan.addFlesh(hand, at(0.468, -0.250, 0.030), 0.018, at(0.520, -0.275, 0.088), 0.014);
}

void
addQuadrupedTrunk(BodyPlan& plan)
{
  const int pelvis = plan.addBone("pelvis", -1, V(0, 0.76, -0.40), V(-5, -5, -5), V(5, 5, 5));
  plan.addFlesh(pelvis, V(0.060, 0.74, -0.44), 0.115, V(0.055, 0.74, -0.25), 0.120);
  const int back = plan.addBone("back", pelvis, V(0, 0.76, -0.20), V(-8, -15, -6), V(10, 15, 6));
  plan.addFlesh(back, V(0.045, 0.73, -0.20), 0.125, V(0.045, 0.715, 0.10), 0.150);
  const int chest = plan.addBone("chest", back, V(0, 0.76, 0.12), V(-8, -15, -6), V(8, 15, 6));
  plan.addFlesh(chest, V(0.050, 0.715, 0.14), 0.150, V(0.045, 0.74, 0.33), 0.125);
  const int neck = plan.addBone("neck", chest, V(0, 0.82, 0.38), V(-15, -25, -10), V(30, 25, 10));
  plan.addFlesh(neck, V(0, 0.80, 0.38), 0.110, V(0, 1.05, 0.58), 0.072);
  const int head = plan.addBone("head", neck, V(0, 1.06, 0.60), V(-20, -20, -10), V(20, 20, 10));
  plan.addFlesh(head, V(0, 1.085, 0.61), 0.082, V(0, 1.05, 0.70), 0.068);
  plan.addFlesh(head, V(0, 1.04, 0.72), 0.055, V(0, 0.985, 0.87), 0.042);
  plan.addFlesh(head, V(0.055, 1.14, 0.59), 0.030, V(0.085, 1.245, 0.575), 0.013);
}

void
addQuadrupedTail(BodyPlan& plan)
{
  const int pelvis = plan.find("pelvis");
  const int root = plan.addBone("tail root", pelvis, V(0, 0.82, -0.53), V(-30, -30, 0), V(25, 30, 0));
  plan.addFlesh(root, V(0, 0.81, -0.53), 0.044, V(0, 0.78, -0.70), 0.034);
  const int middle = plan.addBone("tail middle", root, V(0, 0.78, -0.70), V(-25, -30, 0), V(25, 30, 0));
  plan.addFlesh(middle, V(0, 0.78, -0.70), 0.034, V(0, 0.69, -0.86), 0.028);
  const int tip = plan.addBone("tail tip", middle, V(0, 0.69, -0.86), V(-25, -30, 0), V(25, 30, 0));
  plan.addFlesh(tip, V(0, 0.69, -0.86), 0.028, V(0, 0.57, -0.97), 0.020);
}

void
addQuadrupedLegs(BodyPlan& plan)
{
  const int chest = plan.find("chest");
  const int arm = plan.addBone("left upper foreleg", chest, V(0.115, 0.66, 0.30), V(-35, 0, -3), V(30, 0, 12));
  plan.addFlesh(arm, V(0.115, 0.66, 0.30), 0.082, V(0.135, 0.42, 0.27), 0.050);
  const int cannon = plan.addBone("left lower foreleg", arm, V(0.135, 0.42, 0.27), V(-55, 0, 0), V(0, 0, 0));
  plan.addFlesh(cannon, V(0.135, 0.42, 0.27), 0.049, V(0.140, 0.12, 0.30), 0.033);
  const int paw = plan.addBone("left forefoot", cannon, V(0.140, 0.10, 0.30), V(-10, 0, 0), V(40, 0, 0));
  plan.addFlesh(paw, V(0.140, 0.12, 0.30), 0.033, V(0.140, 0.045, 0.31), 0.038);
  plan.addFlesh(paw, V(0.140, 0.040, 0.31), 0.038, V(0.140, 0.035, 0.375), 0.030);

  const int pelvis = plan.find("pelvis");
  const int thigh = plan.addBone("left thigh", pelvis, V(0.115, 0.68, -0.42), V(-30, 0, -3), V(30, 0, 12));
  plan.addFlesh(thigh, V(0.115, 0.68, -0.42), 0.100, V(0.145, 0.44, -0.36), 0.058);
  const int shin = plan.addBone("left shin", thigh, V(0.145, 0.44, -0.36), V(0, 0, 0), V(45, 0, 0));
  plan.addFlesh(shin, V(0.145, 0.44, -0.36), 0.057, V(0.148, 0.24, -0.47), 0.037);
  const int hock = plan.addBone("left hind cannon", shin, V(0.148, 0.24, -0.47), V(-40, 0, 0), V(5, 0, 0));
  plan.addFlesh(hock, V(0.148, 0.24, -0.47), 0.037, V(0.150, 0.06, -0.44), 0.034);
  plan.addFlesh(hock, V(0.150, 0.042, -0.44), 0.039, V(0.150, 0.035, -0.365), 0.031);
}

/** \brief One of the left legs of the spider: up and out from the trunk, then down to the ground. */
void
addSpiderLeg(BodyPlan& plan, const std::string& name, double heading, double reach, double thickness)
{
  const V out(std::sin(heading * degree), 0.0, std::cos(heading * degree));
  const V hip = V(0, 0.30, 0.12) + 0.15 * out;
  const V knee = hip + 0.42 * reach * out + V(0, 0.22 * reach, 0);
  const V ankle = knee + 0.40 * reach * out - V(0, 0.36 * reach, 0);
  const V tip = ankle + 0.10 * reach * out - V(0, 0.16 * reach, 0);
  const int upper = plan.addBone(name + " upper leg", plan.find("trunk"), hip, V(-12, -12, -12), V(12, 12, 12));
  plan.addFlesh(upper, hip, 1.10 * thickness, knee, thickness);
  // Knees bend in the plane of the leg: about the horizontal line across it.
  const V hinge = out.cross(V::UnitY());
  const int lower = plan.addBone(name + " lower leg", upper, knee, -25.0 * hinge.cwiseAbs(), 25.0 * hinge.cwiseAbs());
  plan.addFlesh(lower, knee, thickness, ankle, 0.75 * thickness);
  plan.addFlesh(lower, ankle, 0.75 * thickness, tip, 0.55 * thickness);
}

void
addBirdWing(BodyPlan& plan)
{
  // A wing is a fan of feathers so close together that they make one sheet.
  constexpr int feathers = 4;
  const int arm =
      plan.addBone("left inner wing", plan.find("body"), V(0.10, 0.56, 0.10), V(-8, -15, -20), V(8, 15, 35));
  for (int i = 0; i < feathers; ++i)
    plan.addFlesh(arm, V(0.08, 0.54, 0.10 - 0.045 * i), 0.040 - 0.003 * i, V(0.40, 0.58, 0.13 - 0.050 * i),
                  0.035 - 0.003 * i);
  const int hand = plan.addBone("left outer wing", arm, V(0.40, 0.58, 0.08), V(-10, -10, -25), V(10, 40, 20));
  for (int i = 0; i < feathers; ++i)
    plan.addFlesh(hand, V(0.40, 0.58, 0.13 - 0.050 * i), 0.035 - 0.003 * i, V(0.78 - 0.05 * i, 0.56, 0.02 - 0.045 * i),
                  0.024);
}

} // namespace

BodyPlan
humanPlan()
{
  BodyPlan plan(0.010, 0.022);
  addHumanTrunk(plan);
  addHumanArm(plan, "left", V(0.195, 1.425, -0.015), 0.0);
  addHumanLeg(plan);
  plan.mirror();
  return plan;
}

BodyPlan
quadrupedPlan()
{
  BodyPlan plan(0.010, 0.025);
  addQuadrupedTrunk(plan);
  addQuadrupedTail(plan);
  addQuadrupedLegs(plan);
  plan.mirror();
  return plan;
}

BodyPlan
spiderPlan()
{
  BodyPlan plan(0.010, 0.024);
  const int trunk = plan.addBone("trunk", -1, V(0, 0.30, 0.12), V(-5, -10, -5), V(5, 10, 5));
  plan.addFlesh(trunk, V(0.035, 0.31, 0.04), 0.125, V(0.030, 0.30, 0.22), 0.105);
  plan.addFlesh(trunk, V(0.045, 0.27, 0.30), 0.036, V(0.050, 0.18, 0.36), 0.024);
  plan.addFlesh(trunk, V(0.050, 0.37, 0.29), 0.026, V(0.055, 0.38, 0.31), 0.022);
  const int abdomen = plan.addBone("abdomen", trunk, V(0, 0.31, -0.09), V(-20, -20, -8), V(15, 20, 8));
  plan.addFlesh(abdomen, V(0, 0.31, -0.08), 0.070, V(0, 0.33, -0.18), 0.090);
  plan.addFlesh(abdomen, V(0, 0.37, -0.33), 0.190, V(0, 0.36, -0.45), 0.165);
  plan.addFlesh(abdomen, V(0.020, 0.29, -0.60), 0.034, V(0.028, 0.27, -0.66), 0.022);
  addSpiderLeg(plan, "left first", 28.0, 1.25, 0.036);
  addSpiderLeg(plan, "left second", 62.0, 1.05, 0.034);
  addSpiderLeg(plan, "left third", 98.0, 0.85, 0.033);
  addSpiderLeg(plan, "left fourth", 134.0, 1.12, 0.035);
  plan.mirror();
  return plan;
}

BodyPlan
birdPlan()
{
  BodyPlan plan(0.012, 0.020);
  const int body = plan.addBone("body", -1, V(0, 0.50, 0), V(-8, -8, -8), V(8, 8, 8));
  plan.addFlesh(body, V(0, 0.50, 0.10), 0.140, V(0, 0.49, -0.20), 0.085);
  const int neck = plan.addBone("neck", body, V(0, 0.58, 0.18), V(-15, -20, -10), V(15, 20, 10));
  plan.addFlesh(neck, V(0, 0.56, 0.16), 0.085, V(0, 0.70, 0.27), 0.052);
  const int head = plan.addBone("head", neck, V(0, 0.71, 0.28), V(-20, -25, -10), V(20, 25, 10));
  plan.addFlesh(head, V(0, 0.735, 0.29), 0.068, V(0, 0.73, 0.32), 0.060);
  plan.addFlesh(head, V(0, 0.720, 0.36), 0.034, V(0, 0.690, 0.47), 0.012);
  const int tail = plan.addBone("tail", body, V(0, 0.49, -0.27), V(-20, -20, -15), V(20, 20, 15));
  plan.addFlesh(tail, V(0, 0.49, -0.24), 0.055, V(0, 0.48, -0.52), 0.022);
  plan.addFlesh(tail, V(0.020, 0.49, -0.24), 0.045, V(0.045, 0.48, -0.50), 0.022);
  addBirdWing(plan);
  const int thigh = plan.addBone("left leg", body, V(0.065, 0.42, -0.03), V(-25, 0, -4), V(25, 0, 12));
  plan.addFlesh(thigh, V(0.065, 0.42, -0.03), 0.052, V(0.075, 0.20, -0.05), 0.022);
  const int foot = plan.addBone("left foot", thigh, V(0.075, 0.20, -0.05), V(-30, 0, 0), V(20, 0, 0));
  plan.addFlesh(foot, V(0.075, 0.20, -0.05), 0.022, V(0.078, 0.05, -0.02), 0.018);
  plan.addFlesh(foot, V(0.078, 0.04, -0.02), 0.022, V(0.085, 0.03, 0.09), 0.016);
  plan.mirror();
  return plan;
}

BodyPlan
missingArmPlan()
{
  BodyPlan plan = humanPlan();
  plan.remove("left upper arm");
  return plan;
}

BodyPlan
thirdArmPlan()
{
  BodyPlan plan = humanPlan();
  addHumanArm(plan, "third", V(0.130, 1.270, 0.070), 40.0);
  return plan;
}

BodyPlan
missingLegPlan()
{
  BodyPlan plan = quadrupedPlan();
  plan.remove("left upper foreleg");
  return plan;
}

} // namespace symmetry
} // namespace pcl
