#include "benchmark/limb_cut.h"

#include "geodesic/shortest_paths.h"
#include "model/disturb.h"

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** At most a hundred of the pairs. */
GroundTruth
somePairs(const GroundTruth& truth)
{
  constexpr std::size_t maximum_pairs = 100;
  GroundTruth pairs;
  std::copy_if(truth.begin(), truth.end(), std::back_inserter(pairs),
               [](const TruePartner& p) { return p.vertex < p.partner; });
  GroundTruth some;
  const std::size_t step = (pairs.size() + maximum_pairs - 1) / maximum_pairs;
  for (std::size_t i = 0; i < pairs.size(); i += step)
    some.push_back(pairs[i]);
  return some;
}

/** The extremities of limbs: pairs of landmarks, and the distances from the first of each. */
class LimbExtremities {
public:
  LimbExtremities(const Surface& mesh, const GroundTruth& truth) : pairs_(somePairs(truth))
  {
    std::vector<Index> sources(pairs_.size());
    std::transform(pairs_.begin(), pairs_.end(), sources.begin(), [](const TruePartner& p) { return p.vertex; });
    fields_ = distanceFields(buildMeshGraph(mesh.points, mesh.triangles), sources);
    for (const float distance : fields_.values)
      diameter_ = std::isfinite(distance) ? std::max(diameter_, distance) : diameter_;
  }

  float
  diameter() const
  {
    return diameter_;
  }

  /** Distances of all vertices from the extremity of a limb. */
  const float*
  distancesFrom(Limb limb) const
  {
    const float* farthest = distancesFromFarthest(nullptr);
    return limb == Limb::Farthest ? farthest : distancesFromFarthest(farthest);
  }

private:
  /** From the pair whose extremities are farthest apart, of those that are not near \a other. */
  const float*
  distancesFromFarthest(const float* other) const
  {
    constexpr float minimum_separation = 0.35F; // shares of the diameter
    constexpr float same_limb = 0.35F;
    const float* best = nullptr;
    float largest = minimum_separation * diameter_;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const float apart = fields_.row(i)[pairs_[i].partner];
      const bool is_near =
          other != nullptr && std::min(other[pairs_[i].vertex], other[pairs_[i].partner]) < same_limb * diameter_;
      if (!is_near && std::isfinite(apart) && apart > largest) {
        largest = apart;
        best = fields_.row(i);
      }
    }
    if (best == nullptr)
      throw pcl::BadArgumentException("no limb to cut off: no partners are far enough apart");
    return best;
  }

  GroundTruth pairs_;
  DistanceFields fields_;
  float diameter_ = 0.0F;
};

/** Keeps the marked vertices, in their order, and the triangles among them. */
DisturbedSurface
keptPart(const DisturbedSurface& whole, const std::vector<char>& keep)
{
  Model model{whole.surface, std::vector<Index>(keep.size(), no_index)};
  keepVertices(model, keep);
  DisturbedSurface part{std::move(model.surface), {}};
  for (std::size_t v = 0; v < keep.size(); ++v)
    if (keep[v] != 0)
      part.origins.push_back(whole.origins[v]);
  return part;
}

DisturbedSurface
largestPiece(const DisturbedSurface& whole)
{
  const SurfaceGraph graph = buildMeshGraph(whole.surface.points, whole.surface.triangles);
  const std::vector<Index> component_of = connectedComponents(graph).component_of;
  std::vector<char> keep(component_of.size());
  std::transform(component_of.begin(), component_of.end(), keep.begin(),
                 [](Index component) { return component == 0 ? 1 : 0; });
  return keptPart(whole, keep);
}

using DirectedEdges = std::set<std::pair<Index, Index>>;

/** Sides of triangles that no other triangle lies at, between origins that the cut lies next to. */
DirectedEdges
openEdges(const DisturbedSurface& part, const std::vector<char>& is_at_cut)
{
  DirectedEdges edges;
  for (const Triangle& t : part.surface.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      edges.emplace(t[k], t[(k + 1) % 3]);
  DirectedEdges open;
  for (const auto& [a, b] : edges)
    if (edges.count({b, a}) == 0 && is_at_cut[part.origins[a]] != 0 && is_at_cut[part.origins[b]] != 0)
      open.emplace(a, b);
  return open;
}

/** Closes each opening by a fan of triangles around the mean of its vertices. */
void
closeOpenings(DisturbedSurface& part, const DirectedEdges& open)
{
  std::vector<GraphEdge> edges;
  for (const auto& [a, b] : open)
    edges.push_back({a, b, 1.0F});
  const std::vector<Index> opening_of = connectedComponents(buildGraph(part.surface.size(), edges)).component_of;
  std::map<Index, std::vector<std::pair<Index, Index>>> openings;
  for (const auto& edge : open)
    openings[opening_of[edge.first]].push_back(edge);
  for (const auto& opening : openings) {
    const auto centre = static_cast<Index>(part.surface.size());
    const float share = 1.0F / static_cast<float>(opening.second.size());
    Vector3 mean{0.0F, 0.0F, 0.0F};
    for (const auto& [a, b] : opening.second) {
      for (std::size_t k = 0; k < 3; ++k)
        mean[k] += share * part.surface.points[a][k];
      part.surface.triangles.push_back({b, a, centre});
    }
    part.surface.points.push_back(mean);
    part.origins.push_back(no_index);
  }
}

} // namespace

DisturbedSurface
cutLimb(const Surface& mesh, const GroundTruth& truth, Limb limb, Stump stump)
{
  constexpr float reach = 0.3F;
  const LimbExtremities extremities(mesh, truth);
  const float* distances = extremities.distancesFrom(limb);
  DisturbedSurface whole{{mesh.points, mesh.triangles, {}}, std::vector<Index>(mesh.size())};
  std::iota(whole.origins.begin(), whole.origins.end(), Index{0});
  std::vector<char> keep(mesh.size());
  std::transform(distances, distances + mesh.size(), keep.begin(),
                 [&](float distance) { return distance >= reach * extremities.diameter() ? 1 : 0; });
  std::vector<char> is_at_cut(mesh.size(), 0);
  for (const Triangle& t : mesh.triangles)
    if (std::any_of(t.begin(), t.end(), [&](Index v) { return keep[v] == 0; }))
      for (const Index v : t)
        is_at_cut[v] = 1;
  DisturbedSurface rest = largestPiece(keptPart(whole, keep));
  if (stump == Stump::Closed)
    closeOpenings(rest, openEdges(rest, is_at_cut));
  return rest;
}

} // namespace symmetry
} // namespace pcl
