#include "io/read/off_header.h"
#include "io/read/point_fields.h"
#include "io/read/scalar_type.h"
#include "io/read/surface_builder.h"

#include <algorithm>
#include <string>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Reads what follows `OFF BINARY`: integers and floats of four bytes, all big-endian. */
class OffBinaryReader {
public:
  OffBinaryReader(const FileContent& file, const OffHeader& header, const Reading& reading)
      : file_(file), header_(header), origin_(reading.origin), position_(header.end_byte)
  {
  }

  Surface
  read()
  {
    const OffCounts counts = readCounts();
    readPoints(counts.points);
    surface_.triangles.reserve(std::min(counts.faces, (file_.size() - position_) / minimum_face_bytes));
    for (std::size_t i = 0; i < counts.faces; ++i)
      readFace();
    return std::move(surface_); // bytes behind the last face are padding of some writers
  }

private:
  static constexpr std::size_t word_bytes = 4;
  static constexpr std::size_t minimum_face_bytes = 2 * word_bytes; // counts of its corners and colours

  const char*
  take(std::size_t words)
  {
    if (!fitsInto(words, word_bytes, file_.size() - position_))
      file_.failAtByte(file_.size(), "the file ends within a record");
    const char* const bytes = file_.data() + position_;
    position_ += words * word_bytes;
    return bytes;
  }

  std::int32_t
  integer()
  {
    return loadScalar<std::int32_t>(take(1), /*swap_bytes=*/true);
  }

  /** \brief Words of one point. */
  std::size_t
  pointWords() const
  {
    return 3U + (header_.homogeneous ? 1U : 0U) + (header_.normals ? 3U : 0U) + (header_.colours ? 4U : 0U) +
           (header_.texture ? 2U : 0U);
  }

  OffCounts
  readCounts()
  {
    if (header_.dimension && integer() != 3)
      file_.failAtByte(position_ - word_bytes, "the points have other than three dimensions");
    const std::size_t begin = position_;
    const std::int32_t points = integer();
    const std::int32_t faces = integer();
    integer(); // edges: never needed
    const auto available = file_.size() - position_;
    if (points < 0 || faces < 0 ||
        !fitsInto(std::uint64_t{static_cast<std::uint32_t>(points)} * pointWords(), word_bytes, available) ||
        !fitsInto(static_cast<std::uint32_t>(faces), minimum_face_bytes, available))
      file_.failAtByte(begin, "the file cannot hold " + std::to_string(points) + " points and " +
                                  std::to_string(faces) + " faces (big-endian, as the format says)");
    return {static_cast<std::size_t>(points), static_cast<std::size_t>(faces)};
  }

  void
  readPoints(std::size_t count)
  {
    const std::size_t stride = pointWords() * word_bytes;
    const char* const first = take(count * pointWords());
    surface_.points.resize(count);
    surface_.normals.resize(header_.normals ? count : 0);
    const std::size_t normal_word = header_.homogeneous ? 4 : 3;
    const auto column = [&](std::size_t word) {
      return ScalarColumn{first + word * word_bytes, stride, ScalarType::Float32, /*swap_bytes=*/true};
    };
    for (std::size_t i = 0; i < 3; ++i) {
      copyColumn(column(i), i, surface_.points, header_.homogeneous ? 0.0 : origin_[i]);
      copyColumn(column(normal_word + i), i, surface_.normals);
    }
    keepAppearance(normal_word + (header_.normals ? 3 : 0), column);
    if (!header_.homogeneous)
      return;
    for (std::size_t point = 0; point < count; ++point) {
      const auto divisor = double{loadScalar<float>(first + point * stride + 3 * word_bytes, true)};
      for (std::size_t i = 0; i < 3; ++i)
        surface_.points[point][i] = static_cast<float>(double{surface_.points[point][i]} / divisor - origin_[i]);
    }
  }

  template <typename Column>
  void
  keepAppearance(std::size_t first_word, Column column)
  {
    std::vector<const char*> names;
    if (header_.colours)
      names = {"red", "green", "blue", "alpha"};
    if (header_.texture)
      names.insert(names.end(), {"u", "v"});
    FieldCollector fields;
    for (std::size_t i = 0; i < names.size(); ++i)
      fields.add(i, names[i], ScalarType::Float32, 1);
    fields.resize(surface_.size());
    for (std::size_t i = 0; i < names.size(); ++i)
      fields.copy(i, column(first_word + i));
    surface_.fields = fields.take(0, 0);
  }

  void
  readFace()
  {
    const std::size_t begin = position_;
    const std::int32_t count = integer();
    if (count < 0 || !fitsInto(static_cast<std::uint32_t>(count), word_bytes, file_.size() - position_))
      file_.failAtByte(begin, "a face of " + std::to_string(count) + " corners, which the file cannot hold");
    corners_.resize(static_cast<std::size_t>(count));
    for (Index& corner : corners_) {
      corner = integer();
      if (corner < 0 || static_cast<std::size_t>(corner) >= surface_.size())
        file_.failAtByte(position_ - word_bytes, "the face refers to point " + std::to_string(corner) + " of " +
                                                     std::to_string(surface_.size()) + ", numbered from 0");
    }
    appendPolygon(corners_, surface_.triangles);
    const std::int32_t colours = integer();
    if (colours < 0)
      file_.failAtByte(position_ - word_bytes, std::to_string(colours) + " is no number of colour components");
    take(static_cast<std::size_t>(colours));
  }

  const FileContent& file_;
  const OffHeader& header_;
  const std::array<double, 3>& origin_;
  std::size_t position_;
  Surface surface_;
  std::vector<Index> corners_;
};

} // namespace

Surface
readOffBinary(const FileContent& file, const OffHeader& header, const Reading& reading)
{
  return OffBinaryReader(file, header, reading).read();
}

} // namespace symmetry
} // namespace pcl
