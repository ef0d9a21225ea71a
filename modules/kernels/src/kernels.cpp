#include "kernels/kernels.h"

#include "kernel_tables.h"

namespace pcl {
namespace symmetry {

const KernelTable&
kernelsFor(InstructionSet set)
{
#ifdef PCL_SYMMETRY_X86_KERNELS
  switch (set) {
  case InstructionSet::Avx512:
    return avx512_kernels;
  case InstructionSet::Avx2:
    return avx2_kernels;
  default:
    break;
  }
#else
  static_cast<void>(set);
#endif
  return baseline_kernels;
}

const KernelTable&
kernels()
{
  static const KernelTable& table = kernelsFor(instructionSetInUse());
  return table;
}

} // namespace symmetry
} // namespace pcl
