/** \file
 * \brief Runs made by hand.
 */
#pragma once

#include "benchmark/run.h"

namespace pcl {
namespace symmetry {
namespace test {

/** \brief A run of a model of four vertices with a confidence each, of which the first \a right_vertices are right and
 * the others off by a fifth of the diameter. */
inline ModelRun
makeRun(const std::string& set, const std::string& class_name, const std::string& name, int right_vertices)
{
  ModelRun run;
  run.model = {name + ".off", name, set, class_name, "sym.txt"};
  run.points = 4;
  run.faces = 2;
  run.status = SymmetryStatus::Symmetric;
  run.confidence = 0.25F * static_cast<float>(right_vertices);
  run.partners = {1, 0, 3, 2};
  run.confidences = {0.9F, 0.8F, 0.7F, 0.6F};
  run.seconds = {{"graph", 0.5}, {"dense", 1.0}};
  run.score.emplace();
  run.score->vertices = run.score->map_size = run.score->matched = 4;
  for (Index vertex = 0; vertex < 4; ++vertex)
    run.score->errors.push_back({vertex, vertex < right_vertices ? 0.0 : 0.2, vertex < right_vertices});
  return run;
}

/** \brief A run that ended with an exception. */
inline ModelRun
makeFailedRun(const std::string& set, const std::string& class_name, const std::string& name)
{
  ModelRun run;
  run.model = {name + ".off", name, set, class_name, "sym.txt"};
  run.failure = name + ".off: \"broken\", truncated";
  return run;
}

/** \brief A run without ground truth. */
inline ModelRun
makeUnscoredRun(const std::string& set, const std::string& name)
{
  ModelRun run = makeRun(set, set, name, 4);
  run.model.truth.clear();
  run.score.reset();
  return run;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
