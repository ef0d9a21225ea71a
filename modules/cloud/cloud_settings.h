/** \file
 * \brief The numbers that decide how a cloud is read, together in one place.
 *
 * Origin of all of them unless another is given: chosen by hand on generated bodies and scans; not fitted by a script.
 * Lengths are in the unit that is named: spacings (mean distances of points to their neighbours), radii of
 * neighbourhoods, or shares of the longest side of the surface.
 */
#pragma once

#include <cstddef>

namespace pcl {
namespace symmetry {

/** \brief Which points are on no surface, see outliers.h. Flatness is 0 of a plane and 0.58 of a ball. */
struct OutlierSettings {
  float local_ratio = 3.0F;       ///< of the distance to the neighbours over the lower quartile of theirs; above 1
  float plane_deviations = 3.0F;  ///< off the plane of the neighbours, in their standard deviations: three sigma
  float plane_distances = 0.8F;   ///< and in spacings: a point of a sparse surface may well be off by half of one
  int maximum_times = 2;          ///< a point beside the surface is a neighbour of hardly any of its neighbours
  float noise_flatness = 0.14F;   ///< of the median point, above which noise fills space as outliers do
  std::size_t probes = 1000;      ///< points that the median flatness is taken of
  float sparse_distance = 3.0F;   ///< medians of the spacing: geometric, about that where the density is a tenth
  float filling_flatness = 0.28F; ///< few points at random are rarely flatter, a surface rarely fuller
  int spreading_rounds = 3;       ///< outliers that only have each other are found within so many steps
};

/** \brief Clouds of even density and bounded size, see resampled_cloud.h. */
struct ResamplingSettings {
  float smoothed_spacing = 0.5F;    ///< of the points that are moved onto sheets, over the spacing that is left
  float maximum_gap = 3.0F;         ///< medians of the gaps: how large an area one point may stand for
  float minimum_support = 0.05F;    ///< share of the typical support: the density may well vary by ten
  float least_spacing = 1e-6F;      ///< of a cloud of unit size; distances of points may be 0 to all digits
  float spacing_step = 1.1F;        ///< factor from try to try; above 1, so that the search ends
  float gaps_per_radius = 1.0F;     ///< of the discs that stand for the surface
  float spacings_per_radius = 0.7F; ///< geometric: half the diagonal of a square, so that discs on a grid leave no gap
  float nearby_distance = 2.0F;     ///< spacings of a point in use within which it stands for what was left out
  /** Of the cube around the points, that they fill: geometric, half of what a ball does. Thick with noise, bodies fill some
   * hundredths of it, a shell a tenth. */
  double filled_share = 0.26;
  float parted_clearance = 0.125F; ///< share of the clearance by which two merged sheets are moved apart
};

/** \brief Noise and how it is smoothed, see sheet_smoothing.h. */
struct SmoothingSettings {
  float first_radius = 2.2F;    ///< spacings; with fewer points around, any plane fits
  float maximum_radius = 0.06F; ///< share of the longest side: about that of a limb
  float radius_step = 1.25F;    ///< factor from radius to radius
  /** Thickness over the first radius, without curvature, up to which there is no noise: 0.09 at the median neighbourhood,
   * and at the lower quartile 0.82 times that, as performance/noise_quantiles.py has it of a plane with noise alone. */
  float flat = 0.074F;
  /** Quantile of the neighbourhoods that is compared: noise is everywhere, contacts are over half of a curled up body. By
   * hand, and not moved after the first trial. */
  double flat_share = 0.25;
  float certain_radius = 1.25F;     ///< flattest radii: with more points planes gain in certainty more than they lose
  float minimum_spacings = 6.0F;    ///< of a radius; with fewer points around, planes are uncertain
  float spacings_per_radius = 6.0F; ///< of points that show all that is left to see
  float width_of_thickness = 3.0F;  ///< half a sheet over its standard deviation: three sigma
  float normal_tolerance = 0.0375F; ///< radians: standard deviation of a normal that is certain
  std::size_t minimum_points = 80;  ///< of a neighbourhood of the least radius
  std::size_t plane_points = 500;   ///< more make no better plane
  /** Neighbourhoods by which it is told whether there is noise: all of a small cloud, whose verdict must not hang on the
   * order of the points. */
  std::size_t noise_probes = 6000;
  std::size_t thickness_probes = 600; ///< neighbourhoods that the thickness is the median of
  std::size_t number_probes = 300;    ///< neighbourhoods whose points are counted
  int rounds = 4;                     ///< each takes a place nearer to the middle of its sheet by more than a half
  float minimum_share = 0.1F;         ///< of the weight around, within the sheet: less has an outlier, a fork has more
};

/** \brief Two sheets of a surface that are nearer to each other than neighbours, see sheet_normals.h and
 * merged_sheets.h. Cubes are those of the space around. */
struct SheetSettings {
  float thickness = 0.3F;         ///< mean distances of the neighbours
  float minimum_share = 0.6F;     ///< of the neighbours in the plane of a point that is in one sheet
  int fitting_rounds = 3;         ///< of the plane through those near it
  float normal_difference = 0.1F; ///< one less the cosine at which a neighbour counts 1 / e: some 26 degrees
  float finest_cube = 1.5F;       ///< spacings; finer cubes leave gaps between the points
  float cube_step = 0.25F;        ///< spacings from one size of the cubes to the next
  int views = 7;                  ///< sizes: up to three spacings
  float closed = 0.9F;            ///< share of the places that must have an inside
  float reach = 2.0F;             ///< cubes: how far the outside is looked for
  float probe_step = 0.25F;       ///< cubes: step of that search
  float doubt = 0.5F;             ///< cubes by which one side must be nearer to the outside
  float opposed = -0.5F;          ///< cosine of normals; geometric: at a sharp edge they turn by a right angle
  double maximum_cubes = 1.6e7;   ///< a byte of memory each
  float cube_growth = 1.1F;       ///< factor from try to try to stay below that; above 1
};

/** \brief Edges of a cloud that are shortcuts, and links across its gaps, see cloud_surface.h. */
struct ContactSettings {
  float steep = 0.7F;         ///< sine of the angle between an edge and the surface: geometric, half a right angle
  float short_edge = 0.5F;    ///< spacings up to which noise may well point along the normal
  float step_excess = 5.0F;   ///< medians of all steps; see ContactTest::step
  float clearance = 0.6F;     ///< depths: where the surface bends inwards it comes nearer than the depth
  float barrier_piece = 8.0F; ///< depths that are searched at a time: four cubes of the grid
  /** Depths: no contact has longer edges, bodies ten times sparser at one end have them up to 13; bounds the time. */
  float longest_barred = 64.0F;
  /** Points that are looked at for each of those pieces: several times as many as clouds of bodies, objects and scans have
   * there. Where half of all points are nearer to each other than the depth it would be all of them, for every edge. */
  std::size_t barrier_points = 2048;
  /** Nearest neighbours to which edges are put back, and along which ways round them are looked for: those to more are
   * long, and keep nothing together. The usual number is 10; of 256 each search would take a thousand times as long. */
  std::size_t restored_neighbours = 32;
  /** Points that are passed on the way round one such edge: several times as many as those clouds have. */
  std::size_t restored_points = 4096;
  float maximum_gap = 0.05F; ///< share of the longest side that a link may bridge
  int minimum_part = 20;     ///< points; less is a speck and stays apart
  float way_ratio = 2.0F;    ///< length of a link over that of the shortest between the same parts
};

/** \brief Planes and triangles around a point, see cloud_normals.h and local_delaunay.h. */
struct FanSettings {
  float falloff = 2.0F;         ///< of the weight exp (-falloff (d / radius)^2) of a neighbour in a plane
  float maximum_gap = 2.6F;     ///< radians, 150 degrees: wider gaps in a fan stay open
  float cotangent_bound = 5.0F; ///< 11 degrees: slivers must not take over
};

} // namespace symmetry
} // namespace pcl
