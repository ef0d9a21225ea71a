#include "model/polygonize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** \brief A lattice point in half cells: all even is a corner, all odd a centre; (0, odd, odd) lies half way between
 * the centres on both sides of the mirror plane. */
using LatticePoint = Eigen::Vector3i;
using Tetrahedron = std::array<LatticePoint, 4>;

constexpr int block_cells = 8;
constexpr int code_bits = 21;

std::uint64_t
encode(const LatticePoint& point)
{
  std::uint64_t code = 0;
  for (int k = 0; k < 3; ++k)
    code = (code << code_bits) | static_cast<std::uint64_t>(point[k]);
  return code;
}

LatticePoint
decode(std::uint64_t code)
{
  constexpr std::uint64_t mask = (std::uint64_t{1} << code_bits) - 1;
  return {static_cast<int>(code >> (2 * code_bits)), static_cast<int>((code >> code_bits) & mask),
          static_cast<int>(code & mask)};
}

/** \brief A lattice edge that the surface crosses, and the triangle corner that lies there. */
struct Crossing {
  std::uint64_t inside = 0;
  std::uint64_t outside = 0;
  std::size_t corner = 0;

  bool
  operator<(const Crossing& other) const
  {
    return std::tie(inside, outside, corner) < std::tie(other.inside, other.outside, other.corner);
  }
};

/** \brief Collects the crossings of one surface, block by block. */
class Marcher {
public:
  Marcher(const ImplicitSurface& surface, double cell, Extent extent);

  TriangleMesh
  run();

private:
  void
  visit(const LatticePoint& first_cell, int cells);
  void
  marchBlock(const LatticePoint& first_cell);
  void
  marchFace(const LatticePoint& cell, int axis);
  void
  marchTetrahedron(Tetrahedron tetrahedron);
  void
  addTriangle(const std::array<std::pair<LatticePoint, LatticePoint>, 3>& edges);
  TriangleMesh
  weld();
  Eigen::Vector3d
  locate(const Crossing& crossing) const;

  Eigen::Vector3d
  position(const LatticePoint& point) const
  {
    return origin_ + 0.5 * cell_ * point.cast<double>();
  }

  float&
  blockValue(const LatticePoint& point)
  {
    const LatticePoint local = point - block_origin_;
    return values_[static_cast<std::size_t>((local.x() * block_width + local.y()) * block_width + local.z())];
  }

  /// Half cells along a block with the centres of the next one, which its last faces need.
  static constexpr int block_width = 2 * block_cells + 2;

  const ImplicitSurface& surface_;
  double cell_;
  Extent extent_;
  Eigen::Vector3d origin_;
  LatticePoint block_origin_ = LatticePoint::Zero();
  std::vector<float> values_; ///< of the current block; only the sign of a value is ever used
  std::vector<Crossing> crossings_;
};

Marcher::Marcher(const ImplicitSurface& surface, double cell, Extent extent)
    : surface_(surface),
      cell_(cell),
      extent_(extent),
      origin_(surface.lowest().array() - 2.0 * cell),
      values_(static_cast<std::size_t>(block_width * block_width * block_width))
{
  if (extent_ == Extent::PositiveHalf)
    origin_.x() = 0.0;
}

TriangleMesh
Marcher::run()
{
  const double longest = (surface_.highest() - origin_).maxCoeff() + 2.0 * cell_;
  int cells = block_cells;
  while (cells * cell_ < longest)
    cells *= 2;
  visit(LatticePoint::Zero(), cells);
  return weld();
}

/** \brief Descends to the blocks near the surface: the slope of the field is at most one. */
void
Marcher::visit(const LatticePoint& first_cell, int cells)
{
  const Eigen::Vector3d middle = position(2 * first_cell) + Eigen::Vector3d::Constant(0.5 * cells * cell_);
  const double half_diagonal = std::sqrt(3.0) * (0.5 * cells + 1.0) * cell_;
  if (std::abs(surface_.value(middle)) > half_diagonal)
    return;
  if (cells == block_cells) {
    marchBlock(first_cell);
    return;
  }
  const int half = cells / 2;
  for (int octant = 0; octant < 8; ++octant)
    visit(first_cell + half * LatticePoint(octant & 1, (octant >> 1) & 1, (octant >> 2) & 1), half);
}

