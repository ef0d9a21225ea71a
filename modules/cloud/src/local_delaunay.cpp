#include "cloud/local_delaunay.h"

#include "base/parallel.h"
#include "base/renumbering.h"
#include "base/tangent_frame.h"
#include "base/vector_math.h"
#include "cloud/cloud_settings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

constexpr FanSettings settings{};

struct PlanePoint {
  float x;
  float y;
  float angle;
  Index point;
};

/** Neighbours of a point in its tangent plane, by angle; of those in the same direction only the nearest. */
std::vector<PlanePoint>
projectNeighbours(const std::vector<Vector3>& points, const Vector3& n, const SurfaceGraph& graph, std::size_t v)
{
  const auto [axis_x, axis_y] = tangentFrame(n);
  std::vector<PlanePoint> projected;
  for (const auto [w, length] : graph.edges(v)) {
    const Vector3 offset = points[w] - points[v];
    PlanePoint p{dot(offset, axis_x), dot(offset, axis_y), 0.0F, w};
    const float flat = std::hypot(p.x, p.y);
    if (flat > 0.0F) {
      // At its true distance: projecting would pull points on a bend towards the centre.
      const float stretch = length / flat;
      p.x *= stretch;
      p.y *= stretch;
      p.angle = std::atan2(p.y, p.x);
      projected.push_back(p);
    }
  }
  std::sort(projected.begin(), projected.end(), [](const PlanePoint& a, const PlanePoint& b) {
    return a.angle != b.angle ? a.angle < b.angle : a.point < b.point;
  });
  return projected;
}

/** Whether b is a Delaunay neighbour of the origin between a and c, in angular order: it lies inside the circle through
 * the origin, a and c. */
bool
isInside(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
  const float turn = a.x * c.y - a.y * c.x;
  const float aa = a.x * a.x + a.y * a.y;
  const float cc = c.x * c.x + c.y * c.y;
  if (turn <= 0.0F) {
    return true; // a and c are half a turn apart or more: without b there would be a gap
  }
  const float centre_x = (c.y * aa - a.y * cc) / (2.0F * turn);
  const float centre_y = (a.x * cc - c.x * aa) / (2.0F * turn);
  return b.x * b.x + b.y * b.y < 2.0F * (b.x * centre_x + b.y * centre_y);
}

/** Takes out neighbours until every remaining one is a Delaunay neighbour of the origin. */
void
keepDelaunayNeighbours(std::vector<PlanePoint>& ring)
{
  for (std::size_t unchanged = 0, i = 0; ring.size() > 3 && unchanged < ring.size();) {
    i %= ring.size();
    const PlanePoint& before = ring[(i + ring.size() - 1) % ring.size()];
    const PlanePoint& after = ring[(i + 1) % ring.size()];
    if (isInside(before, ring[i], after)) {
      ++unchanged;
      ++i;
    }
    else {
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      i = i == 0 ? ring.size() - 1 : i - 1; // the one before may have become superfluous
      unchanged = 0;
    }
  }
}

/** The Delaunay neighbours of a point in its tangent plane, by angle. */
std::vector<PlanePoint>
delaunayNeighbours(const std::vector<Vector3>& points,
                   const std::vector<Vector3>& normals,
                   const SurfaceGraph& graph,
                   std::size_t v)
{
  std::vector<PlanePoint> ring = projectNeighbours(points, normals[v], graph, v);
  keepDelaunayNeighbours(ring);
  return ring;
}

/** Calls visit (a, b) for every two neighbours that form a triangle with the centre; gaps of more than 150 degrees stay
 * open. */
template <typename Visit>
void
visitFan(const std::vector<PlanePoint>& ring, Visit visit)
{
  constexpr float full_turn = 6.2831853F;
  if (ring.size() < 2) {
    return;
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanePoint& a = ring[i];
    const PlanePoint& b = ring[(i + 1) % ring.size()];
    const float gap = i + 1 < ring.size() ? b.angle - a.angle : b.angle - a.angle + full_turn;
    if (gap > 0.0F && gap < settings.maximum_gap) {
      visit(a, b);
    }
  }
}

/** Half the cotangent of the angle between two sides; bounded, so that slivers do not take over. */
float
halfCotangent(float ux, float uy, float vx, float vy)
{
  const float sine = std::abs(ux * vy - uy * vx);
  const float cosine = ux * vx + uy * vy;
  return 0.5F * (sine * settings.cotangent_bound <= std::abs(cosine) ? std::copysign(settings.cotangent_bound, cosine)
                                                                     : cosine / sine);
}

/** Triangles that occur at least twice, once each. Sorted, so that the result does not depend on threads. */
std::vector<Triangle>
keepAgreed(std::vector<Triangle> proposed)
{
  std::sort(proposed.begin(), proposed.end());
  std::vector<Triangle> agreed;
  for (std::size_t i = 0; i + 1 < proposed.size(); ++i) {
    if (proposed[i] == proposed[i + 1] && (agreed.empty() || agreed.back() != proposed[i])) {
      agreed.push_back(proposed[i]);
    }
  }
  return agreed;
}

/** A triangle, how many of its corners propose it, and its longest side. */
struct Candidate {
  Triangle corners;
  int votes;
  float longest;
};

