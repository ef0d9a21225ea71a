/** \file
 * \brief How likely the partner of each point is right.
 */
#pragma once

#include "symmetry/confidence/map_evidence.h"
#include "symmetry/refine/sample_refinement.h"
#include "symmetry/samples/sampled_surface.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What speaks for and against the partners around a landmark. */
struct PointEvidence {
  float local_change = 0.0F; ///< LocalDistanceChange
  float fit_distance = 0.0F; ///< PatchFit::distance of the smallest patch there
  float reversal = 1.0F;     ///< reversalAtLandmarks ()
};

/** \brief Evidence at every landmark.
 * \param[in] local_changes see MapEvidence */
std::vector<PointEvidence>
pointEvidence(const SampledSurface& sampled, const SampleEstimate& samples, const std::vector<float>& local_changes);

/** \brief Probability that the partner of each point is within 5 % of the diameter of the true one.
 *
 * A logistic function of the evidence at the landmark around and of the confidence of the map, interpolated; see
 * PointCalibration. */
std::vector<float>
pointConfidences(const SampledSurface& sampled, const std::vector<PointEvidence>& evidence, float map_confidence);

/** \brief The confidence of a point when that of the map turns out to be another. */
float
withMapConfidence(float point_confidence, float before, float after);

} // namespace symmetry
} // namespace pcl
