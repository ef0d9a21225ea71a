/** \file
 * \brief The first samples of a coarse surface with all their mutual distances: where hypotheses are made and judged.
 */
#pragma once

#include "symmetry/samples/coarse_surface.h"

#include <pcl/symmetry/symmetry_parameters.h>

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Landmarks are samples 0 .. size-1 of the coarse surface, evenly spaced as they come from farthest-point
 * sampling.
 */
struct LandmarkSurface {
  Eigen::MatrixXf distances;           ///< landmarks x landmarks, geodesic along the coarse graph, exactly symmetric
  Eigen::MatrixXf to_samples;          ///< samples x landmarks: distance from each landmark to every sample
  float diameter = 0.0F;               ///< largest distance
  std::vector<Triangle> triangles;     ///< dual of the landmarks' cells
  std::vector<Index> nearest_landmark; ///< of every sample
  std::vector<Vector3> points;
  std::vector<Vector3> normals;
  std::vector<char> at_hole;               ///< not 0: a hole reaches into the cell of the sample
  std::vector<float> average_distance;     ///< average geodesic distance (AGD) of each landmark
  std::vector<Index> extremities;          ///< local maxima of the AGD \cite kim2010moebius, the farthest out first
  std::vector<std::vector<Index>> nearest; ///< landmarks around each one: nearestLandmarks () of the distances

  std::size_t
  size() const
  {
    return points.size();
  }
};

/** \brief How many of the landmarks around each one are kept: the most that a step looks at. */
constexpr std::size_t kept_nearest_landmarks = 30;

/** \brief The landmarks nearest to each landmark, nearest first, without itself; ties go to the lower landmark.
 * \param[in] distances between all of them */
std::vector<std::vector<Index>>
nearestLandmarks(const Eigen::MatrixXf& distances, std::size_t count = kept_nearest_landmarks);

/** \brief Takes the first \a landmarks samples; cost: one shortest-path search on the coarse graph for each.
 * \param[in] metric Euclidean: the mutual distances are straight lines */
LandmarkSurface
makeLandmarkSurface(const CoarseSurface& surface, std::size_t landmarks, Metric metric);

/** \brief Marks what a map says something about: the landmarks that neither lie at a hole themselves nor are sent to
 * one, as what belongs into a hole is. All of them where that leaves hardly any. \param[in] map image of each landmark
 */
std::vector<char>
comparableLandmarks(const LandmarkSurface& landmarks, const std::vector<Index>& map);

/** \brief Least distance between the ends of limbs, as a share of the diameter: longer than a hand, shorter than the way from
 * one hand to the other; by hand. */
constexpr float limb_separation = 0.12F;

/** \brief Ends of limbs that are looked at: more than any body has. */
constexpr std::size_t most_limbs = 16;

/** \brief Landmarks whose AGD is largest within a distance of \a separation (share of the diameter), at most so many,
 * the farthest out first. */
std::vector<Index>
extremitiesOf(const LandmarkSurface& landmarks, float separation, std::size_t maximum_count);

} // namespace symmetry
} // namespace pcl
