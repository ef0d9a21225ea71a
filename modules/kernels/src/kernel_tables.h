/** \file
 * \brief The table of each instruction set; which of them exist depends on the machine the project is built for.
 */
#pragma once

#include "kernels/kernel_table.h"

namespace pcl {
namespace symmetry {

extern const KernelTable baseline_kernels;
extern const KernelTable avx2_kernels;
extern const KernelTable avx512_kernels;

} // namespace symmetry
} // namespace pcl
