/** \file
 * \brief Builds the content of files in memory: text numbers and little-endian bytes.
 */
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace pcl {
namespace symmetry {

/** \brief Appends \a value as the shortest text that reads back as the same number; independent of the locale. */
template <typename Number>
void
appendNumber(std::string& text, Number value)
{
  char buffer[64];
  const std::to_chars_result end = std::to_chars(buffer, buffer + sizeof(buffer), value);
  text.append(buffer, end.ptr);
}

/** \brief Appends the bytes of \a value; files are little-endian, as all machines that Debian's PCL is built for. */
template <typename Number>
void
appendBytes(std::string& bytes, Number value)
{
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "byte order of the files");
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

} // namespace symmetry
} // namespace pcl
