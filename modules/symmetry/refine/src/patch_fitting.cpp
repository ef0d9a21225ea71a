#include "symmetry/refine/patch_fitting.h"

#include "base/vector_math.h"

#include <algorithm>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** Members of a patch that take part in fits: the first ones cover it evenly. */
std::size_t
fittedMembers(const SurfacePatch& patch)
{
  constexpr std::size_t most = 40;
  return std::min(most, patch.size());
}

/** In spacings: what lies farther off than 1.41 of them costs as much as what is not there. */
constexpr float reach = 1.5F;

/** Samples that are looked at around a place: those of a surface that is folded four times, each sheet with some forty. */
constexpr std::size_t most_around = 160;

constexpr float normal_reach = 2.0F; // spacings, see fitReflection ()

} // namespace

PatchFitting::PatchFitting(const CoarseSurface& coarse)
    : coarse_(coarse),
      spacing_(sampleSpacing(coarse)),
      grid_(coarse.points, uncrowdedCell(coarse.points, reach * spacing_, most_around))
{
  for (const Index i : grid_.order()) {
    in_order_.push_back({coarse.points[i], coarse.normals[i]});
  }
}

RigidReflection
PatchFitting::byMap(const SurfacePatch& patch, const PreparedSurface& surface, const std::vector<Index>& partners) const
{
  std::vector<OrientedMatch> matches;
  for (std::size_t m = 0; m < fittedMembers(patch); ++m) {
    const auto [sample, weight] = patch[m];
    matches.push_back({coarse_.points[sample], coarse_.normals[sample], surface.points[partners[sample]],
                       surface.normals[partners[sample]], weight});
  }
  return fitReflection(matches, normal_reach * spacing_);
}

PatchPlacement
PatchFitting::settled(const SurfacePatch& patch, const RigidReflection& reflection, float limit, float enough) const
{
  constexpr int rounds = 3;
  constexpr std::size_t fewest = 6;
  constexpr float hopeless = 1.5F; // times the limit, after the first round
  float total = 0.0F;
  for (std::size_t m = 0; m < fittedMembers(patch); ++m) {
    total += patch[m].weight;
  }
  PatchPlacement placement{reflection, 1.0F};
  std::vector<OrientedMatch> matches;
  for (int round = 0;; ++round) {
    // Misfits only add up: what is beyond this part way is given up at the end of the round.
    const float most = (round == 0 ? 1.0F : round < rounds ? hopeless * limit : limit) * total;
    matches.clear();
    float sum = 0.0F;
    for (std::size_t m = 0; m < fittedMembers(patch) && sum <= most; ++m) {
      const auto [sample, weight] = patch[m];
      const Vector3 place = placement.reflection(coarse_.points[sample]);
      const Vector3 normal = placement.reflection.turned(coarse_.normals[sample]);
      const Index image = nearestFacing(place, normal);
      const float misfit = misfitAt(image, place, normal);
      sum += weight * misfit;
      if (misfit < 1.0F) {
        const float trust = (1.0F - misfit) * (1.0F - misfit);
        matches.push_back({coarse_.points[sample], coarse_.normals[sample], coarse_.points[image],
                           coarse_.normals[image], weight * trust});
      }
    }
    placement.misfit = sum / total;
    const bool is_hopeless = round > 0 && placement.misfit > hopeless * limit;
    if (sum > most || round == rounds || placement.misfit < enough || matches.size() < fewest || is_hopeless) {
      return placement;
    }
    placement.reflection = fitReflection(matches, normal_reach * spacing_);
  }
}

Index
PatchFitting::nearestFacing(const Vector3& place, const Vector3& normal) const
{
  const float turn_cost = 8.0F * spacing_ * spacing_; // a right angle costs like 2.8 spacings; by hand
  std::size_t best = in_order_.size();
  float least = std::numeric_limits<float>::infinity();
  grid_.visitRangesAround(place, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vector3 off = in_order_[i].place - place;
      const float cost = dot(off, off) + turn_cost * (1.0F - dot(normal, in_order_[i].normal));
      if (cost < least) {
        least = cost;
        best = i;
      }
    }
  });
  return best == in_order_.size() ? no_index : grid_.order()[best];
}

/** Squared distance from the plane at a sample, or from the surface where that ends, in units of the spacing, and 1 -
 * cosine of the angle between the normals; 1 at most. */
float
PatchFitting::misfitAt(Index image, const Vector3& place, const Vector3& normal) const
{
  if (image == no_index) {
    return 1.0F;
  }
  const float unit = spacing_ * spacing_;
  const Vector3 off = coarse_.points[image] - place;
  const float off_plane = dot(coarse_.normals[image], off);
  const float beyond = std::max(0.0F, dot(off, off) - unit);
  const float turn = 1.0F - dot(coarse_.normals[image], normal);
  return std::min(1.0F, (off_plane * off_plane + beyond) / unit + turn);
}

} // namespace symmetry
} // namespace pcl
