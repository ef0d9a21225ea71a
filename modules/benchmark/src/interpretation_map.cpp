#include "benchmark/interpretation_map.h"

namespace pcl {
namespace symmetry {

std::vector<Index>
mapOfModel(const Interpretation& interpretation, const ModelInput& model)
{
  const PreparedSurface& surface = interpretation.surface;
  const std::vector<Index>& partners = interpretation.estimate.partners;
  std::vector<Index> of_input(surface.representatives.size(), no_index);
  for (std::size_t v = 0; v < of_input.size() && !partners.empty(); ++v) {
    if (surface.representatives[v] != no_index && partners[surface.representatives[v]] != no_index) {
      of_input[v] = surface.original[partners[surface.representatives[v]]];
    }
  }
  return mapOfFile(model, of_input);
}

} // namespace symmetry
} // namespace pcl
