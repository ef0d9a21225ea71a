#include "symmetry/names/labelled_samples.h"

#include "base/renumbering.h"
#include "symmetry/step_timer.h"
#include "symmetry/surface/mesh_subdivision.h"
#include "symmetry/surface/surface_preparation.h"

#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** The points that have partners, with the triangles between them. */
struct MatchedPart {
  Surface surface;
  std::vector<Index> original;   ///< numbers of its points in the whole surface
  std::vector<Index> new_number; ///< and back; no_index elsewhere
};

MatchedPart
matchedPart(const Surface& surface, const std::vector<Index>& partners)
{
  MatchedPart part;
  part.new_number.assign(surface.size(), no_index);
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (partners[v] == no_index) {
      continue;
    }
    part.new_number[v] = static_cast<Index>(part.original.size());
    part.original.push_back(static_cast<Index>(v));
    part.surface.points.push_back(surface.points[v]);
    if (!surface.normals.empty()) {
      part.surface.normals.push_back(surface.normals[v]);
    }
  }
  part.surface.triangles = surface.triangles;
  renumberTriangles(part.surface.triangles, part.new_number);
  return part;
}

/** Partners of the samples, among them; of a sample whose partner took no part, itself. */
SampleMap
mapOfSamples(const SampledSurface& sampled, const MatchedPart& part, const std::vector<Index>& partners)
{
  const FarthestPointSamples& cells = sampled.coarse.cells;
  SampleMap map;
  for (std::size_t i = 0; i < sampled.coarse.size(); ++i) {
    const Index point = part.original[sampled.surface.original[cells.vertices[i]]];
    const Index partner = part.new_number[partners[point]];
    const Index there = partner == no_index ? no_index : sampled.surface.representatives[partner];
    map.push_back(there == no_index ? static_cast<Index>(i) : cells.owner[there]);
  }
  return map;
}

/** Mean over the cell of each sample: 1 on the source side, -1 on the target side. */
std::vector<float>
sidesOfSamples(const SampledSurface& sampled, const MatchedPart& part, const std::vector<Side>& sides)
{
  std::vector<float> sums(sampled.coarse.size(), 0.0F);
  std::vector<float> points(sampled.coarse.size(), 0.0F);
  for (std::size_t v = 0; v < sampled.surface.size(); ++v) {
    const Side side = sides[part.original[sampled.surface.original[v]]];
    const Index cell = sampled.coarse.cells.owner[v];
    sums[cell] += side == Side::Source ? 1.0F : side == Side::Target ? -1.0F : 0.0F;
    points[cell] += 1.0F;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i] = points[i] > 0.0F ? sums[i] / points[i] : 0.0F;
  }
  return sums;
}

} // namespace

ComparableSurface
describeLabelled(const Surface& surface,
                 const std::vector<Side>& sides,
                 const std::vector<Index>& partners,
                 const NeighbourSearch& search)
{
  const MatchedPart part = matchedPart(surface, partners);
  if (part.original.size() < minimum_samples) {
    return {};
  }
  const SymmetryParameters parameters;
  // As an estimation does in its first attempt.
  const PreparedSurface prepared =
      prepareSurface(usablePoints(part.surface, parameters, search, NoiseInterpretation::Close, FaceUse::Connection,
                                  points_of_a_surface),
                     parameters, ContactTest{});
  if (prepared.size() < minimum_samples) {
    return {};
  }
  StepTimer timer;
  const SampledSurface sampled = sampleSurface(prepared, SamplingSettings{}, parameters.metric, timer);
  if (sampled.coarse.size() < minimum_samples) {
    return {};
  }
  return comparableSurface(sampled, mapOfSamples(sampled, part, partners), sidesOfSamples(sampled, part, sides));
}

} // namespace symmetry
} // namespace pcl
