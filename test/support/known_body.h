/** \file
 * \brief Bodies with known partners, and how far a map is from them.
 */
#pragma once

#include "base/vector_math.h"
#include "geodesic/shortest_paths.h"
#include "model/articulated_body.h"
#include "support/graphs.h"

#include <pcl/symmetry/symmetry_result.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

inline Model
body(Body kind, double bend, std::uint64_t seed = 1, std::size_t vertices = 3000)
{
  ModelParameters parameters;
  parameters.body = kind;
  parameters.vertices = vertices;
  parameters.bend = bend;
  parameters.seed = seed;
  return makeModel(parameters);
}

/** \brief Distance of the mirror image of a vertex in the rest pose from the nearest vertex. */
inline float
distanceFromMirrorImage(const Surface& rest, Index vertex)
{
  const Vector3& p = rest.points[vertex];
  float nearest = std::numeric_limits<float>::max();
  for (const Vector3& q : rest.points) {
    nearest = std::min(nearest, distance(q, {-p[0], p[1], p[2]}));
  }
  return nearest;
}

/** \brief A human whose pose is slightly bent, made once. */
inline const Model&
bentHuman()
{
  static const Model model = body(Body::Human, 0.3);
  return model;
}

inline double
surfaceArea(const Surface& mesh)
{
  double doubled = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vector3& p = mesh.points[t[0]];
    doubled += norm(cross(mesh.points[t[1]] - p, mesh.points[t[2]] - p));
  }
  return 0.5 * doubled;
}

/** \brief Geodesic distances between found and true partner over sqrt (area), at every third vertex with a partner.
 * A vertex without a found partner counts as infinitely far off. */
inline std::vector<double>
mapErrors(const Model& model, const std::vector<Index>& found)
{
  const SurfaceGraph graph = meshGraph(model.surface);
  const double unit = std::sqrt(surfaceArea(model.surface));
  std::vector<double> errors;
  for (std::size_t v = 0; v < model.partners.size(); v += 3) {
    if (model.partners[v] == no_index) {
      continue;
    }
    errors.push_back(found[v] == no_index ? unreachable : distanceField(graph, model.partners[v])[found[v]] / unit);
  }
  return errors;
}

inline double
mean(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/** \brief Share of the errors within the radius at which a correspondence counts as right: a disc of a twentieth of the
 * area (V. G. Kim et al.: Moebius transformations for global intrinsic symmetry analysis, 2010). */
inline double
correspondenceRate(const std::vector<double>& errors)
{
  const double radius = 1.0 / std::sqrt(20.0 * std::acos(-1.0));
  const auto right = std::count_if(errors.begin(), errors.end(), [&](double error) { return error <= radius; });
  return static_cast<double>(right) / static_cast<double>(errors.size());
}

/** \brief Share of the vertices whose true partner is on the other side, of those that are off the true axis and not
 * labelled as the axis, nor their partners. */
inline double
shareOnOppositeSides(const Model& model, const std::vector<Side>& sides)
{
  const auto is_sided = [&](Index v) {
    return sides[v] == Side::Source || sides[v] == Side::Target;
  };
  std::size_t opposite = 0;
  std::size_t all = 0;
  for (std::size_t v = 0; v < model.partners.size(); ++v) {
    const Index partner = model.partners[v];
    if (partner != no_index && partner != static_cast<Index>(v) && is_sided(static_cast<Index>(v)) &&
        is_sided(partner)) {
      ++all;
      opposite += sides[v] != sides[partner] ? 1U : 0U;
    }
  }
  return all == 0 ? 0.0 : static_cast<double>(opposite) / static_cast<double>(all);
}

/** \brief The vertices that are their own partners. */
inline std::vector<Index>
trueAxis(const Model& model)
{
  std::vector<Index> axis;
  for (std::size_t v = 0; v < model.partners.size(); ++v) {
    if (model.partners[v] == static_cast<Index>(v)) {
      axis.push_back(static_cast<Index>(v));
    }
  }
  return axis;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
