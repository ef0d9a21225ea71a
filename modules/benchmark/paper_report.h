/** \file
 * \brief The tables and figures of the published method's paper, made anew: its figures beside ours.
 */
#pragma once

#include "benchmark/run.h"

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The same models, in the same order, run with each of the methods. */
struct PaperRuns {
  std::vector<ModelRun> staged;
  std::vector<ModelRun> robust;
};

/** \brief The pictures of one map; names of files beside the page. */
struct PaperPicture {
  BenchmarkModel model;
  Method method = Method::Robust;
  SymmetryStatus status = SymmetryStatus::NoSymmetry;
  std::string matches; ///< sides, axis and partner lines; empty where there is no map
  std::string colours; ///< colours of one side carried over to the other; empty where there is no map
};

/** \brief Name of the page in its folder. */
constexpr const char* paper_page = "paper.md";

/** \brief Name of the file with the error curves beside the page. */
constexpr const char* paper_curves = "error_curves.svg";

/** \brief The page, in Markdown: rates and times by class with the published ones, and links to the pictures.
 * \param[in] runs means are those of the runs with ground truth; a failed run counts with rate 0
 * \param[in] parameters of both, named on the page; the method is not looked at
 * \param[in] pictures in the order in which they are shown */
std::string
describePaper(const PaperRuns& runs, const SymmetryParameters& parameters, const std::vector<PaperPicture>& pictures);

/** \brief Writes page, error curves and pictures into a folder that is there.
 *
 * Pictures are drawn of the first model with ground truth of each class that neither method failed for; it is run once
 * more with each, since runs keep no more than the map.
 * \param[in] folder each file in it appears whole or not at all, the page last
 * \param[in] runs see describePaper()
 * \param[in] options of both runs; its method is not looked at
 * \throws pcl::IOException cannot be written, or a model that was read before cannot be read any more */
void
writePaper(const std::string& folder, const PaperRuns& runs, const RunOptions& options);

} // namespace symmetry
} // namespace pcl
