/** \file
 * \brief Readers of the ground truth of published data sets.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The true partner of one vertex; the vertex itself where it lies on the axis. */
struct TruePartner {
  Index vertex = no_index;
  Index partner = no_index;
};

/** \brief Both directions of every known pair, and the vertices known to lie on the axis. */
using GroundTruth = std::vector<TruePartner>;

/** \brief Reads landmarks: which vertices they are, and which of them are partners.
 *
 * \param[in] landmark_file .pid or .vts: line L begins with the 0-based vertex of landmark L, what follows is ignored
 * \param[in] symmetry_file .sym.info: numbers of landmarks, two in a line are partners, one alone is on the axis; more
 * than two are an orbit of several symmetries and say nothing about a single one: such lines are ignored
 * \throws pcl::IOException cannot be read, holds something else than whole numbers, names a landmark that is not
 * there, or no pair at all
 */
GroundTruth
readLandmarkTruth(const std::string& landmark_file, const std::string& symmetry_file);

/** \brief Reads a dense map with 1-based numbers, whole but possibly written as floats.
 *
 * Where the first of several lines holds two numbers, every line is a vertex and its partner; otherwise number i of the
 * file is the partner of vertex i, however the list is broken into lines. A number below 1, or NaN, stands for
 * "none", and the vertex is left out.
 * \throws pcl::IOException cannot be read, holds something else, or no pair at all
 */
GroundTruth
readDenseTruth(const std::string& file);

/** \brief Reads the ground truth that a specification names.
 *
 * \param[in] specification `CLASS.pid` (with CLASS.sym.info beside it), `MODEL.vts:N.sym.info`, or a dense map
 * \throws pcl::IOException as the readers above
 */
GroundTruth
readGroundTruth(const std::string& specification);

/** \brief Throws unless all vertices of \a truth are vertices of a surface of \a vertices points.
 * \throws pcl::IOException names \a specification, the vertex and the allowed range */
void
checkGroundTruth(const GroundTruth& truth, std::size_t vertices, const std::string& specification);

} // namespace symmetry
} // namespace pcl
