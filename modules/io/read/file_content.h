/** \file
 * \brief A file read into memory, and the way every reader complains about it.
 */
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace pcl {
namespace symmetry {

/** \brief The bytes of one regular file, or of standard input. */
class FileContent {
public:
  /** \brief Reads the file in one go; "-" is standard input, of which at most 4 GiB are read.
   * \throws pcl::IOException is missing, empty, a directory or another special file, or cannot be read
   */
  explicit FileContent(const std::string& path);

  /** \brief Replaces the bytes by what they are the gzip compression of, one member or several.
   * \throws pcl::IOException is not, is truncated or damaged, or unpacks to more than mostUnpacked() */
  void
  unpackGzip();

  bool
  isGzip() const
  {
    return view().substr(0, 2) == "\x1F\x8B";
  }

  const char*
  data() const
  {
    return bytes_.get();
  }

  std::size_t
  size() const
  {
    return size_;
  }

  std::string_view
  view() const
  {
    return {bytes_.get(), size_};
  }

  /** \brief Complains about the file as a whole.
   * \throws pcl::IOException "file: reason", always */
  [[noreturn]] void
  fail(const std::string& reason) const;

  /** \brief Complains about a line of a text.
   * \throws pcl::IOException "file: line n: reason", always; lines count from 1 */
  [[noreturn]] void
  failAtLine(std::size_t line, const std::string& reason) const;

  /** \brief Complains about a place in binary data.
   * \throws pcl::IOException "file: byte n: reason", always; bytes count from 0 */
  [[noreturn]] void
  failAtByte(std::size_t byte, const std::string& reason) const;

private:
  void
  readRegular(int descriptor, std::size_t expected);

  void
  readStream(int descriptor);

  void
  grow(std::size_t capacity);

  std::string path_;
  std::unique_ptr<char[]> bytes_;
  std::size_t size_ = 0;
};

} // namespace symmetry
} // namespace pcl
