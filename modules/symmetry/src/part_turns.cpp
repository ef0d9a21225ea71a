#include "symmetry/part_turns.h"

#include "geodesic/parallel.h"
#include "geodesic/vector_math.h"
#include "symmetry/rigid_reflection.h"
#include "symmetry/surface_patch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** A reflection of an end and how badly its image fits the surface. */
struct EndFit {
  RigidReflection reflection;
  float misfit = std::numeric_limits<float>::infinity();
};

/** One end of a body and the region that a map sends it to. */
class BodyEnd {
public:
  BodyEnd(const PreparedSurface& surface,
          const CoarseSurface& coarse,
          Index tip,
          float radius,
          const std::vector<Index>& partners)
      : coarse_(coarse), tip_(tip), spacing_(sampleSpacing(coarse)), patch_(patchAround(coarse, tip, radius))
  {
    for (const PatchMember& member : patch_) {
      const Index cell = coarse.cells.owner[partners[member.sample]];
      region_.push_back(cell);
      region_.insert(region_.end(), coarse.graph.neighbours.begin() + coarse.graph.offsets[cell],
                     coarse.graph.neighbours.begin() + coarse.graph.offsets[cell + 1]);
    }
    std::sort(region_.begin(), region_.end());
    region_.erase(std::unique(region_.begin(), region_.end()), region_.end());
    constexpr std::size_t most = 60;
    for (std::size_t k = 0; k < std::min(most, patch_.size()); ++k) {
      const Index sample = patch_[k].sample;
      matches_.push_back({coarse.points[sample], coarse.normals[sample], surface.points[partners[sample]],
                          surface.normals[partners[sample]], patch_[k].weight});
    }
  }

  bool
  isLargeEnough() const
  {
    constexpr std::size_t fewest = 12;
    return patch_.size() >= fewest;
  }

  const SurfacePatch&
  patch() const
  {
    return patch_;
  }

  /** As the map has it. */
  EndFit
  present() const
  {
    return settled(fitReflection(matches_, 2.0F * spacing_));
  }

  /** After a turn of the image about its axis. */
  EndFit
  turned(const EndFit& fit, float angle) const
  {
    Vector3 middle{0.0F, 0.0F, 0.0F};
    float total = 0.0F;
    for (const OrientedMatch& match : matches_) {
      middle = middle + match.weight * match.from;
      total += match.weight;
    }
    middle = (1.0F / total) * middle;
    const Vector3 axis = normalized(fit.reflection.turned(coarse_.points[tip_] - middle));
    const Vector3 centre = fit.reflection(middle);
    const Eigen::Vector3f c(centre[0], centre[1], centre[2]);
    const Eigen::Matrix3f turn =
        Eigen::AngleAxisf(angle, Eigen::Vector3f(axis[0], axis[1], axis[2])).toRotationMatrix();
    RigidReflection reflection = fit.reflection;
    reflection.linear = turn * fit.reflection.linear;
    reflection.shift = turn * (fit.reflection.shift - c) + c;
    return settled(reflection);
  }

  /** Sample of the region that is nearest to the image of a sample and faces the same way. */
  Index
  imageOf(Index sample, const RigidReflection& reflection) const
  {
    return nearest(reflection(coarse_.points[sample]), reflection.turned(coarse_.normals[sample])).sample;
  }

private:
  struct Nearest {
    Index sample = no_index;
    float cost = std::numeric_limits<float>::infinity();
  };

  Nearest
  nearest(const Vector3& place, const Vector3& normal) const
  {
    const float turn_cost = 8.0F * spacing_ * spacing_;
    Nearest best;
    for (const Index i : region_) {
      const Vector3 off = coarse_.points[i] - place;
      const float cost = dot(off, off) + turn_cost * (1.0F - dot(normal, coarse_.normals[i]));
      if (cost < best.cost) {
        best = {i, cost};
      }
    }
    return best;
  }

  /** Iterative closest points from a reflection on. */
  EndFit
  settled(RigidReflection reflection) const
  {
    constexpr int rounds = 4;
    EndFit fit;
    for (int round = 0;; ++round) {
      std::vector<OrientedMatch> matches = matches_;
      float sum = 0.0F;
      float total = 0.0F;
      for (OrientedMatch& match : matches) {
        const Vector3 place = reflection(match.from);
        const Nearest found = nearest(place, reflection.turned(match.from_normal));
        match.to = coarse_.points[found.sample];
        match.to_normal = coarse_.normals[found.sample];
        const float off_plane = dot(match.to_normal, match.to - place);
        const float turn = 1.0F - dot(match.to_normal, reflection.turned(match.from_normal));
        sum += match.weight * (off_plane * off_plane / (spacing_ * spacing_) + turn);
        total += match.weight;
      }
      fit.reflection = reflection;
      fit.misfit = sum / total;
      if (round == rounds) {
        return fit;
      }
      reflection = fitReflection(matches, 2.0F * spacing_);
    }
  }

  const CoarseSurface& coarse_;
  Index tip_;
  float spacing_;
  SurfacePatch patch_;
  std::vector<Index> region_; ///< samples
  std::vector<OrientedMatch> matches_;
};

/** The better fit of an end, if there is one that is clearly better than the present one. */
EndFit
betterFit(const BodyEnd& end)
{
  constexpr float well = 0.03F;
  constexpr float clearly = 0.6F;
  constexpr int turns = 8;
  const EndFit present = end.present();
  EndFit best;
  if (present.misfit < well) {
    return best;
  }
  for (int k = 1; k < turns; ++k) {
    const EndFit fit = end.turned(present, static_cast<float>(k) * 6.2831853F / static_cast<float>(turns));
    if (fit.misfit < best.misfit) {
      best = fit;
    }
  }
  return best.misfit < clearly * present.misfit ? best : EndFit{};
}

} // namespace

std::size_t
turnParts(const PreparedSurface& surface,
          const CoarseSurface& coarse,
          const std::vector<Index>& tips,
          float radius,
          std::vector<Index>& partners,
          unsigned threads)
{
  std::vector<std::vector<std::pair<Index, Index>>> moved(tips.size());
  parallelFor(tips.size(), threads, [&](std::size_t k) {
    const BodyEnd end(surface, coarse, tips[k], radius, partners);
    if (!end.isLargeEnough()) {
      return;
    }
    const EndFit fit = betterFit(end);
    if (std::isfinite(fit.misfit)) {
      for (const PatchMember& member : end.patch()) {
        const Index image = end.imageOf(member.sample, fit.reflection);
        moved[k].push_back({member.sample, coarse.cells.vertices[image]});
      }
    }
  });
  std::size_t turned = 0;
  for (const auto& end : moved) {
    for (const auto& [sample, partner] : end) {
      partners[sample] = partner;
    }
    turned += end.empty() ? 0U : 1U;
  }
  return turned;
}

} // namespace symmetry
} // namespace pcl
