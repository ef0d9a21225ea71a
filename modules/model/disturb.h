/** \file
 * \brief What scanners do to a surface, done to a model: each function changes one thing and keeps the truth in step.
 *
 * A vertex that is dropped takes its partner's truth along: the partner gets -1. Lengths are relative to the diagonal
 * of the bounding box. The same seed gives the same bytes. Cost: linear but for cutHoles without faces (holes times
 * points).
 */
#pragma once

#include "model/articulated_body.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Moves every point in a random direction by a normally distributed length.
 *  \param[in,out] model changed in place
 *  \param[in] fraction standard deviation of the length over the diagonal, [0, 1]
 *  \param[in] seed of the random numbers
 *  \throws std::invalid_argument the fraction is out of range */
void
addNoise(Model& model, double fraction, std::uint64_t seed);

/** \brief Gives a surface another pose: bends space twice and twists it once, about random axes through the centre of
 * the bounding box. Lengths change by the share of the angle that their distance from the axis is of the diagonal.
 * Normals that came with the surface hold no longer and are left out.
 *  \param[in,out] model changed in place
 *  \param[in] angle of each, in radians over the length of the diagonal, of which 0.6 to 1 at random, [0, 3]
 *  \param[in] seed of the random numbers
 *  \throws std::invalid_argument the angle is out of range */
void
bend(Model& model, double angle, std::uint64_t seed);

/** \brief Rounds every coordinate to a multiple of a step, as files of few digits and depth sensors do; points may
 * coincide then.
 *  \param[in,out] model changed in place
 *  \param[in] fraction the step over the diagonal, [0, 1]; 0: nothing is rounded
 *  \throws std::invalid_argument the fraction is out of range */
void
quantise(Model& model, double fraction);

/** \brief Marks the vertices that round holes leave: of equal numbers of vertices, around random vertices; what is no
 * longer in a triangle goes too.
 *
 * Holes may overlap, so that less than the share may be missing. A large hole may cut a limb off.
 *  \param[in] surface mesh or cloud
 *  \param[in] holes how many, at least 0
 *  \param[in] share of the vertices that the holes take together, [0, 0.9]
 *  \param[in] seed of the random numbers
 *  \throws std::invalid_argument the share is out of range */
std::vector<char>
markOutsideHoles(const Surface& surface, std::size_t holes, double share, std::uint64_t seed);

/** \brief Cuts holes, see markOutsideHoles (). */
void
cutHoles(Model& model, std::size_t holes, double share, std::uint64_t seed);

/** \brief Marks the points that stay when more and more of them go in a random direction.
 *  \param[in] ratio of the density where all points are kept to that at the far end, [1, 1000]
 *  \param[in] seed of the random numbers
 *  \throws std::invalid_argument the ratio is out of range */
std::vector<char>
markThinnedOut(const std::vector<Vector3>& points, double ratio, std::uint64_t seed);

/** \brief Drops points, more and more in a random direction, see markThinnedOut (); drops all faces. */
void
thinOut(Model& model, double ratio, std::uint64_t seed);

/** \brief Drops a share of the points at random; drops all faces.
 *  \throws std::invalid_argument the share is not in [0, 1) */
void
dropPoints(Model& model, double share, std::uint64_t seed);

/** \brief Makes a cloud of the mesh. */
void
dropFaces(Model& model);

/** \brief Puts the vertices, and the triangles, into random order. */
void
shuffleVertices(Model& model, std::uint64_t seed);

/** \brief Adds points without partner at random places of a box a tenth larger than the bounding box on every side.
 *  \param[in,out] model mesh or cloud
 *  \param[in] share of the points there are that is added, [0, 1]
 *  \param[in] seed of the random numbers
 *  \throws std::invalid_argument the share is out of range */
void
addOutliers(Model& model, double share, std::uint64_t seed);

/** \brief Adds copies of random points, at the same places and without partners.
 *  \param[in,out] model mesh or cloud
 *  \param[in] share of the points there are that is added, [0, 1]
 *  \param[in] seed of the random numbers
 *  \return which point each of them is a copy of
 *  \throws std::invalid_argument the share is out of range */
std::vector<Index>
repeatPoints(Model& model, double share, std::uint64_t seed);

/** \brief Keeps the vertices that \a keep marks, and the triangles among them, in their order.
 *  \throws std::invalid_argument \a keep has not one entry per vertex */
void
keepVertices(Model& model, const std::vector<char>& keep);

} // namespace symmetry
} // namespace pcl
