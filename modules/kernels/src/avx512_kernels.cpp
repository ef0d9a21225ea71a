#include "kernel_tables.h"
#include "vector_lanes.h"

namespace pcl {
namespace symmetry {

#include "min_plus.inc"
#include "nearest_rows.inc"
#include "transpose.inc"
#include "weighted_distance.inc"

const KernelTable avx512_kernels{nearestRows,   minPlus,           minPlusPicked,       closeTile,
                                 transposeTile, weightedDistances, weightedBoxDistances};

} // namespace symmetry
} // namespace pcl
