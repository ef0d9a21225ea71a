#include "io/read/text_scanner.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

bool
isLineEnd(char c)
{
  return c == '\n' || c == '\r';
}

/** \brief Skips a leading plus, which std::from_chars does not know; "+-1" stays wrong. */
const char*
skipPlus(const char* begin, const char* end)
{
  return end - begin > 1 && begin[0] == '+' && begin[1] != '-' ? begin + 1 : begin;
}

/** \brief The value of a well-formed number whose exponent does not fit: an infinity, or a zero. */
template <typename Number>
Number
parseOutOfRange(const char* begin, const char* end)
{
  long double value = 0.0L;
  const std::from_chars_result parsed = std::from_chars(begin, end, value);
  if (parsed.ec == std::errc())
    return static_cast<Number>(value);
  // Not even that holds it. Only a negative exponent makes a number that small.
  const std::string_view word(begin, static_cast<std::size_t>(parsed.ptr - begin));
  const bool tiny = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos;
  const Number magnitude = tiny ? Number{0} : std::numeric_limits<Number>::infinity();
  return *begin == '-' ? -magnitude : magnitude;
}

} // namespace

TextScanner::TextScanner(const FileContent& file, TextSyntax syntax, std::size_t begin, std::size_t line)
    : file_(file), syntax_(syntax), next_(file.data() + begin), end_(file.data() + file.size()), line_(line)
{
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (begin == 0 && file.view().substr(0, byte_order_mark.size()) == byte_order_mark)
    next_ += byte_order_mark.size();
}

void
TextScanner::passLineEnd()
{
  if (*next_ == '\r' && end_ - next_ > 1 && next_[1] == '\n')
    ++next_;
  ++next_;
  ++line_;
}

void
TextScanner::skipBlanks()
{
  while (next_ != end_) {
    if (isBlank(*next_)) {
      ++next_;
    }
    else if (*next_ == '#' && syntax_.hash_comments) {
      while (next_ != end_ && !isLineEnd(*next_))
        ++next_;
    }
    else if (*next_ == '\\' && syntax_.backslash_continues && end_ - next_ > 1 && isLineEnd(next_[1])) {
      ++next_;
      passLineEnd();
    }
    else {
      return;
    }
  }
}

bool
TextScanner::endsWord(const char* character) const
{
  return character == end_ || isBlank(*character) || isLineEnd(*character) ||
         (*character == '#' && syntax_.hash_comments) ||
         (*character == '\\' && syntax_.backslash_continues && end_ - character > 1 && isLineEnd(character[1]));
}

bool
TextScanner::nextLine()
{
  while (in_line_ && !atLineEnd()) {
    ++next_; // whatever the caller left unread
  }
  in_line_ = true;
  while (skipBlanks(), next_ != end_ && isLineEnd(*next_))
    passLineEnd();
  return next_ != end_;
}

bool
TextScanner::nextLineOrEmpty()
{
  if (in_line_) {
    while (!atLineEnd())
      ++next_;
    if (next_ != end_)
      passLineEnd();
  }
  in_line_ = true;
  return next_ != end_;
}

void
TextScanner::needLine(const char* expected)
{
  if (!nextLine())
    fail(std::string("the file ends where ") + expected + " is expected");
}

bool
TextScanner::atLineEnd()
{
  skipBlanks();
  return next_ == end_ || isLineEnd(*next_);
}

std::string_view
TextScanner::word()
{
  skipBlanks();
  const char* const begin = next_;
  while (!endsWord(next_))
    ++next_;
  return {begin, static_cast<std::size_t>(next_ - begin)};
}

template <typename Number>
Number
TextScanner::parseNumber()
{
  skipBlanks();
  const char* const begin = skipPlus(next_, end_);
  Number value = 0;
  const std::from_chars_result parsed = std::from_chars(begin, end_, value);
  if (parsed.ec == std::errc::invalid_argument || !endsWord(parsed.ptr)) {
    const std::string_view found = word();
    fail(found.empty() ? "the line ends where a number is expected" : quoted(found) + " is not a number");
  }
  next_ = parsed.ptr;
  return parsed.ec == std::errc::result_out_of_range ? parseOutOfRange<Number>(begin, end_) : value;
}

float
TextScanner::number()
{
  return parseNumber<float>();
}

double
TextScanner::preciseNumber()
{
  return parseNumber<double>();
}

float
TextScanner::numberFrom(double origin)
{
  // Rounded once where nothing is subtracted: a double on the way to a float would round twice.
  return origin == 0.0 ? number() : static_cast<float>(preciseNumber() - origin);
}

std::int64_t
TextScanner::integer()
{
  const std::string_view found = word();
  std::int64_t value = 0;
  if (!parseInteger(found, value))
    fail(found.empty() ? "the line ends where an integer is expected" : quoted(found) + " is not an integer");
  return value;
}

void
TextScanner::needLineEnd()
{
  if (!atLineEnd())
    fail("unexpected " + quoted(word()) + " behind the last value of the line");
}

void
TextScanner::finishLine()
{
  needLineEnd();
  if (next_ != end_)
    passLineEnd();
  in_line_ = false;
}

bool
parseInteger(std::string_view word, std::int64_t& value)
{
  const char* const end = word.data() + word.size();
  const std::from_chars_result parsed = std::from_chars(skipPlus(word.data(), end), end, value);
  return parsed.ec == std::errc() && parsed.ptr == end;
}

std::string
toLower(std::string_view word)
{
  std::string lower(word);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::string
quoted(std::string_view word)
{
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : word.substr(0, longest))
    text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > longest ? "...'" : "'");
}

} // namespace symmetry
} // namespace pcl
