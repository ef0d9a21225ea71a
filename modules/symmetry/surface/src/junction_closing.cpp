#include "symmetry/surface/junction_closing.h"

#include "base/bounding_box.h"
#include "base/heartbeat.h"
#include "base/vector_math.h"
#include "cloud/point_grid.h"
#include "symmetry/surface/open_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {
namespace {

/** A vertex on the side of a triangle, and how far along it. */
struct Junction {
  double along;
  Index vertex;
};

/** Vertices that lie on open sides, by the triangle and the number of its side. */
class JunctionSearch {
public:
  JunctionSearch(const PreparedSurface& surface, const std::vector<OpenSide>& sides)
      : surface_(surface), corners_(surface, sides), beside_(corners_.size())
  {
    std::vector<Index> number(surface.size(), no_index);
    BoundingBox box;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      number[corners_.point(i)] = static_cast<Index>(i);
      box.extend(corners_.place(i));
    }
    for (const OpenSide& side : sides) {
      beside_[number[side.a]].push_back(side.b);
      beside_[number[side.b]].push_back(side.a);
    }
    centre_ = box.low;
    extent_ = std::max(box.longestSide(), double{std::numeric_limits<float>::min()});
  }

  std::map<std::pair<Index, std::size_t>, std::vector<Junction>>
  find(const std::vector<OpenSide>& sides) const
  {
    std::vector<Vector3> places;
    std::vector<float> lengths;
    places.reserve(corners_.size());
    lengths.reserve(sides.size());
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      places.push_back(atUnitScale(corners_.place(i)));
    }
    for (const OpenSide& side : sides) {
      lengths.push_back(distance(atUnitScale(surface_.points[side.a]), atUnitScale(surface_.points[side.b])));
    }
    constexpr float finest = 1.0F / 128.0F; // a long side crosses no more cubes than that squared
    std::nth_element(lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2), lengths.end());
    const float cell = std::max(finest, lengths[lengths.size() / 2]);
    const PointGrid grid(places, cell);
    // Around a side of a mesh with seams there are few open corners. Where there are many around all of them the faces are a
    // tangle, in which ends touch sides by accident.
    constexpr std::size_t tangle = 256; // cubes and corners looked at, per side
    std::size_t effort = 0;
    std::map<std::pair<Index, std::size_t>, std::vector<Junction>> found;
    for (const OpenSide& side : sides) {
      heartbeat();
      std::vector<Junction> on_side;
      const Vector3 a = atUnitScale(surface_.points[side.a]);
      const Vector3 b = atUnitScale(surface_.points[side.b]);
      BoundingBox box;
      box.extend(a);
      box.extend(b);
      const auto rim = static_cast<float>(rounding_share) * distance(a, b);
      const Vector3 wider{rim, rim, rim};
      effort += cubesOf(box, cell);
      if (effort > tangle * sides.size() + corners_.size()) {
        return {};
      }
      grid.visitBox(box.low - wider, box.high + wider, [&](Index i) {
        ++effort;
        addIfOn(side, static_cast<std::size_t>(i), on_side);
      });
      if (!on_side.empty()) {
        const Triangle& t = surface_.triangles[side.triangle];
        const std::size_t k = t[0] == side.a ? 0 : t[1] == side.a ? 1 : 2;
        found[{side.triangle, k}] = inOrder(std::move(on_side));
      }
    }
    return found;
  }

