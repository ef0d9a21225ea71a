#include "kernel_tables.h"
#include "vector_lanes.h"

namespace pcl {
namespace symmetry {

#include "nearest_rows.inc"

const KernelTable baseline_kernels{nearestRows};

} // namespace symmetry
} // namespace pcl
