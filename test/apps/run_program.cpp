#include "apps/run_program.h"

#include <cerrno>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace test {

namespace {

/** \brief Where a child's stdout and stderr go. */
class Redirection {
public:
  Redirection(const std::string& output, const std::string& errors)
  {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
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

} // namespace

ProgramRun
runProgram(const std::string& name, const std::vector<std::string>& arguments)
{
  std::vector<std::string> words{std::string(PCL_SYMMETRY_PROGRAM_FOLDER) + "/" + name};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);

  const ScratchFolder folder;
  const std::string output = folder.file("output");
  const std::string errors = folder.file("errors");
  pid_t child = 0;
  const int failure = posix_spawn(&child, argv[0], Redirection(output, errors).get(), nullptr, argv.data(), environ);
  if (failure != 0)
    throw std::system_error(failure, std::generic_category(), words[0]);
  int status = 0;
  while (waitpid(child, &status, 0) == -1)
    if (errno != EINTR)
      throw std::system_error(errno, std::generic_category(), "waitpid");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readBytes(output), readBytes(errors)};
}

} // namespace test
} // namespace symmetry
} // namespace pcl
