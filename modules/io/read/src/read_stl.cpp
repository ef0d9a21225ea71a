#include "io/read/readers.h"
#include "io/read/scalar_type.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t prologue_bytes = header_bytes + sizeof(std::uint32_t);
constexpr std::size_t facet_bytes = 50; // normal, three corners, attribute
constexpr std::size_t corners_offset = 12;

/** \brief Gives equal positions the same number, in the order of their first appearance. */
class PointMerger {
public:
  explicit PointMerger(std::vector<Vector3>& points) : points_(points), slots_(1024, no_index)
  {
  }

  Index
  add(Vector3 position)
  {
    for (float& coordinate : position)
      coordinate += 0.0F; // -0 and 0 are the same place
    if (2 * points_.size() >= slots_.size())
      grow();
    Index& slot = slots_[findSlot(position)];
    if (slot == no_index) {
      slot = static_cast<Index>(points_.size());
      points_.push_back(position);
    }
    return slot;
  }

private:
  static std::array<std::uint32_t, 3>
  bitsOf(const Vector3& position)
  {
    std::array<std::uint32_t, 3> bits = {};
    std::memcpy(bits.data(), position.data(), sizeof(bits));
    return bits;
  }

  /** \brief The slot that holds the position, or the free one that it belongs into. Compares bits, so NaN equals NaN.
   */
  std::size_t
  findSlot(const Vector3& position) const
  {
    const std::array<std::uint32_t, 3> bits = bitsOf(position);
    std::uint64_t hash = bits[0] * 0x9E3779B97F4A7C15ULL;
    hash = (hash ^ (hash >> 32) ^ bits[1]) * 0xBF58476D1CE4E5B9ULL;
    hash = (hash ^ (hash >> 32) ^ bits[2]) * 0x94D049BB133111EBULL;
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = static_cast<std::size_t>(hash >> 20) & mask;
    while (slots_[slot] != no_index && bitsOf(points_[static_cast<std::size_t>(slots_[slot])]) != bits)
      slot = (slot + 1) & mask;
    return slot;
  }

  void
  grow()
  {
    slots_.assign(4 * slots_.size(), no_index);
    for (std::size_t i = 0; i < points_.size(); ++i)
      slots_[findSlot(points_[i])] = static_cast<Index>(i);
  }

  std::vector<Vector3>& points_;
  std::vector<Index> slots_; ///< open addressing, at most half full; the size is a power of two
};

std::uint32_t
facetCount(const FileContent& file)
{
  return loadScalar<std::uint32_t>(file.data() + header_bytes, /*swap_bytes=*/false);
}

/** \brief Tells the two kinds apart. Many binary files begin with "solid", as the text does, so their size decides. */
bool
isBinary(const FileContent& file)
{
  if (file.size() >= prologue_bytes && file.size() == prologue_bytes + facet_bytes * std::uint64_t{facetCount(file)})
    return true;
  const std::string_view beginning = file.view().substr(0, 512);
  const bool is_text =
      std::none_of(beginning.begin(), beginning.end(), [](char c) { return static_cast<unsigned char>(c) < '\t'; });
  const std::size_t first = beginning.find_first_not_of(" \t\r\n");
  return !is_text || first == std::string_view::npos || toLower(beginning.substr(first, 5)) != "solid";
}

Surface
readBinary(const FileContent& file)
{
  if (file.size() < prologue_bytes)
    file.failAtByte(file.size(), "the file ends within the header of a binary STL file");
  const std::uint32_t count = facetCount(file);
  if (!fitsInto(count, facet_bytes, file.size() - prologue_bytes))
    file.failAtByte(file.size(), "the file ends before the last of its " + std::to_string(count) + " facets");

  Surface surface;
  PointMerger merger(surface.points);
  std::vector<Index> corners(3);
  for (std::size_t i = 0; i < count; ++i) {
    const char* bytes = file.data() + prologue_bytes + i * facet_bytes + corners_offset;
    for (Index& corner : corners) {
      corner = merger.add({loadScalar<float>(bytes, false), loadScalar<float>(bytes + sizeof(float), false),
                           loadScalar<float>(bytes + 2 * sizeof(float), false)});
      bytes += sizeof(Vector3);
    }
    appendPolygon(corners, surface.triangles);
  }
  return surface;
}

void
needWord(TextScanner& text, const char* expected)
{
  const std::string_view word = text.word();
  if (toLower(word) != expected)
    text.fail("'" + std::string(expected) + "' is expected, not " + quoted(word));
}

void
needLineOf(TextScanner& text, const char* expected)
{
  text.needLine(expected);
  needWord(text, expected);
}

Vector3
readVector(TextScanner& text)
{
  const float x = text.number();
  const float y = text.number();
  const Vector3 vector = {x, y, text.number()};
  text.needLineEnd();
  return vector;
}

/** \brief Reads one facet, of which the line "facet normal x y z" is begun. */
void
readFacet(TextScanner& text, PointMerger& merger, std::vector<Index>& corners)
{
  needWord(text, "normal");
  readVector(text);
  needLineOf(text, "outer");
  needWord(text, "loop");
  for (Index& corner : corners) {
    needLineOf(text, "vertex");
    corner = merger.add(readVector(text));
  }
  needLineOf(text, "endloop");
  needLineOf(text, "endfacet");
}

/** \brief Reads one or more solids. */
Surface
readText(const FileContent& file)
{
  Surface surface;
  PointMerger merger(surface.points);
  std::vector<Index> corners(3);
  TextScanner text(file);
  while (text.nextLine()) {
    needWord(text, "solid");
    for (;;) {
      text.needLine("'facet' or 'endsolid'");
      const std::string word = toLower(text.word());
      if (word == "endsolid")
        break;
      if (word != "facet")
        text.fail("'facet' or 'endsolid' is expected, not " + quoted(word));
      readFacet(text, merger, corners);
      appendPolygon(corners, surface.triangles);
    }
  }
  return surface;
}

} // namespace

Surface
readStl(const FileContent& file)
{
  return isBinary(file) ? readBinary(file) : readText(file);
}

} // namespace symmetry
} // namespace pcl
