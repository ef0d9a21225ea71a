#include "symmetry/refine/patch_alignment.h"

#include "base/parallel.h"
#include "base/sort_unique.h"
#include "base/statistics.h"
#include "base/vector_math.h"
#include "symmetry/refine/point_map.h"
#include "symmetry/samples/greedy_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** A cell and those within two steps of it, ascending. */
std::vector<Index>
withinTwoSteps(const SurfaceGraph& graph, Index cell)
{
  // Of a surface there are some forty, most of them twice; around a hub that all others touch there are all.
  constexpr std::size_t most_listed = 512;
  std::vector<Index> cells{cell};
  std::size_t begin = 0;
  for (int step = 0; step < 2; ++step) {
    const std::size_t end = cells.size();
    for (; begin < end && cells.size() < most_listed; ++begin) {
      const Index from = cells[begin];
      cells.insert(cells.end(), graph.neighbours.begin() + graph.offsets[from],
                   graph.neighbours.begin() + graph.offsets[from + 1]);
    }
  }
  cells.resize(std::min(cells.size(), most_listed));
  sortUnique(cells);
  return cells;
}

} // namespace

PatchAlignment::PatchAlignment(const SampledSurface& sampled, const PatchSize& size)
    : sampled_(sampled),
      surface_(sampled.surface),
      coarse_(sampled.coarse),
      spacing_(sampleSpacing(sampled.coarse)),
      patches_(std::min(size.patches, sampled.coarse.size())),
      surroundings_(sampled.coarse.size())
{
  const float radius = size.radius * sampled.landmarks.diameter;
  parallelFor(
      patches_.size(), [&](std::size_t k) { patches_[k] = patchAround(coarse_, static_cast<Index>(k), radius); }, 8);
  parallelFor(
      coarse_.size(), [&](std::size_t i) { surroundings_[i] = withinTwoSteps(coarse_.graph, static_cast<Index>(i)); },
      32);
}

std::vector<Index>
PatchAlignment::align(std::vector<Index> partners, int rounds) const
{
  for (int round = 0; round < rounds; ++round) {
    const std::vector<WantedPlace> wanted = wantedPlaces(partners);
    parallelFor(
        coarse_.size(),
        [&](std::size_t i) {
          if (wanted[i].weight > 0.0F) {
            partners[i] = nearestFacing(partners[i], wanted[i]);
          }
        },
        32);
    partners = mutualPartners(sampled_, std::move(partners), 1);
  }
  return partners;
}

std::vector<PatchFit>
PatchAlignment::fits(const std::vector<Index>& partners) const
{
  std::vector<PatchFit> fits(patches_.size());
  parallelFor(
      fits.size(),
      [&](std::size_t k) {
        const std::vector<OrientedMatch> matches = matchesOf(patches_[k], partners);
        const RigidReflection reflection = fitReflection(matches, 2.0F * spacing_);
        float turn = 0.0F;
        float total = 0.0F;
        for (const OrientedMatch& match : matches) {
          turn += match.weight * (1.0F - dot(reflection.turned(match.from_normal), match.to_normal));
          total += match.weight;
        }
        fits[k] = {std::sqrt(reflection.error) / sampled_.landmarks.diameter, turn / total};
      },
      8);
  return fits;
}

std::vector<OrientedMatch>
PatchAlignment::matchesOf(const SurfacePatch& patch, const std::vector<Index>& partners) const
{
  constexpr std::size_t most = 60;     // determines a rigid motion well enough
  constexpr std::size_t fewest = 8;    // does so hardly
  constexpr float least_weight = 0.4F; // share
  // Partners at a hole may stand for any that are missing.
  std::vector<OrientedMatch> matches;
  std::vector<OrientedMatch> at_holes;
  float weight = 0.0F;
  float weight_at_holes = 0.0F;
  for (std::size_t k = 0; k < patch.size() && matches.size() < most; ++k) {
    const auto [sample, share] = patch[k];
    const Index partner = partners[sample];
    const bool is_at_hole = coarse_.at_hole[coarse_.cells.owner[partner]] != 0;
    (is_at_hole ? at_holes : matches)
        .push_back({coarse_.points[sample], coarse_.normals[sample], surface_.points[partner],
                    surface_.normals[partner], share});
    (is_at_hole ? weight_at_holes : weight) += share;
  }
  if (matches.size() < fewest || weight < least_weight * (weight + weight_at_holes)) {
    matches.insert(matches.end(), at_holes.begin(), at_holes.end());
  }
  return matches;
}

std::vector<PatchAlignment::WantedPlace>
PatchAlignment::wantedPlaces(const std::vector<Index>& partners) const
{
  std::vector<RigidReflection> reflections(patches_.size());
  parallelFor(
      patches_.size(),
      [&](std::size_t k) { reflections[k] = fitReflection(matchesOf(patches_[k], partners), 2.0F * spacing_); }, 8);
  const float best_error = 0.06F * spacing_ * spacing_; // no fit is trusted beyond the precision of the samples
  std::vector<WantedPlace> wanted(coarse_.size());
  for (std::size_t k = 0; k < patches_.size(); ++k) {
    const float trust = 1.0F / (reflections[k].error + best_error);
    for (const PatchMember& member : patches_[k]) {
      WantedPlace& sum = wanted[member.sample];
      const float weight = trust * member.weight;
      sum.place = sum.place + weight * reflections[k](coarse_.points[member.sample]);
      sum.normal = sum.normal + weight * reflections[k].turned(coarse_.normals[member.sample]);
      sum.weight += weight;
    }
  }
  for (WantedPlace& place : wanted) {
    if (place.weight > 0.0F) {
      place.place = (1.0F / place.weight) * place.place;
      place.normal = normalized(place.normal);
    }
  }
  return wanted;
}

/** The point around the present partner that is nearest to the wanted place and faces as it should. */
Index
PatchAlignment::nearestFacing(Index partner, const WantedPlace& wanted) const
{
  const float turn_cost = 8.0F * spacing_ * spacing_; // a right angle costs like 2.8 spacings; by hand
  const auto cost = [&](Index v) {
    const Vector3 off = surface_.points[v] - wanted.place;
    return dot(off, off) + turn_cost * (1.0F - dot(wanted.normal, surface_.normals[v]));
  };
  Index best = partner;
  float least = std::numeric_limits<float>::infinity();
  for (const Index cell : surroundings_[coarse_.cells.owner[partner]]) {
    for (std::uint32_t e = sampled_.probes.offsets[cell]; e < sampled_.probes.offsets[cell + 1]; ++e) {
      const float here = cost(sampled_.probes.points[e]);
      if (here < least) {
        least = here;
        best = sampled_.probes.points[e];
      }
    }
  }
  return walkDown(surface_.graph, best, cost);
}

PatchFit
meanOf(const std::vector<PatchFit>& fits)
{
  PatchFit mean{0.0F, 0.0F};
  for (const PatchFit& fit : fits) {
    mean.distance += fit.distance / static_cast<float>(fits.size());
    mean.turn += fit.turn / static_cast<float>(fits.size());
  }
  return mean;
}

float
worstDistance(const std::vector<PatchFit>& fits)
{
  constexpr double nearly_all = 0.98;
  std::vector<float> distances(fits.size());
  std::transform(fits.begin(), fits.end(), distances.begin(), [](const PatchFit& fit) { return fit.distance; });
  return quantile(std::move(distances), nearly_all);
}

} // namespace symmetry
} // namespace pcl
