/** \file
 * \brief Strict reading of text, line by line and word by word, without copying.
 */
#pragma once

#include "io/read/file_content.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace pcl {
namespace symmetry {

/** \brief What a text format makes of special characters. */
struct TextSyntax {
  bool hash_comments = false;       ///< `#` hides the rest of the line
  bool backslash_continues = false; ///< a backslash at the end of a line joins the next one to it
  char separator = ' ';             ///< parts words as blanks do
};

/** \brief Walks through the lines of a text and the words of each line.
 *
 * A line ends with LF, CR LF or CR. Lines without a word are passed over. Call nextLine() before the first word.
 */
class TextScanner {
public:
  /** \param[in] file text; must outlive the scanner
   * \param[in] syntax special characters of the format
   * \param[in] begin byte to start at
   * \param[in] line number of the line that \a begin is on
   */
  explicit TextScanner(const FileContent& file, TextSyntax syntax = {}, std::size_t begin = 0, std::size_t line = 1);

  /** \brief Goes to the next line that holds a word, leaving unread what is left of this one; false at the end. */
  bool
  nextLine();

  /** \brief Goes to the line behind this one, even where it holds no word, leaving unread what is left of this one; false
   * at the end. */
  bool
  nextLineOrEmpty();

  /** \brief Goes to the next line that holds a word.
   * \throws pcl::IOException the text ends instead: "`expected` ..."
   */
  void
  needLine(const char* expected);

  /** \brief The next word of the line; empty at its end. */
  std::string_view
  word();

  /** \brief True where the line holds no further word. */
  bool
  atLineEnd();

  /** \brief The next word of the line as a number; nan and inf in any case are numbers, what is too large for a float
   * is infinite.
   * \throws pcl::IOException there is no further word, or it is no number */
  float
  number();

  /** \brief The next word of the line as a number with the digits of a double; otherwise as number(). */
  double
  preciseNumber();

  /** \brief The next word of the line as a number, relative to \a origin: subtracted in double precision, so that what
   * a float cannot tell apart far from zero is told apart near the origin.
   * \throws pcl::IOException there is no further word, or it is no number */
  float
  numberFrom(double origin);

  /** \brief The next word of the line as an integer.
   * \throws pcl::IOException there is none, or it is no integer */
  std::int64_t
  integer();

  /** \brief The next characters, up to \a count. */
  std::string_view
  ahead(std::size_t count) const
  {
    return {next_, std::min(count, remaining())};
  }

  /** \brief Makes sure that the line is read to its end.
   * \throws pcl::IOException the line holds a further word */
  void
  needLineEnd();

  /** \brief Goes behind the end of the line.
   * \throws pcl::IOException the line holds a further word */
  void
  finishLine();

  /** \brief Number of the current line, from 1. */
  std::size_t
  line() const
  {
    return line_;
  }

  /** \brief Byte of the next character. */
  std::size_t
  position() const
  {
    return static_cast<std::size_t>(next_ - file_.data());
  }

  /** \brief Bytes from here to the end of the file. */
  std::size_t
  remaining() const
  {
    return static_cast<std::size_t>(end_ - next_);
  }

  /** \brief Complains about the current line.
   * \throws pcl::IOException naming file and current line, always */
  [[noreturn]] void
  fail(const std::string& reason) const
  {
    file_.failAtLine(line_, reason);
  }

private:
  template <typename Number>
  Number
  parseNumber();

  void
  skipBlanks();

  void
  passLineEnd();

  bool
  isBlank(char c) const
  {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == syntax_.separator;
  }

  bool
  endsWord(const char* character) const;

  const FileContent& file_;
  TextSyntax syntax_;
  const char* next_;
  const char* end_;
  std::size_t line_;
  bool in_line_ = false;
};

/** \brief A word as an integer.
 * \return false where it is none, or has anything behind it, or does not fit */
bool
parseInteger(std::string_view word, std::int64_t& value);

/** \brief Letters A-Z of \a word made small. */
std::string
toLower(std::string_view word);

/** \brief A word for an error message: quoted, and cut where it is long or not printable. */
std::string
quoted(std::string_view word);

} // namespace symmetry
} // namespace pcl
