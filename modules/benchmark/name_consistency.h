/** \file
 * \brief Whether the sides of models keep their names, from pose to pose and from body to body.
 */
#pragma once

#include "benchmark/run.h"
#include "symmetry/names/comparable_surface.h"

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Where the true side of every vertex of a model is, by the name of its file: `Sides/<class>.txt` beside the
 * folder of the model, `<model>_side.txt` or `side.txt` in it. Empty where there is none. */
std::string
findSideTruth(const BenchmarkModel& model);

/** \brief Reads one side per vertex: 1 or 2, 3 on the axis, 0 not known.
 * \throws pcl::IOException cannot be read, holds something else, or not as many as there are vertices */
std::vector<Side>
readSideTruth(const std::string& file, std::size_t vertices);

/** \brief A model after the estimation. */
struct NamedModel {
  BenchmarkModel model;
  std::string failure;     ///< why it takes no part; empty where it does
  bool is_as_true = false; ///< the names of its sides are those of the truth
  ComparableSurface described;
};

/** \brief Pairs of models of two classes. */
struct NamePairs {
  std::string first; ///< set/class
  std::string second;
  std::size_t pairs = 0;
  std::size_t by_shape = 0;     ///< of them with the same names as the shapes alone give them
  std::size_t by_reference = 0; ///< and with one taken as the reference of the other
  std::size_t doubtful = 0;     ///< with a margin below SideNaming::doubtful
};

/** \brief Estimates models and compares each with each of the same set, whatever its class.
 * \param[in] exchanged classes whose truth calls 2 what that of the others calls 1 */
std::vector<NamePairs>
compareAllNames(const std::vector<BenchmarkModel>& models,
                const RunOptions& options,
                const std::vector<std::string>& exchanged,
                unsigned jobs,
                const std::function<void(const NamedModel&)>& failed = {});

/** \brief Writes a line per pair of classes and sums: within classes and across them. */
void
printNames(std::ostream& out, const std::vector<NamePairs>& rows);

} // namespace symmetry
} // namespace pcl
