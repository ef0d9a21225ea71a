/** \file
 * \brief A folder for the files of one test.
 */
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Base of tests that need files; the folder goes with the test. */
class TemporaryFolder : public ::testing::Test {
public:
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder&
  operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder&
  operator=(TemporaryFolder&&) = delete;

  ~TemporaryFolder() override
  {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

protected:
  TemporaryFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "pcl_symmetry_test_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
      throw std::runtime_error("no folder for temporary files");
    folder_ = pattern;
  }

  std::string
  path(const std::string& name) const
  {
    return (folder_ / name).string();
  }

  /** \brief Writes a file, and the folders on the way to it; returns its path. */
  std::string
  write(const std::string& name, const std::string& content) const
  {
    const std::filesystem::path file = folder_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
    return file.string();
  }

  static std::string
  read(const std::string& file)
  {
    std::ostringstream content;
    content << std::ifstream(file, std::ios::binary).rdbuf();
    return content.str();
  }

private:
  std::filesystem::path folder_;
};

/** \brief Message of the exception that a call throws; empty where it throws none. */
template <typename Exception, typename Call>
std::string
messageOf(Call call)
{
  try {
    call();
  }
  catch (const Exception& error) {
    return error.what();
  }
  return {};
}

} // namespace test
} // namespace symmetry
} // namespace pcl
