/** \file
 * \brief A file that appears whole or not at all.
 */
#pragma once

#include "io/write/unfinished_files.h"

#include <string>
#include <string_view>

namespace pcl {
namespace symmetry {

/** \brief The name of standard output, and for readers that of standard input. */
constexpr const char* standard_stream = "-";

/** \brief Writes beside the place of a file and moves the result there at the end.
 *
 * Until commit() a file that was there before stays as it was; without commit() nothing is left behind, but by a process
 * that is killed: what such a one has left is cleared away by the next that writes the same file. A link is followed. A
 * file that may not be written to stays. What cannot be replaced is written to directly: a device, a pipe, "-" (standard
 * output), and what the process has open already (/dev/stdout, /dev/fd/3), be it a file: who has redirected standard
 * output to the end of a log wants the log to stay.
 */
class OutputFile {
public:
  /** \brief Creates the temporary file.
   * \throws pcl::IOException the folder is missing or cannot be written to, or the name is too long */
  explicit OutputFile(const std::string& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile&
  operator=(const OutputFile&) = delete;
  OutputFile(OutputFile&&) = delete;
  OutputFile&
  operator=(OutputFile&&) = delete;
  ~OutputFile();

  /** \brief Appends to what has been written so far.
   * \throws pcl::IOException cannot be written, for instance since the disk is full */
  void
  write(std::string_view bytes);

  /** \brief Makes the file appear, on the disk.
   * \throws pcl::IOException cannot be written or moved; nothing is left behind then */
  void
  commit();

private:
  void
  createBeside(unsigned mode, bool exists);

  bool
  moveIntoPlace();

  [[noreturn]] void
  failWithSystemError() const;

  std::string path_;      ///< as the caller gave it, for messages
  std::string target_;    ///< \a path_ with links followed
  std::string temporary_; ///< empty where \a target_ is written to directly
  UnfinishedFile unfinished_;
  int descriptor_ = -1;
};

/** \brief Throws unless a file can be written there; leaves no trace.
 * \throws pcl::IOException */
void
checkOutputFile(const std::string& path);

/** \brief Whether two names lead to one file, there or not; one may be empty. */
bool
areOneFile(const std::string& a, const std::string& b);

/** \brief Writes \a content as one file, whole or not at all.
 * \throws pcl::IOException */
void
writeWholeFile(const std::string& path, std::string_view content);

} // namespace symmetry
} // namespace pcl
