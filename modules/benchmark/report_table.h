/** \file
 * \brief The figures of a benchmark as tables for a person.
 */
#pragma once

#include "benchmark/confidence_metrics.h"
#include "benchmark/summary.h"

#include <iosfwd>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Writes the head of the table of models. */
void
printModelHeader(std::ostream& out);

/** \brief Writes one line: status, confidence, rate, error, seconds; with \a verbose a second one with the seconds of
 * each step, the properties of the map and the message of the estimation. */
void
printModel(std::ostream& out, const ModelRun& run, bool verbose);

/** \brief Writes one line per class and one per set (mean of its classes): Correspondence Rate and Mesh Rate in
 * percent, mean Geodesic Error, shares of points below each error threshold in percent, confidence, seconds. */
void
printSummaries(std::ostream& out, const std::vector<GroupSummary>& classes, const std::vector<GroupSummary>& sets);

/** \brief Writes what the confidences are worth: area under the ROC curve of the maps, accuracy of the vertices at some
 * coverages. */
void
printConfidence(std::ostream& out, const std::vector<ModelRun>& runs);

/** \brief Writes one line per set: how many of its models ended as no symmetry, and the confidence of the rest. */
void
printRefusals(std::ostream& out, const std::vector<ModelRun>& runs);

/** \brief Writes the score of one map. */
void
printScore(std::ostream& out, const MapAccuracy& score);

/** \brief Writes what came of each kind of change, a line per set and kind. */
void
printVariants(std::ostream& out, const std::vector<VariantSummary>& summaries);

} // namespace symmetry
} // namespace pcl
