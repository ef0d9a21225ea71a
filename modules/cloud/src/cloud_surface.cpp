#include "cloud/cloud_surface.h"

#include "base/heartbeat.h"
#include "base/parallel.h"
#include "base/statistics.h"
#include "base/union_find.h"
#include "base/vector_math.h"
#include "cloud/cloud_normals.h"
#include "cloud/cloud_settings.h"
#include "cloud/contact_barrier.h"
#include "cloud/local_delaunay.h"
#include "cloud/point_grid.h"
#include "cloud/sheet_normals.h"
#include "geodesic/shortest_paths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>

namespace pcl {
namespace symmetry {
namespace {

constexpr ContactSettings settings{};

/** Every edge of a graph once. */
std::vector<GraphEdge>
edgesOf(const SurfaceGraph& graph)
{
  std::vector<GraphEdge> edges;
  edges.reserve(graph.neighbours.size() / 2);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    for (const auto [w, length] : graph.edges(v)) {
      if (static_cast<std::size_t>(w) > v) {
        edges.push_back({static_cast<Index>(v), w, length});
      }
    }
  }
  return edges;
}

/** Median length of the edges at each point: the local spacing. */
std::vector<float>
localSpacing(const SurfaceGraph& graph)
{
  std::vector<float> spacing(graph.size(), 0.0F);
  std::vector<float> lengths;
  for (std::size_t v = 0; v < graph.size(); ++v) {
    lengths.assign(graph.lengths.begin() + graph.offsets[v], graph.lengths.begin() + graph.offsets[v + 1]);
    spacing[v] = medianInPlace(lengths);
  }
  return spacing;
}

/** Moves the edges for which a worker's verdict is true; what is left keeps its order.
 * \param[in] make_judge called once per thread, returns a function of an edge */
template <typename MakeJudge>
void
moveEdges(std::vector<GraphEdge>& from, std::vector<GraphEdge>& to, MakeJudge make_judge)
{
  constexpr std::size_t grain = 1024;
  std::vector<char> moves(from.size());
  parallelBlocks(from.size(), grain, [&] {
    return [&, judge = make_judge()](std::size_t begin, std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        moves[i] = judge(from[i]) ? 1 : 0;
      }
    };
  });
  std::size_t left = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (moves[i] != 0) {
      to.push_back(from[i]);
    }
    else {
      from[left++] = from[i];
    }
  }
  from.resize(left);
}

/** Splits edges into trusted and distrusted ones. */
template <typename IsShortcut>
void
separateEdges(std::vector<GraphEdge>& trusted, std::vector<GraphEdge>& distrusted, IsShortcut is_shortcut)
{
  moveEdges(trusted, distrusted, [&is_shortcut] { return is_shortcut; });
}

/** How an edge lies to the tangent planes of its ends, as sines of angles, whichever way the normals are turned. */
struct EdgeSlope {
  float steepest = 0.0F; ///< at the end where it is steeper
  float step = 0.0F;     ///< see ContactTest::step
};

EdgeSlope
slopeOf(const GraphEdge& edge, const std::vector<Vector3>& points, const std::vector<Vector3>& normals)
{
  const Vector3 direction = normalized(points[edge.b] - points[edge.a]);
  const float at_a = dot(direction, normals[edge.a]);
  const float at_b = std::copysign(1.0F, dot(normals[edge.a], normals[edge.b])) * dot(direction, normals[edge.b]);
  return {std::max(std::abs(at_a), std::abs(at_b)), 0.5F * std::abs(at_a + at_b)};
}

/** The largest step of an edge that is trusted: more where the points are rough, as by rounding or where they are few.
 */
float
largestStep(const std::vector<GraphEdge>& edges,
            const std::vector<Vector3>& points,
            const std::vector<Vector3>& normals,
            const ContactTest& contact)
{
  if (contact.step >= 1.0F || edges.empty()) {
    return 1.0F; // that of no edge is larger
  }
  std::vector<float> steps(edges.size());
  std::transform(edges.begin(), edges.end(), steps.begin(),
                 [&](const GraphEdge& edge) { return slopeOf(edge, points, normals).step; });
  return std::max(contact.step, settings.step_excess * median(std::move(steps)));
}

