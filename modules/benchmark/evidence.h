/** \file
 * \brief The table that the confidence of a map is calibrated with: all measures of every map, and whether it is right.
 */
#pragma once

#include "benchmark/run.h"
#include "symmetry/confidence/point_confidence.h"

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What is known of the partner of one scored vertex. */
struct VertexEvidence {
  Index vertex = no_index; ///< of the model's file
  double error = 0.0;      ///< VertexError::geodesic
  PointEvidence evidence;  ///< at the landmark around it
};

/** \brief One map of a model, whether it is delivered or not. */
struct EvidenceRow {
  BenchmarkModel model;
  std::string input;      ///< mesh, cloud or mesh_as_cloud
  std::size_t number = 0; ///< of the interpretation, or of the contender, from 0
  bool is_cut = false;    ///< a limb was cut off: no map is right as a whole
  double rate = 0.0;      ///< Correspondence Rate; where a limb was cut off, of the pairs that are left
  float confidence = 0.0F;
  std::vector<std::pair<std::string, float>> measures; ///< namedMeasures () and misfit, SampleEstimate::value
  std::vector<VertexEvidence> vertices;                ///< empty where a limb was cut off
};

/** \brief Runs models, \a jobs at a time, by the robust method, and collects a row for every interpretation; in the
 * order of the models. Models that fail are left out with a line to \a errors. */
std::vector<EvidenceRow>
collectEvidence(const std::vector<BenchmarkModel>& models,
                const RunOptions& options,
                unsigned jobs,
                std::ostream& errors);

/** \brief The same with a row for every contender of the first interpretation, the one that is taken first: all maps that
 * were refined, among them those with limbs exchanged. What the choice among them is fitted with. */
std::vector<EvidenceRow>
collectContenders(const std::vector<BenchmarkModel>& models,
                  const RunOptions& options,
                  unsigned jobs,
                  std::ostream& errors);

/** \brief Comma-separated values with a header line; without rows nothing, since the measures have no names then.
 * \throws pcl::IOException cannot be written */
void
writeEvidence(const std::string& path, const std::vector<EvidenceRow>& rows);

/** \brief The same for the vertices of all rows, a line each.
 * \throws pcl::IOException cannot be written */
void
writeVertexEvidence(const std::string& path, const std::vector<EvidenceRow>& rows);

} // namespace symmetry
} // namespace pcl
