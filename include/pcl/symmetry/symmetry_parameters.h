/** \file
 * \brief Parameters of the symmetry estimation, one defaulted struct; the setters of the class write to it.
 */
#pragma once

namespace pcl {
namespace symmetry {

/** \brief How the symmetric map is found. */
enum class Method {
  Robust, ///< many hypotheses, scored and refined: the default, right on bodies with or without four limbs
  Staged  ///< the published staged coarse-to-fine matching, step by step
};

/** \brief What is used as the distance of two points of the surface. */
enum class Metric {
  Geodesic, ///< shortest path along the surface: the result does not depend on the pose
  Euclidean ///< straight line: right only where left and right are posed alike
};

/** \brief Which feature groups the four extreme points of the staged method into two pairs (paper, section 3.1). */
enum class PairingFeature {
  AverageGeodesicDistance, ///< at every size: the stable choice, the default
  MinimalGeodesicDistance, ///< at every size
  BySurfaceSize            ///< as published: average below 30,000 points, minimal from there on
};

/** \brief Which points of a surface the staged method takes for the tips of its limbs (paper, section 3.1). */
enum class ExtremePoints {
  AmongNine, ///< of the first nine farthest points the two pairs that are most alike: also on animals with a tail
  FirstFour  ///< literally the first four farthest points, paired by PairingFeature
};

/** \brief Where the normals of a point cloud without faces come from. */
enum class NormalSource {
  Estimate, ///< from the neighbours of each point, oriented by propagation
  Given     ///< from Surface::normals, of any length; points without one (zero, not finite) get an estimate
};

/** \brief What takes part of a surface in several connected components. */
enum class ComponentUse {
  All,    ///< parts of one object, which touch, overlap or lie close: the default
  Largest ///< one component, of a mesh that of the largest area, of a cloud that of most points
};

/** \brief What only the robust method uses. */
struct RobustParameters {
  /** Evenly spaced samples that stand for the surface, [30, 20000]: the default is spaced by 1/40 of the diameter on a
   * body, half as wide as a finger is long. */
  int samples = 1500;
};

/** \brief What only the staged method uses; the defaults are the paper's unless another reason is given. */
struct StagedParameters {
  int landmarks = 100; ///< sources of full distance fields, [10, 1000]
  int samples = 100;   ///< evenly spaced samples that stages 3 and 4 match, [20, 20000]
  /** Dimensions of the spectral embedding in which the extreme points are paired, [2, 20]. */
  int embedding_dimensions = 3;
  ExtremePoints extremities = ExtremePoints::AmongNine;
  PairingFeature pairing = PairingFeature::AverageGeodesicDistance; ///< of the first four, see ExtremePoints
};

/** \brief Everything that can be set, with defaults; plain data. What one method alone uses is in a part of its own.
 *
 * No length is absolute: a tolerance is relative to the diameter of the surface (the largest distance
 * between the points that fields of distances start from) or to the local point spacing.
 * \ingroup symmetry
 */
struct SymmetryParameters {
  Method method = Method::Robust;
  RobustParameters robust; ///< of no effect on the staged method
  StagedParameters staged; ///< of no effect on the robust method
  Metric metric = Metric::Geodesic;

  /** Neighbours of a point in the graph of a cloud without faces, [3, 256]. */
  int k_search = 10;
  /** Longest edge of a cloud's neighbour graph, in the unit of the points; 0: no limit. */
  float radius = 0.0F;
  NormalSource normals = NormalSource::Estimate;
  ComponentUse components = ComponentUse::All;
  /** Points of a cloud whose mean neighbour distance exceeds the cloud's mean by more than this number of standard
   * deviations are left out; 0: only points several times farther from their neighbours than these are from theirs. */
  float outlier_deviations = 0.0F;

  /** Deliver no dense map and no alternatives; sides, axis and sparse matches are there all the same. */
  bool sparse_only = false;
  /** Whether points at the axis are labelled Side::Axis; if not, every point that took part is on one of the sides. */
  bool label_axis = true;
  /** How many distinct reflections, and rotations beside them, the result lists at most, the best first, [1, 100]. */
  int alternatives = 1;

  /** Worker threads, 0: as many as the machine has cores. The result does not depend on it. */
  unsigned threads = 0;
};

} // namespace symmetry
} // namespace pcl
