#include "io/read/readers.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <string>

namespace pcl {
namespace symmetry {
namespace {

struct OffCounts {
  std::size_t points = 0;
  std::size_t faces = 0;
};

/** \brief Reads the keyword, and says whether it promises normals. */
bool
readKeyword(TextScanner& text)
{
  text.needLine("the keyword OFF");
  const std::string_view keyword = text.word();
  std::string_view prefix = keyword;
  bool has_normals = false;
  while (prefix != "OFF") {
    if (prefix.substr(0, 2) == "ST") {
      prefix.remove_prefix(2);
      continue;
    }
    if (prefix.empty() || (prefix.front() != 'C' && prefix.front() != 'N'))
      text.fail("begins with " + quoted(keyword) + ": not an OFF file of points in space");
    has_normals = has_normals || prefix.front() == 'N';
    prefix.remove_prefix(1);
  }
  return has_normals;
}

std::size_t
readCount(TextScanner& text, const char* what)
{
  const std::int64_t count = text.integer();
  if (count < 0 || static_cast<std::uint64_t>(count) > most_points)
    text.fail(std::to_string(count) + " is no number of " + what);
  return static_cast<std::size_t>(count);
}

/** \brief Reads points, faces and, where it is there, edges, from the line of the keyword or the next. */
OffCounts
readCounts(TextScanner& text)
{
  if (text.atLineEnd())
    text.needLine("the line of counts");
  OffCounts counts;
  counts.points = readCount(text, "points");
  counts.faces = readCount(text, "faces");
  if (!text.atLineEnd())
    text.integer(); // edges: often 0, never needed
  text.needLineEnd();
  // The least that can be: a line end with "0 0 0", and with "0".
  if (!fitsInto(counts.points, 6, text.remaining()) || !fitsInto(counts.faces, 2, text.remaining() - 6 * counts.points))
    text.fail("the file is too short for " + std::to_string(counts.points) + " points and " +
              std::to_string(counts.faces) + " faces, or truncated");
  return counts;
}

Vector3
readVector(TextScanner& text)
{
  const float x = text.number();
  const float y = text.number();
  return {x, y, text.number()};
}

void
readFace(TextScanner& text, std::size_t points, std::vector<Index>& corners)
{
  const std::int64_t count = text.integer();
  if (count < 0 || !fitsInto(static_cast<std::uint64_t>(count), 2, text.remaining()))
    text.fail("a face of " + std::to_string(count) + " corners, which the file cannot hold");
  corners.clear();
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t corner = text.integer();
    if (corner < 0 || corner >= static_cast<std::int64_t>(points))
      text.fail("the face refers to point " + std::to_string(corner) + " of " + std::to_string(points) +
                ", numbered from 0");
    corners.push_back(static_cast<Index>(corner));
  }
  // What is left of the line is the colour of the face; nextLine() passes over it.
}

} // namespace

Surface
readOff(const FileContent& file)
{
  TextScanner text(file, {/*hash_comments=*/true, /*backslash_continues=*/false});
  const bool has_normals = readKeyword(text);
  const OffCounts counts = readCounts(text);

  Surface surface;
  surface.points.reserve(counts.points);
  surface.normals.reserve(has_normals ? counts.points : 0);
  for (std::size_t i = 0; i < counts.points; ++i) {
    text.needLine("a point");
    surface.points.push_back(readVector(text));
    if (has_normals)
      surface.normals.push_back(readVector(text));
    while (!text.atLineEnd())
      text.number(); // colour or texture coordinate
  }
  surface.triangles.reserve(counts.faces);
  std::vector<Index> corners;
  for (std::size_t i = 0; i < counts.faces; ++i) {
    text.needLine("a face");
    readFace(text, counts.points, corners);
    appendPolygon(corners, surface.triangles);
  }
  if (text.nextLine())
    text.fail("unexpected " + quoted(text.word()) + " behind the last face");
  return surface;
}

} // namespace symmetry
} // namespace pcl
