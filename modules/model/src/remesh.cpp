#include "model/remesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {
namespace {

/** \brief An edge that waits for its collapse, as it was when its vertices had these versions. */
struct Candidate {
  double length = 0.0; ///< in units of the wanted length
  Index a = no_index;
  Index b = no_index;
  std::uint32_t version = 0; ///< sum of the versions of both ends: it grows with every change of either

  bool
  operator>(const Candidate& other) const
  {
    return std::tie(length, a, b, version) > std::tie(other.length, other.a, other.b, other.version);
  }
};

class Reducer {
public:
  Reducer(EditableMesh& mesh, const ImplicitSurface& surface, const SizeField& size)
      : mesh_(mesh), surface_(surface), size_(size), versions_(mesh.points().size(), 0)
  {
    std::vector<Candidate> all;
    for (const auto& [a, b] : mesh.edges())
      all.push_back(candidate(a, b));
    queue_ = Queue({}, std::move(all));
  }

  bool
  run(std::size_t vertices)
  {
    while (2 * mesh_.countVertices() - mesh_.countBoundaryVertices() > vertices) {
      if (queue_.empty())
        return false;
      const Candidate shortest = queue_.top();
      queue_.pop();
      if (mesh_.alive(shortest.a) && mesh_.alive(shortest.b) && version(shortest.a, shortest.b) == shortest.version)
        tryCollapse(shortest.a, shortest.b);
    }
    return true;
  }

private:
  using Queue = std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>>;

  std::uint32_t
  version(Index a, Index b) const
  {
    return versions_[static_cast<std::size_t>(a)] + versions_[static_cast<std::size_t>(b)];
  }

  Candidate
  candidate(Index a, Index b) const
  {
    const Eigen::Vector3d middle = 0.5 * (mesh_.point(a) + mesh_.point(b));
    return {(mesh_.point(a) - mesh_.point(b)).norm() / size_(middle), a, b, version(a, b)};
  }

  void
  tryCollapse(Index a, Index b)
  {
    if (mesh_.onBoundary(b) && !mesh_.onBoundary(a))
      std::swap(a, b);
    const bool pulled = mesh_.onBoundary(a) && !mesh_.onBoundary(b);
    const Eigen::Vector3d middle = 0.5 * (mesh_.point(a) + mesh_.point(b));
    const Eigen::Vector3d target = pulled ? mesh_.point(a) : projectVertex(surface_, middle, mesh_.onBoundary(a));
    if (!mesh_.collapse(a, b, target))
      return;
    ++versions_[static_cast<std::size_t>(a)];
    for (const Index other : mesh_.neighbours(a))
      queue_.push(candidate(std::min(a, other), std::max(a, other)));
  }

  EditableMesh& mesh_;
  const ImplicitSurface& surface_;
  const SizeField& size_;
  std::vector<std::uint32_t> versions_;
  Queue queue_;
};

/** \brief Neighbours a vertex should have: six, or four where the other half is missing. */
int
valenceExcess(const EditableMesh& mesh, Index vertex)
{
  return mesh.valence(vertex) - (mesh.onBoundary(vertex) ? 4 : 6);
}

void
evenOutValences(EditableMesh& mesh)
{
  for (const auto& [a, b] : mesh.edges()) {
    const auto [c, d] = mesh.opposite(a, b);
    if (c == no_index || d == no_index)
      continue;
    const int ea = valenceExcess(mesh, a);
    const int eb = valenceExcess(mesh, b);
    const int ec = valenceExcess(mesh, c);
    const int ed = valenceExcess(mesh, d);
    const auto cost = [](int p, int q, int r, int s) {
      return p * p + q * q + r * r + s * s;
    };
    if (cost(ea - 1, eb - 1, ec + 1, ed + 1) < cost(ea, eb, ec, ed))
      mesh.flip(a, b);
  }
}

/** \brief Where a vertex would be if it lay in the middle of its neighbours, but on the surface. */
Eigen::Vector3d
smoothed(const EditableMesh& mesh, const ImplicitSurface& surface, const SizeField& size, Index vertex)
{
  const bool in_plane = mesh.onBoundary(vertex);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weights = 0.0;
  for (const Index other : mesh.neighbours(vertex)) {
    if (in_plane && !mesh.onBoundary(other))
      continue;
    // A long edge pulls in proportion to its length, unless it is meant to be long.
    const double weight = 1.0 / size(mesh.point(other));
    sum += weight * mesh.point(other);
    weights += weight;
  }
  const Eigen::Vector3d& here = mesh.point(vertex);
  const Eigen::Vector3d normal = mesh.normal(vertex).normalized();
  const Eigen::Vector3d step = sum / weights - here;
  return projectVertex(surface, here + step - step.dot(normal) * normal, in_plane);
}

} // namespace

bool
reduce(EditableMesh& mesh, const ImplicitSurface& surface, const SizeField& size, std::size_t vertices)
{
  return Reducer(mesh, surface, size).run(vertices);
}

void
relax(EditableMesh& mesh, const ImplicitSurface& surface, const SizeField& size, int rounds)
{
  for (int round = 0; round < rounds; ++round) {
    evenOutValences(mesh);
    for (std::size_t v = 0; v < mesh.points().size(); ++v) {
      const auto vertex = static_cast<Index>(v);
      if (mesh.alive(vertex))
        mesh.point(vertex) = smoothed(mesh, surface, size, vertex);
    }
  }
}

Eigen::Vector3d
projectVertex(const ImplicitSurface& surface, const Eigen::Vector3d& point, bool in_plane)
{
  Eigen::Vector3d projected = surface.project(point);
  if (in_plane)
    projected.x() = 0.0;
  return projected;
}

} // namespace symmetry
} // namespace pcl
