/** \file
 * \brief The first samples of a coarse surface with all their mutual distances: where hypotheses are made and judged.
 */
#pragma once

#include "symmetry/coarse_surface.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Hubs are samples 0 .. size-1 of the coarse surface, evenly spaced as they come from farthest-point sampling.
 */
struct HubSurface {
  Eigen::MatrixXf distances;       ///< hubs x hubs, geodesic along the coarse graph, exactly symmetric
  float diameter = 0.0F;           ///< largest distance
  std::vector<Triangle> triangles; ///< dual of the hubs' cells
  std::vector<Index> nearest_hub;  ///< of every sample
  std::vector<Vector3> points;
  std::vector<Vector3> normals;
  std::vector<char> at_hole;      ///< not 0: a hole reaches into the cell of the sample
  std::vector<float> centrality;  ///< average geodesic distance (AGD) of each hub
  std::vector<Index> extremities; ///< local maxima of the AGD, the farthest out first

  std::size_t
  size() const
  {
    return points.size();
  }
};

/** \brief Takes the first \a hubs samples; cost: one shortest-path search on the coarse graph for each.
 * \param[in] metric Euclidean: the mutual distances are straight lines */
HubSurface
makeHubSurface(const CoarseSurface& surface, std::size_t hubs, Metric metric, unsigned threads);

/** \brief Marks what a map says something about: the hubs that neither lie at a hole themselves nor are sent to one, as
 * what belongs into a hole is. All of them where that leaves hardly any.
 * \param[in] map image of each hub */
std::vector<char>
comparableHubs(const HubSurface& hubs, const std::vector<Index>& map);

/** \brief Hubs whose AGD is largest within a distance of \a separation (share of the diameter), at most so many, the
 * farthest out first. */
std::vector<Index>
extremitiesOf(const HubSurface& hubs, float separation, std::size_t most);

} // namespace symmetry
} // namespace pcl
