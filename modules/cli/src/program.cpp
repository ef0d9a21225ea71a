#include "cli/program.h"

#include "io/write/unfinished_files.h"

#include <array>
#include <atomic>
#include <csignal>
#include <iostream>
#include <new>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace {

/** \brief What is to be done when a signal comes; empty places are null. */
std::array<std::atomic<void (*)() noexcept>, 4> clean_ups{};

extern "C" void
endBySignal(int signal)
{
  for (const auto& clean_up : clean_ups) {
    if (auto* const function = clean_up.load()) {
      function();
    }
  }
  constexpr int exit_signal = 128; // as shells report it
  ::_exit(exit_signal + signal);
}

void
handleSignals()
{
  cleanUpOnSignal(removePartFiles);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
    struct sigaction present = {};
    if (::sigaction(signal, nullptr, &present) != 0 || present.sa_handler != SIG_DFL) {
      continue;
    }
    struct sigaction wanted = {};
    wanted.sa_handler = endBySignal;
    sigfillset(&wanted.sa_mask);
    ::sigaction(signal, &wanted, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large is an error with a message
}

} // namespace

void
cleanUpOnSignal(void (*clean_up)() noexcept)
{
  for (auto& place : clean_ups) {
    void (*expected)() noexcept = nullptr;
    if (place.load() == clean_up || place.compare_exchange_strong(expected, clean_up)) {
      return;
    }
  }
}

int
runProgram(const char* name, const std::function<int()>& run)
{
  handleSignals();
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
