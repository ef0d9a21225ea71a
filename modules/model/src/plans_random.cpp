// Bodies that nobody drew: trunk, limbs, head and tail by chance, so that there are as many kinds as there are seeds.
#include "model/body_plan.h"
#include "model/random_numbers.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl {
namespace symmetry {
namespace {

using V = Eigen::Vector3d;

// Length of the trunk for a pair of limbs: roots of the mean thickness (0.14) stay apart, thicker ones may grow together.
constexpr double limb_room = 0.26;

/** \brief Where a limb leaves the trunk, and where it goes: \a out of length 1. */
struct LimbRoot {
  int bone;
  V place;
  V out;
};

/** \brief A chain of one to three bones, from thick to thin, with or without something like a hand at its end. */
void
addLimb(BodyPlan& plan, const std::string& name, const LimbRoot& root, bool is_off_the_middle, RandomNumbers& random)
{
  const auto pieces = static_cast<int>(1 + random.index(3));
  const double length = random.uniform(0.35, 1.0);
  const double thinning = random.uniform(0.55, 1.0);
  const double bow = is_off_the_middle ? random.uniform(-25.0, 25.0) * degree : 0.0;
  double radius = std::max(0.035, random.uniform(0.06, 0.11) * std::sqrt(length));
  V place = root.place;
  V out = root.out;
  int bone = root.bone;
  for (int i = 0; i < pieces; ++i) {
    const double swing = i == 0 ? 22.0 : 12.0;
    const double fold = i == 0 ? 22.0 : random.uniform(20.0, 70.0);
    // Joints swing about every axis, and those along the limb fold about one: upright, for what reaches sideways.
    bone = plan.addBone(name + " " + std::to_string(i + 1), bone, place, V(-swing, i == 0 ? -fold : -swing, -swing),
                        V(swing, fold, swing));
    const V end = place + length / pieces * out;
    const double thinner = std::max(0.03, radius * thinning);
    plan.addFlesh(bone, place, radius, end, thinner);
    place = end;
    radius = thinner;
    out = Eigen::AngleAxisd(bow, V::UnitY()) * out;
  }
  if (random.uniform() < 0.4) {
    const double fist = random.uniform(1.2, 1.8) * radius;
    plan.addFlesh(bone, place, radius, place + fist * out, fist);
  }
}

/** \brief The trunk along z, with head and tail or without; where limbs are rooted on its left, from rear to front. */
std::vector<LimbRoot>
addTrunk(BodyPlan& plan, std::size_t pairs, RandomNumbers& random)
{
  const double length = limb_room * (static_cast<double>(pairs) + random.uniform(0.2, 1.2));
  const double width = random.uniform(0.0, 0.08);
  const auto pieces = static_cast<int>(2 + random.index(2));
  std::vector<double> radii(static_cast<std::size_t>(pieces) + 1);
  std::generate(radii.begin(), radii.end(), [&random] { return random.uniform(0.11, 0.2); });
  int bone = -1;
  std::vector<int> bones;
  for (int i = 0; i < pieces; ++i) {
    const double from = length * i / pieces;
    const double to = length * (i + 1) / pieces;
    bone = plan.addBone("trunk " + std::to_string(i + 1), bone, V(0, 0, from), V(-12, -15, -6), V(12, 15, 6));
    bones.push_back(bone);
    plan.addFlesh(bone, V(width, 0, from), radii[static_cast<std::size_t>(i)], V(width, 0, to),
                  radii[static_cast<std::size_t>(i) + 1]);
  }
  std::vector<LimbRoot> roots;
  for (std::size_t k = 0; k < pairs; ++k) {
    const double share = (static_cast<double>(k) + random.uniform(0.35, 0.65)) / static_cast<double>(pairs);
    const auto piece = std::min(static_cast<std::size_t>(share * pieces), bones.size() - 1);
    // From rear to front limbs turn from backward to forward: they do not cross.
    const double heading = (share - 0.5) * random.uniform(60.0, 110.0) * degree;
    const double rise = random.uniform(-45.0, 45.0) * degree;
    const V out(std::cos(heading) * std::cos(rise), std::sin(rise), std::sin(heading) * std::cos(rise));
    roots.push_back({bones[piece], V(width, 0, length * share) + 0.08 * out, out});
  }
  for (const bool at_front : {false, true}) {
    if (random.uniform() < 0.7) {
      const double rise = random.uniform(-60.0, 60.0) * degree;
      const LimbRoot end{at_front ? bones.back() : bones.front(), V(0, 0, at_front ? length : 0.0),
                         V(0, std::sin(rise), at_front ? std::cos(rise) : -std::cos(rise))};
      addLimb(plan, at_front ? "head" : "tail", end, false, random);
    }
  }
  return roots;
}

std::size_t
somePairs(RandomNumbers& random)
{
  return 2 + random.index(3);
}

std::string
limbName(std::size_t number)
{
  return "left limb " + std::to_string(number + 1);
}

BodyPlan
symmetricPlan(RandomNumbers& random, std::size_t pairs)
{
  BodyPlan plan(0.012, 0.025);
  const std::vector<LimbRoot> roots = addTrunk(plan, pairs, random);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    addLimb(plan, limbName(k), roots[k], true, random);
  }
  plan.mirror();
  return plan;
}

} // namespace

BodyPlan
creaturePlan(std::uint64_t seed)
{
  RandomNumbers random(seed);
  const std::size_t pairs = somePairs(random);
  return symmetricPlan(random, pairs);
}

BodyPlan
lameCreaturePlan(std::uint64_t seed)
{
  RandomNumbers random(seed);
  const std::size_t pairs = somePairs(random);
  BodyPlan plan = symmetricPlan(random, pairs);
  plan.remove(limbName(random.index(pairs)) + " 1");
  return plan;
}

BodyPlan
askewCreaturePlan(std::uint64_t seed)
{
  RandomNumbers random(seed);
  const std::size_t pairs = somePairs(random);
  BodyPlan plan(0.012, 0.025);
  const std::vector<LimbRoot> roots = addTrunk(plan, pairs, random);
  plan.mirror(); // the trunk alone, which has no limbs yet
  for (const bool is_left : {true, false}) {
    for (std::size_t k = 0; k < roots.size(); ++k) {
      const double turn = random.uniform(-30.0, 30.0) * degree;
      LimbRoot root = roots[k];
      root.out = Eigen::AngleAxisd(turn, V::UnitZ()) * root.out;
      if (!is_left) {
        root.place.x() = -root.place.x();
        root.out.x() = -root.out.x();
      }
      if (random.uniform() < 0.75) {
        addLimb(plan, (is_left ? "left limb " : "right limb ") + std::to_string(k + 1), root, true, random);
      }
    }
  }
  return plan;
}

} // namespace symmetry
} // namespace pcl
