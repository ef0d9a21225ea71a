#include "symmetry/refine/reflection_growth.h"

#include "base/parallel.h"
#include "base/vector_math.h"

#include <Eigen/LU>

#include <algorithm>
#include <functional>
#include <queue>

namespace pcl {
namespace symmetry {
namespace {

RigidReflection
inverseOf(const RigidReflection& reflection)
{
  RigidReflection inverse;
  inverse.linear = reflection.linear.transpose();
  inverse.shift = -(inverse.linear * reflection.shift);
  return inverse;
}

/** Patches with their reflections, some of which are replaced by those of others. */
class ReflectionGrowth {
public:
  ReflectionGrowth(const SampledSurface& sampled, const PatchFitting& fitting, const GrowthSettings& settings)
      : sampled_(sampled),
        coarse_(sampled.coarse),
        fitting_(fitting),
        settings_(settings),
        radius_(settings.radius * sampled.landmarks.diameter),
        patches_(std::min(settings.patches, coarse_.size())),
        placements_(patches_.size()),
        has_grown_(patches_.size(), 0),
        refusals_(patches_.size(), 0),
        centres_(std::vector<Vector3>(coarse_.points.begin(),
                                      coarse_.points.begin() + static_cast<std::ptrdiff_t>(patches_.size())),
                 0.5F * radius_)
  {
    parallelFor(
        patches_.size(), [&](std::size_t k) { patches_[k] = patchAround(coarse_, static_cast<Index>(k), radius_); }, 8);
  }

  /** Gives each patch the reflection that a map has there. */
  void
  start(const std::vector<Index>& partners)
  {
    parallelFor(
        patches_.size(),
        [&](std::size_t k) {
          const RigidReflection reflection = fitting_.byMap(patches_[k], sampled_.surface, partners);
          placements_[k] = fitting_.settled(patches_[k], reflection, 1.0F, settings_.well);
        },
        4);
  }

  /** Offers the reflection of each patch to those around it and, backwards, to those around its image. */
  std::size_t
  spread()
  {
    std::size_t replaced = 0;
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      queue_.push({placements_[k].misfit, k});
    }
    while (!queue_.empty()) {
      const auto [misfit, k] = queue_.top();
      queue_.pop();
      if (misfit > placements_[k].misfit) {
        continue; // replaced since
      }
      const PatchPlacement placement = placements_[k];
      const PatchPlacement backwards{inverseOf(placement.reflection), misfit};
      for (const PatchMember& member : patches_[k]) {
        replaced += offer(member.sample, placement) ? 1U : 0U;
      }
      centres_.visitAround(placement.reflection(coarse_.points[k]),
                           [&](Index j) { replaced += offer(j, backwards) ? 1U : 0U; });
    }
    return replaced;
  }

  /** Sends the samples of patches that have grown where their reflections put them. */
  void
  movePartners(std::vector<Index>& partners) const
  {
    const std::vector<Index> patch_of = mostTrusted();
    parallelFor(
        coarse_.size(),
        [&](std::size_t i) {
          const Index k = patch_of[i];
          if (k == no_index || has_grown_[k] == 0) {
            return;
          }
          const RigidReflection& reflection = placements_[k].reflection;
          const Index image =
              fitting_.nearestFacing(reflection(coarse_.points[i]), reflection.turned(coarse_.normals[i]));
          if (image != no_index) {
            partners[i] = coarse_.cells.vertices[image];
          }
        },
        32);
  }

private:
  /** Whether the patch takes the reflection of another one. */
  bool
  offer(Index patch, const PatchPlacement& other)
  {
    constexpr int maximum_refusals = 8; // the first offers come from what fits best
    const auto j = static_cast<std::size_t>(patch);
    if (j >= patches_.size() || placements_[j].misfit < settings_.well || refusals_[j] >= maximum_refusals) {
      return false;
    }
    const float limit = settings_.clearly * placements_[j].misfit;
    if (other.misfit > limit || isLike(other.reflection, placements_[j].reflection, coarse_.points[j])) {
      return false;
    }
    const PatchPlacement settled = fitting_.settled(patches_[j], other.reflection, limit);
    if (settled.misfit >= limit) {
      ++refusals_[j];
      return false;
    }
    refusals_[j] = 0;
    placements_[j] = settled;
    has_grown_[j] = 1;
    queue_.push({settled.misfit, j});
    return true;
  }

  /** Whether two reflections take a patch to the same place but for a fraction of a spacing. */
  bool
  isLike(const RigidReflection& a, const RigidReflection& b, const Vector3& centre) const
  {
    const Vector3 off = a(centre) - b(centre);
    const float turn = (a.linear - b.linear).norm() * radius_;
    const float close = 0.5F * fitting_.spacing();
    return dot(off, off) + 0.5F * turn * turn < close * close;
  }

  /** For every sample the patch in whose middle it lies and that fits well; no_index if it is in none. */
  std::vector<Index>
  mostTrusted() const
  {
    constexpr float least_misfit = 0.01F; // fits are not trusted beyond that
    std::vector<Index> patch_of(coarse_.size(), no_index);
    std::vector<float> most(coarse_.size(), 0.0F);
    for (std::size_t k = 0; k < patches_.size(); ++k) {
      for (const PatchMember& member : patches_[k]) {
        const float trust = member.weight / (placements_[k].misfit + least_misfit);
        if (trust > most[member.sample]) {
          most[member.sample] = trust;
          patch_of[member.sample] = static_cast<Index>(k);
        }
      }
    }
    return patch_of;
  }

  using Entry = std::pair<float, std::size_t>; // misfit, patch

  const SampledSurface& sampled_;
  const CoarseSurface& coarse_;
  const PatchFitting& fitting_;
  const GrowthSettings& settings_;
  float radius_;
  std::vector<SurfacePatch> patches_;
  std::vector<PatchPlacement> placements_;
  std::vector<char> has_grown_;
  std::vector<int> refusals_;                                            ///< of offers in a row, by patch
  PointGrid centres_;                                                    ///< of the patches
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_; ///< patches whose reflections are to be tried
};

} // namespace

std::size_t
growReflections(const SampledSurface& sampled,
                const PatchFitting& fitting,
                const GrowthSettings& settings,
                std::vector<Index>& partners)
{
  if (settings.patches == 0) {
    return 0;
  }
  ReflectionGrowth growth(sampled, fitting, settings);
  growth.start(partners);
  const std::size_t replaced = growth.spread();
  growth.movePartners(partners);
  return replaced;
}

} // namespace symmetry
} // namespace pcl
