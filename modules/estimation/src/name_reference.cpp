#include "base/thread_scope.h"
#include "neighbour_search.h"
#include "refuse_argument.h"
#include "symmetry/names/exchanged_sides.h"
#include "symmetry/names/labelled_samples.h"
#include "symmetry/names/name_comparison.h"

#include <pcl/symmetry/name_reference.h>

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

void
checkLabels(const Surface& surface, const std::vector<Side>& sides, const std::vector<Index>& partners)
{
  if (sides.size() != surface.size() || partners.size() != surface.size()) {
    refuseArgument("there are ", sides.size(), " sides and ", partners.size(), " partners for ", surface.size(),
                   " points");
  }
  for (const Index partner : partners) {
    if (partner < no_index || (partner >= 0 && static_cast<std::size_t>(partner) >= surface.size())) {
      refuseArgument("partner ", partner, " is out of range, there are ", surface.size(), " points");
    }
  }
  for (const Triangle& triangle : surface.triangles) {
    for (const Index corner : triangle) {
      if (corner < 0 || static_cast<std::size_t>(corner) >= surface.size()) {
        refuseArgument("a triangle refers to point ", corner, ", there are ", surface.size(), " points");
      }
    }
  }
}

bool
isAllUnmatched(const std::vector<Index>& partners)
{
  return std::all_of(partners.begin(), partners.end(), [](Index partner) { return partner == no_index; });
}

ComparableSurface
describe(const Surface& surface, const std::vector<Side>& sides, const std::vector<Index>& partners)
{
  return describeLabelled(surface, sides, partners, searchByKdTree);
}

} // namespace

NameReference::NameReference(const Surface& surface,
                             const std::vector<Side>& sides,
                             const std::vector<Index>& partners,
                             unsigned threads)
{
  const ThreadScope scope(threads);
  checkLabels(surface, sides, partners);
  for (const Side side : {Side::Source, Side::Target}) {
    if (std::find(sides.begin(), sides.end(), side) == sides.end()) {
      refuseArgument("the reference has no point on the ", side == Side::Source ? "source" : "target",
                     " side: it names nothing");
    }
  }
  if (isAllUnmatched(partners)) {
    refuseArgument("no point of the reference has a partner");
  }
  ComparableSurface described = describe(surface, sides, partners);
  if (!described.isComparable()) {
    refuseArgument("the reference has too few points to be compared with");
  }
  reference_ = std::make_shared<const ComparableSurface>(std::move(described));
}

void
NameReference::nameSides(const Surface& surface, SymmetryResult& result, unsigned threads) const
{
  if (!hasMap(result.status)) {
    return;
  }
  const ThreadScope scope(threads);
  checkLabels(surface, result.sides, result.partners);
  if (isAllUnmatched(result.partners)) {
    refuseArgument("sides are named by a reference from the dense map, which the result does not have");
  }
  const NameComparison comparison = compareNames(*reference_, describe(surface, result.sides, result.partners));
  result.naming.by_reference = true;
  result.naming.exchanged = comparison.margin() < 0.0;
  result.naming.margin = static_cast<float>(std::abs(comparison.margin()));
  result.naming.misfit = static_cast<float>(std::min(comparison.same, comparison.opposite));
  if (result.naming.exchanged) {
    exchangeSides(result);
  }
}

} // namespace symmetry
} // namespace pcl
