#include "kernel_tables.h"
#include "vector_lanes.h"

namespace pcl {
namespace symmetry {

#include "nearest_rows.inc"

const KernelTable avx2_kernels{nearestRows};

} // namespace symmetry
} // namespace pcl
