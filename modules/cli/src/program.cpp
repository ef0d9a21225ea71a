#include "cli/program.h"

#include <csignal>
#include <iostream>
#include <new>

namespace pcl {
namespace symmetry {

int
runProgram(const char* name, const std::function<int()>& run)
{
  std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large is an error with a message
  const auto complain = [name](const std::string& reason) {
    std::cerr << name << ": " << reason << '\n';
    return exit_failed;
  };
  try {
    const int status = run();
    return std::cout.flush() ? status : complain("standard output: cannot be written");
  }
  catch (const UsageError& error) {
    complain(error.what());
    std::cerr << "Try '" << name << " --help'.\n";
    return exit_usage;
  }
  catch (const std::bad_alloc&) {
    return complain("out of memory");
  }
  catch (const std::exception& error) {
    return complain(errorText(error));
  }
}

} // namespace symmetry
} // namespace pcl
