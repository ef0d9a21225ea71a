/** \file
 * \brief Runs one of the project's programs as a user does and keeps what it says.
 */
#pragma once

#include "support/temporary_folder.h"

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

struct ProgramRun {
  int exit_status = -1; ///< -1: ended by a signal
  std::string output;   ///< stdout
  std::string errors;   ///< stderr
};

/** \brief Runs a program of the build folder, without a shell in between.
 * \throws std::system_error it cannot be started */
ProgramRun
runProgram(const std::string& name, const std::vector<std::string>& arguments);

} // namespace test
} // namespace symmetry
} // namespace pcl
