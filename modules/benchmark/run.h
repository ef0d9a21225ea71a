/** \file
 * \brief Runs the estimation on models of a data set and scores the maps.
 */
#pragma once

#include "benchmark/data_set.h"
#include "benchmark/disturbance.h"
#include "benchmark/limb_cut.h"
#include "benchmark/metrics.h"

#include <pcl/symmetry/symmetry_parameters.h>
#include <pcl/symmetry/symmetry_result.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief How the models are run. */
struct RunOptions {
  SymmetryParameters parameters;
  bool as_cloud = false; ///< without the faces; the map is scored on the mesh all the same
  /** The map is scored on the undisturbed mesh, at the points that were not dropped; where holes were cut, at those
   * whose true partner is left as well. */
  Disturbance disturbance;
  /** Is cut off first, and the stump closed but for a cloud. What is left has no symmetry that could be scored. */
  std::optional<Limb> cut_limb;
};

/** \brief How well the part without a counterpart was told, after a limb was cut off. */
struct OddPartAccuracy {
  double true_share = 0.0;  ///< of the area that is left: what has its true partner cut off
  double found_share = 0.0; ///< of the reported parts without a counterpart whose extreme point is among that
  double rest_rate = 0.0;   ///< Correspondence Rate of the pairs that are left
};

/** \brief What came out for one model. Points are those of the model's file. */
struct ModelRun {
  BenchmarkModel model;
  std::string failure; ///< why there is no result; empty where there is one
  std::size_t points = 0;
  std::size_t faces = 0; ///< of the file, also where they were not used

  SymmetryStatus status = SymmetryStatus::TooFewPoints;
  std::string message;     ///< SymmetryResult::message
  float confidence = 0.0F; ///< of the whole map
  std::vector<Index> partners;
  std::vector<float> confidences;
  MapSummary map;
  std::vector<std::pair<std::string, double>> seconds; ///< per step of the estimation

  std::optional<MapAccuracy> score; ///< of the map as delivered, whatever the status; nothing without ground
                                    ///< truth or after a limb was cut off

  std::vector<UnsupportedPart> unsupported; ///< as in the result: extreme points are those of the input
  std::optional<OddPartAccuracy> odd_part;  ///< of a map, after a limb was cut off

  /** \brief Correspondence Rate; 0 after a failure or without ground truth. */
  double
  correspondenceRate() const
  {
    return score ? score->correspondenceRate() : 0.0;
  }

  /** \brief Time of the estimation: the sum of its steps. */
  double
  totalSeconds() const;
};

/** \brief Runs and scores one model; a failure of any kind is part of the result. */
ModelRun
runModel(const BenchmarkModel& model, const RunOptions& options);

/** \brief Runs several models, \a jobs at a time.
 *
 * \param[in] models
 * \param[in] options for all of them
 * \param[in] jobs models at a time, 0: as many as there are cores
 * \param[in] finished called once per model, in the order of \a models and from one thread at a time
 * \return one run per model, in the order of \a models
 */
std::vector<ModelRun>
runModels(const std::vector<BenchmarkModel>& models,
          const RunOptions& options,
          unsigned jobs,
          const std::function<void(const ModelRun&)>& finished = {});

} // namespace symmetry
} // namespace pcl
