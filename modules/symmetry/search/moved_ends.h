/** \file
 * \brief How many ends of limbs a map sends elsewhere.
 */
#pragma once

#include "symmetry/samples/landmark_surface.h"
#include "symmetry/samples/sample_map.h"

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The ends of the limbs of a surface, where limbs are seen best: a map that turns front to back and leaves each limb
 * where it is, mirrored in itself, moves the trunk as far as one that exchanges the limbs, and keeps distances as well. */
class MovedEnds {
public:
  /** \param[in] landmarks referred to, not copied */
  explicit MovedEnds(const LandmarkSurface& landmarks);

  /** \brief Share of the ends that go to another limb, in [0, 1], of all but two: a head and a tail stay where they are, and
   * what sends these to each other as well has no advantage. 0 where there are two ends or fewer. */
  float
  share(const SampleMap& map) const;

private:
  const LandmarkSurface& landmarks_;
  std::vector<Index> ends_;
};

} // namespace symmetry
} // namespace pcl
