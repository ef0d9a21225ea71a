#include "model/body_plan.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

Eigen::Vector3d
mirrored(const Eigen::Vector3d& point)
{
  return {-point.x(), point.y(), point.z()};
}

std::string
mirroredName(const std::string& name)
{
  const std::string left = "left";
  const std::size_t at = name.find(left);
  return at == std::string::npos ? name : std::string(name).replace(at, left.size(), "right");
}

} // namespace

int
BodyPlan::addBone(const std::string& name,
                  int parent,
                  const Eigen::Vector3d& joint,
                  const Eigen::Vector3d& lowest_turn,
                  const Eigen::Vector3d& highest_turn)
{
  bones_.push_back({name, parent, joint, lowest_turn, highest_turn});
  return static_cast<int>(bones_.size()) - 1;
}

void
BodyPlan::addFlesh(
    int bone, const Eigen::Vector3d& start, double start_radius, const Eigen::Vector3d& end, double end_radius)
{
  flesh_.push_back({bone, RoundCone(start, start_radius, end, end_radius)});
}

void
BodyPlan::mirror()
{
  const std::size_t count = bones_.size();
  std::vector<int> image(count);
  for (std::size_t i = 0; i < count; ++i) {
    image[i] = static_cast<int>(i);
    const Bone bone = bones_[i];
    if (bone.joint.x() == 0.0)
      continue;
    // A reflection keeps the sense of a turn about x and reverses those about y and z.
    image[i] = addBone(mirroredName(bone.name), image[static_cast<std::size_t>(bone.parent)], mirrored(bone.joint),
                       {bone.lowest_turn.x(), -bone.highest_turn.y(), -bone.highest_turn.z()},
                       {bone.highest_turn.x(), -bone.lowest_turn.y(), -bone.lowest_turn.z()});
  }
  const std::vector<Flesh> one_side = flesh_;
  for (const Flesh& piece : one_side)
    if (piece.cone.start().x() != 0.0 || piece.cone.end().x() != 0.0)
      addFlesh(image[static_cast<std::size_t>(piece.bone)], mirrored(piece.cone.start()), piece.cone.startRadius(),
               mirrored(piece.cone.end()), piece.cone.endRadius());
}

void
BodyPlan::remove(const std::string& name)
{
  const int root = find(name);
  std::vector<int> number(bones_.size(), -1);
  std::vector<Bone> kept;
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    Bone bone = bones_[i];
    const bool gone =
        static_cast<int>(i) == root || (bone.parent >= 0 && number[static_cast<std::size_t>(bone.parent)] < 0);
    if (gone)
      continue;
    number[i] = static_cast<int>(kept.size());
    if (bone.parent >= 0)
      bone.parent = number[static_cast<std::size_t>(bone.parent)];
    kept.push_back(std::move(bone));
  }
  bones_ = std::move(kept);
  for (Flesh& piece : flesh_)
    piece.bone = number[static_cast<std::size_t>(piece.bone)];
  flesh_.erase(std::remove_if(flesh_.begin(), flesh_.end(), [](const Flesh& piece) { return piece.bone < 0; }),
               flesh_.end());
}

int
BodyPlan::find(const std::string& name) const
{
  const auto found = std::find_if(bones_.begin(), bones_.end(), [&](const Bone& bone) { return bone.name == name; });
  if (found == bones_.end())
    throw std::invalid_argument("the body has no bone '" + name + "'");
  return static_cast<int>(found - bones_.begin());
}

ImplicitSurface
BodyPlan::surface() const
{
  std::vector<RoundCone> cones;
  cones.reserve(flesh_.size());
  for (const Flesh& piece : flesh_)
    cones.push_back(piece.cone);
  return {std::move(cones), blend_};
}

} // namespace symmetry
} // namespace pcl
