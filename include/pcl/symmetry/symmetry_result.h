/** \file
 * \brief What the symmetry estimation delivers: plain data, indices of the input.
 */
#pragma once

#include <pcl/symmetry/export.h>
#include <pcl/symmetry/surface.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Outcome of an estimation; a caller's mistake is an exception instead. */
enum class SymmetryStatus {
  Symmetric, ///< a reflective symmetry was found
  /** A reflection explains more than half of the surface; parts without a counterpart are named and have no partner. So is
   * what lies apart from the part that was mapped, where that is more than a tenth of the points. */
  PartlySymmetric,
  NoSymmetry,   ///< the surface has none, or none that can be trusted
  TooFewPoints, ///< less than the method needs, after what is unusable was left out
  Cancelled     ///< the progress callback asked to stop
};

/** \brief Name of a status as it appears in reports: symmetric, partly_symmetric, no_symmetry, too_few_points, cancelled. */
PCL_SYMMETRY_EXPORTS const char*
toString(SymmetryStatus status);

/** \brief Which side of the symmetry axis a point is on; the values are those of the label field in files. */
enum class Side : std::uint8_t { None = 0, Source = 1, Target = 2, Axis = 3 };

/** \brief Region of a point; the values are those of the region field in files. */
enum class Region : std::uint8_t { None = 0, Source1 = 1, Target1 = 2, Source2 = 3, Target2 = 4, Centre = 5 };

/** \brief One sparse correspondence. */
struct SymmetricMatch {
  Index source = no_index;
  Index target = no_index;
  Index midpoint = no_index; ///< the point half way on the geodesic from source to target, on the axis or near it
  /** How badly the two match, 0 is best, no unit. Staged method: dissimilarity of their feature vectors; robust: change
   * of their distance when each is mapped, as a share of the diameter: |d(s, t) - d(t, m(t))|. */
  float cost = 0.0F;
};

/** \brief A place on the symmetry axis curve, mostly between points of the surface. */
struct AxisPoint {
  Vector3 position{};       ///< in the unit and the place of the points
  float arc_length = 0.0F;  ///< from the first place along the curve, in the unit of the points
  Vector3 normal{};         ///< of the surface there, of unit length
  Vector3 across{};         ///< perpendicular to normal and curve, of unit length, towards the source side
  Index nearest = no_index; ///< point of the surface next to it
};

/** \brief An ordered line on the surface. */
struct Polyline {
  /** Consecutive points are neighbours, but where a line is continued over a gap of a cloud; the first is not repeated
   * at the end. */
  std::vector<Index> points;
  bool closed = false; ///< the last point is a neighbour of the first
  /** The same line where it really runs: it crosses the edges between points. On a cloud through the surface that was
   * solved for, which noise is smoothed away from. The first place is not repeated at the end. */
  std::vector<AxisPoint> curve = {};
};

/** \brief What was read, used and left out. */
struct InputSummary {
  std::size_t points = 0;           ///< of the input
  std::size_t faces = 0;            ///< triangles of the input
  std::size_t used = 0;             ///< points that took part, themselves or represented by a neighbour
  std::size_t working_points = 0;   ///< points that were solved for; fewer than used where a cloud was thinned out
  std::size_t non_finite = 0;       ///< points dropped since a coordinate is no finite number
  std::size_t outside_indices = 0;  ///< points that the caller's indices leave out
  std::size_t outliers = 0;         ///< points dropped as outliers
  std::size_t unused = 0;           ///< points of a mesh that no face uses: they are no surface
  std::size_t welded = 0;           ///< corners of a mesh for which another at the same place stands, but for rounding
  std::size_t junctions = 0;        ///< corners of a mesh on the side of a triangle, which was cut there
  std::size_t other_components = 0; ///< points dropped since they belong to something else than what was mapped
  std::size_t components = 0;       ///< connected components of the surface, before parts of one object were linked
  std::size_t linked_parts = 0;     ///< components that were linked to one object; 0 where it is in one piece
  std::size_t part_links = 0;       ///< edges that link them
  std::size_t bridges = 0;          ///< edges added between parts of a cloud
  std::size_t distrusted_edges = 0; ///< edges removed from a cloud's graph as shortcuts between parts in contact
  bool read_as_cloud = false;       ///< of a mesh: its faces told normals only, as holes or cracks run through it
  float smoothing_radius = 0.0F;    ///< radius of the planes that a noisy cloud was smoothed by; 0: it was not
  std::vector<std::string> notes;   ///< what the reader of the file passed over or changed, a sentence each
};

/** \brief Properties of the dense map. */
struct MapSummary {
  std::size_t matched = 0;     ///< points with a partner
  std::size_t axis = 0;        ///< points labelled Side::Axis
  float involution = 0.0F;     ///< share of matched points v with m (m (v)) within 2 % of the diameter or next to v
  float inverted_faces = 0.0F; ///< share of faces that the map does not turn over as a reflection does
  float torn_faces = 0.0F;     ///< share of faces with an edge whose length changes by 5 % of the diameter
  float isometry_error = 0.0F; ///< mean |d (p, q) - d (m (p), m (q))| over pairs of landmarks, share of the diameter
};

