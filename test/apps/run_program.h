/** \file
 * \brief Runs one of the project's programs as a user does and keeps what it says.
 */
#pragma once

#include <filesystem>
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

/** \brief Bytes of a file.
 * \throws std::runtime_error cannot be opened */
std::string
readBytes(const std::filesystem::path& path);

/** \brief A fresh folder for one test, removed with everything in it at the end. */
class ScratchFolder {
public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder&
  operator=(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&&) = delete;
  ScratchFolder&
  operator=(ScratchFolder&&) = delete;

  std::string
  file(const std::string& name) const
  {
    return (path_ / name).string();
  }

  const std::filesystem::path&
  path() const
  {
    return path_;
  }

private:
  std::filesystem::path path_;
};

} // namespace test
} // namespace symmetry
} // namespace pcl
