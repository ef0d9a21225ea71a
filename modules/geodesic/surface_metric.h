/** \file
 * \brief Distances between vertices of a surface behind one interface: along the surface, or straight through space.
 */
#pragma once

#include "geodesic/shortest_paths.h"
#include "geodesic/surface_graph.h"

#include <mutex>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A way to measure distances between the vertices of one surface. Thread-safe. */
class SurfaceMetric { // NOLINT(cppcoreguidelines-special-member-functions): an interface
public:
  virtual ~SurfaceMetric() = default;

  /** \brief One field of distances to all vertices per source. */
  virtual DistanceFields
  fields(const std::vector<Index>& sources) const = 0;

  /** \brief Farthest-point sampling, see farthestPointSampling (); \a start is the first sample. */
  virtual std::vector<Index>
  farthestPoints(Index start, std::size_t count) const = 0;

  /** \brief The vertex half way between the source of each field and a target.
   * \param[in] fields as fields () returns them for \a sources
   * \param[in] targets one per source */
  virtual std::vector<Index>
  midpoints(const std::vector<Index>& sources,
            const DistanceFields& fields,
            const std::vector<Index>& targets) const = 0;
};

/** \brief Shortest paths along a connected graph; the midpoint is that of such a path. Fields come from one
 * DistanceFieldSolver: the more of them, the cheaper. */
class GeodesicMetric : public SurfaceMetric {
public:
  /** \param[in] graph connected; referred to, not copied */
  explicit GeodesicMetric(const SurfaceGraph& graph) : graph_(graph), solver_(graph)
  {
  }

  DistanceFields
  fields(const std::vector<Index>& sources) const override;

  std::vector<Index>
  farthestPoints(Index start, std::size_t count) const override;

  std::vector<Index>
  midpoints(const std::vector<Index>& sources,
            const DistanceFields& fields,
            const std::vector<Index>& targets) const override;

private:
  const SurfaceGraph& graph_;
  mutable DistanceFieldSolver solver_;
  mutable std::mutex solver_mutex_;
};

/** \brief Straight lines; the midpoint is the vertex nearest to the middle of the line. Every operation is O(n) per
 * source, sample or pair. */
class EuclideanMetric : public SurfaceMetric {
public:
  /** \param[in] points referred to, not copied */
  explicit EuclideanMetric(const std::vector<Vector3>& points) : points_(points)
  {
  }

  DistanceFields
  fields(const std::vector<Index>& sources) const override;

  std::vector<Index>
  farthestPoints(Index start, std::size_t count) const override;

  std::vector<Index>
  midpoints(const std::vector<Index>& sources,
            const DistanceFields& fields,
            const std::vector<Index>& targets) const override;

private:
  Index
  nearestVertex(const Vector3& position) const;

  const std::vector<Vector3>& points_;
};

} // namespace symmetry
} // namespace pcl
