#include "io/read/point_fields.h"
#include "io/read/readers.h"
#include "io/read/scalar_type.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <string>

namespace pcl {
namespace symmetry {
namespace {

constexpr TextSyntax off_syntax = {/*hash_comments=*/true, /*backslash_continues=*/false};

/** \brief What the keyword promises, and where the counts begin. */
struct OffHeader {
  bool texture = false;     ///< ST: two numbers a point
  bool colours = false;     ///< C
  bool normals = false;     ///< N
  bool homogeneous = false; ///< 4: each position has a fourth number, its divisor
  bool dimension = false;   ///< n: the number of dimensions comes before the counts
  bool binary = false;
  std::size_t end_byte = 0;
  std::size_t end_line = 0;
};

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

/** \brief Reads the keyword, which may be glued to the counts (`OFF490 518 0`) or missing. */
OffHeader
readHeader(const FileContent& file)
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

/** \brief The counts that both kinds of file begin with. */
struct OffCounts {
  std::size_t points = 0;
  std::size_t faces = 0;
};

/** \brief Reads the text behind the keyword. */
class OffTextReader {
public:
  OffTextReader(const FileContent& file, const OffHeader& header, const Reading& reading)
      : header_(header), origin_(reading.origin), text_(file, off_syntax, header.end_byte, header.end_line)
  {
  }

  Surface
  read()
  {
    const OffCounts counts = readCounts();
    surface_.points.reserve(counts.points);
    surface_.normals.reserve(header_.normals ? counts.points : 0);
    for (std::size_t i = 0; i < counts.points; ++i)
      readPoint();
    surface_.triangles.reserve(counts.faces);
    for (std::size_t i = 0; i < counts.faces; ++i)
      readFace();
    if (text_.nextLine())
      text_.fail("unexpected " + quoted(text_.word()) + " behind the last face");
    surface_.fields = appearanceFields(colours_, texture_, surface_.size());
    return std::move(surface_);
  }

private:
  std::size_t
  readCount(const char* what)
  {
    const std::int64_t count = text_.integer();
    if (count < 0 || static_cast<std::uint64_t>(count) > point_limit)
      text_.fail(std::to_string(count) + " is no number of " + what);
    return static_cast<std::size_t>(count);
  }

  /** \brief Reads points, faces and, where it is there, edges, from the line of the keyword or the next. */
  OffCounts
  readCounts()
  {
    text_.needLine("the line of counts");
    if (header_.dimension) {
      const std::int64_t dimension = text_.integer();
      if (dimension != 3)
        text_.fail("the points have " + std::to_string(dimension) + " dimensions: only three can be read");
      if (text_.atLineEnd())
        text_.needLine("the line of counts");
    }
    OffCounts counts;
    counts.points = readCount("points");
    counts.faces = readCount("faces");
    if (!text_.atLineEnd())
      text_.integer(); // edges: often 0, never needed
    text_.needLineEnd();
    // The least that can be: a line end with "0 0 0", and with "0".
    if (!fitsInto(counts.points, 6, text_.remaining()) ||
        !fitsInto(counts.faces, 2, text_.remaining() - 6 * counts.points))
      text_.fail("the file is too short for " + std::to_string(counts.points) + " points and " +
                 std::to_string(counts.faces) + " faces, or truncated");
    return counts;
  }

  void
  readPoint()
  {
    text_.needLine("a point");
    Vector3 point = {};
    if (header_.homogeneous) {
      double numbers[4] = {};
      for (double& number : numbers)
        number = text_.preciseNumber();
      for (std::size_t i = 0; i < 3; ++i)
        point[i] = static_cast<float>(numbers[i] / numbers[3] - origin_[i]);
    }
    else {
      for (std::size_t i = 0; i < 3; ++i)
        point[i] = text_.numberFrom(origin_[i]);
    }
    surface_.points.push_back(point);
    if (header_.normals) {
      const float x = text_.number();
      const float y = text_.number();
      surface_.normals.push_back({x, y, text_.number()});
    }
    readRest();
  }

  /** \brief Reads the colour, which counts where all points have as many numbers, and passes over what is behind. */
  void
  readRest()
  {
    const std::size_t begin = colours_.size();
    while (!text_.atLineEnd()) {
      const float number = text_.number();
      if (colours_.size() <= begin + 6) // more than colour and texture coordinates have
        colours_.push_back(number);
    }
    // Texture coordinates come last.
    if (header_.texture && colours_.size() >= begin + 2) {
      texture_.insert(texture_.end(), colours_.end() - 2, colours_.end());
      colours_.resize(colours_.size() - 2);
    }
    if (!header_.colours)
      colours_.resize(begin);
    all_coloured_ = all_coloured_ && colours_.size() == surface_.size() * (colours_.size() - begin);
    if (!all_coloured_)
      colours_.clear();
  }

  void
  readFace()
  {
    text_.needLine("a face");
    const std::int64_t count = text_.integer();
    if (count < 0 || !fitsInto(static_cast<std::uint64_t>(count), 2, text_.remaining()))
      text_.fail("a face of " + std::to_string(count) + " corners, which the file cannot hold");
    corners_.clear();
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t corner = text_.integer();
      if (corner < 0 || corner >= static_cast<std::int64_t>(surface_.size()))
        text_.fail("the face refers to point " + std::to_string(corner) + " of " + std::to_string(surface_.size()) +
                   ", numbered from 0");
      corners_.push_back(static_cast<Index>(corner));
    }
    appendPolygon(corners_, surface_.triangles);
    // What is left of the line is the colour of the face; nextLine() passes over it.
  }

  const OffHeader& header_;
  const std::array<double, 3>& origin_;
  TextScanner text_;
  std::vector<float> colours_;
  std::vector<float> texture_;
  bool all_coloured_ = true;
  Surface surface_;
  std::vector<Index> corners_;
};

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
      const double divisor = double{loadScalar<float>(first + point * stride + 3 * word_bytes, true)};
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
readOff(const FileContent& file, Reading& reading)
{
  const OffHeader header = readHeader(file);
  reading.single_precision = header.binary;
  return header.binary ? OffBinaryReader(file, header, reading).read() : OffTextReader(file, header, reading).read();
}

} // namespace symmetry
} // namespace pcl
