#include "kernel_tables.h"
#include "vector_lanes.h"

namespace pcl {
namespace symmetry {

#include "interleaved_sums.inc"
#include "min_plus.inc"
#include "nearest_rows.inc"
#include "slab_moments.inc"
#include "transpose.inc"
#include "weighted_distance.inc"

const KernelTable avx2_kernels{nearestRows,   minPlus,           minPlusPicked,        closeTile,
                               transposeTile, weightedDistances, weightedBoxDistances, slabMoments};

} // namespace symmetry
} // namespace pcl
