// Bodies that are not their own mirror image in any pose.
#include "model/body_plan.h"

#include <array>
#include <cmath>
#include <string>

namespace pcl {
namespace symmetry {
namespace {

using V = Eigen::Vector3d;

/** \brief A finger of two bones: \a base is its knuckle, \a direction its length and course. */
void
addFinger(BodyPlan& plan, const std::string& name, int palm, const V& base, const V& direction, double thickness)
{
  const V middle = base + 0.55 * direction;
  const int root = plan.addBone(name + " root", palm, base, V(-5, -5, -8), V(45, 5, 8));
  plan.addFlesh(root, base, thickness, middle, 0.92 * thickness);
  const int tip = plan.addBone(name + " tip", root, middle, V(0, 0, 0), V(60, 0, 0));
  plan.addFlesh(tip, middle, 0.92 * thickness, base + direction, 0.75 * thickness);
}

} // namespace

BodyPlan
handPlan()
{
  BodyPlan plan(0.006, 0.009);
  const int wrist = plan.addBone("wrist", -1, V(0, 0, 0), V(-5, -5, -5), V(5, 5, 5));
  plan.addFlesh(wrist, V(0.02, -0.30, 0), 0.085, V(0.01, 0.02, 0), 0.075);
  const int palm = plan.addBone("palm", wrist, V(0, 0.05, 0), V(-20, -10, -10), V(20, 10, 10));
  const std::array<V, 4> knuckles = {V(-0.13, 0.38, 0), V(-0.04, 0.41, 0.010), V(0.05, 0.40, 0.010), V(0.13, 0.36, 0)};
  for (const V& knuckle : knuckles)
    plan.addFlesh(palm, V(0.35 * knuckle.x(), 0.08, 0), 0.070, knuckle, 0.046);
  plan.addFlesh(palm, V(-0.07, 0.10, 0.06), 0.060, V(-0.10, 0.22, 0.06), 0.050);
  plan.addFlesh(palm, V(0.08, 0.10, 0.05), 0.048, V(0.10, 0.25, 0.04), 0.036);
  addFinger(plan, "forefinger", palm, knuckles[0], V(-0.070, 0.30, 0), 0.042);
  addFinger(plan, "middle finger", palm, knuckles[1], V(-0.020, 0.36, 0), 0.044);
  addFinger(plan, "ring finger", palm, knuckles[2], V(0.035, 0.32, 0), 0.041);
  addFinger(plan, "little finger", palm, knuckles[3], V(0.085, 0.22, 0), 0.035);
  addFinger(plan, "thumb", palm, V(-0.12, 0.16, 0.07), V(-0.17, 0.13, 0.10), 0.048);
  return plan;
}

BodyPlan
helixPlan()
{
  constexpr int pieces = 40;
  constexpr double turns = 2.25;
  constexpr double two_pi = 6.283185307179586;
  BodyPlan plan(0.012, 0.032);
  const int coil = plan.addBone("coil", -1, V(0, 0, 0), V(-10, -10, -10), V(10, 10, 10));
  // The tube grows towards one end, so that it is no mirror image of itself end to end.
  const auto centre = [](double t) -> V {
    const double angle = two_pi * turns * t;
    return {0.42 * std::cos(angle), 0.85 * t, 0.42 * std::sin(angle)};
  };
  const auto radius = [](double t) {
    return 0.045 + 0.065 * t * t;
  };
  for (int i = 0; i < pieces; ++i) {
    const double from = static_cast<double>(i) / pieces;
    const double to = static_cast<double>(i + 1) / pieces;
    plan.addFlesh(coil, centre(from), radius(from), centre(to), radius(to));
  }
  // A round tube is its own mirror image across any plane through its axis: bumps on different sides end that.
  struct Bump {
    double at;
    V direction;
    double size;
  };
  const std::array<Bump, 4> bumps = {{{0.22, V(0, -0.16, 0), 0.040},
                                      {0.45, V(0.03, 0.05, 0.13), 0.055},
                                      {0.70, V(0.05, 0.22, 0.02), 0.050},
                                      {0.88, V(-0.02, 0.04, -0.19), 0.060}}};
  for (const Bump& bump : bumps)
    plan.addFlesh(coil, centre(bump.at), bump.size, centre(bump.at) + bump.direction, 0.8 * bump.size);
  return plan;
}

} // namespace symmetry
} // namespace pcl
