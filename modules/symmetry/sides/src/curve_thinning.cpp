#include "symmetry/sides/curve_thinning.h"

#include "base/renumbering.h"
#include "base/vector_math.h"
#include "geodesic/shortest_paths.h"
#include "symmetry/sides/side_settings.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

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

float
meanEdgeLength(const SurfaceGraph& graph)
{
  const double sum = std::accumulate(graph.lengths.begin(), graph.lengths.end(), 0.0);
  return static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(graph.lengths.size(), 1)));
}

/** Takes curves out of a band of vertices, one at a time. */
class BandThinner {
public:
  BandThinner(const SurfaceGraph& graph, const std::vector<Index>& band, const std::vector<float>& factor)
      : graph_(graph), factor_(factor), rest_(band), reach_(meanEdgeLength(graph))
  {
  }

  bool
  done() const
  {
    return rest_.empty();
  }

  /** Numbers of vertices of the graph in order, and whether the last is joined to the first. */
  std::pair<std::vector<Index>, bool>
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
    std::vector<Index> path = shortestPath(weighted.graph, p, q);
    const std::vector<Index> back = wayBack(part, plain.graph, path, from_p);
    path.insert(path.end(), back.begin(), back.end());
    removeTube(part, distanceField(plain.graph, path));
    return {renumbered(path, part), !back.empty()};
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

/** Crossings of all edges that lead from one sign to the other, those of each point one after another. */
std::vector<ZeroCrossing>
findCrossings(const SurfaceGraph& graph, const std::vector<float>& values)
{
  std::vector<ZeroCrossing> crossings;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    for (const Index w : graph.neighboursOf(v)) {
      if (values[v] >= 0.0F && values[w] < 0.0F) {
        crossings.push_back(crossingBetween(static_cast<Index>(v), w, values));
      }
    }
  }
  return crossings;
}

/** What a graph of 10 neighbours, read both ways, has at nearly all points. */
constexpr std::size_t enough_edges = 16;

/** The edges that are among the shortest ones of either end: all of them in any usual graph; where points have hundreds
 * of neighbours, pairs of crossings would be tens of thousands a point. */
SurfaceGraph
shortestEdges(const SurfaceGraph& graph)
{
  std::vector<GraphEdge> kept;
  std::vector<std::pair<float, Index>> edges; // of one point
  for (std::size_t v = 0; v < graph.size(); ++v) {
    edges.clear();
    for (const auto [w, length] : graph.edges(v)) {
      edges.emplace_back(length, w);
    }
    const auto end = edges.begin() + static_cast<std::ptrdiff_t>(std::min(enough_edges, edges.size()));
    std::partial_sort(edges.begin(), end, edges.end());
    for (auto edge = edges.begin(); edge != end; ++edge) {
      kept.push_back({static_cast<Index>(v), edge->second, edge->first});
    }
  }
  return buildGraph(graph.size(), kept);
}

/** Links crossings that share a point or, where they are near, of which one has a neighbour of the other. */
class CrossingLinks {
public:
  CrossingLinks(const SurfaceGraph& graph,
                const std::vector<ZeroCrossing>& crossings,
                const std::vector<Vector3>& points)
      : at_point_(graph.size())
  {
    for (std::size_t i = 0; i < crossings.size(); ++i) {
      at_point_[crossings[i].from].push_back(static_cast<Index>(i));
      at_point_[crossings[i].to].push_back(static_cast<Index>(i));
      places_.push_back(placeOf(crossings[i], points));
      lengths_.push_back(distance(points[crossings[i].from], points[crossings[i].to]));
    }
    for (std::vector<Index>& at : at_point_) { // a hub of thousands would link them all with each other
      const auto end = at.begin() + static_cast<std::ptrdiff_t>(std::min(enough_edges, at.size()));
      std::partial_sort(at.begin(), end, at.end(),
                        [this](Index i, Index j) { return std::tie(lengths_[i], i) < std::tie(lengths_[j], j); });
      at.erase(end, at.end());
    }
    for (std::size_t v = 0; v < graph.size(); ++v) {
      link(static_cast<Index>(v), static_cast<Index>(v), unreachable);
      for (const Index w : graph.neighboursOf(v)) {
        if (static_cast<Index>(v) < w) {
          link(static_cast<Index>(v), w, settings.link);
        }
      }
    }
  }

  SurfaceGraph
  graph() const
  {
    return buildGraph(places_.size(), links_);
  }

private:
  /** The crossings of one point with those of another, as far apart as a share of their mean length at most. */
  void
  link(Index v, Index w, float share)
  {
    for (const Index i : at_point_[v]) {
      for (const Index j : at_point_[w]) {
        const float apart = distance(places_[i], places_[j]);
        if (i != j && apart <= share * 0.5F * (lengths_[i] + lengths_[j])) {
          links_.push_back({i, j, apart});
        }
      }
    }
  }

  std::vector<std::vector<Index>> at_point_;
  std::vector<Vector3> places_;
  std::vector<float> lengths_;
  std::vector<GraphEdge> links_;
};

/** By how much longer a path through each crossing counts: by the square of the length of its edge, in mean ones. */
std::vector<float>
lengthPenalties(const std::vector<ZeroCrossing>& crossings, const std::vector<Vector3>& points)
{
  std::vector<float> squares;
  double sum = 0.0;
  for (const ZeroCrossing& crossing : crossings) {
    const float length = distance(points[crossing.from], points[crossing.to]);
    squares.push_back(length * length);
    sum += length;
  }
  const float mean = static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(crossings.size(), 1)));
  for (float& square : squares) {
    square = mean > 0.0F ? square / (mean * mean) : 0.0F;
  }
  return squares;
}

} // namespace

Vector3
placeOf(const ZeroCrossing& crossing, const std::vector<Vector3>& points)
{
  const Vector3& from = points[crossing.from];
  return from + crossing.share * (points[crossing.to] - from);
}

std::vector<ZeroLine>
cloudContours(const SurfaceGraph& whole, const std::vector<Vector3>& points, const std::vector<float>& values)
{
  const SurfaceGraph graph = shortestEdges(whole);
  const std::vector<ZeroCrossing> crossings = findCrossings(graph, values);
  const SurfaceGraph links = CrossingLinks(graph, crossings, points).graph();
  const std::vector<float> penalties = lengthPenalties(crossings, points);
  std::vector<Index> all(crossings.size());
  std::iota(all.begin(), all.end(), 0);
  BandThinner thinner(links, all, penalties);
  std::vector<ZeroLine> lines;
  while (!thinner.done() && lines.size() < settings.maximum_curves) {
    const auto [path, closed] = thinner.next();
    lines.push_back({{}, closed});
    for (const Index i : path) {
      lines.back().crossings.push_back(crossings[i]);
    }
  }
  return lines;
}

} // namespace symmetry
} // namespace pcl
