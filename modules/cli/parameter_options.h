/** \file
 * \brief The parameters of the estimation as options of a program.
 */
#pragma once

#include <pcl/symmetry/symmetry_parameters.h>

namespace pcl {
namespace symmetry {

/** \brief Most threads, and most estimations at a time, that a program can be asked for. */
constexpr unsigned thread_limit = 1024;

/** \brief Gives the method that is chosen this many samples: what --samples N means. 0: as many as it has. */
void
setSamples(SymmetryParameters& parameters, int samples);

/** \brief As checkParameters (), in terms of the command line.
 * \throws UsageError names the option of the parameter that is out of its range */
void
checkParameterOptions(const SymmetryParameters& parameters);

} // namespace symmetry
} // namespace pcl
