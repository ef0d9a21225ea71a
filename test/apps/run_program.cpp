#include "apps/run_program.h"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace test {

namespace {

/** \brief Where a child's stdin comes from, and its stdout and stderr go. */
class Redirection {
public:
  Redirection(const Streams& streams, const std::string& output, const std::string& errors)
  {
    constexpr int write = O_WRONLY | O_CREAT;
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, streams.input.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, output.c_str(),
                                     write | (streams.output.empty() ? O_TRUNC : O_APPEND), 0600);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, errors.c_str(), write | O_TRUNC, 0600);
  }
  ~Redirection()
  {
    posix_spawn_file_actions_destroy(&actions_);
  }
  Redirection(const Redirection&) = delete;
  Redirection&
  operator=(const Redirection&) = delete;
  Redirection(Redirection&&) = delete;
  Redirection&
  operator=(Redirection&&) = delete;

  const posix_spawn_file_actions_t*
  get() const
  {
    return &actions_;
  }

private:
  posix_spawn_file_actions_t actions_{};
};

double
secondsOf(const timeval& time)
{
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

} // namespace

StartedProgram::StartedProgram(const std::string& name,
                               const std::vector<std::string>& arguments,
                               const Streams& streams)
    : output_(streams.output.empty() ? folder_.file("output") : streams.output), errors_(folder_.file("errors"))
{
  std::vector<std::string> words{std::string(PCL_SYMMETRY_PROGRAM_FOLDER) + "/" + name};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);

  const Redirection redirection(streams, output_, errors_);
  const int failure = posix_spawn(&child_, argv[0], redirection.get(), nullptr, argv.data(), environ);
  if (failure != 0)
    throw std::system_error(failure, std::generic_category(), words[0]);
  if (streams.cpu_seconds > 0) {
    const rlimit limit = {streams.cpu_seconds, streams.cpu_seconds};
    ::prlimit(child_, RLIMIT_CPU, &limit, nullptr);
  }
}

void
StartedProgram::send(int signal) const
{
  ::kill(child_, signal);
}

ProgramRun
StartedProgram::wait()
{
  int status = 0;
  rusage used = {};
  while (wait4(child_, &status, 0, &used) == -1)
    if (errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "wait4");
  constexpr double kilobytes = 1024.0;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readBytes(output_), readBytes(errors_),
          secondsOf(used.ru_utime) + secondsOf(used.ru_stime), static_cast<double>(used.ru_maxrss) / kilobytes};
}

ProgramRun
runProgram(const std::string& name, const std::vector<std::string>& arguments, const Streams& streams)
{
  return StartedProgram(name, arguments, streams).wait();
}

} // namespace test
} // namespace symmetry
} // namespace pcl