/** Moves the shortest distrusted edges between parts that the trusted ones do not join to these; the number of them. */
std::size_t
bridgeParts(std::size_t n, std::vector<GraphEdge>& trusted, std::vector<GraphEdge>& distrusted)
{
  UnionFind parts(n);
  for (const GraphEdge& edge : trusted) {
    parts.join(edge.a, edge.b);
  }
  std::stable_sort(distrusted.begin(), distrusted.end(),
                   [](const GraphEdge& x, const GraphEdge& y) { return x.length < y.length; });
  const auto first_left = std::stable_partition(distrusted.begin(), distrusted.end(),
                                                [&](const GraphEdge& edge) { return parts.join(edge.a, edge.b); });
  const auto bridges = static_cast<std::size_t>(first_left - distrusted.begin());
  trusted.insert(trusted.end(), distrusted.begin(), first_left);
  distrusted.erase(distrusted.begin(), first_left);
  return bridges;
}

/** Searches around a vertex, with memory kept from search to search. Goes first where the way and the straight line
 * from there to the target are shortest together (Hart, Nilsson and Raphael: A formal basis for the heuristic
 * determination of minimum cost paths. IEEE Transactions on Systems Science and Cybernetics 4(2), 1968
 * \cite hart1968formal). */
class LocalSearch {
public:
  LocalSearch(const std::vector<Vector3>& points, const SurfaceGraph& graph)
      : points_(points), graph_(graph), distance_(graph.size(), unreachable)
  {
  }

  /** Whether there is a way between two vertices no longer than \a limit, among the points nearest to it. */
  bool
  isNear(Index from, Index to, float limit)
  {
    constexpr float rounding = 1.0001F;
    bool found = false;
    std::size_t passed = 0;
    push(from, 0.0F, 0.0F);
    while (!queue_.empty() && !found && passed < settings.restored_points) {
      std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
      const auto [least, d, v] = queue_.back();
      queue_.pop_back();
      if (d > distance_[v]) {
        continue;
      }
      found = v == to;
      ++passed;
      for (const auto [next, length] : graph_.edges(v)) {
        const float through = d + length;
        if (through <= limit && through < distance_[next]) {
          const float whole = through + distance(points_[next], points_[to]);
          if (whole <= rounding * limit) {
            push(next, through, whole);
          }
        }
      }
    }
    for (const Index v : reached_) {
      distance_[v] = unreachable;
    }
    reached_.clear();
    queue_.clear();
    return found;
  }

private:
  void
  push(Index v, float d, float whole)
  {
    distance_[v] = d;
    reached_.push_back(v);
    queue_.emplace_back(whole, d, v);
    std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
  }

  using Entry = std::tuple<float, float, Index>; // least length of the whole way, length so far, vertex
  const std::vector<Vector3>& points_;
  const SurfaceGraph& graph_;
  std::vector<float> distance_;
  std::vector<Index> reached_;
  std::vector<Entry> queue_; ///< a heap, the least on top
};

/** Tells edges to one of the nearest neighbours of either end. */
class NearEdges {
public:
  NearEdges(const std::vector<Vector3>& points, const NeighbourLists& lists)
      : reach_(points.size(), std::numeric_limits<float>::infinity())
  {
    for (std::size_t v = 0; v < points.size(); ++v) {
      const IndexRange around = lists.of(v);
      if (around.size() > settings.restored_neighbours) {
        const Index last = around.begin()[settings.restored_neighbours - 1];
        reach_[v] = distance(points[v], points[last]);
      }
    }
  }

  bool
  operator()(const GraphEdge& edge) const
  {
    return edge.length <= std::max(reach_[edge.a], reach_[edge.b]);
  }

private:
  std::vector<float> reach_; ///< of each point; infinite where there are no more neighbours
};

/** Puts back the edges that shorten no way by much: on a sharp bend they are needed, and they join no parts in contact.
 */
void
restoreHarmless(const std::vector<Vector3>& points,
                const NearEdges& is_near,
                float detour,
                std::vector<GraphEdge>& trusted,
                std::vector<GraphEdge>& distrusted)
{
  std::vector<GraphEdge> ways;
  std::copy_if(trusted.begin(), trusted.end(), std::back_inserter(ways), is_near);
  const SurfaceGraph graph = buildGraph(points.size(), ways);
  const Components parts = connectedComponents(graph); // a search between two of them would go through all of one
  moveEdges(distrusted, trusted, [&points, &graph, &parts, &is_near, detour] {
    return [search = LocalSearch(points, graph), &parts, &is_near, detour](const GraphEdge& edge) mutable {
      return parts.component_of[edge.a] == parts.component_of[edge.b] && is_near(edge) &&
             search.isNear(edge.a, edge.b, detour * edge.length);
    };
  });
}

