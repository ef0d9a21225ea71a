#include "symmetry/mirror/rooted_pieces.h"

#include "base/centroid.h"
#include "base/statistics.h"
#include "geodesic/marked_groups.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** A connected piece of what is off, and where it meets the rest. */
struct Piece {
  float area = 0.0F;
  std::vector<Vector3> root;
};

/** The piece of every sample that stands for one, see UnionFind; the others are empty. */
std::vector<Piece>
piecesOf(const CoarseSurface& coarse, const std::vector<char>& is_off)
{
  UnionFind groups = markedGroups(coarse.graph, is_off);
  std::vector<Piece> pieces(coarse.size());
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    if (is_off[i] != 0) {
      pieces[groups.find(static_cast<Index>(i))].area += coarse.areas[i];
      continue;
    }
    std::vector<Index> beside;
    for (const Index j : coarse.graph.neighboursOf(i)) {
      const Index piece = groups.find(j);
      if (is_off[j] != 0 && std::find(beside.begin(), beside.end(), piece) == beside.end()) {
        beside.push_back(piece);
        pieces[piece].root.push_back(coarse.points[i]);
      }
    }
  }
  return pieces;
}

/** Mean distance from the centroid; between samples nothing is known, so half of their spacing more. */
float
radiusOf(const std::vector<Vector3>& root, float spacing)
{
  const Vector3 centre = centroid(root);
  float sum = 0.0F;
  for (const Vector3& p : root) {
    sum += distance(p, centre);
  }
  return sum / static_cast<float>(root.size()) + 0.5F * spacing;
}

float
distanceToNearest(const Vector3& place, const std::vector<Vector3>& points)
{
  float nearest = std::numeric_limits<float>::infinity();
  for (const Vector3& p : points) {
    nearest = std::min(nearest, distance(p, place));
  }
  return nearest;
}

} // namespace

bool
areRootedAlike(const CoarseSurface& coarse,
               const std::vector<char>& is_off,
               const PlaneReflection& plane,
               float least_share)
{
  std::vector<Piece> pieces = piecesOf(coarse, is_off);
  std::vector<Vector3> roots;
  for (const Piece& piece : pieces) {
    roots.insert(roots.end(), piece.root.begin(), piece.root.end());
  }
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(),
                              [least_share](const Piece& piece) { return piece.area < least_share; }),
               pieces.end());
  const float spacing = sampleSpacing(coarse);
  const auto is_rooted_alike = [&](const Piece& piece) {
    if (piece.root.empty()) { // it floats
      return false;
    }
    std::vector<float> ways;
    std::transform(piece.root.begin(), piece.root.end(), std::back_inserter(ways),
                   [&](const Vector3& p) { return distanceToNearest(plane.image(p), roots); });
    return median(std::move(ways)) <= radiusOf(piece.root, spacing);
  };
  return !pieces.empty() && std::all_of(pieces.begin(), pieces.end(), is_rooted_alike);
}

} // namespace symmetry
} // namespace pcl
