#include "cloud/local_delaunay.h"

#include "geodesic/parallel.h"
#include "geodesic/vector_math.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

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
  const Vector3 axis_x = normalized(cross(n, std::abs(n[0]) < 0.9F ? Vector3{1, 0, 0} : Vector3{0, 1, 0}));
  const Vector3 axis_y = cross(n, axis_x);
  std::vector<PlanePoint> projected;
  for (std::uint32_t e = graph.offsets[v]; e < graph.offsets[v + 1]; ++e) {
    const Vector3 offset = points[graph.neighbours[e]] - points[v];
    PlanePoint p{dot(offset, axis_x), dot(offset, axis_y), 0.0F, graph.neighbours[e]};
    const float flat = std::hypot(p.x, p.y);
    if (flat > 0.0F) {
      // At its true distance: projecting would pull points on a bend towards the centre.
      const float stretch = graph.lengths[e] / flat;
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

Triangle
lowestFirst(Triangle t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/** The fan of triangles that a point proposes; gaps of more than 150 degrees stay open. */
void
appendFan(const std::vector<PlanePoint>& ring, Index centre, std::vector<Triangle>& triangles)
{
  constexpr float widest = 2.6F;
  constexpr float full_turn = 6.2831853F;
  if (ring.size() < 2) {
    return;
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const PlanePoint& a = ring[i];
    const PlanePoint& b = ring[(i + 1) % ring.size()];
    const float gap = i + 1 < ring.size() ? b.angle - a.angle : b.angle - a.angle + full_turn;
    if (gap > 0.0F && gap < widest) {
      triangles.push_back(lowestFirst({centre, a.point, b.point}));
    }
  }
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

} // namespace

std::vector<Triangle>
localDelaunayTriangles(const std::vector<Vector3>& points,
                       const std::vector<Vector3>& normals,
                       const SurfaceGraph& graph,
                       unsigned threads)
{
  constexpr std::size_t grain = 1024;
  const std::size_t blocks = (points.size() + grain - 1) / grain;
  std::vector<std::vector<Triangle>> proposed(blocks);
  parallelFor(blocks, threads, [&](std::size_t block) {
    for (std::size_t v = block * grain; v < std::min(points.size(), (block + 1) * grain); ++v) {
      std::vector<PlanePoint> ring = projectNeighbours(points, normals[v], graph, v);
      keepDelaunayNeighbours(ring);
      appendFan(ring, static_cast<Index>(v), proposed[block]);
    }
  });
  std::vector<Triangle> all;
  for (const std::vector<Triangle>& part : proposed) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return keepAgreed(std::move(all));
}

} // namespace symmetry
} // namespace pcl
