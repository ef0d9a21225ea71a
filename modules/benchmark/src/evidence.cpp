#include "benchmark/evidence.h"

#include "../../estimation/src/neighbour_search.h"
#include "base/error_text.h"
#include "base/parallel.h"
#include "benchmark/metrics.h"
#include "benchmark/model_input.h"
#include "io/write/output_file.h"
#include "symmetry/pipeline.h"
#include "symmetry/refine/point_map.h"
#include "symmetry/robust_method.h"

#include <exception>
#include <iterator>
#include <ostream>
#include <sstream>

namespace pcl {
namespace symmetry {
namespace {

/** Per vertex of the model's file: the point of the prepared surface that stands for it; no_index where none does. */
std::vector<Index>
pointsOfFile(const PreparedSurface& surface, const ModelInput& model)
{
  std::vector<Index> in_input = model.stand_ins;
  if (in_input.empty()) {
    in_input.assign(model.mesh.size(), no_index);
    for (std::size_t i = 0; i < model.input.origins.size(); ++i) {
      if (model.input.origins[i] != no_index) {
        in_input[static_cast<std::size_t>(model.input.origins[i])] = static_cast<Index>(i);
      }
    }
  }
  for (Index& v : in_input) {
    v = v == no_index ? no_index : surface.representatives[static_cast<std::size_t>(v)];
  }
  return in_input;
}

/** What is known of the partners of the scored vertices. */
std::vector<VertexEvidence>
vertexEvidence(const Interpretation& interpretation, const ModelInput& model, const MapAccuracy& score)
{
  const MapEstimate& estimate = interpretation.estimate;
  std::vector<VertexEvidence> vertices;
  const std::vector<Index> points = pointsOfFile(interpretation.surface, model);
  for (const VertexError& error : score.errors) {
    const Index point = points[static_cast<std::size_t>(error.vertex)];
    if (point != no_index && !estimate.landmark_of.empty()) {
      vertices.push_back({error.vertex, error.geodesic, estimate.landmark_evidence[estimate.landmark_of[point]]});
    }
  }
  return vertices;
}

/** What a map of a model is known to be, without what was measured on it. */
EvidenceRow
rowFor(const BenchmarkModel& model, const PreparedSurface& surface, const RunOptions& options, std::size_t number)
{
  EvidenceRow row;
  row.model = model;
  row.input = surface.summary.read_as_cloud ? "mesh_as_cloud" : options.as_cloud ? "cloud" : "mesh";
  row.number = number;
  row.is_cut = options.cut_limb.has_value();
  return row;
}

/** Every map of every interpretation. */
std::vector<EvidenceRow>
evidenceOf(const BenchmarkModel& model, const RunOptions& options)
{
  const ModelInput input = readModel(model, options);
  std::vector<EvidenceRow> rows;
  StepTimer timer;
  InputSummary summary;
  interpretSurface(input.input.surface, parametersFor(model, options), searchByKdTree, timer, summary,
                   [&](const Interpretation& interpretation) {
                     const MapEstimate& estimate = interpretation.estimate;
                     EvidenceRow row = rowFor(model, interpretation.surface, options, rows.size());
                     row.confidence = estimate.map_confidence;
                     row.measures = estimate.measures;
                     if (!input.asked.empty()) {
                       const MapAccuracy score =
                           scoreMap(input.mesh, input.asked, mapOfFile(input, mapOfInput(interpretation)));
                       row.rate = score.correspondenceRate();
                       if (!row.is_cut) {
                         row.vertices = vertexEvidence(interpretation, input, score);
                       }
                     }
                     if (!row.measures.empty() && !estimate.landmark_of.empty()) { // a mirror plane has other measures
                       rows.push_back(std::move(row));
                     }
                   });
  return rows;
}

/** Every contender of the first interpretation. */
std::vector<EvidenceRow>
contendersOf(const BenchmarkModel& model, const RunOptions& options)
{
  const ModelInput input = readModel(model, options);
  const SymmetryParameters parameters = parametersFor(model, options);
  Interpretation interpretation{firstSurface(input, parameters), {}};
  std::vector<EvidenceRow> rows;
  RobustSettings settings = robustSettings(parameters);
  settings.observer = [&](const SampledSurface& sampled, const std::vector<Contender>& contenders) {
    const MapJudge judge(sampled);
    for (const Contender& contender : contenders) {
      EvidenceRow row = rowFor(model, interpretation.surface, options, rows.size());
      const MapEvidence evidence = judge.evidenceFor(*contender.candidate, contender.samples);
      row.confidence = mapConfidence(evidence);
      row.measures = namedMeasures(evidence);
      row.measures.emplace_back("moved_ends", contender.samples.moved_ends);
      row.measures.emplace_back("misfit", contender.samples.value);
      if (!input.asked.empty()) {
        interpretation.estimate.partners = partnersOfPoints(sampled, contender.samples.partners);
        row.rate = scoreMap(input.mesh, input.asked, mapOfFile(input, mapOfInput(interpretation))).correspondenceRate();
      }
      rows.push_back(std::move(row));
    }
  };
  StepTimer timer;
  estimateRobust(interpretation.surface, parameters, settings, timer);
  return rows;
}

using CollectRows = std::vector<EvidenceRow> (*)(const BenchmarkModel&, const RunOptions&);

/** The rows of all models, in their order. */
std::vector<EvidenceRow>
collectRows(CollectRows rows_of,
            const std::vector<BenchmarkModel>& models,
            const RunOptions& options,
            unsigned jobs,
            std::ostream& errors)
{
  std::vector<std::vector<EvidenceRow>> rows(models.size());
  std::vector<std::string> failures(models.size());
  const ThreadScope all_jobs(jobs);
  parallelFor(models.size(), [&](std::size_t i) {
    const ThreadScope of_a_job(options.parameters.threads);
    try {
      rows[i] = rows_of(models[i], options);
    }
    catch (const std::exception& error) {
      failures[i] = errorText(error);
    }
  });
  std::vector<EvidenceRow> all;
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (!failures[i].empty()) {
      errors << models[i].set << '/' << models[i].name << ": " << failures[i] << '\n';
    }
    all.insert(all.end(), std::make_move_iterator(rows[i].begin()), std::make_move_iterator(rows[i].end()));
  }
  return all;
}

} // namespace

std::vector<EvidenceRow>
collectEvidence(const std::vector<BenchmarkModel>& models,
                const RunOptions& options,
                unsigned jobs,
                std::ostream& errors)
{
  return collectRows(evidenceOf, models, options, jobs, errors);
}

std::vector<EvidenceRow>
collectContenders(const std::vector<BenchmarkModel>& models,
                  const RunOptions& options,
                  unsigned jobs,
                  std::ostream& errors)
{
  return collectRows(contendersOf, models, options, jobs, errors);
}

void
writeEvidence(const std::string& path, const std::vector<EvidenceRow>& rows)
{
  std::ostringstream out;
  out.precision(7);
  for (const EvidenceRow& row : rows) {
    if (&row == &rows.front()) {
      out << "set,class,model,input,number,cut,rate,confidence";
      for (const auto& measure : row.measures) {
        out << ',' << measure.first;
      }
      out << '\n';
    }
    out << row.model.set << ',' << row.model.class_name << ',' << row.model.name << ',' << row.input << ','
        << row.number << ',' << (row.is_cut ? 1 : 0) << ',' << row.rate << ',' << row.confidence;
    for (const auto& measure : row.measures) {
      out << ',' << measure.second;
    }
    out << '\n';
  }
  writeWholeFile(path, out.str());
}

void
writeVertexEvidence(const std::string& path, const std::vector<EvidenceRow>& rows)
{
  std::ostringstream out;
  out.precision(7);
  out << "set,model,input,number,map_confidence,vertex,error,local_change,fit_distance,reversal\n";
  for (const EvidenceRow& row : rows) {
    for (const VertexEvidence& vertex : row.vertices) {
      out << row.model.set << ',' << row.model.name << ',' << row.input << ',' << row.number << ',' << row.confidence
          << ',' << vertex.vertex << ',' << vertex.error << ',' << vertex.evidence.local_change << ','
          << vertex.evidence.fit_distance << ',' << vertex.evidence.reversal << '\n';
    }
  }
  writeWholeFile(path, out.str());
}

} // namespace symmetry
} // namespace pcl
