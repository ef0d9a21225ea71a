/** \file
 * \brief Runs one of the project's programs as a user does and keeps what it says.
 */
#pragma once

#include "support/temporary_folder.h"

#include <string>
#include <sys/types.h>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {

struct ProgramRun {
  int exit_status = -1; ///< -1: ended by a signal
  std::string output;   ///< stdout
  std::string errors;   ///< stderr
  double cpu_seconds = 0.0;
  double megabytes = 0.0; ///< of memory in use at the same time
};

/** \brief What a program is connected to. */
struct Streams {
  std::string input = "/dev/null";
  std::string output;       ///< a file that stdout is appended to; empty: kept in ProgramRun::output
  unsigned cpu_seconds = 0; ///< after so many it is killed; 0: never
};

/** \brief A program of the build folder that runs, without a shell in between. */
class StartedProgram {
public:
  /** \throws std::system_error it cannot be started */
  StartedProgram(const std::string& name, const std::vector<std::string>& arguments, const Streams& streams = {});
  StartedProgram(const StartedProgram&) = delete;
  StartedProgram&
  operator=(const StartedProgram&) = delete;
  StartedProgram(StartedProgram&&) = delete;
  StartedProgram&
  operator=(StartedProgram&&) = delete;

  void
  send(int signal) const;

  /** \brief Waits for its end; once. */
  ProgramRun
  wait();

private:
  ScratchFolder folder_;
  std::string output_;
  std::string errors_;
  pid_t child_ = 0;
};

/** \brief Runs a program of the build folder.
 * \throws std::system_error it cannot be started */
ProgramRun
runProgram(const std::string& name, const std::vector<std::string>& arguments, const Streams& streams = {});

} // namespace test
} // namespace symmetry
} // namespace pcl
