/** \file
 * \brief Shortest paths on the graph of a surface: one field, many fields in bulk, single paths.
 */
#pragma once

#include "geodesic/surface_graph.h"

#include <limits>
#include <memory>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Distance of a vertex that cannot be reached. */
constexpr float unreachable = std::numeric_limits<float>::infinity();

/** \brief Distances of all vertices from \a source. Cost about O(n) (bucket queue); exact as
 * Dijkstra's \cite dijkstra1959note. */
std::vector<float>
distanceField(const SurfaceGraph& graph, Index source);

/** \brief Distances of all vertices from the nearest of several sources. */
std::vector<float>
distanceField(const SurfaceGraph& graph, const std::vector<Index>& sources);

/** \brief Row-major matrix of distance fields: row i is the field of source i. */
struct DistanceFields {
  std::size_t columns = 0;
  std::vector<float> values;

  const float*
  row(std::size_t i) const
  {
    return values.data() + i * columns;
  }

  std::size_t
  rows() const
  {
    return columns == 0 ? 0 : values.size() / columns;
  }
};

class MinPlusFactor;

/** \brief Distance fields of one graph, asked for in one or several portions.
 *
 * Few fields are searched one by one as by distanceField (). Once so many have been asked for that elimination
 * (MinPlusFactor) is expected to be faster, the graph is factorized and the factor kept for the fields to come; these
 * agree with searched ones but for the rounding of sums, 1e-6 of the distance. Which way is taken depends on the graph
 * and the numbers of sources alone, so that the values are the same for any number of threads and any machine. Not to
 * be used from several threads at once.
 */
class DistanceFieldSolver {
public:
  /** \param[in] graph referred to, not copied */
  explicit DistanceFieldSolver(const SurfaceGraph& graph);
  ~DistanceFieldSolver();
  DistanceFieldSolver(const DistanceFieldSolver&) = delete;
  DistanceFieldSolver&
  operator=(const DistanceFieldSolver&) = delete;
  DistanceFieldSolver(DistanceFieldSolver&&) = delete;
  DistanceFieldSolver&
  operator=(DistanceFieldSolver&&) = delete;

  /** \brief One full field per source. */
  DistanceFields
  fields(const std::vector<Index>& sources);

private:
  bool
  isFactorized();

  const SurfaceGraph& graph_;
  std::size_t sources_ = 0; ///< asked for so far
  std::unique_ptr<MinPlusFactor> factor_;
  bool factorized_ = false;
};

/** \brief One full field per source; see DistanceFieldSolver. */
DistanceFields
distanceFields(const SurfaceGraph& graph, const std::vector<Index>& sources);

/** \brief Vertices of a shortest path from \a source to \a target, both included; empty where there is none. */
std::vector<Index>
shortestPath(const SurfaceGraph& graph, Index source, Index target);

/** \brief Vertices of a shortest path to \a target, from the source of a field that is already known.
 *
 * Where several paths are equally short that of the lowest vertices, seen from the target, is taken.
 * \param[in] field distances from the source, as distanceField () or distanceFields () returns them
 * \return first the source or a vertex at distance zero from it; empty where the target cannot be reached
 */
std::vector<Index>
shortestPath(const SurfaceGraph& graph, const float* field, Index target);

/** \brief The vertex of a path whose distance along it from the first vertex is closest to half of the whole. */
Index
pathMidpoint(const SurfaceGraph& graph, const std::vector<Index>& path);

} // namespace symmetry
} // namespace pcl
