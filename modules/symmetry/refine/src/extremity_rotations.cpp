#include "symmetry/refine/extremity_rotations.h"

#include "base/parallel.h"
#include "base/vector_math.h"

#include <Eigen/Geometry>

namespace pcl {
namespace symmetry {
namespace {

/** An extreme point, what is around it, and the image that a map has of that. */
class Extremity {
public:
  Extremity(const PreparedSurface& surface,
            const CoarseSurface& coarse,
            const PatchFitting& fitting,
            Index point,
            float radius,
            const std::vector<Index>& partners)
      : coarse_(coarse),
        fitting_(fitting),
        point_(point),
        patch_(patchAround(coarse, point, radius)),
        by_map_(fitting.byMap(patch_, surface, partners))
  {
  }

  bool
  isLargeEnough() const
  {
    constexpr std::size_t minimum_samples = 12;
    return patch_.size() >= minimum_samples;
  }

  const SurfacePatch&
  patch() const
  {
    return patch_;
  }

  /** As the map has it. */
  PatchPlacement
  present() const
  {
    return fitting_.settled(patch_, by_map_);
  }

  /** After a turn of the image about its axis. */
  PatchPlacement
  turned(const PatchPlacement& placement, float angle) const
  {
    Vector3 middle{0.0F, 0.0F, 0.0F};
    float total = 0.0F;
    for (const PatchMember& member : patch_) {
      middle = middle + member.weight * coarse_.points[member.sample];
      total += member.weight;
    }
    middle = (1.0F / total) * middle;
    const Vector3 axis = normalized(placement.reflection.turned(coarse_.points[point_] - middle));
    const Vector3 centre = placement.reflection(middle);
    const Eigen::Vector3f c(centre[0], centre[1], centre[2]);
    const Eigen::Matrix3f turn =
        Eigen::AngleAxisf(angle, Eigen::Vector3f(axis[0], axis[1], axis[2])).toRotationMatrix();
    RigidReflection reflection = placement.reflection;
    reflection.linear = turn * placement.reflection.linear;
    reflection.shift = turn * (placement.reflection.shift - c) + c;
    return fitting_.settled(patch_, reflection);
  }

private:
  const CoarseSurface& coarse_;
  const PatchFitting& fitting_;
  Index point_;
  SurfacePatch patch_;
  RigidReflection by_map_;
};

/** Whether an extremity fits clearly better after some turn of its image. \param[out] better that one */
bool
findBetterTurn(const Extremity& extremity, PatchPlacement& better)
{
  constexpr float good_misfit = 0.02F;
  constexpr float clear_gain = 0.6F;
  constexpr int turns = 8;
  const PatchPlacement present = extremity.present();
  if (present.misfit < good_misfit) {
    return false;
  }
  better.misfit = clear_gain * present.misfit;
  bool is_found = false;
  for (int k = 1; k < turns; ++k) {
    const PatchPlacement turned =
        extremity.turned(present, static_cast<float>(k) * 6.2831853F / static_cast<float>(turns));
    if (turned.misfit < better.misfit) {
      better = turned;
      is_found = true;
    }
  }
  return is_found;
}

} // namespace

std::size_t
rotateExtremities(const SampledSurface& sampled,
                  const PatchFitting& fitting,
                  const std::vector<Index>& extremities,
                  float radius,
                  std::vector<Index>& partners)
{
  const CoarseSurface& coarse = sampled.coarse;
  std::vector<std::vector<std::pair<Index, Index>>> moved(extremities.size());
  parallelFor(extremities.size(), [&](std::size_t k) {
    const Extremity extremity(sampled.surface, coarse, fitting, extremities[k], radius, partners);
    PatchPlacement better;
    if (!extremity.isLargeEnough() || !findBetterTurn(extremity, better)) {
      return;
    }
    for (const PatchMember& member : extremity.patch()) {
      const RigidReflection& reflection = better.reflection;
      const Index image = fitting.nearestFacing(reflection(coarse.points[member.sample]),
                                                reflection.turned(coarse.normals[member.sample]));
      if (image != no_index) {
        moved[k].push_back({member.sample, coarse.cells.vertices[image]});
      }
    }
  });
  std::size_t turned = 0;
  for (const auto& matches : moved) {
    for (const auto& [sample, partner] : matches) {
      partners[sample] = partner;
    }
    turned += matches.empty() ? 0U : 1U;
  }
  return turned;
}

} // namespace symmetry
} // namespace pcl