private:
  /** How many cubes of a grid a box reaches into, about. */
  static std::size_t
  cubesOf(const BoundingBox& box, float cell)
  {
    std::size_t cubes = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      cubes *= static_cast<std::size_t>((box.high[k] - box.low[k]) / cell) + 1;
    }
    return cubes;
  }

  Vector3
  atUnitScale(const Vector3& p) const
  {
    Vector3 scaled{};
    for (std::size_t k = 0; k < 3; ++k) {
      scaled[k] = static_cast<float>((double{p[k]} - double{centre_[k]}) / extent_);
    }
    return scaled;
  }

  void
  addIfOn(const OpenSide& side, std::size_t i, std::vector<Junction>& on_side) const
  {
    const Index v = corners_.point(i);
    if (v == side.a || v == side.b || v == side.third) {
      return;
    }
    const Vector3& a = surface_.points[side.a];
    const Vector3& b = surface_.points[side.b];
    const double length = lengthBetween(a, b);
    const double tolerance = std::min(corners_.tolerance(i), rounding_share * length);
    const Vector3 way = unitOrZero(b - a);
    const Vector3 to_v = unitOrZero(corners_.place(i) - a);
    const double from_a = lengthBetween(a, corners_.place(i));
    const double along = from_a * double{dot(way, to_v)};
    const double off = from_a * double{norm(cross(way, to_v))};
    if (along <= tolerance || along >= length - tolerance || off > tolerance || !runsAlong(i, way) ||
        liesOver(side, i, way)) {
      return;
    }
    on_side.push_back({along / length, v});
  }

  /** Whether an open side of a point has the direction of another: seams run along sides, a tip only touches one. */
  bool
  runsAlong(std::size_t i, const Vector3& way) const
  {
    return std::any_of(beside_[i].begin(), beside_[i].end(), [&](Index w) {
      return norm(cross(way, unitOrZero(surface_.points[w] - corners_.place(i)))) < parallel_faces;
    });
  }

  /** Whether a face around a point lies over the face that the side is of. */
  bool
  liesOver(const OpenSide& side, std::size_t i, const Vector3& way) const
  {
    const Vector3 to_third = surface_.points[side.third] - surface_.points[side.a];
    const Vector3 normal = unitOrZero(cross(way, unitOrZero(to_third)));
    const Vector3 inward = cross(normal, way);
    const std::vector<FaceCorner> around = corners_.facesAround(i);
    return std::any_of(around.begin(), around.end(), [&](const FaceCorner& corner) {
      const Vector3 into = corner.bisector();
      return std::abs(dot(into, normal)) < parallel_faces && dot(into, inward) > parallel_faces;
    });
  }

  /** Along the side; of several at one place the first. */
  static std::vector<Junction>
  inOrder(std::vector<Junction> junctions)
  {
    std::sort(junctions.begin(), junctions.end(), [](const Junction& x, const Junction& y) {
      return std::tie(x.along, x.vertex) < std::tie(y.along, y.vertex);
    });
    const auto last = std::unique(junctions.begin(), junctions.end(), [](const Junction& x, const Junction& y) {
      return y.along - x.along < rounding_share * rounding_share;
    });
    junctions.erase(last, junctions.end());
    return junctions;
  }

  const PreparedSurface& surface_;
  OpenCorners corners_;
  std::vector<std::vector<Index>> beside_; ///< per open point: other ends of its open sides
  Vector3 centre_{};
  double extent_ = 1.0;
};

using JunctionsOfSides = std::array<std::vector<Junction>, 3>;

/** Cuts a triangle from the vertices on one of its sides to the corner opposite, then the first and the last piece at the
 * other sides. */
void
cutAtJunctions(const Triangle& t, const JunctionsOfSides& junctions, std::vector<Triangle>& to)
{
  std::size_t k = 0;
  while (k < 3 && junctions[k].empty()) {
    ++k;
  }
  if (k == 3) {
    to.push_back(t);
    return;
  }
  const Index b = t[(k + 1) % 3];
  const Index c = t[(k + 2) % 3];
  const std::vector<Junction>& on_side = junctions[k];
  cutAtJunctions({t[k], on_side.front().vertex, c}, {{{}, {}, junctions[(k + 2) % 3]}}, to);
  for (std::size_t i = 1; i < on_side.size(); ++i) {
    to.push_back({on_side[i - 1].vertex, on_side[i].vertex, c});
  }
  cutAtJunctions({on_side.back().vertex, b, c}, {{{}, junctions[(k + 1) % 3], {}}}, to);
}

} // namespace

std::size_t
closeJunctions(PreparedSurface& surface, const std::vector<OpenSide>& sides)
{
  if (sides.empty()) {
    return 0;
  }
  const auto found = JunctionSearch(surface, sides).find(sides);
  heartbeat();
  if (found.empty()) {
    return 0;
  }
  std::vector<Triangle> cut;
  std::size_t count = 0;
  auto next = found.begin();
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    JunctionsOfSides junctions;
    for (; next != found.end() && next->first.first == static_cast<Index>(i); ++next) {
      junctions[next->first.second] = next->second;
      count += next->second.size();
    }
    cutAtJunctions(surface.triangles[i], junctions, cut);
  }
  surface.triangles = std::move(cut);
  return count;
}

} // namespace symmetry
} // namespace pcl
