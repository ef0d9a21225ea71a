/** \file
 * \brief A surface with a map, described so that it can be compared with another one of its kind.
 */
#pragma once

#include "symmetry/names/even_functions.h"
#include "symmetry/samples/sampled_surface.h"

#include <Eigen/Core>

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What of a surface does not depend on which side is called what, and what does: \a turns.
 *
 * All but the areas depend neither on pose, scale, place nor triangles, as far as distances along the surface do not. */
struct ComparableSurface {
  EvenFunctions even;
  Eigen::MatrixXd features;  ///< samples x features: mean square 1 each, kept by the map
  Eigen::MatrixXf distances; ///< samples x landmarks: to the landmark or its partner, whichever is nearer; mean 1
  std::vector<Index> nearest_landmark; ///< of every sample
  Eigen::VectorXd areas;               ///< of the samples
  std::vector<Triangle> triangles;     ///< of the samples, counter-clockwise as seen from outside
  Eigen::VectorXd sides;               ///< of the samples, in [-1, 1]: positive on the source side
  double chirality = 0.0;              ///< of these sides, see side_names.h

  Eigen::Index
  samples() const
  {
    return features.rows();
  }

  /** \brief The first samples, among which maps are made. */
  Eigen::Index
  landmarks() const
  {
    return distances.cols();
  }

  /** \brief Whether there is anything to compare: two even functions at least, whose gradients span the surface. */
  bool
  isComparable() const
  {
    return even.functions.cols() >= 2 && landmarks() > 0;
  }
};

/** \brief Describes a surface.
 * \param[in] map partner of each sample; a sample without one is its own
 * \param[in] sides of the samples, in [-1, 1] */
ComparableSurface
comparableSurface(const SampledSurface& sampled, const SampleMap& map, const std::vector<float>& sides);

/** \brief Which way functions turn: for every two of them the side, times the component along the outward normal of the
 * cross product of their gradients.
 *
 * A reflection turns that component over, and the side as well: for even functions the product is even, and changes its
 * sign as a whole when the sides change their names.
 * \param[in] functions samples x count
 * \return samples x count (count - 1) / 2, rows of similar length */
Eigen::MatrixXd
turnsOf(const ComparableSurface& surface, const Eigen::MatrixXd& functions);

} // namespace symmetry
} // namespace pcl
