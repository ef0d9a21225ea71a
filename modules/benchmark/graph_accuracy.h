/** \file
 * \brief How well the graph of a cloud measures distances along the surface: compared with those of the mesh.
 */
#pragma once

#include "benchmark/run.h"
#include "symmetry/surface/prepared_surface.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Distances in the graph of a cloud against those along the edges of the mesh that its points come from. */
struct GraphAccuracy {
  std::size_t pairs = 0;     ///< of points that were compared: those at least 5 % of the mesh's diameter apart
  double median_error = 0.0; ///< of |distance - that of the mesh| over that of the mesh
  /** Share of the pairs with a distance below 0.8 of the mesh's: a shortcut is on the way. */
  double short_pairs = 0.0;
};

/** \brief Compares the distances of a hundred points, evenly numbered, from up to a thousand others; what has no point
 * that stands for it is left out.
 *
 * Cost: a shortest-path field on either graph for each of the hundred points.
 * \param[in] mesh surface with faces
 * \param[in] prepared made of a cloud
 * \param[in] origins vertex of the mesh that each point of the cloud was, no_index: none */
GraphAccuracy
compareGraph(const Surface& mesh, const PreparedSurface& prepared, const std::vector<Index>& origins);

/** \brief What came out for one model. */
struct GraphRun {
  BenchmarkModel model;
  std::string failure; ///< why there is no result; empty where there is one
  GraphAccuracy accuracy;
};

/** \brief Disturbs each model, takes its faces away, reads the cloud as the estimation does and compares the graph of
 * the interpretation that it decides for; \a jobs models at a time, 0: as many as there are cores. */
std::vector<GraphRun>
compareGraphs(const std::vector<BenchmarkModel>& models, const RunOptions& options, unsigned jobs);

/** \brief Writes a line per model, per class (means of its models) and per set (means of its classes). */
void
printGraphs(std::ostream& out, const std::vector<GraphRun>& runs);

} // namespace symmetry
} // namespace pcl
