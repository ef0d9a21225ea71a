/** \file
 * \brief The map of one interpretation of a model, delivered or not.
 */
#pragma once

#include "benchmark/model_input.h"
#include "symmetry/rival_interpretations.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The map in the numbers of the model's file; no_index where it has none. */
std::vector<Index>
mapOfModel(const Interpretation& interpretation, const ModelInput& model);

} // namespace symmetry
} // namespace pcl
