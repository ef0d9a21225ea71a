/** \file
 * \brief The table of kernels for this machine.
 */
#pragma once

#include "kernels/instruction_set.h"
#include "kernels/kernel_table.h"

namespace pcl {
namespace symmetry {

/** \brief Kernels for one instruction set, which must be available. */
const KernelTable&
kernelsFor(InstructionSet set);

/** \brief Kernels for instructionSetInUse (). */
const KernelTable&
kernels();

} // namespace symmetry
} // namespace pcl