void
Marcher::marchBlock(const LatticePoint& first_cell)
{
  block_origin_ = 2 * first_cell;
  const bool at_plane = extent_ == Extent::PositiveHalf && first_cell.x() == 0;
  LatticePoint local;
  for (local.x() = 0; local.x() < block_width; ++local.x())
    for (local.y() = 0; local.y() < block_width; ++local.y())
      for (local.z() = 0; local.z() < block_width; ++local.z()) {
        const int odd = (local.x() & 1) + (local.y() & 1) + (local.z() & 1);
        const bool between = at_plane && local.x() == 0 && odd == 2;
        if (odd == 0 || odd == 3 || between) {
          const LatticePoint point = block_origin_ + local;
          blockValue(point) = surface_.value(position(point)) < 0.0 ? -1.0F : 1.0F;
        }
      }
  LatticePoint cell;
  for (cell.x() = 0; cell.x() < block_cells; ++cell.x())
    for (cell.y() = 0; cell.y() < block_cells; ++cell.y())
      for (cell.z() = 0; cell.z() < block_cells; ++cell.z())
        for (int axis = 0; axis < 3; ++axis) {
          marchFace(first_cell + cell, axis);
          if (at_plane && cell.x() == 0 && axis == 0)
            marchFace(first_cell + cell - LatticePoint::UnitX(), axis);
        }
}

/** \brief The four tetrahedra around the line from the centre of a cell to the centre of the next one along an axis. */
void
Marcher::marchFace(const LatticePoint& cell, int axis)
{
  const LatticePoint forward = LatticePoint::Unit(axis);
  const LatticePoint right = LatticePoint::Unit((axis + 1) % 3);
  const LatticePoint up = LatticePoint::Unit((axis + 2) % 3);
  LatticePoint from = 2 * cell + LatticePoint::Ones();
  const LatticePoint to = from + 2 * forward;
  const LatticePoint middle = from + forward;
  if (from.x() < 0)
    from = middle; // the half of the tetrahedra that lies on the positive side
  const std::array<LatticePoint, 4> ring = {middle - right - up, middle + right - up, middle + right + up,
                                            middle - right + up};
  for (std::size_t i = 0; i < 4; ++i)
    marchTetrahedron({from, ring[i], ring[(i + 1) % 4], to});
}

/** \brief Cuts a tetrahedron (a, b, c, d) with det (b - a, c - a, d - a) > 0. */
void
Marcher::marchTetrahedron(Tetrahedron tetrahedron)
{
  unsigned inside = 0;
  for (unsigned i = 0; i < 4; ++i)
    if (blockValue(tetrahedron[i]) < 0.0F)
      inside |= 1U << i;
  if (inside == 0U || inside == 15U)
    return;

  // Even permutations bring the corners that differ from the others to the front and keep the orientation.
  static constexpr std::array<std::array<unsigned, 4>, 4> lone_first = {
      {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}}};
  static constexpr std::array<std::array<unsigned, 4>, 6> pair_first = {
      {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};
  const auto corner = [&](unsigned i) {
    return tetrahedron[i];
  };
  for (const auto& [p, q, r, s] : lone_first) {
    if (inside == 1U << p)
      addTriangle({{{corner(p), corner(q)}, {corner(p), corner(r)}, {corner(p), corner(s)}}});
    if (inside == 15U - (1U << p))
      addTriangle({{{corner(q), corner(p)}, {corner(s), corner(p)}, {corner(r), corner(p)}}});
  }
  for (const auto& [p, q, r, s] : pair_first)
    if (inside == ((1U << p) | (1U << q))) {
      addTriangle({{{corner(p), corner(r)}, {corner(p), corner(s)}, {corner(q), corner(s)}}});
      addTriangle({{{corner(p), corner(r)}, {corner(q), corner(s)}, {corner(q), corner(r)}}});
    }
}

void
Marcher::addTriangle(const std::array<std::pair<LatticePoint, LatticePoint>, 3>& edges)
{
  for (const auto& [inside, outside] : edges)
    crossings_.push_back({encode(inside), encode(outside), crossings_.size()});
}

/** \brief Makes one vertex of all corners on the same lattice edge. */
TriangleMesh
Marcher::weld()
{
  std::sort(crossings_.begin(), crossings_.end());
  TriangleMesh mesh;
  mesh.triangles.resize(crossings_.size() / 3);
  const Crossing* previous = nullptr;
  for (const Crossing& crossing : crossings_) {
    if (previous == nullptr || previous->inside != crossing.inside || previous->outside != crossing.outside)
      mesh.points.push_back(locate(crossing));
    mesh.triangles[crossing.corner / 3][crossing.corner % 3] = static_cast<Index>(mesh.points.size() - 1);
    previous = &crossing;
  }
  return mesh;
}

/** \brief Where the surface crosses a lattice edge: one step of regula falsi, kept off the ends. */
Eigen::Vector3d
Marcher::locate(const Crossing& crossing) const
{
  const Eigen::Vector3d inside = position(decode(crossing.inside));
  const Eigen::Vector3d outside = position(decode(crossing.outside));
  const double below = surface_.value(inside);
  const double above = surface_.value(outside);
  const double t = std::clamp(below / std::min(below - above, -1e-300), 0.02, 0.98);
  return inside + t * (outside - inside);
}

} // namespace

TriangleMesh
polygonize(const ImplicitSurface& surface, double cell, Extent extent)
{
  return Marcher(surface, cell, extent).run();
}

} // namespace symmetry
} // namespace pcl
