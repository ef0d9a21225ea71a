/** \file
 * \brief A folder of its own for each test, and small files in it.
 */
#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Fixture with an empty folder that is removed after the test. */
class TemporaryFolder : public ::testing::Test {
protected:
  TemporaryFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "pcl_symmetry_XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }

  ~TemporaryFolder() override
  {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::string
  path(const std::string& name) const
  {
    return (folder_ / name).string();
  }

  std::string
  writeFile(const std::string& name, const std::string& content) const
  {
    // Some file systems wait for the disk when a file is emptied and written anew.
    std::filesystem::remove(path(name));
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

  std::string
  readFile(const std::string& name) const
  {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }

  std::size_t
  countFiles() const
  {
    const std::filesystem::directory_iterator files(folder_);
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }

private:
  std::filesystem::path folder_;
};

/** \brief The bytes of numbers, one after the other, in this machine's byte order or the other one. */
class Bytes {
public:
  explicit Bytes(bool big_endian = false) : big_endian_(big_endian)
  {
  }

  template <typename... Numbers>
  Bytes&
  add(Numbers... numbers)
  {
    (append(numbers), ...);
    return *this;
  }

  const std::string&
  str() const
  {
    return bytes_;
  }

private:
  template <typename Number>
  void
  append(Number number)
  {
    std::string bytes(sizeof(number), '\0');
    std::memcpy(bytes.data(), &number, sizeof(number));
    bytes_ += big_endian_ ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
  }

  bool big_endian_;
  std::string bytes_;
};

} // namespace test
} // namespace symmetry
} // namespace pcl
