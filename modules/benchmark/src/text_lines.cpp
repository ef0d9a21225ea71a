#include "benchmark/text_lines.h"

#include <pcl/exceptions.h>

#include <charconv>

namespace pcl {
namespace symmetry {

TextLines::TextLines(const std::string& path, std::string_view separators)
    : path_(path), separators_(" \t\r\v\f"), file_(path, std::ios::binary)
{
  separators_ += separators;
  if (!file_)
    throw pcl::IOException(path + ": cannot be opened");
}

bool
TextLines::next()
{
  words_.clear();
  while (words_.empty() && std::getline(file_, line_)) {
    ++line_number_;
    const std::string_view line = line_;
    std::size_t begin = line.find_first_not_of(separators_);
    while (begin != std::string_view::npos) {
      const std::size_t end = line.find_first_of(separators_, begin);
      words_.push_back(line.substr(begin, end - begin));
      begin = line.find_first_not_of(separators_, end);
    }
  }
  // A folder opens like a file and fails only here.
  if (file_.bad() || (line_number_ == 0 && !file_.eof()))
    throw pcl::IOException(path_ + ": cannot be read");
  return !words_.empty();
}

Index
TextLines::toInteger(std::string_view word) const
{
  Index value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    fail("'" + std::string(word) + "' is no integer of 32 bits");
  return value;
}

double
TextLines::toNumber(std::string_view word) const
{
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size())
    fail("'" + std::string(word) + "' is no number");
  return value;
}

void
TextLines::fail(const std::string& reason) const
{
  throw pcl::IOException(path_ + ":" + std::to_string(line_number_) + ": " + reason);
}

} // namespace symmetry
} // namespace pcl
