#include "kernels/instruction_set.h"

#include <cstdlib>
#include <cstring>

namespace pcl {
namespace symmetry {
namespace {

bool
isAvailable(InstructionSet set)
{
#ifdef PCL_SYMMETRY_X86_KERNELS
  switch (set) {
  case InstructionSet::Baseline:
    return true;
  case InstructionSet::Avx2:
    return __builtin_cpu_supports("avx2") != 0;
  case InstructionSet::Avx512:
    return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
           __builtin_cpu_supports("avx512vl") != 0;
  }
#endif
  return set == InstructionSet::Baseline;
}

InstructionSet
chooseInstructionSet()
{
  const std::vector<InstructionSet> available = availableInstructionSets();
  if (const char* wanted = std::getenv("PCL_SYMMETRY_INSTRUCTION_SET")) {
    for (const InstructionSet set : available) {
      if (std::strcmp(wanted, instructionSetName(set)) == 0) {
        return set;
      }
    }
  }
  return available.back();
}

} // namespace

const char*
instructionSetName(InstructionSet set)
{
  switch (set) {
  case InstructionSet::Avx2:
    return "avx2";
  case InstructionSet::Avx512:
    return "avx512";
  default:
    return "baseline";
  }
}

std::vector<InstructionSet>
availableInstructionSets()
{
  std::vector<InstructionSet> available;
  for (const InstructionSet set : {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
    if (isAvailable(set)) {
      available.push_back(set);
    }
  }
  return available;
}

InstructionSet
instructionSetInUse()
{
  static const InstructionSet set = chooseInstructionSet();
  return set;
}

} // namespace symmetry
} // namespace pcl
