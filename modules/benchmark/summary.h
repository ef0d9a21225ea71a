/** \file
 * \brief Figures of groups of runs: classes, data sets, error curves.
 */
#pragma once

#include "benchmark/run.h"

#include <array>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Thresholds of the Geodesic Error at which published tables give the share of points below. */
constexpr std::array<double, 5> error_thresholds{0.05, 0.10, 0.15, 0.20, 0.25};

/** \brief Means over the scored runs of a group; a failed run counts with rate 0 and error 1. */
struct GroupSummary {
  std::string set;
  std::string class_name; ///< empty for a whole set
  std::size_t models = 0;
  std::size_t failed = 0;
  std::size_t symmetric = 0;                           ///< models with SymmetryStatus::Symmetric
  double correspondence_rate = 0.0;                    ///< in [0, 1]
  double mesh_rate = 0.0;                              ///< share of models whose map is right
  double mean_geodesic_error = 0.0;                    ///< share of the diameter
  std::array<double, error_thresholds.size()> below{}; ///< share of points with an error below each threshold
  double mean_confidence = 0.0;
  double mean_seconds = 0.0; ///< of a model's estimation
};

/** \brief One summary per class, in the order in which the classes first occur; runs without ground truth are left out.
 */
std::vector<GroupSummary>
summariseClasses(const std::vector<ModelRun>& runs);

/** \brief One summary per set: the mean of its classes' figures, as published tables have it, however many models a
 * class has; counts are sums. */
std::vector<GroupSummary>
summariseSets(const std::vector<GroupSummary>& classes);

/** \brief What came of one kind of change of all models of a set. */
struct VariantSummary {
  std::string set;
  Variant variant = Variant::AsItIs;
  std::size_t models = 0;         ///< that ran and were scored
  std::size_t refused = 0;        ///< no map
  std::size_t right = 0;          ///< maps with a Correspondence Rate that counts as right
  std::size_t sure_but_wrong = 0; ///< wrong maps with a confidence above one half
  std::size_t alike = 0;          ///< refused, right or wrong as the model itself
  double correspondence_rate = 0.0;
};

/** \brief One summary per set and variant, in the order of the runs. */
std::vector<VariantSummary>
summariseVariants(const std::vector<ModelRun>& runs);

/** \brief Share of points with a Geodesic Error below a threshold, as a function of the threshold. */
struct ErrorCurve {
  std::string name;
  std::vector<double> thresholds; ///< ascending, share of the diameter
  std::vector<double> shares;     ///< in [0, 1], one per threshold
};

/** \brief One curve per set, from 0 to \a largest in \a steps equal steps: the mean of its classes' curves, so that it
 * agrees with the set's summary. */
std::vector<ErrorCurve>
errorCurves(const std::vector<ModelRun>& runs, double largest = 0.25, int steps = 50);

} // namespace symmetry
} // namespace pcl