/** Each once, the most agreed on first. */
std::vector<Candidate>
byAgreement(std::vector<Triangle> proposed, const std::vector<Vector3>& points)
{
  std::sort(proposed.begin(), proposed.end());
  std::vector<Candidate> candidates;
  for (const Triangle& t : proposed) {
    if (!candidates.empty() && candidates.back().corners == t) {
      ++candidates.back().votes;
      continue;
    }
    float longest = 0.0F;
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, distance(points[t[k]], points[t[(k + 1) % 3]]));
    }
    candidates.push_back({t, 1, longest});
  }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.votes != b.votes ? a.votes > b.votes : a.longest < b.longest;
  });
  return candidates;
}

/** Triangles that share no side but from its two sides. */
class ConformingSet {
public:
  explicit ConformingSet(const std::vector<Vector3>& points) : points_(points)
  {
  }

  void
  addWhereFree(const Triangle& t)
  {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!isFree(t[k], t[(k + 1) % 3], t[(k + 2) % 3])) {
        return;
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      opposite_[edge(t[k], t[(k + 1) % 3])].push_back(t[(k + 2) % 3]);
    }
    triangles_.push_back(t);
  }

  std::vector<Triangle>
  take()
  {
    return std::move(triangles_);
  }

private:
  static std::pair<Index, Index>
  edge(Index a, Index b)
  {
    return std::minmax(a, b);
  }

  bool
  isFree(Index a, Index b, Index c) const
  {
    const auto found = opposite_.find(edge(a, b));
    if (found == opposite_.end()) {
      return true;
    }
    const Vector3 along = points_[b] - points_[a];
    const auto is_aside = [&](Index d) {
      return dot(cross(along, points_[c] - points_[a]), cross(along, points_[d] - points_[a])) > 0.0F;
    };
    return found->second.size() < 2 && std::none_of(found->second.begin(), found->second.end(), is_aside);
  }

  const std::vector<Vector3>& points_;
  std::map<std::pair<Index, Index>, std::vector<Index>> opposite_; ///< third corners at each side
  std::vector<Triangle> triangles_;
};

} // namespace

std::vector<Triangle>
conformingTriangles(const std::vector<Vector3>& points,
                    const std::vector<Vector3>& normals,
                    const SurfaceGraph& graph,
                    const std::vector<Index>& around)
{
  std::vector<Triangle> proposed;
  for (const Index v : around) {
    const std::vector<PlanePoint> ring = delaunayNeighbours(points, normals, graph, static_cast<std::size_t>(v));
    visitFan(ring, [&](const PlanePoint& a, const PlanePoint& b) {
      proposed.push_back(lowestFirst({v, a.point, b.point}));
    });
  }
  ConformingSet set(points);
  for (const Candidate& candidate : byAgreement(std::move(proposed), points)) {
    set.addWhereFree(candidate.corners);
  }
  return set.take();
}

std::vector<Triangle>
localDelaunayTriangles(const std::vector<Vector3>& points,
                       const std::vector<Vector3>& normals,
                       const SurfaceGraph& graph)
{
  constexpr std::size_t grain = 1024;
  const std::size_t blocks = (points.size() + grain - 1) / grain;
  std::vector<std::vector<Triangle>> proposed(blocks);
  parallelFor(blocks, [&](std::size_t block) {
    for (std::size_t v = block * grain; v < std::min(points.size(), (block + 1) * grain); ++v) {
      const std::vector<PlanePoint> ring = delaunayNeighbours(points, normals, graph, v);
      visitFan(ring, [&](const PlanePoint& a, const PlanePoint& b) {
        proposed[block].push_back(lowestFirst({static_cast<Index>(v), a.point, b.point}));
      });
    }
  });
  std::vector<Triangle> all;
  for (const std::vector<Triangle>& part : proposed) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return keepAgreed(std::move(all));
}

FanLaplacian
localDelaunayLaplacian(const std::vector<Vector3>& points,
                       const std::vector<Vector3>& normals,
                       const SurfaceGraph& graph)
{
  FanLaplacian result;
  result.areas.assign(points.size(), 0.0F);
  std::vector<float> one_sided(graph.neighbours.size(), 0.0F);
  for (std::size_t v = 0; v < points.size(); ++v) {
    const auto centre = static_cast<Index>(v);
    const std::vector<PlanePoint> ring = delaunayNeighbours(points, normals, graph, v);
    visitFan(ring, [&](const PlanePoint& a, const PlanePoint& b) {
      result.triangles.push_back(lowestFirst({centre, a.point, b.point}));
      result.areas[v] += std::abs(a.x * b.y - a.y * b.x);
      one_sided[edgeNumber(graph, centre, a.point)] += halfCotangent(b.x, b.y, b.x - a.x, b.y - a.y);
      one_sided[edgeNumber(graph, centre, b.point)] += halfCotangent(a.x, a.y, a.x - b.x, a.y - b.y);
    });
  }
  std::sort(result.triangles.begin(), result.triangles.end());
  result.triangles.erase(std::unique(result.triangles.begin(), result.triangles.end()), result.triangles.end());

  const double total = std::accumulate(result.areas.begin(), result.areas.end(), 0.0);
  for (float& area : result.areas) {
    area = total > 0.0 ? static_cast<float>(area / total) : 1.0F / static_cast<float>(points.size());
  }
  result.conductances.resize(one_sided.size());
  for (std::size_t v = 0; v < graph.size(); ++v) {
    for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
      const std::size_t back = edgeNumber(graph, graph.neighbours[e], static_cast<Index>(v));
      result.conductances[e] = std::max(0.0F, 0.5F * (one_sided[e] + one_sided[back]));
    }
  }
  return result;
}

} // namespace symmetry
} // namespace pcl
