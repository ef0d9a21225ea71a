/** \file
 * \brief Disturbs a surface as a scanner would, and remembers which point is which.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief What is done to a surface before it is run. */
struct Disturbance {
  double noise = 0.0;    ///< standard deviation of a point's way, share of the bounding box's diagonal, [0, 1]
  double drop = 0.0;     ///< share of the points that are left out at random, with their faces, [0, 0.99]
  double outliers = 0.0; ///< points added at random in and around the bounding box, share of those left, [0, 1]
  std::uint64_t seed = 1;
  std::size_t holes = 0;   ///< round patches that are cut out
  double hole_share = 0.2; ///< of the points, in all holes together, [0, 0.9]
  double thin = 1.0;       ///< density at one end over that at the other, points drop out in between, [1, 1000]
  double quantise = 0.0;   ///< coordinates are rounded to multiples of this share of the diagonal, [0, 1]
  double bend = 0.0;       ///< radians over the diagonal by which space is bent and twisted, [0, 3]
  double repeat = 0.0;     ///< points that are there twice, share of those left, [0, 1]

  /** \brief Whether any surface is left as it is. */
  bool
  changesNothing() const
  {
    return !(noise > 0.0 || drop > 0.0 || outliers > 0.0 || holes > 0 || thin > 1.0 || quantise > 0.0 || repeat > 0.0 ||
             bend > 0.0);
  }
};

/** \brief Throws unless all shares are in their range.
 * \throws pcl::BadArgumentException names the share, its value and the range */
void
checkDisturbance(const Disturbance& disturbance);

/** \brief A disturbed surface. */
struct DisturbedSurface {
  Surface surface;
  std::vector<Index> origins; ///< per point of \a surface: its number before, no_index for an outlier
};

/** \brief Drops points at random, in holes and towards one end, then bends, adds noise, rounds, repeats points and adds
 * outliers; the same seed gives the same bytes.
 * \throws pcl::BadArgumentException as checkDisturbance() */
DisturbedSurface
disturb(const Surface& surface, const Disturbance& disturbance);

/** \brief Takes a map of a disturbed surface back to the \a points of the surface before; points that were dropped have
 * no partner, and neither has a point whose partner is an outlier. */
std::vector<Index>
undisturbMap(const std::vector<Index>& partners, const std::vector<Index>& origins, std::size_t points);

} // namespace symmetry
} // namespace pcl
