/** \file
 * \brief How far a confidence can be trusted: does it separate right from wrong?
 */
#pragma once

#include "benchmark/run.h"

#include <optional>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A confidence, and whether what it speaks of was right. */
struct Judgement {
  double confidence = 0.0;
  bool right = false;
};

/** \brief Area under the ROC curve: the chance that a right one has a higher confidence than a wrong one, ties counted
 * half. Cost O(n log n).
 * \return nothing where all are right or all are wrong
 */
std::optional<double>
areaUnderRoc(std::vector<Judgement> judgements);

/** \brief One point of an accuracy-against-coverage curve. */
struct CoveragePoint {
  double coverage = 0.0; ///< share that is kept, the most confident first
  double accuracy = 0.0; ///< share of the kept that is right
};

/** \brief Accuracy of the most confident share, for \a steps equal steps of coverage up to 1.
 *
 * Equal confidences are indistinguishable: where the cut falls among them, each counts with the same fraction.
 * \return empty without judgements
 */
std::vector<CoveragePoint>
coverageCurve(std::vector<Judgement> judgements, int steps = 20);

/** \brief Which runs a judgement of maps takes in. */
enum class JudgedRuns {
  All,      ///< every scored run; one that refused to deliver a map counts as wrong
  Delivered ///< those that delivered a map
};

/** \brief One judgement per scored run: the confidence of its map, and whether its Mesh Rate is 1. */
std::vector<Judgement>
judgeMaps(const std::vector<ModelRun>& runs, JudgedRuns which);

/** \brief Error of a partner below which it is what the confidence of a point speaks of, share of the diameter. */
constexpr double right_vertex_error = 0.05;

/** \brief One judgement per scored vertex with a partner: its confidence, and whether its error is below
 * right_vertex_error. */
std::vector<Judgement>
judgeVertices(const std::vector<ModelRun>& runs);

} // namespace symmetry
} // namespace pcl
