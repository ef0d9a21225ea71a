#include "model/editable_mesh.h"

#include <algorithm>
#include <iterator>

namespace pcl {
namespace symmetry {
namespace {

bool
contains(const Triangle& triangle, Index vertex)
{
  return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
}

void
removeItem(std::vector<Index>& items, Index item)
{
  items.erase(std::find(items.begin(), items.end(), item));
}

Eigen::Vector3d
areaNormal(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  return (b - a).cross(c - a);
}

/** \brief Whether a changed triangle still faces the way it did: less than about 75 degrees away. */
bool
facesAlike(const Eigen::Vector3d& before, const Eigen::Vector3d& after)
{
  return before.dot(after) > 0.25 * before.norm() * after.norm();
}

} // namespace

EditableMesh::EditableMesh(TriangleMesh mesh)
    : mesh_(std::move(mesh)), stars_(mesh_.points.size()), on_boundary_(mesh_.points.size(), 0)
{
  for (std::size_t face = 0; face < mesh_.triangles.size(); ++face)
    for (const Index vertex : mesh_.triangles[face])
      star(vertex).push_back(static_cast<Index>(face));
  for (const std::vector<Index>& faces : stars_)
    vertices_ += faces.empty() ? 0 : 1;
  markBoundary();
}

void
EditableMesh::markBoundary()
{
  for (std::size_t v = 0; v < stars_.size(); ++v) {
    // Inside the surface a vertex has as many triangles as neighbours.
    const bool boundary = !stars_[v].empty() && neighbours(static_cast<Index>(v)).size() != stars_[v].size();
    on_boundary_[v] = boundary ? 1 : 0;
    boundary_vertices_ += boundary ? 1 : 0;
  }
}

std::vector<Index>
EditableMesh::neighbours(Index vertex) const
{
  std::vector<Index> ring;
  ring.reserve(2 * star(vertex).size());
  for (const Index face : star(vertex))
    for (const Index other : triangle(face))
      if (other != vertex)
        ring.push_back(other);
  std::sort(ring.begin(), ring.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  return ring;
}

std::vector<std::pair<Index, Index>>
EditableMesh::edges() const
{
  std::vector<std::pair<Index, Index>> all;
  all.reserve(3 * vertices_);
  for (std::size_t v = 0; v < stars_.size(); ++v)
    for (const Index other : neighbours(static_cast<Index>(v)))
      if (static_cast<Index>(v) < other)
        all.emplace_back(static_cast<Index>(v), other);
  return all;
}

Eigen::Vector3d
EditableMesh::normal(Index vertex) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Index face : star(vertex)) {
    const Triangle& t = triangle(face);
    sum += areaNormal(point(t[0]), point(t[1]), point(t[2]));
  }
  return sum;
}

std::pair<Index, Index>
EditableMesh::opposite(Index a, Index b) const
{
  std::pair<Index, Index> found(no_index, no_index); // left of a -> b, then right of it
  for (const Index face : star(a)) {
    const Triangle& t = triangle(face);
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] == a && t[(k + 1) % 3] == b)
        found.first = t[(k + 2) % 3];
      if (t[k] == b && t[(k + 1) % 3] == a)
        found.second = t[(k + 2) % 3];
    }
  }
  return found;
}

/** \brief The link condition, and the rule that no inner edge joins two vertices of the boundary. */
bool
EditableMesh::mayCollapse(Index kept, Index gone) const
{
  const auto [left, right] = opposite(kept, gone);
  const bool boundary_edge = left == no_index || right == no_index;
  if (onBoundary(gone) && !boundary_edge)
    return false; // the boundary would leave its place, or be pinched
  if (boundary_edge && !onBoundary(kept))
    return false;
  const std::vector<Index> ring = neighbours(kept);
  const std::vector<Index> other_ring = neighbours(gone);
  std::vector<Index> common;
  std::set_intersection(ring.begin(), ring.end(), other_ring.begin(), other_ring.end(), std::back_inserter(common));
  if (common.size() != (boundary_edge ? 1U : 2U))
    return false;
  if (onBoundary(kept) && !onBoundary(gone))
    for (const Index other : other_ring)
      if (other != kept && onBoundary(other) && !std::binary_search(ring.begin(), ring.end(), other))
        return false;
  return std::all_of(common.begin(), common.end(), [this](Index vertex) { return star(vertex).size() > 1; }) &&
         vertices_ > 4;
}

