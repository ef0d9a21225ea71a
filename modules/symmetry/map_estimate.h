/** \file
 * \brief What a method (staged or robust) hands on: plain data on the points of a prepared surface.
 */
#pragma once

#include "symmetry/confidence/point_confidence.h"

#include <pcl/symmetry/symmetry_result.h>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief MapEstimate::misfit of a mirror image in space: below that of any map of samples, which cannot be less than -18
 * (the logarithms in the score and in the fit of the patches have floors); only the order of the two matters. */
constexpr float exact_misfit = -20.0F;

/** \brief Symmetric map of a prepared surface; arrays have one entry per point of it. */
struct MapEstimate {
  SymmetryStatus status = SymmetryStatus::NoSymmetry;
  std::string message; ///< why the status is not Symmetric
  float confidence = 0.0F;
  float map_confidence = 0.0F; ///< of the map as it came out, also where it is refused
  float misfit = 0.0F;         ///< of the map: SampleEstimate::value, a logarithm, the lower the better
  /** Of the best candidate of the search: MapScore::value, the lower the better; infinite where nothing was searched. */
  float search_score = std::numeric_limits<float>::infinity();
  float known_holes = 0.0F;          ///< share of the samples into whose cells holes of a mesh reach; 0 for a cloud
  float unsupported_share = 0.0F;    ///< of the area: parts without a counterpart, see Support
  float supported_confidence = 0.0F; ///< of the map of the rest; map_confidence where all is supported
  bool is_partial = false;           ///< see MapJudge::judgeSupport ()
  /** Of a refused map: how far it can be trusted on what a closer look leaves supported, see MapJudge::lookCloser (). */
  float trust_of_part = 0.0F;
  bool is_by_plane = false;                     ///< a mirror image in space, as a whole or but for odd parts
  float trust = 0.0F;                           ///< share of the surface that can be expected to be right under the map
  std::vector<Index> ends;                      ///< of limbs, see LandmarkSurface::extremities
  std::vector<char> is_unsupported;             ///< per point
  std::vector<float> support;                   ///< per point, as SymmetryResult::support
  std::vector<PointEvidence> landmark_evidence; ///< of the robust method, per landmark
  std::vector<Index> landmark_of;               ///< per point: the landmark around it; empty without them
  std::vector<Index> partners;                  ///< empty where the staged method was asked for sparse matches only
  std::vector<float> confidences;               ///< per point, in [0, 1]
  std::vector<float> side_function; ///< positive on the source side, negative on the target side, 0 undecided
  bool are_sides_exact = false;     ///< heights over a plane: nothing in the side function is noise
  std::vector<Region> regions;
  std::vector<SymmetricMatch> matches;
  std::vector<Index> extremities;
  std::size_t equal_reflections = 0;        ///< as SymmetryResult::equal_reflections
  std::vector<AlternativeMap> alternatives; ///< reflections
  std::vector<AlternativeMap> rotations;
  std::vector<std::pair<std::string, float>> measures; ///< what speaks for and against the map, by name
  float diameter = 0.0F; ///< largest landmark distance, in the unit of the prepared surface
};

} // namespace symmetry
} // namespace pcl
