/** \file
 * \brief The base vertices of the staged matching: partners found so far and their midpoints (paper, section 3.3).
 */
#pragma once

#include "geodesic/surface_metric.h"
#include "symmetry/staged/feature_vectors.h"

#include <pcl/symmetry/symmetry_result.h>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Which distances make up a feature vector. */
enum class FeatureSet {
  OwnEndpointsAndMidpoints, ///< to the base vertices of the vertex's own side and to all midpoints
  Midpoints                 ///< to the midpoints alone
};

/** \brief Matched pairs and midpoints with their distance fields, growing from stage to stage.
 *
 * The distances of a vertex to the source ends and those of its partner to the target ends are alike, and so are both
 * vertices' distances to a midpoint: these are the features.
 */
class BaseVertices {
public:
  /** \param[in] metric referred to, not copied */
  explicit BaseVertices(const SurfaceMetric& metric) : metric_(metric)
  {
  }

  /** \brief Adds both ends of each pair and its midpoint.
   * \param[in,out] pairs their midpoints are found and set */
  void
  addPairs(std::vector<SymmetricMatch>& pairs);

  /** \brief Adds a midpoint without a pair of its own. */
  void
  addMidpoint(Index midpoint);

  const DistanceFields&
  sourceFields() const
  {
    return source_fields_;
  }

  const DistanceFields&
  targetFields() const
  {
    return target_fields_;
  }

  const DistanceFields&
  midpointFields() const
  {
    return midpoint_fields_;
  }

  /** \brief Number of features of a vertex: own ends and midpoints. */
  std::size_t
  dimensions() const
  {
    return source_fields_.rows() + midpoint_fields_.rows();
  }

  /** \brief Feature vectors of some vertices, seen from one side.
   * \param[in] side Source or Target: whose ends count as the vertices' own */
  FeatureVectors
  features(const std::vector<Index>& vertices, Side side, FeatureSet set) const;

  /** \brief Floors that belong to these features, see featureFloors (): maxima are those over the whole surface. */
  std::vector<float>
  floors(Side side, FeatureSet set) const;

private:
  std::vector<const float*>
  rows(Side side, FeatureSet set) const;

  const SurfaceMetric& metric_;
  DistanceFields source_fields_;
  DistanceFields target_fields_;
  DistanceFields midpoint_fields_;
};

} // namespace symmetry
} // namespace pcl
