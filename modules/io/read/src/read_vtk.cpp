#include "io/read/readers.h"
#include "io/read/scalar_type.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <array>
#include <optional>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Lists of corners, one after the other. */
struct CornerLists {
  std::vector<std::size_t> begins; ///< of each list, and the end of the last
  std::vector<std::int64_t> corners;
};

/** \brief Numbers of cells of an unstructured grid that are faces. */
enum CellType : std::int64_t { Vertex = 1, PolyLine = 4, Triangle3 = 5, Strip = 6, Polygon = 7, Pixel = 8, Quad = 9 };

/** \brief Reads a legacy file section by section; binary numbers are big-endian. */
class VtkReader {
public:
  VtkReader(const FileContent& file, Reading& reading) : file_(file), reading_(reading)
  {
    text_.emplace(file_);
  }

  Surface
  read()
  {
    readHead();
    while (text_->nextLine() && readSection())
      ;
    if (has_cells_)
      addCells();
    return std::move(surface_);
  }

private:
  void
  readHead()
  {
    constexpr std::string_view mark = "# vtk DataFile Version ";
    text_->needLine("'# vtk DataFile'");
    if (file_.view().substr(text_->position(), mark.size()) != mark)
      text_->fail("not a VTK file of the legacy form");
    is_listed_apart_ = file_.view().substr(text_->position() + mark.size(), 1) >= "5";
    // The title may be empty, and the scanner passes over empty lines.
    text_->needLine("'ASCII' or 'BINARY'");
    std::string kind = toLower(text_->word());
    if (kind != "ascii" && kind != "binary") {
      text_->needLine("'ASCII' or 'BINARY'");
      kind = toLower(text_->word());
    }
    if (kind != "ascii" && kind != "binary")
      text_->fail(quoted(std::string_view(kind)) + " is neither 'ASCII' nor 'BINARY'");
    is_binary_ = kind == "binary";
    text_->needLine("'DATASET'");
    if (toLower(text_->word()) != "dataset")
      text_->fail("'DATASET' is expected");
    const std::string data = toLower(text_->word());
    if (data != "polydata" && data != "unstructured_grid")
      text_->fail("the data set is " + quoted(std::string_view(data)) +
                  ": only polydata and unstructured_grid list points and faces");
  }

  /** \brief Reads the section that the line begins; false where what follows says nothing of points and faces. */
  bool
  readSection()
  {
    const std::string keyword = toLower(text_->word());
    if (keyword == "points")
      readPoints();
    else if (keyword == "polygons")
      addAll(readLists(), appendPolygon);
    else if (keyword == "triangle_strips")
      addAll(readLists(), appendStrip);
    else if (keyword == "vertices" || keyword == "lines")
      readLists(); // they bound no area
    else if (keyword == "cells") {
      cells_ = readLists();
      has_cells_ = true;
    }
    else if (keyword == "cell_types")
      types_ = readIntegers(readCount(), ScalarType::Int32);
    else if (keyword == "field")
      passOverField();
    else if (keyword == "point_data" || keyword == "cell_data")
      return false;
    else if (keyword != "metadata" && keyword != "information" && keyword != "name" && keyword != "data")
      text_->fail("unknown section " + quoted(std::string_view(keyword)));
    return true;
  }

  /** \brief Arrays that belong to the whole, such as a time. */
  void
  passOverField()
  {
    text_->word();
    const std::size_t arrays = readCount();
    for (std::size_t i = 0; i < arrays; ++i) {
      text_->needLine("an array of the field");
      text_->word();
      const std::uint64_t components = readCount();
      const std::uint64_t values = components * readCount();
      const ScalarType type = readType();
      if (values > point_limit)
        text_->fail("an array of " + std::to_string(values) + " values");
      if (is_binary_) {
        takeBinary(values, type);
        continue;
      }
      expectText(values);
      for (std::uint64_t k = 0; k < values; ++k) {
        toNumber();
        text_->preciseNumber();
      }
    }
  }

