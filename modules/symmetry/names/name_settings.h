/** \file
 * \brief The numbers that decide how two surfaces are compared to name their sides alike.
 *
 * Origin: chosen by hand on the four-legged animals of TOSCA and nine people of TOSCA, KIDS and posed bodies.
 */
#pragma once

#include "symmetry/sides/side_settings.h"

#include <array>
#include <cstddef>

namespace pcl {
namespace symmetry {

/** \brief What two surfaces are compared by, see comparable_surface.h. */
struct ComparisonFeatures {
  std::array<double, 4> heat_times = {0.003, 0.01, 0.03, 0.1}; ///< on a surface of area 1
  double steep = 0.3; ///< of the mean length of the turns, added to each: steep places do not outweigh others
  /** Chiralities weigh finer shape than where they alone name sides: of 54 poses of TOSCA, KIDS and posed bodies, on which
   * this was chosen, all but a wolf and a centaur have that of their left. */
  SideNameSettings chirality = {0.003, 0.03, 0, 2.6, 17.5, 0.8};
};

/** \brief How maps from one surface to the other are found and weighed, see name_comparison.h. */
struct NameComparisonSettings {
  int signed_functions = 5;                               ///< whose signs are tried: 2^5 starts
  int turning_functions = 8;                              ///< even functions whose turns are compared
  double turn_weight = 0.5;                               ///< of the turns against the even functions
  double start_weight = 0.3;                              ///< of the features against the even functions, at the start
  double weight = 0.5;                                    ///< and later
  std::array<int, 6> dimensions = {6, 8, 10, 13, 16, 20}; ///< even functions to go up through
  std::size_t turned_over = 4;                            ///< maps of either orientation that the other one starts from
  std::size_t compared_landmarks = 120;                   ///< to which distances are compared
  double feature_share = 1.0;    ///< mean square difference of features against mean difference of distances
  double chirality_share = 0.15; ///< of what the shapes say each by itself, at most, in the margin
};

} // namespace symmetry
} // namespace pcl
