/** \file
 * \brief The Geodesic Error curve as a picture.
 */
#pragma once

#include "benchmark/summary.h"

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Draws the share of points against the error threshold, one labelled line per curve.
 * \param[in] curves at least two thresholds each; the widest one sets the horizontal axis
 * \return an SVG document
 */
std::string
drawErrorCurves(const std::vector<ErrorCurve>& curves);

/** \brief Writes what drawErrorCurves() draws; the file appears whole or not at all.
 * \throws pcl::IOException cannot be written */
void
writeErrorCurves(const std::string& path, const std::vector<ErrorCurve>& curves);

} // namespace symmetry
} // namespace pcl
