#include "benchmark/variants.h"

#include "base/vector_math.h"
#include "model/disturb.h"
#include "model/editable_mesh.h"
#include "model/random_numbers.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** The surface as it is. */
VariedSurface
unchanged(const Surface& mesh)
{
  VariedSurface varied{mesh, std::vector<Index>(mesh.size()), {}};
  std::iota(varied.origins.begin(), varied.origins.end(), Index{0});
  varied.stand_ins = varied.origins;
  varied.surface.normals.clear(); // they may hold no longer
  varied.surface.fields.reset();
  return varied;
}

void
shuffle(VariedSurface& varied, std::uint64_t seed)
{
  RandomNumbers random(seed);
  const std::size_t n = varied.surface.size();
  std::vector<Index> order(n); // new number -> old one
  std::iota(order.begin(), order.end(), Index{0});
  random.shuffle(order);
  const std::vector<Vector3> points = varied.surface.points;
  for (std::size_t v = 0; v < n; ++v) {
    varied.surface.points[v] = points[static_cast<std::size_t>(order[v])];
    varied.stand_ins[static_cast<std::size_t>(order[v])] = static_cast<Index>(v);
  }
  varied.origins = order;
  for (Triangle& t : varied.surface.triangles)
    for (Index& v : t)
      v = varied.stand_ins[static_cast<std::size_t>(v)];
  random.shuffle(varied.surface.triangles);
}

/** Collapses edges, the shortest first, until so many vertices are left or no edge can be. */
class Coarsening {
public:
  explicit Coarsening(const Surface& mesh) : mesh_(toTriangleMesh(mesh)), kept_(mesh.size())
  {
    std::iota(kept_.begin(), kept_.end(), Index{0});
    for (const auto& [a, b] : mesh_.edges())
      push(a, b);
  }

  void
  run(std::size_t vertices)
  {
    while (mesh_.countVertices() > vertices && !edges_.empty()) {
      const auto [length, a, b] = edges_.top();
      edges_.pop();
      if (mesh_.alive(a) && mesh_.alive(b) && length == lengthOf(a, b))
        collapse(a, b);
    }
  }