/** \brief Whether a triangle around \a moved, but for those that hold \a without, turns over when it moves. */
bool
EditableMesh::turnsOver(Index moved, Index without, const Eigen::Vector3d& position) const
{
  for (const Index face : star(moved)) {
    const Triangle& t = triangle(face);
    if (contains(t, without))
      continue;
    const auto where = [&](Index vertex) -> const Eigen::Vector3d& {
      return vertex == moved ? position : point(vertex);
    };
    if (!facesAlike(areaNormal(point(t[0]), point(t[1]), point(t[2])),
                    areaNormal(where(t[0]), where(t[1]), where(t[2]))))
      return true;
  }
  return false;
}

bool
EditableMesh::collapse(Index kept, Index gone, const Eigen::Vector3d& position)
{
  if (!mayCollapse(kept, gone) || turnsOver(kept, gone, position) || turnsOver(gone, kept, position))
    return false;
  for (const Index face : star(gone)) {
    Triangle& t = triangle(face);
    if (contains(t, kept)) {
      for (const Index vertex : t)
        if (vertex != gone)
          removeItem(star(vertex), face);
    }
    else {
      std::replace(t.begin(), t.end(), gone, kept);
      star(kept).push_back(face);
    }
  }
  star(gone).clear();
  point(kept) = position;
  --vertices_;
  boundary_vertices_ -= onBoundary(gone) ? 1 : 0;
  return true;
}

bool
EditableMesh::flip(Index a, Index b)
{
  const auto [c, d] = opposite(a, b);
  if (c == no_index || d == no_index || c == d || (onBoundary(c) && onBoundary(d)))
    return false;
  const std::pair<Index, Index> existing = opposite(c, d);
  if (existing.first != no_index || existing.second != no_index)
    return false;
  const Eigen::Vector3d before = areaNormal(point(a), point(b), point(c)) + areaNormal(point(b), point(a), point(d));
  if (!facesAlike(before, areaNormal(point(c), point(d), point(b))) ||
      !facesAlike(before, areaNormal(point(d), point(c), point(a))))
    return false;
  for (const Index face : std::vector<Index>(star(a))) {
    Triangle& t = triangle(face);
    if (!contains(t, b))
      continue;
    const bool left = contains(t, c);
    t = left ? Triangle{c, d, b} : Triangle{d, c, a};
    removeItem(star(left ? a : b), face);
    star(left ? d : c).push_back(face);
  }
  return true;
}

TriangleMesh
EditableMesh::compact() const
{
  TriangleMesh result;
  std::vector<Index> number(mesh_.points.size(), no_index);
  for (std::size_t v = 0; v < stars_.size(); ++v)
    if (!stars_[v].empty()) {
      number[v] = static_cast<Index>(result.points.size());
      result.points.push_back(mesh_.points[v]);
    }
  for (std::size_t face = 0; face < mesh_.triangles.size(); ++face) {
    const Triangle& t = mesh_.triangles[face];
    const std::vector<Index>& faces = star(t[0]);
    if (std::find(faces.begin(), faces.end(), static_cast<Index>(face)) != faces.end())
      result.triangles.push_back({number[static_cast<std::size_t>(t[0])], number[static_cast<std::size_t>(t[1])],
                                  number[static_cast<std::size_t>(t[2])]});
  }
  return result;
}

} // namespace symmetry
} // namespace pcl
