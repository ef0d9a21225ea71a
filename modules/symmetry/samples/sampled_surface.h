/** \file
 * \brief A surface, its samples, and all that is known of them before there is a map.
 */
#pragma once

#include "symmetry/samples/cell_members.h"
#include "symmetry/samples/coarse_surface.h"
#include "symmetry/samples/landmark_surface.h"
#include "symmetry/samples/laplacian_basis.h"
#include "symmetry/samples/sample_interpolation.h"
#include "symmetry/samples/shape_descriptor.h"
#include "symmetry/step_timer.h"

#include <pcl/symmetry/symmetry_parameters.h>

namespace pcl {
namespace symmetry {

/** \brief How finely a surface is sampled. */
struct SamplingSettings {
  std::size_t samples = static_cast<std::size_t>(RobustParameters{}.samples);
  std::size_t landmarks =
      600; ///< of the samples: hypotheses are made and judged among them, all pairs of distances fit a cache
  int eigenfunctions = 60;   ///< wavelengths down to about four spacings of the samples, what they can represent
  std::uint32_t probes = 16; ///< points of a cell from which nearest ones are searched over the surface
  int dimensions = 8;        ///< spectral coordinates on which hypotheses act: 2^7 sign patterns can be tried
  DescriptorWeights descriptor;
};

/** \brief What the steps from the search to the dense map work on; made once per surface.
 *
 * Numbers of samples are used throughout; landmark i is sample i. */
struct SampledSurface {
  const PreparedSurface& surface; ///< referred to, not copied
  CoarseSurface coarse;
  LaplacianBasis basis;
  LandmarkSurface landmarks;
  SampleInterpolation interpolation; ///< from the samples to all points
  CellMembers members;               ///< points of each cell
  CellMembers probes;                ///< some of them
  ShapeDescriptor descriptor;        ///< of the samples

  /** \brief Whether there are enough eigenfunctions and any distances to search a symmetry by. */
  bool
  isSearchable() const
  {
    constexpr Eigen::Index minimum_functions = 4; // fewer leave no sign pattern that swaps more than two things
    return basis.functions.cols() >= minimum_functions && landmarks.diameter > 0.0F;
  }
};

/** \brief Fewer samples hold no patch whose reflection could be told. */
constexpr std::size_t minimum_samples = 30;

/** \brief Samples a surface; of one with fewer than minimum_samples distinct places only the coarse surface is made.
 * \param[in] surface referred to, not copied
 * \param[in] metric of the distances between landmarks
 * \param[in,out] timer told of the steps sampling, embedding, geodesics, features
 * \throws Cancelled by the timer */
SampledSurface
sampleSurface(const PreparedSurface& surface, const SamplingSettings& settings, Metric metric, StepTimer& timer);

} // namespace symmetry
} // namespace pcl