/** Links across the gaps between the parts of a graph: from each smaller part to the nearest other one, all ways that
 * are at most twice as long as the shortest. Specks stay apart. */
std::vector<GraphEdge>
linksAcrossGaps(const std::vector<Vector3>& points, const SurfaceGraph& graph)
{
  std::vector<GraphEdge> links;
  const Components parts = connectedComponents(graph);
  if (parts.sizes.size() < 2) {
    return links;
  }
  const PointGrid grid(points, settings.maximum_gap);
  std::vector<std::vector<GraphEdge>> ways(parts.sizes.size());
  for (std::size_t v = 0; v < points.size(); ++v) {
    const Index part = parts.component_of[v];
    if (part == 0 || parts.sizes[part] < settings.minimum_part) {
      continue;
    }
    GraphEdge nearest{static_cast<Index>(v), no_index, settings.maximum_gap};
    grid.visitAround(points[v], [&](Index w) {
      const Index other = parts.component_of[w];
      if (other != part && parts.sizes[other] >= settings.minimum_part &&
          distance(points[v], points[w]) < nearest.length) {
        nearest.b = w;
        nearest.length = distance(points[v], points[w]);
      }
    });
    if (nearest.b != no_index) {
      ways[part].push_back(nearest);
    }
  }
  for (const std::vector<GraphEdge>& candidates : ways) {
    float shortest = settings.maximum_gap;
    for (const GraphEdge& way : candidates) {
      shortest = std::min(shortest, way.length);
    }
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(links),
                 [shortest](const GraphEdge& way) { return way.length <= settings.way_ratio * shortest; });
  }
  return links;
}

} // namespace

CloudSurface
buildCloudSurface(const std::vector<Vector3>& points,
                  const NeighbourLists& lists,
                  const std::vector<Vector3>& given_normals,
                  float radius,
                  const ContactTest& contact,
                  const std::vector<char>& is_oriented)
{
  const SurfaceGraph plain = buildNeighbourGraph(points, lists, radius);
  heartbeat();
  const std::vector<GraphEdge> gaps = radius > 0.0F ? std::vector<GraphEdge>{} : linksAcrossGaps(points, plain);
  const std::vector<float> spacing = localSpacing(plain);
  CloudSurface cloud;
  cloud.normals = given_normals.empty() ? estimateNormals(points, lists) : given_normals;
  if (given_normals.empty() && contact.sheet_normals) {
    cloud.normals = sheetNormals(points, lists, cloud.normals);
  }

  std::vector<GraphEdge> trusted = edgesOf(plain);
  std::vector<GraphEdge> distrusted;
  const float largest_step = largestStep(trusted, points, cloud.normals, contact);
  separateEdges(trusted, distrusted, [&](const GraphEdge& edge) {
    const EdgeSlope slope = slopeOf(edge, points, cloud.normals);
    return slope.step > largest_step ||
           (slope.steepest > settings.steep &&
            edge.length > settings.short_edge * std::min(spacing[edge.a], spacing[edge.b]));
  });
  if (given_normals.empty() || !is_oriented.empty()) {
    std::vector<GraphEdge> whole = trusted;
    std::vector<GraphEdge> rest = distrusted;
    bridgeParts(points.size(), whole, rest);
    orientNormals(points, buildGraph(points.size(), whole), is_oriented, cloud.normals);
  }
  separateEdges(trusted, distrusted, [&](const GraphEdge& edge) {
    return dot(cloud.normals[edge.a], cloud.normals[edge.b]) < contact.bend;
  });
  std::size_t bridges = 0;
  const float depth = contact.depth * median(spacing);
  if (depth > 0.0F) {
    const ContactBarrier barrier(points, cloud.normals, depth);
    separateEdges(trusted, distrusted, [&](const GraphEdge& edge) { return barrier.isCrossedBy(edge); });
    // The inside of a thin part is crossed all over: first it has to hang together.
    bridges = bridgeParts(points.size(), trusted, distrusted);
  }
  restoreHarmless(points, NearEdges(points, lists), contact.detour, trusted, distrusted);

  cloud.triangles = localDelaunayTriangles(points, cloud.normals, buildGraph(points.size(), trusted));
  cloud.bridges = bridges + bridgeParts(points.size(), trusted, distrusted) + gaps.size();
  cloud.distrusted_edges = distrusted.size();
  trusted.insert(trusted.end(), gaps.begin(), gaps.end());
  cloud.graph = buildGraph(points.size(), trusted);
  return cloud;
}

} // namespace symmetry
} // namespace pcl
