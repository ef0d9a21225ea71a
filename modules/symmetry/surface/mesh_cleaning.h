/** \file
 * \brief Points and triangles of a mesh that are there twice, or are none; the normals of what is left.
 */
#pragma once

#include "symmetry/surface/prepared_surface.h"

#include <cstddef>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Lets some points stand for others, which are left out.
 * \param[in] first for each point the one that stands for it, itself perhaps
 * \return number of points that were left out */
std::size_t
letStandForOthers(PreparedSurface& surface, const std::vector<Index>& first);

/** \brief Lets the first of several points at one place stand for all: in a cloud they would take up each other's
 * neighbours, and a mesh falls apart at the seams of its texture, where exporters repeat the vertices. Cost O(n).
 * \return number of points that another stands for now */
std::size_t
mergeRepeatedPoints(PreparedSurface& surface);

/** \brief Drops triangles that have a corner twice. */
void
dropDegenerateTriangles(std::vector<Triangle>& triangles);

/** \brief Keeps the first of several triangles with the same corners, whichever way they turn: doubled faces, as of
 * two-sided exports, would leave more than two triangles at every edge, which ends every line drawn over the surface.
 * \param[in] n number of points */
void
dropRepeatedTriangles(std::size_t n, std::vector<Triangle>& triangles);

/** \brief Drops points that no triangle has as a corner; they are no surface. */
void
dropUnusedPoints(PreparedSurface& surface);

/** \brief Leaves the connected component with the largest area, of equal ones that with the lowest point.
 * \param[in,out] surface a mesh at unit scale of which every point has a triangle */
void
keepLargestComponent(PreparedSurface& surface);

/** \brief Mean of the normals of the faces around each vertex, weighted by area; zero where there is no face. */
std::vector<Vector3>
vertexNormals(const std::vector<Vector3>& points, const std::vector<Triangle>& triangles);

} // namespace symmetry
} // namespace pcl