/** \brief The plane in which the reflection comes nearest to the map: what it is for a body in a symmetric pose.
 *
 * For places where the file has them: Surface::offset is included. */
struct MirrorPlane {
  std::array<double, 3> normal{}; ///< of unit length, towards the source side; zero where no point has a partner
  double offset = 0.0;            ///< normal . p = offset for p in the plane, in the unit of the points
  double rms = 0.0; ///< root mean square distance of the partners from the mirrored points: 0 is an exact mirror image
  /** Rows of a rigid motion (a turn, and in the last column a shift) that brings the plane to x = 0 and the source side
   * to where x is positive. */
  std::array<std::array<double, 4>, 3> to_x{};
};

/** \brief How the two sides got their names: which one is called the source side. */
struct SideNaming {
  bool by_reference = false; ///< as those of a reference, see NameReference; else by the shape alone
  bool exchanged = false;    ///< the names by the shape alone were the other way round
  /** How much better the names fit than if they were exchanged, in [0, 1]; 0: nothing can be told. Below \a doubtful
   * they may well be wrong. */
  float margin = 0.0F;
  static constexpr float doubtful = 0.1F; ///< by hand, on people and four-legged animals; see BENCHMARK.md
  float misfit = 0.0F; ///< how unlike the reference is: about 0.3 in another pose, about 1 as another kind of animal
};

/** \brief A connected part of the surface that has no counterpart under the map. */
struct UnsupportedPart {
  std::size_t points = 0; ///< of the surface that was solved for
  float share = 0.0F;     ///< of the area of the surface
  float extent = 0.0F;    ///< distance of its extreme point from the rest along the surface, in the unit of the points
  Index extreme = no_index; ///< the point farthest from the rest: the tip of an odd limb
};

/** \brief Whether a status comes with a map: Symmetric or PartlySymmetric. */
constexpr bool
hasMap(SymmetryStatus status)
{
  return status == SymmetryStatus::Symmetric || status == SymmetryStatus::PartlySymmetric;
}

/** \brief One of several symmetries of a surface. */
struct AlternativeMap {
  std::vector<Index> partners;      ///< as SymmetryResult::partners; a rotation need not be its own inverse
  float score = 0.0F;               ///< lower is better
  float confidence = 0.0F;          ///< in [0, 1]
  bool reverses_orientation = true; ///< true: a reflection, false: a rotation
};

/** \brief The result of one estimation.
 *
 * Every per-point array has one entry per point of the input, whatever was left out on the way: left-out points have
 * partner -1, Side::None, Region::None and confidence 0. Unless there is a map, see hasMap (), the arrays
 * hold nothing but such entries.
 * \ingroup symmetry
 */
struct SymmetryResult {
  SymmetryStatus status = SymmetryStatus::TooFewPoints; ///< look at it first, see hasMap ()
  std::string message;     ///< for a person: why the status is not Symmetric, or what was noticed
  float confidence = 0.0F; ///< of the whole map, in [0, 1]; below two thirds a cloud may well have no symmetry

  std::vector<SymmetricMatch> matches; ///< sparse correspondences, spread over limbs and centre of the source side
  std::vector<Index> partners;         ///< dense map
  /** Per point, in [0, 1]: the probability that its partner is within 5 % of the diameter of the true one, as far as the
   * robust method can tell; of the staged method and of a mirror plane a measure of fit. 0 without a partner. */
  std::vector<float> confidences;
  /** Per point, in [0, 1]: how well its surroundings have a counterpart, by how little the map changes distances there;
   * 0 in the parts that are left out and for points that took no part. */
  std::vector<float> support;
  /** Per point. Robust method: which half is called the source side follows from the shape alone, and for most bodies
   * does not change with the pose; staged method: it is arbitrary. */
  std::vector<Side> sides;
  SideNaming naming;              ///< what decided that, where a reference was given
  std::vector<Region> regions;    ///< per point
  std::vector<Polyline> axis;     ///< the symmetry axis curve, longest part first
  std::vector<Index> extremities; ///< ends of limbs: source, target, source, target; fewer where there are fewer limbs
  std::vector<UnsupportedPart> unsupported; ///< of a partial map, the largest first
  /** Mirror planes in which the surface is its own image equally well, the one of the map among them, as far as they
   * were looked for: 12 may stand for any number. 0 where there is at most one. */
  std::size_t equal_reflections = 0;
  std::vector<AlternativeMap> alternatives; ///< on request: the reflections, best first; the first is the map above
  std::vector<AlternativeMap> rotations;    ///< on request: maps that keep the orientation, best first

  float diameter = 0.0F; ///< largest distance between landmarks, in the unit of the points
  InputSummary input;    ///< what was read, used and left out
  MapSummary map;        ///< properties of the dense map
  MirrorPlane plane;     ///< best-fit mirror plane of the dense map; see its rms
  std::vector<std::pair<std::string, double>> seconds; ///< wall time per step, in order; steps do not overlap
};

} // namespace symmetry
} // namespace pcl
