#include "geodesic/marked_groups.h"

namespace pcl {
namespace symmetry {

UnionFind
markedGroups(const SurfaceGraph& graph, const std::vector<char>& marks)
{
  UnionFind groups(graph.size());
  for (std::size_t v = 0; v < graph.size(); ++v) {
    if (marks[v] == 0) {
      continue;
    }
    for (const Index w : graph.neighboursOf(v)) {
      if (marks[w] != 0) {
        groups.join(static_cast<Index>(v), w);
      }
    }
  }
  return groups;
}

} // namespace symmetry
} // namespace pcl