  VariedSurface
  result()
  {
    VariedSurface varied;
    std::vector<Index> numbers(kept_.size(), no_index);
    for (std::size_t v = 0; v < kept_.size(); ++v)
      if (mesh_.alive(static_cast<Index>(v))) {
        numbers[v] = static_cast<Index>(varied.origins.size());
        varied.origins.push_back(static_cast<Index>(v));
      }
    const TriangleMesh compact = mesh_.compact();
    for (const Eigen::Vector3d& p : compact.points)
      varied.surface.points.push_back(
          {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
    varied.surface.triangles = compact.triangles;
    for (std::size_t v = 0; v < kept_.size(); ++v)
      varied.stand_ins.push_back(numbers[static_cast<std::size_t>(keptFor(static_cast<Index>(v)))]);
    return varied;
  }

private:
  using Edge = std::tuple<double, Index, Index>;

  static TriangleMesh
  toTriangleMesh(const Surface& mesh)
  {
    TriangleMesh result;
    for (const Vector3& p : mesh.points)
      result.points.emplace_back(p[0], p[1], p[2]);
    result.triangles = mesh.triangles;
    return result;
  }

  double
  lengthOf(Index a, Index b) const
  {
    return (mesh_.point(a) - mesh_.point(b)).norm();
  }

  void
  push(Index a, Index b)
  {
    edges_.emplace(lengthOf(a, b), a, b);
  }

  void
  collapse(Index a, Index b)
  {
    if (mesh_.onBoundary(a) != mesh_.onBoundary(b) || !mesh_.collapse(a, b, 0.5 * (mesh_.point(a) + mesh_.point(b))))
      return;
    kept_[static_cast<std::size_t>(b)] = a;
    for (const Index other : mesh_.neighbours(a))
      push(a, other);
  }

  Index
  keptFor(Index v) const
  {
    while (kept_[static_cast<std::size_t>(v)] != v)
      v = kept_[static_cast<std::size_t>(v)];
    return v;
  }

  EditableMesh mesh_;
  std::vector<Index> kept_; ///< per vertex: the one that it was merged into, itself where it was not
  std::priority_queue<Edge, std::vector<Edge>, std::greater<>> edges_;
};

VariedSurface
coarsened(const Surface& mesh, std::size_t vertices)
{
  Coarsening coarsening(mesh);
  coarsening.run(vertices);
  return coarsening.result();
}

void
subdivide(VariedSurface& varied)
{
  Surface& surface = varied.surface;
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [place, is_new] =
        middles.emplace(std::pair(std::min(a, b), std::max(a, b)), static_cast<Index>(surface.size()));
    if (is_new) {
      const std::vector<Vector3>& p = surface.points;
      surface.points.push_back(0.5F * (p[static_cast<std::size_t>(a)] + p[static_cast<std::size_t>(b)]));
      varied.origins.push_back(std::min(a, b));
    }
    return place->second;
  };
  std::vector<Triangle> quarters;
  for (const Triangle& t : surface.triangles) {
    const Triangle m{middle(t[0], t[1]), middle(t[1], t[2]), middle(t[2], t[0])};
    quarters.insert(quarters.end(), {{t[0], m[0], m[2]}, {t[1], m[1], m[0]}, {t[2], m[2], m[1]}, m});
  }
  surface.triangles = std::move(quarters);
}

void
smooth(Surface& surface)
{
  std::vector<Vector3> sums(surface.size(), Vector3{});
  std::vector<float> counts(surface.size(), 0.0F);
  for (const Triangle& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) { // an inner edge is met from both of its sides
      Vector3& sum = sums[static_cast<std::size_t>(t[k])];
      sum = sum + surface.points[static_cast<std::size_t>(t[(k + 1) % 3])] +
            surface.points[static_cast<std::size_t>(t[(k + 2) % 3])];
      counts[static_cast<std::size_t>(t[k])] += 2.0F;
    }
  for (std::size_t v = 0; v < surface.size(); ++v)
    if (counts[v] > 0.0F)
      surface.points[v] = 0.5F * (surface.points[v] + (1.0F / counts[v]) * sums[v]);
}

void
stretch(Surface& surface, std::uint64_t seed)
{
  constexpr float longer = 0.03F;
  RandomNumbers random(seed);
  Vector3 direction{};
  for (float& coordinate : direction)
    coordinate = static_cast<float>(random.normal());
  direction = normalized(direction);
  for (Vector3& p : surface.points)
    p = p + longer * dot(p, direction) * direction;
}

void
mirror(Surface& surface)
{
  for (Vector3& p : surface.points)
    p[0] = -p[0];
  for (Triangle& t : surface.triangles)
    std::swap(t[1], t[2]);
}

} // namespace

const char*
toString(Variant variant)
{
  static constexpr std::array<const char*, variant_count + 1> names{
      "",      "shuffled",      "half",     "noisy",    "more-samples", "stretched",
      "third", "fewer-samples", "mirrored", "smoothed", "subdivided"};
  return names[static_cast<std::size_t>(variant)];
}

float
samplesOf(Variant variant)
{
  constexpr float more = 1.2F;
  return variant == Variant::MoreSamples ? more : variant == Variant::FewerSamples ? 1.0F / more : 1.0F;
}

VariedSurface
vary(const Surface& mesh, Variant variant, std::uint64_t seed)
{
  constexpr double little_noise = 1e-3;
  if (variant == Variant::Half || variant == Variant::Third)
    return coarsened(mesh, mesh.size() / (variant == Variant::Half ? 2 : 3));
  VariedSurface varied = unchanged(mesh);
  if (variant == Variant::Shuffled)
    shuffle(varied, seed);
  if (variant == Variant::Noisy) {
    Model model{std::move(varied.surface), std::vector<Index>(mesh.size(), no_index)};
    addNoise(model, little_noise, seed);
    varied.surface = std::move(model.surface);
  }
  if (variant == Variant::Stretched)
    stretch(varied.surface, seed);
  if (variant == Variant::Mirrored)
    mirror(varied.surface);
  if (variant == Variant::Smoothed)
    smooth(varied.surface);
  if (variant == Variant::Subdivided)
    subdivide(varied);
  return varied;
}

} // namespace symmetry
} // namespace pcl
