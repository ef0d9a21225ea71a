/** \file
 * \brief Reads small text tables strictly: every complaint names file, line and reason.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The lines of a text file, one after the other, split into words. */
class TextLines {
public:
  /** \brief Opens \a path.
   * \param[in] path file to read
   * \param[in] separators characters between words, besides blanks
   * \throws pcl::IOException cannot be opened
   */
  explicit TextLines(const std::string& path, std::string_view separators = "");

  /** \brief Goes to the next line that is not blank; false at the end of the file.
   * \throws pcl::IOException cannot be read to the end */
  bool
  next();

  /** \brief Words of the current line; valid until the next call of next(). */
  const std::vector<std::string_view>&
  words() const
  {
    return words_;
  }

  /** \brief A word as an integer.
   *
   * \throws pcl::IOException is none, or does not fit */
  Index
  toInteger(std::string_view word) const;

  /** \brief A word as a number; "nan" in any case is one.
   *
   * \throws pcl::IOException is none */
  double
  toNumber(std::string_view word) const;

  /** \brief Ends the reading with a message that begins with file and current line.
   * \throws pcl::IOException always */
  [[noreturn]] void
  fail(const std::string& reason) const;

private:
  std::string path_;
  std::string separators_;
  std::ifstream file_;
  std::string line_;
  std::vector<std::string_view> words_;
  std::size_t line_number_ = 0;
};

} // namespace symmetry
} // namespace pcl
