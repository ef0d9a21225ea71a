#include "symmetry/interpretation_maps.h"

#include "base/vector_math.h"

#include <algorithm>
#include <limits>

namespace pcl {
namespace symmetry {

std::vector<Index>
mapOfInput(const Interpretation& interpretation)
{
  const PreparedSurface& surface = interpretation.surface;
  const std::vector<Index>& partners = interpretation.estimate.partners;
  std::vector<Index> map(surface.representatives.size(), no_index);
  for (std::size_t v = 0; v < map.size() && !partners.empty(); ++v) {
    const Index point = surface.representatives[v];
    if (point != no_index && partners[point] != no_index) {
      map[v] = surface.original[partners[point]];
    }
  }
  return map;
}

std::vector<char>
unsupportedInInput(const Interpretation& interpretation)
{
  const std::vector<Index>& representatives = interpretation.surface.representatives;
  const std::vector<char>& is_unsupported = interpretation.estimate.is_unsupported;
  std::vector<char> marks(representatives.size());
  for (std::size_t v = 0; v < marks.size() && !is_unsupported.empty(); ++v) {
    marks[v] = representatives[v] != no_index ? is_unsupported[representatives[v]] : char{0};
  }
  return marks;
}

std::vector<Index>
mapOnSurface(const PreparedSurface& surface, const Interpretation& interpretation)
{
  const std::vector<Index> of_input = mapOfInput(interpretation);
  std::vector<Index> map(surface.size(), no_index);
  for (std::size_t v = 0; v < map.size(); ++v) {
    const Index partner = of_input[surface.original[v]];
    map[v] = partner == no_index ? no_index : surface.representatives[partner];
  }
  return map;
}

std::vector<Vector3>
imagesOf(const PreparedSurface& surface, const std::vector<Index>& partners)
{
  constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();
  std::vector<Vector3> images(partners.size());
  std::transform(partners.begin(), partners.end(), images.begin(), [&surface](Index partner) {
    return partner == no_index ? Vector3{nowhere, nowhere, nowhere} : surface.points[partner];
  });
  return images;
}

std::vector<Vector3>
imagesOfProbes(const Interpretation& interpretation, MapPart part)
{
  constexpr std::size_t probes = 500;
  const std::vector<Index>& representatives = interpretation.surface.representatives;
  const std::vector<Index>& partners = interpretation.estimate.partners;
  const std::vector<char>& is_unsupported = interpretation.estimate.is_unsupported;
  std::vector<Index> of_probes;
  const std::size_t step = std::max<std::size_t>(1, representatives.size() / probes);
  for (std::size_t v = 0; !partners.empty() && v < representatives.size(); v += step) {
    const Index point = representatives[v];
    const bool is_asked = point != no_index && (part == MapPart::Whole || is_unsupported[point] == 0);
    of_probes.push_back(is_asked ? partners[point] : no_index);
  }
  return imagesOf(interpretation.surface, of_probes);
}

bool
areAlike(const std::vector<Vector3>& a, const std::vector<Vector3>& b)
{
  constexpr float near = 0.1F; // surfaces are at unit scale
  constexpr double most = 0.7; // by hand
  std::size_t both = 0;
  std::size_t alike = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const float apart = distance(a[i], b[i]);
    both += apart >= 0.0F ? 1U : 0U; // false for what is not a number
    alike += apart < near ? 1U : 0U;
  }
  return static_cast<double>(alike) >= most * static_cast<double>(both);
}

} // namespace symmetry
} // namespace pcl
