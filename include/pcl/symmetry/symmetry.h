/** \file
 * \brief One-off function without PCL types in its signature; see intrinsic_symmetry.h for the PCL class.
 */
#pragma once

#include <pcl/symmetry/export.h>
#include <pcl/symmetry/surface.h>
#include <pcl/symmetry/symmetry_parameters.h>
#include <pcl/symmetry/symmetry_result.h>

#include <functional>

namespace pcl {
namespace symmetry {

/** \brief Called with the name of the running step and the share of the whole work that is done, in [0, 1], always from
 * the thread that called: as each step starts, and several times a second while it runs. Return false to cancel. What
 * it throws ends the estimation and reaches the caller. */
using ProgressCallback = std::function<bool(const char* step, double fraction)>;

/** \brief Throws unless every parameter is within its documented range.
 * \throws pcl::BadArgumentException names the parameter, its value and the allowed range
 */
PCL_SYMMETRY_EXPORTS void
checkParameters(const SymmetryParameters& parameters);

/** \brief Finds the global intrinsic reflective symmetry of a surface.
 *
 * Memory and time grow about linearly with the number of points; a cloud in doubt takes up to fifteen times as long.
 * May be called from several threads at once.
 *
 * \param[in] surface mesh, or cloud without triangles; non-finite points are left out, of points at one place the first
 * stands for all
 * \param[in] parameters see SymmetryParameters
 * \param[in] progress may be empty
 * \return see SymmetryResult; the same input and parameters give the same bytes for any number of threads
 * \throws pcl::BadArgumentException a parameter is out of range, or a triangle refers to a point that is not there
 * \ingroup symmetry
 */
PCL_SYMMETRY_EXPORTS SymmetryResult
estimateIntrinsicSymmetry(const Surface& surface,
                          const SymmetryParameters& parameters = {},
                          const ProgressCallback& progress = {});

} // namespace symmetry
} // namespace pcl
