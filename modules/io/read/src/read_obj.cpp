#include "io/read/point_fields.h"
#include "io/read/readers.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** \brief The surface as far as it is read, with what can only be judged at the end. */
class ObjReader {
public:
  ObjReader(const FileContent& file, Reading& reading)
      : file_(file), reading_(reading), text_(file, {/*hash_comments=*/true, /*backslash_continues=*/true})
  {
  }

  Surface
  read()
  {
    while (text_.nextLine())
      readStatement();
    // A face may name a point of a later line, so the end of the points is known only now.
    if (largest_index_ >= static_cast<std::int64_t>(surface_.size()))
      file_.failAtLine(largest_index_line_, "the face refers to point " + std::to_string(largest_index_ + 1) + " of " +
                                                std::to_string(surface_.size()));
    if (!normals_match_points_ || surface_.normals.size() != surface_.size())
      surface_.normals.clear();
    surface_.fields = appearanceFields(colours_, textureOfPoints(), surface_.size());
    return std::move(surface_);
  }

private:
  void
  readStatement()
  {
    const std::string_view keyword = text_.word();
    if (keyword == "v") {
      surface_.points.push_back(readVector(reading_.origin));
      readColour();
      if (surface_.size() > point_limit)
        text_.fail("more points than can be numbered");
    }
    else if (keyword == "vn") {
      surface_.normals.push_back(readVector({0.0, 0.0, 0.0}));
      text_.needLineEnd();
    }
    else if (keyword == "vt") {
      texture_.push_back({text_.number(), text_.atLineEnd() ? 0.0F : text_.number()});
    }
    else if (keyword == "f" || keyword == "fo") { // fo: a face of the first versions of the format
      readFace();
    }
  }

  /** \brief Reads what follows a position: a weight, or a colour, which counts where all points have one. */
  void
  readColour()
  {
    const std::size_t before = colours_.size();
    while (!text_.atLineEnd()) {
      const float number = text_.number();
      if (colours_.size() <= before + 4) // one more than a colour has tells that it is none
        colours_.push_back(number);
    }
    all_coloured_ = all_coloured_ && (colours_.size() == before + 3 || colours_.size() == before + 4) &&
                    colours_.size() % surface_.size() == 0;
    if (!all_coloured_)
      colours_.clear();
  }

  Vector3
  readVector(const std::array<double, 3>& origin)
  {
    const float x = text_.numberFrom(origin[0]);
    const float y = text_.numberFrom(origin[1]);
    return {x, y, text_.numberFrom(origin[2])};
  }

  void
  readFace()
  {
    corners_.clear();
    for (std::string_view word = text_.word(); !word.empty(); word = text_.word())
      corners_.push_back(readCorner(word));
    if (corners_.empty())
      text_.fail("a face without corners");
    appendPolygon(corners_, surface_.triangles);
  }

  /** \brief Takes apart `v`, `v/vt`, `v//vn` or `v/vt/vn`; an empty index behind a slash, as in `v//` or `v/vt/`, is
   * none. */
  Index
  readCorner(std::string_view word)
  {
    const std::size_t first_slash = word.find('/');
    const std::int64_t point = readIndex(word, word.substr(0, first_slash), surface_.size());
    if (first_slash != std::string_view::npos) {
      const std::string_view rest = word.substr(first_slash + 1);
      const std::size_t second_slash = rest.find('/');
      const std::string_view texture = rest.substr(0, second_slash);
      if (!texture.empty())
        textured_corners_.emplace_back(point, textureIndex(word, texture));
      const std::string_view last =
          second_slash == std::string_view::npos ? std::string_view() : rest.substr(second_slash + 1);
      if (!last.empty()) {
        const std::int64_t normal = readIndex(word, last, surface_.normals.size());
        normals_match_points_ = normals_match_points_ && normal == point;
      }
    }
    if (point > largest_index_) {
      largest_index_ = point;
      largest_index_line_ = text_.line();
    }
    return static_cast<Index>(point);
  }

  /** \brief An index of a texture coordinate, which may be of a later line, or of none at all: no face needs it. */
  std::int64_t
  textureIndex(std::string_view word, std::string_view part) const
  {
    const std::int64_t number = needInteger(word, part);
    return number < 0 ? static_cast<std::int64_t>(texture_.size()) + number : number - 1;
  }

  /** \brief Texture coordinates of each point: those of the first corner that has some. Not numbers where no corner has;
   * empty where none of all has. Along the seams of a texture corners of one point differ, which a note counts. */
  std::vector<float>
  textureOfPoints()
  {
    std::vector<float> of_points;
    std::vector<char> is_seam(textured_corners_.empty() ? 0 : surface_.size(), 0);
    for (const auto& [point, index] : textured_corners_) {
      if (index < 0 || index >= static_cast<std::int64_t>(texture_.size()))
        continue;
      if (of_points.empty())
        of_points.assign(2 * surface_.size(), std::numeric_limits<float>::quiet_NaN());
      const std::array<float, 2>& coordinates = texture_[static_cast<std::size_t>(index)];
      float* const own = of_points.data() + 2 * point;
      if (std::isnan(own[0]))
        std::copy(coordinates.begin(), coordinates.end(), own);
      else if (!std::equal(coordinates.begin(), coordinates.end(), own))
        is_seam[static_cast<std::size_t>(point)] = 1;
    }
    const auto seams = std::count(is_seam.begin(), is_seam.end(), 1);
    if (seams > 0)
      reading_.notes.push_back(std::to_string(seams) + " points lie on seams of the texture: u and v are those of the "
                                                       "first face that has them");
    return of_points;
  }

  std::int64_t
  needInteger(std::string_view word, std::string_view part) const
  {
    std::int64_t value = 0;
    if (!parseInteger(part, value))
      text_.fail(quoted(word) + " is not a corner of a face");
    return value;
  }

  /** \brief A number from 1, or from -1 backwards from the last of the \a count so far, as one from 0. */
  std::int64_t
  readIndex(std::string_view word, std::string_view part, std::size_t count) const
  {
    const std::int64_t number = needInteger(word, part);
    const std::int64_t index = number < 0 ? static_cast<std::int64_t>(count) + number : number - 1;
    if (number == 0 || index < 0 || index >= static_cast<std::int64_t>(point_limit))
      text_.fail(quoted(word) + " refers to nothing: there are " + std::to_string(count) + " so far, numbered from 1");
    return index;
  }

  const FileContent& file_;
  Reading& reading_;
  TextScanner text_;
  Surface surface_;
  std::vector<Index> corners_;
  std::vector<float> colours_;
  std::vector<std::array<float, 2>> texture_;
  std::vector<std::pair<std::int64_t, std::int64_t>> textured_corners_; ///< point, texture coordinates
  bool all_coloured_ = true;
  bool normals_match_points_ = true;
  std::int64_t largest_index_ = -1;
  std::size_t largest_index_line_ = 0;
};

} // namespace

Surface
readObj(const FileContent& file, Reading& reading)
{
  return ObjReader(file, reading).read();
}

} // namespace symmetry
} // namespace pcl
