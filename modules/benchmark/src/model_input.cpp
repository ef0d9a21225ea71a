#include "benchmark/model_input.h"

#include "../../estimation/src/neighbour_search.h"
#include "symmetry/interpretations.h"
#include "symmetry/samples/sampled_surface.h"

#include <pcl/symmetry/surface_io.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

std::vector<bool>
presentVertices(const std::vector<Index>& origins, std::size_t points)
{
  std::vector<bool> is_present(points, false);
  for (const Index origin : origins)
    if (origin != no_index)
      is_present[static_cast<std::size_t>(origin)] = true;
  return is_present;
}

/** The part of the ground truth that is scored: a point that was dropped is nothing the estimation was asked about.
 * \param[in] with_partner nor is one whose partner is gone; where single points were dropped, one next to it will do */
GroundTruth
selectTruth(const GroundTruth& truth, const std::vector<Index>& origins, std::size_t points, bool with_partner)
{
  const std::vector<bool> is_present = presentVertices(origins, points);
  const auto is_asked = [&](const TruePartner& p) {
    return is_present[static_cast<std::size_t>(p.vertex)] &&
           (!with_partner || is_present[static_cast<std::size_t>(p.partner)]);
  };
  GroundTruth selected = subsampleTruth(truth);
  selected.erase(std::remove_if(selected.begin(), selected.end(), [&](const TruePartner& p) { return !is_asked(p); }),
                 selected.end());
  return selected;
}

/** The variant of a mesh that is run, with its disturbance. */
void
varyModel(ModelInput& result, const BenchmarkModel& model, const RunOptions& options)
{
  VariedSurface varied = vary(result.mesh, model.variant, options.disturbance.seed);
  result.input = disturb(varied.surface, options.disturbance);
  for (Index& origin : result.input.origins)
    if (origin != no_index)
      origin = varied.origins[static_cast<std::size_t>(origin)];
  result.stand_ins = std::move(varied.stand_ins);
}

/** The mesh as it is given to the estimation. */
DisturbedSurface
disturbModel(const Surface& mesh, const GroundTruth& truth, const RunOptions& options)
{
  if (!options.cut_limb)
    return disturb(mesh, options.disturbance);
  const DisturbedSurface rest = cutLimb(mesh, truth, *options.cut_limb, options.as_cloud ? Stump::Open : Stump::Closed);
  DisturbedSurface input = disturb(rest.surface, options.disturbance);
  for (Index& origin : input.origins)
    if (origin != no_index)
      origin = rest.origins[static_cast<std::size_t>(origin)];
  return input;
}

} // namespace

std::vector<VertexTruth>
vertexTruths(const BenchmarkModel& model, const ModelInput& input)
{
  const std::vector<bool> is_present = presentVertices(input.input.origins, input.mesh.size());
  std::vector<VertexTruth> truths(input.mesh.size(), VertexTruth::Unknown);
  for (const TruePartner& p : readGroundTruth(model.truth))
    if (is_present[static_cast<std::size_t>(p.vertex)])
      truths[static_cast<std::size_t>(p.vertex)] =
          is_present[static_cast<std::size_t>(p.partner)] ? VertexTruth::Paired : VertexTruth::Odd;
  return truths;
}

std::vector<Index>
mapOfFile(const ModelInput& input, const std::vector<Index>& partners)
{
  const std::vector<Index>& origins = input.input.origins;
  if (input.stand_ins.empty() || partners.empty())
    return undisturbMap(partners, origins, input.mesh.size());
  std::vector<Index> map;
  for (const Index stand_in : input.stand_ins) {
    const Index partner = stand_in == no_index ? no_index : partners[static_cast<std::size_t>(stand_in)];
    map.push_back(partner == no_index ? no_index : origins[static_cast<std::size_t>(partner)]);
  }
  return map;
}

ModelInput
readModel(const BenchmarkModel& model, const RunOptions& options)
{
  ModelInput result;
  result.mesh = readSurface(model.file);
  GroundTruth truth;
  if (!model.truth.empty()) {
    truth = readGroundTruth(model.truth);
    checkGroundTruth(truth, result.mesh.size(), model.truth);
  }
  if (model.variant == Variant::AsItIs)
    result.input = disturbModel(result.mesh, truth, options);
  else
    varyModel(result, model, options);
  if (options.as_cloud) {
    result.input.surface.triangles.clear();
  }
  if (!truth.empty()) {
    const bool with_partner = options.disturbance.holes > 0 || options.cut_limb.has_value();
    result.asked = result.stand_ins.empty() ? selectTruth(truth, result.input.origins, result.mesh.size(), with_partner)
                                            : subsampleTruth(truth);
  }
  return result;
}

PreparedSurface
firstSurface(const ModelInput& input, const SymmetryParameters& parameters)
{
  const NeighbourSearch search = searchByKdTree;
  InterpretationPlan plan(input.input.surface, parameters, search);
  return plan.next(RivalInterpretations(plan.pooling()))->surface;
}

SymmetryParameters
parametersFor(const BenchmarkModel& model, const RunOptions& options)
{
  SymmetryParameters parameters = options.parameters;
  const float samples = samplesOf(model.variant);
  if (samples != 1.0F) {
    int& usual = parameters.method == Method::Robust ? parameters.robust.samples : parameters.staged.samples;
    usual = static_cast<int>(std::lround(samples * static_cast<float>(usual)));
  }
  return parameters;
}

} // namespace symmetry
} // namespace pcl
