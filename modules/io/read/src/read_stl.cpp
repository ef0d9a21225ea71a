#include "io/read/readers.h"
#include "io/read/scalar_type.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <algorithm>
#include <random>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t prologue_bytes = header_bytes + sizeof(std::uint32_t);
constexpr std::size_t facet_bytes = 50; // normal, three corners, attribute
constexpr std::size_t corners_offset = 12;

/** \brief Gives equal positions the same number, in the order of their first appearance.
 *
 * The hash begins with a number of chance, so that no file can be made whose positions all meet in one slot; numbers
 * of points do not depend on it.
 */
class PointMerger {
public:
  explicit PointMerger(std::vector<Vector3>& points) : points_(points), slots_(1024, no_index)
  {
    std::random_device chance;
    seed_ = std::uint64_t{chance()} << 32 | chance();
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

  /** \brief Each bit of the result depends on each bit of \a value: the finalizer of MurmurHash3. */
  static std::uint64_t
  mixed(std::uint64_t value)
  {
    value = (value ^ (value >> 33)) * 0xFF51AFD7ED558CCDULL;
    value = (value ^ (value >> 33)) * 0xC4CEB9FE1A85EC53ULL;
    return value ^ (value >> 33);
  }

  /** \brief The slot that holds the position, or the free one that it belongs into. Compares bits, so NaN equals NaN.
   */
  std::size_t
  findSlot(const Vector3& position) const
  {
    const std::array<std::uint32_t, 3> bits = bitsOf(position);
    const std::uint64_t hash = mixed(mixed(seed_ ^ (std::uint64_t{bits[0]} << 32 | bits[1])) + (seed_ ^ bits[2]));
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = static_cast<std::size_t>(hash) & mask;
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
  std::uint64_t seed_ = 0;
  std::vector<Index> slots_; ///< open addressing, at most half full; the size is a power of two
};

std::uint32_t
facetCount(const FileContent& file)
{
  return loadScalar<std::uint32_t>(file.data() + header_bytes, /*swap_bytes=*/false);
}

constexpr TextSyntax stl_syntax = {/*hash_comments=*/true, /*backslash_continues=*/false};

/** \brief Goes to the next line that is no comment: the format has none, but people write `#`, `//` and `;`. */
bool
nextStatement(TextScanner& text)
{
  while (text.nextLine()) {
    TextScanner ahead = text;
    const std::string_view word = ahead.word();
    if (word.substr(0, 2) != "//" && word.front() != ';')
      return true;
  }
  return false;
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
  if (!is_text)
    return true;
  TextScanner text(file, stl_syntax);
  return !nextStatement(text) || toLower(text.word()).substr(0, 5) != "solid";
}

Surface
readBinary(const FileContent& file, const std::array<double, 3>& origin)
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
      Vector3 position = {};
      for (std::size_t k = 0; k < 3; ++k, bytes += sizeof(float))
        position[k] = loadFloat(bytes, ScalarType::Float32, /*swap_bytes=*/false, origin[k]);
      corner = merger.add(position);
    }
    appendPolygon(corners, surface.triangles);
  }
  return surface;
}

void
needStatement(TextScanner& text, const char* expected)
{
  if (!nextStatement(text))
    text.fail(std::string("the file ends where ") + expected + " is expected");
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
  needStatement(text, expected);
  needWord(text, expected);
}

Vector3
readVector(TextScanner& text, const std::array<double, 3>& origin)
{
  const float x = text.numberFrom(origin[0]);
  const float y = text.numberFrom(origin[1]);
  const Vector3 vector = {x, y, text.numberFrom(origin[2])};
  text.needLineEnd();
  return vector;
}

/** \brief Reads one facet, of which the line "facet normal x y z" is begun. */
void
readFacet(TextScanner& text, const std::array<double, 3>& origin, PointMerger& merger, std::vector<Index>& corners)
{
  needWord(text, "normal");
  readVector(text, origin); // not needed: the corners tell it
  needLineOf(text, "outer");
  needWord(text, "loop");
  for (Index& corner : corners) {
    needLineOf(text, "vertex");
    corner = merger.add(readVector(text, origin));
  }
  needLineOf(text, "endloop");
  needLineOf(text, "endfacet");
}

/** \brief Reads one or more solids. */
Surface
readText(const FileContent& file, const std::array<double, 3>& origin)
{
  Surface surface;
  PointMerger merger(surface.points);
  std::vector<Index> corners(3);
  TextScanner text(file, stl_syntax);
  while (nextStatement(text)) {
    needWord(text, "solid");
    for (;;) {
      needStatement(text, "'facet' or 'endsolid'");
      const std::string word = toLower(text.word());
      if (word == "endsolid")
        break;
      if (word != "facet")
        text.fail("'facet' or 'endsolid' is expected, not " + quoted(word));
      readFacet(text, origin, merger, corners);
      appendPolygon(corners, surface.triangles);
    }
  }
  return surface;
}

} // namespace

Surface
readStl(const FileContent& file, Reading& reading)
{
  reading.single_precision = isBinary(file);
  return reading.single_precision ? readBinary(file, reading.origin) : readText(file, reading.origin);
}

} // namespace symmetry
} // namespace pcl
