#include "symmetry/sides/curve_thinning.h"

#include "base/renumbering.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/sides/side_settings.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr AxisSettings settings{};

/** Part of a graph, its vertices renumbered. */
struct Subgraph {
  SurfaceGraph graph;
  std::vector<Index> original; ///< ascending
};

/** \param[in] factor lengths are multiplied by (1 + the mean of their ends' factors); empty: none are */
Subgraph
subgraph(const SurfaceGraph& graph, const std::vector<Index>& vertices, const std::vector<float>& factor)
{
  Subgraph part;
  part.original = vertices;
  std::vector<Index> number(graph.size(), no_index);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    number[vertices[i]] = static_cast<Index>(i);
  }
  std::vector<GraphEdge> edges;
  for (const Index v : vertices) {
    for (const auto [w, length] : graph.edges(v)) {
      if (v < w && number[w] != no_index) {
        const float stretch = factor.empty() ? 1.0F : 1.0F + 0.5F * (factor[v] + factor[w]);
        edges.push_back({number[v], number[w], stretch * length});
      }
    }
  }
  part.graph = buildGraph(vertices.size(), edges);
  return part;
}

/** The vertex with the largest finite distance. */
Index
farthest(const std::vector<float>& field)
{
  Index best = 0;
  for (std::size_t v = 0; v < field.size(); ++v) {
    if (field[v] < unreachable && field[v] > field[best]) {
      best = static_cast<Index>(v);
    }
  }
  return best;
}

/** Mean length of the longest edge of each vertex. */
float
meanReach(const SurfaceGraph& graph)
{
  double sum = 0.0;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    float longest = 0.0F;
    for (const auto [w, length] : graph.edges(v)) {
      longest = std::max(longest, length);
    }
    sum += longest;
  }
  return static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(graph.size(), 1)));
}

/** Takes curves out of a band, one at a time. */
class BandThinner {
public:
  BandThinner(const SurfaceGraph& graph, const std::vector<Index>& band, const std::vector<float>& factor)
      : graph_(graph), factor_(factor), rest_(band), reach_(meanReach(subgraph(graph, band, {}).graph))
  {
  }

  bool
  done() const
  {
    return rest_.empty();
  }

  Polyline
  next()
  {
    // The largest connected part of what is left.
    const Subgraph left = subgraph(graph_, rest_, {});
    const Components components = connectedComponents(left.graph);
    std::vector<Index> part;
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      if (components.component_of[i] == 0) {
        part.push_back(rest_[i]);
      }
    }

    const Subgraph plain = subgraph(graph_, part, {});
    const Subgraph weighted = subgraph(graph_, part, factor_);
    const Index p = farthest(distanceField(plain.graph, 0));
    const std::vector<float> from_p = distanceField(plain.graph, p);
    const Index q = farthest(from_p);
    Polyline curve;
    std::vector<Index> path = shortestPath(weighted.graph, p, q);
    const std::vector<Index> back = wayBack(part, plain.graph, path, from_p);
    curve.closed = !back.empty();
    path.insert(path.end(), back.begin(), back.end());
    curve.points = renumbered(path, part);
    removeTube(part, distanceField(plain.graph, path));
    return curve;
  }

private:
  /** A path from the last vertex of \a path to its first that avoids its surroundings, without these two; empty where
   * there is none. */
  std::vector<Index>
  wayBack(const std::vector<Index>& part,
          const SurfaceGraph& plain,
          const std::vector<Index>& path,
          const std::vector<float>& from_p) const
  {
    const Index p = path.front();
    const Index q = path.back();
    if (from_p[q] <= 2.0F * settings.end_radius * reach_) {
      return {};
    }
    const std::vector<float> from_q = distanceField(plain, q);
    std::vector<Index> core;
    for (const Index v : path) {
      if (std::min(from_p[v], from_q[v]) > settings.end_radius * reach_) {
        core.push_back(v);
      }
    }
    const std::vector<float> from_core = distanceField(plain, core);
    std::vector<Index> open;
    Index first = no_index;
    Index last = no_index;
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (from_core[i] > settings.tube_radius * reach_) {
        first = static_cast<Index>(i) == p ? static_cast<Index>(open.size()) : first;
        last = static_cast<Index>(i) == q ? static_cast<Index>(open.size()) : last;
        open.push_back(static_cast<Index>(i));
      }
    }
    if (first == no_index || last == no_index) {
      return {};
    }
    const Subgraph around = subgraph(graph_, renumbered(open, part), factor_);
    std::vector<Index> back = renumbered(shortestPath(around.graph, last, first), open);
    if (back.size() <= 2) {
      return {};
    }
    return {back.begin() + 1, back.end() - 1};
  }

  /** Takes the surroundings of a curve out of the band. */
  void
  removeTube(const std::vector<Index>& part, const std::vector<float>& from_curve)
  {
    std::vector<Index> covered;
    for (std::size_t i = 0; i < part.size(); ++i) {
      if (from_curve[i] <= settings.tube_radius * reach_) {
        covered.push_back(part[i]);
      }
    }
    std::vector<Index> remaining;
    std::set_difference(rest_.begin(), rest_.end(), covered.begin(), covered.end(), std::back_inserter(remaining));
    rest_.swap(remaining);
  }

  const SurfaceGraph& graph_;
  const std::vector<float>& factor_;
  std::vector<Index> rest_; ///< ascending
  float reach_;
};

} // namespace

std::vector<Polyline>
bandCurves(const SurfaceGraph& graph, const std::vector<float>& side_function, const std::vector<Side>& sides)
{
  std::vector<Index> band;
  float largest = 0.0F;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    if (sides[v] == Side::Axis) {
      band.push_back(static_cast<Index>(v));
      largest = std::max(largest, std::abs(side_function[v]));
    }
  }
  std::vector<float> factor(graph.size(), 0.0F);
  for (const Index v : band) {
    factor[v] = largest > 0.0F ? std::abs(side_function[v]) / largest : 0.0F;
  }
  BandThinner thinner(graph, band, factor);
  std::vector<Polyline> curves;
  while (!thinner.done() && curves.size() < settings.maximum_curves) {
    curves.push_back(thinner.next());
  }
  return curves;
}

} // namespace symmetry
} // namespace pcl
