/** \file
 * \brief A folder for the files of one test.
 */
#pragma once

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Bytes of a file.
 * \throws std::runtime_error cannot be opened */
inline std::string
readBytes(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file)
    throw std::runtime_error("cannot open " + path.string());
  return {std::istreambuf_iterator<char>(file), {}};
}

/** \brief A fresh folder, removed with everything in it at the end. */
class ScratchFolder {
public:
  ScratchFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "pcl_symmetry.XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(), pattern);
    path_ = pattern;
  }
  ~ScratchFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
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

/** \brief Base of tests that need files; the folder goes with the test. */
class TemporaryFolder : public ::testing::Test {
protected:
  std::string
  path(const std::string& name) const
  {
    return folder_.file(name);
  }

  /** \brief Writes a file, and the folders on the way to it; returns its path. */
  std::string
  write(const std::string& name, const std::string& content) const
  {
    const std::filesystem::path file = path(name);
    std::filesystem::create_directories(file.parent_path());
    // Some file systems wait for the disk when a file is emptied and written anew.
    std::filesystem::remove(file);
    std::ofstream(file, std::ios::binary) << content;
    return file.string();
  }

  static std::string
  read(const std::string& file)
  {
    return readBytes(file);
  }

  std::size_t
  countFiles() const
  {
    const std::filesystem::directory_iterator files(folder_.path());
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }

private:
  ScratchFolder folder_;
};

} // namespace test
} // namespace symmetry
} // namespace pcl