  std::size_t
  readCount()
  {
    const std::int64_t count = text_->integer();
    if (count < 0 || static_cast<std::uint64_t>(count) > point_limit)
      text_->fail(std::to_string(count) + " is no number of anything that can be read");
    return static_cast<std::size_t>(count);
  }

  ScalarType
  readType()
  {
    static const std::array<std::pair<const char*, ScalarType>, 13> types = {
        {{"char", ScalarType::Int8},
         {"unsigned_char", ScalarType::UInt8},
         {"short", ScalarType::Int16},
         {"unsigned_short", ScalarType::UInt16},
         {"int", ScalarType::Int32},
         {"unsigned_int", ScalarType::UInt32},
         {"long", ScalarType::Int64},
         {"unsigned_long", ScalarType::UInt64},
         {"vtktypeint64", ScalarType::Int64},
         {"vtktypeint32", ScalarType::Int32},
         {"vtkidtype", ScalarType::Int32}, // is written with 4 bytes
         {"float", ScalarType::Float32},
         {"double", ScalarType::Float64}}};
    const std::string name = toLower(text_->word());
    for (const auto& [known, type] : types)
      if (name == known)
        return type;
    text_->fail(quoted(std::string_view(name)) + " is no type of numbers");
  }

  /** \brief The numbers behind the line as a column; the next line is that behind them. */
  ScalarColumn
  takeBinary(std::size_t count, ScalarType type)
  {
    text_->finishLine();
    const std::size_t begin = text_->position();
    const std::size_t line = text_->line();
    if (!fitsInto(count, sizeOf(type), text_->remaining()))
      file_.failAtByte(file_.size(), "the file ends within " + std::to_string(count) + " numbers that begin at byte " +
                                         std::to_string(begin));
    text_.emplace(file_, TextSyntax{}, begin + count * sizeOf(type), line);
    return {file_.data() + begin, sizeOf(type), type, /*swap_bytes=*/true};
  }

  /** \brief Makes sure that the file may hold so many numbers, and that each is found on this line or a later one. */
  void
  expectText(std::size_t count)
  {
    text_->needLineEnd();
    if (!fitsInto(count, 2, text_->remaining() + 1))
      text_->fail("the file is too short for " + std::to_string(count) + " numbers, or truncated");
  }

  void
  toNumber()
  {
    if (text_->atLineEnd())
      text_->needLine("a number");
  }

