#include "benchmark/map_file.h"

#include "benchmark/text_lines.h"

#include <pcl/exceptions.h>

#include <utility>

namespace pcl {
namespace symmetry {
namespace {

bool
isHeader(std::string_view word)
{
  return word.find_first_of("0123456789") == std::string_view::npos;
}

} // namespace

std::vector<Index>
readMap(const std::string& path, std::size_t vertices)
{
  std::vector<Index> partners(vertices, no_index);
  TextLines lines(path, ",;");
  bool first = true;
  while (lines.next()) {
    if (lines.words()[0].front() == '#')
      continue;
    if (std::exchange(first, false) && isHeader(lines.words()[0]))
      continue;
    if (lines.words().size() < 2)
      lines.fail("a vertex and its partner expected");
    const Index vertex = lines.toInteger(lines.words()[0]);
    const Index partner = lines.toInteger(lines.words()[1]);
    if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertices)
      lines.fail("vertex " + std::to_string(vertex) + " is not in [0, " + std::to_string(vertices) + ")");
    if (partner < no_index || (partner >= 0 && static_cast<std::size_t>(partner) >= vertices))
      lines.fail("partner " + std::to_string(partner) + " is not in [-1, " + std::to_string(vertices) + ")");
    partners[static_cast<std::size_t>(vertex)] = partner;
  }
  if (first)
    throw pcl::IOException(path + ": there is nothing in it");
  return partners;
}

} // namespace symmetry
} // namespace pcl
