/** \file
 * \brief What all programs have in common: exit statuses, and the place where errors become messages.
 */
#pragma once

#include "base/error_text.h"

#include <functional>
#include <stdexcept>

namespace pcl {
namespace symmetry {

constexpr int exit_done = 0;
constexpr int exit_failed = 1; ///< cannot read, write or compute
constexpr int exit_usage = 2;
constexpr int exit_no_symmetry = 3;

/** \brief A mistake in the command line. */
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/** \brief Runs a check of what the command line asks for: a \a Mistake that it throws is a mistake of usage. */
template <typename Mistake, typename Check>
void
checkUsage(Check check)
{
  try {
    check();
  }
  catch (const Mistake& mistake) {
    throw UsageError(errorText(mistake));
  }
}

/** \brief Has a function called when a signal ends the program. It may do only what a signal handler may. */
void
cleanUpOnSignal(void (*clean_up)() noexcept);

/** \brief Runs a program: what it throws ends as one message on stderr that begins with the program's name.
 *
 * SIGINT, SIGTERM, SIGHUP and SIGPIPE end the program with 128 more than their number as the exit status, after what is
 * half written has been removed; one that was ignored before (nohup) stays so. What was printed is flushed at the end: a program that cannot say what it found has failed.
 * \param[in] name of the program
 * \param[in] run returns the exit status
 * \return the exit status: exit_usage after a UsageError, exit_failed after any other exception
 */
int
runProgram(const char* name, const std::function<int()>& run);

} // namespace symmetry
} // namespace pcl