  void
  readPoints()
  {
    const std::size_t count = readCount();
    const ScalarType type = readType();
    if (!surface_.points.empty())
      text_->fail("a second list of points");
    if (is_binary_) {
      reading_.single_precision = type == ScalarType::Float32;
      ScalarColumn column = takeBinary(3 * count, type);
      column.stride *= 3;
      surface_.points.resize(count);
      for (std::size_t axis = 0; axis < 3; ++axis, column.first += sizeOf(type))
        copyColumn(column, axis, surface_.points, reading_.origin[axis]);
      return;
    }
    expectText(3 * count);
    surface_.points.resize(count);
    for (Vector3& point : surface_.points)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        toNumber();
        point[axis] = text_->numberFrom(reading_.origin[axis]);
      }
  }

  std::vector<std::int64_t>
  readIntegers(std::size_t count, ScalarType type)
  {
    std::vector<std::int64_t> integers;
    if (is_binary_) {
      const ScalarColumn column = takeBinary(count, type);
      integers.resize(count);
      for (std::size_t i = 0; i < count; ++i)
        integers[i] = loadInteger(column.first + i * column.stride, type, column.swap_bytes);
      return integers;
    }
    expectText(count);
    integers.reserve(count);
    while (integers.size() < count) {
      toNumber();
      integers.push_back(text_->integer());
    }
    return integers;
  }

  /** \brief Integers below a line of a keyword and their type, as from version 5 on. */
  std::vector<std::int64_t>
  readNamedIntegers(const char* name, std::size_t count)
  {
    text_->needLine(name);
    if (toLower(text_->word()) != toLower(name))
      text_->fail(std::string("'") + name + "' is expected");
    const ScalarType type = readType();
    if (!isInteger(type))
      text_->fail(std::string(name) + " are no integers");
    return readIntegers(count, type);
  }

  CornerLists
  readLists()
  {
    const std::size_t count = readCount();
    const std::size_t size = readCount();
    CornerLists lists;
    if (is_listed_apart_) {
      text_->needLineEnd();
      for (const std::int64_t begin : readNamedIntegers("OFFSETS", count)) {
        if (begin < 0 || begin > static_cast<std::int64_t>(size) ||
            (!lists.begins.empty() && static_cast<std::size_t>(begin) < lists.begins.back()))
          text_->fail("offset " + std::to_string(begin) + " among " + std::to_string(size) + " corners");
        lists.begins.push_back(static_cast<std::size_t>(begin));
      }
      lists.corners = readNamedIntegers("CONNECTIVITY", size);
      return lists;
    }
    const std::vector<std::int64_t> integers = readIntegers(size, ScalarType::Int32);
    lists.begins.push_back(0);
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t corners = next < size ? integers[next] : -1;
      if (corners < 0 || !fitsInto(static_cast<std::uint64_t>(corners), 1, size - next - 1))
        text_->fail("list " + std::to_string(i) + " of corners reaches beyond the " + std::to_string(size) +
                    " numbers of all");
      const auto first = integers.begin() + static_cast<std::ptrdiff_t>(next) + 1;
      lists.corners.insert(lists.corners.end(), first, first + corners);
      lists.begins.push_back(lists.corners.size());
      next += static_cast<std::size_t>(corners) + 1;
    }
    return lists;
  }

  /** \brief The corners of a list as numbers of points. */
  const std::vector<Index>&
  cornersOf(const CornerLists& lists, std::size_t list)
  {
    corners_.clear();
    for (std::size_t i = lists.begins[list]; i < lists.begins[list + 1]; ++i) {
      const std::int64_t corner = lists.corners[i];
      if (corner < 0 || corner >= static_cast<std::int64_t>(surface_.size()))
        text_->fail("a face refers to point " + std::to_string(corner) + " of " + std::to_string(surface_.size()) +
                    ", numbered from 0");
      corners_.push_back(static_cast<Index>(corner));
    }
    return corners_;
  }

  template <typename Append>
  void
  addAll(const CornerLists& lists, Append append)
  {
    for (std::size_t list = 0; list + 1 < lists.begins.size(); ++list)
      append(cornersOf(lists, list), surface_.triangles);
  }

  void
  addCells()
  {
    if (types_.size() + 1 != std::max<std::size_t>(cells_.begins.size(), 1))
      text_->fail("there are " + std::to_string(types_.size()) + " types of cells, not as many as cells");
    std::size_t others = 0;
    for (std::size_t cell = 0; cell < types_.size(); ++cell) {
      const std::int64_t type = types_[cell];
      if (type == Strip)
        appendStrip(cornersOf(cells_, cell), surface_.triangles);
      else if (type == Triangle3 || type == Polygon || type == Quad)
        appendPolygon(cornersOf(cells_, cell), surface_.triangles);
      else if (type == Pixel && cornersOf(cells_, cell).size() == 4) {
        std::swap(corners_[2], corners_[3]); // its last two corners come the other way round
        appendPolygon(corners_, surface_.triangles);
      }
      else
        others += type < Vertex || type > PolyLine ? 1U : 0U;
    }
    if (others > 0)
      reading_.notes.push_back(std::to_string(others) + " cells that are no polygons were passed over");
  }

  const FileContent& file_;
  Reading& reading_;
  std::optional<TextScanner> text_;
  bool is_binary_ = false;
  bool is_listed_apart_ = false; ///< offsets and corners in a list each
  bool has_cells_ = false;
  CornerLists cells_;
  std::vector<std::int64_t> types_;
  Surface surface_;
  std::vector<Index> corners_;
};

} // namespace

Surface
readVtk(const FileContent& file, Reading& reading)
{
  return VtkReader(file, reading).read();
}

} // namespace symmetry
} // namespace pcl
