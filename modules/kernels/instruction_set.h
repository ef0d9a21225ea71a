/** \file
 * \brief Which vector units the machine has, found when the program runs.
 */
#pragma once

#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Instruction sets for which the kernels of this module exist, each a superset of the one before it. */
enum class InstructionSet { Baseline, Avx2, Avx512 };

/** \brief "baseline", "avx2" or "avx512". */
const char*
instructionSetName(InstructionSet set);

/** \brief Those that this machine and this build have, rising; Baseline is always among them. */
std::vector<InstructionSet>
availableInstructionSets();

/** \brief The one in use: the highest available one, at most that named by the environment variable
 * PCL_SYMMETRY_INSTRUCTION_SET (a name as above; anything else is ignored). Results do not depend on it, only the speed
 * does. Read once; thread-safe. */
InstructionSet
instructionSetInUse();

} // namespace symmetry
} // namespace pcl
