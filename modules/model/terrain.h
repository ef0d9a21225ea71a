/** \file
 * \brief A patch of random hills.
 */
#pragma once

#include "model/random_numbers.h"

#include <pcl/symmetry/surface.h>

#include <cstddef>

namespace pcl {
namespace symmetry {

/** \brief A crooked quadrangle with about \a vertices vertices on random hills: one boundary, no symmetry. */
Surface
makeTerrain(std::size_t vertices, RandomNumbers& random);

} // namespace symmetry
} // namespace pcl
