#include "io/read/off_header.h"

#include <string>
#include <string_view>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Takes the letters before OFF apart, in any order; false where one is not known. */
bool
readPrefix(std::string_view prefix, OffHeader& header)
{
  while (!prefix.empty()) {
    std::size_t length = 1;
    if (prefix.substr(0, 2) == "ST") {
      header.texture = true;
      length = 2;
    }
    else if (prefix.front() == 'C')
      header.colours = true;
    else if (prefix.front() == 'N')
      header.normals = true;
    else if (prefix.front() == '4')
      header.homogeneous = true;
    else if (prefix.front() == 'n')
      header.dimension = true;
    else
      return false;
    prefix.remove_prefix(length);
  }
  return true;
}

} // namespace

OffHeader
readOffHeader(const FileContent& file)
{
  TextScanner text(file, off_syntax);
  text.needLine("the keyword OFF");
  OffHeader header;
  header.end_byte = text.position();
  header.end_line = text.line();
  const std::string_view keyword = text.word();
  std::int64_t count = 0;
  if (parseInteger(keyword, count))
    return header;

  constexpr std::size_t length = 3;
  const std::size_t begin = toLower(keyword).find("off");
  const std::string_view glued = begin == std::string::npos ? keyword : keyword.substr(begin + length);
  if (begin == std::string::npos || !readPrefix(keyword.substr(0, begin), header) ||
      (!glued.empty() && !parseInteger(glued, count)))
    text.fail("begins with " + quoted(keyword) + ": not an OFF file");
  header.end_byte += begin + length;
  if (glued.empty() && text.word() == "BINARY") {
    text.finishLine();
    header.binary = true;
    header.end_byte = text.position();
    header.end_line = text.line();
  }
  return header;
}

} // namespace symmetry
} // namespace pcl
