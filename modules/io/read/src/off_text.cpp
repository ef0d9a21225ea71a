#include "io/read/off_header.h"
#include "io/read/point_fields.h"
#include "io/read/surface_builder.h"

#include <string>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

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

} // namespace

Surface
readOffText(const FileContent& file, const OffHeader& header, const Reading& reading)
{
  return OffTextReader(file, header, reading).read();
}

} // namespace symmetry
} // namespace pcl
