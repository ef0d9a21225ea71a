#include "benchmark/model_input.h"

#include <pcl/symmetry/surface_io.h>

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

/** The part of the ground truth that is scored: a point that was dropped is nothing the estimation was asked about.
 * \param[in] with_partner nor is one whose partner is gone; where single points were dropped, one next to it will do */
GroundTruth
selectTruth(const GroundTruth& truth, const std::vector<Index>& origins, std::size_t points, bool with_partner)
{
  std::vector<bool> is_present(points, false);
  for (const Index origin : origins)
    if (origin != no_index)
      is_present[static_cast<std::size_t>(origin)] = true;
  const auto is_asked = [&](const TruePartner& p) {
    return is_present[static_cast<std::size_t>(p.vertex)] &&
           (!with_partner || is_present[static_cast<std::size_t>(p.partner)]);
  };
  GroundTruth selected = subsampleTruth(truth);
  selected.erase(std::remove_if(selected.begin(), selected.end(), [&](const TruePartner& p) { return !is_asked(p); }),
                 selected.end());
  return selected;
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
  result.input = disturbModel(result.mesh, truth, options);
  if (options.as_cloud) {
    result.input.surface.triangles.clear();
  }
  if (!truth.empty()) {
    const bool with_partner = options.disturbance.holes > 0 || options.cut_limb.has_value();
    result.asked = selectTruth(truth, result.input.origins, result.mesh.size(), with_partner);
  }
  return result;
}

} // namespace symmetry
} // namespace pcl
