/** \file
 * \brief Finds the models of published data sets, with their ground truth, below a folder.
 */
#pragma once

#include "benchmark/variants.h"

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief One model of a data set. */
struct BenchmarkModel {
  std::string file;                  ///< path of the surface
  std::string name;                  ///< file name without folder and ending
  std::string set;                   ///< name of the data set's folder
  std::string class_name;            ///< models of one class are poses or individuals of one kind
  std::string truth;                 ///< specification for readGroundTruth(); empty where there is none
  Variant variant = Variant::AsItIs; ///< how it is changed before all else
};

/** \brief Finds all models of a data set, or of the data sets in the folders directly below \a folder.
 *
 * What makes a folder a data set:
 * - `Meshes` and `Corrs` in it: landmarks. `Corrs/<model>.vts` with `Corrs/<class number>.sym.info` where the model's
 *   name is a number (SHREC 2007: twenty models per class), else `Corrs/<class>.pid` with `Corrs/<class>.sym.info`,
 *   where the class is the model's name without the digits at its end; when no such class is there, and only
 *   one .pid file (SCAPE), that one is for all models.
 * - Otherwise surface files in it: `<model>_sym.txt`, or else `sym.txt` for all of them, is the dense ground truth;
 *   without either the models have none. They form one class of the folder's name.
 *
 * \param[in] folder a data set, or a folder that holds data sets
 * \return ordered by set, then by name, numbers in names by value
 * \throws pcl::IOException \a folder is none, cannot be read, or no model is in it
 */
std::vector<BenchmarkModel>
findModels(const std::string& folder);

/** \brief Adds the first \a count variants of every model behind it, named `MODEL~VARIANT`. */
void
addVariants(std::vector<BenchmarkModel>& models, std::size_t count);

} // namespace symmetry
} // namespace pcl
