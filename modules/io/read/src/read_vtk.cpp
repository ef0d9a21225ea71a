#include "io/read/readers.h"
#include "io/read/scalar_type.h"
#include "io/read/surface_builder.h"
#include "io/read/vtk_numbers.h"

#include <algorithm>
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
  VtkReader(const FileContent& file, Reading& reading) : file_(file), reading_(reading), numbers_(file)
  {
  }

  Surface
  read()
  {
    readHead();
    while (numbers_.text().nextLine() && readSection())
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
    numbers_.text().needLine("'# vtk DataFile'");
    if (file_.view().substr(numbers_.text().position(), mark.size()) != mark)
      numbers_.text().fail(numbers_.text().ahead(1) == "<"
                               ? "VTK's XML is not read: save the surface as a legacy file, or as .ply"
                               : "not a VTK file of the legacy form");
    is_listed_apart_ = file_.view().substr(numbers_.text().position() + mark.size(), 1) >= "5";
    // The title may be empty, and the scanner passes over empty lines.
    numbers_.text().needLine("'ASCII' or 'BINARY'");
    std::string kind = toLower(numbers_.text().word());
    if (kind != "ascii" && kind != "binary") {
      numbers_.text().needLine("'ASCII' or 'BINARY'");
      kind = toLower(numbers_.text().word());
    }
    if (kind != "ascii" && kind != "binary")
      numbers_.text().fail(quoted(std::string_view(kind)) + " is neither 'ASCII' nor 'BINARY'");
    is_binary_ = kind == "binary";
    numbers_.setBinary(is_binary_);
    numbers_.text().needLine("'DATASET'");
    if (toLower(numbers_.text().word()) != "dataset")
      numbers_.text().fail("'DATASET' is expected");
    const std::string data = toLower(numbers_.text().word());
    if (data != "polydata" && data != "unstructured_grid")
      numbers_.text().fail("the data set is " + quoted(std::string_view(data)) +
                           ": only polydata and unstructured_grid list points and faces");
  }

  /** \brief Reads the section that the line begins; false where what follows says nothing of points and faces. */
  bool
  readSection()
  {
    const std::string keyword = toLower(numbers_.text().word());
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
      types_ = numbers_.readIntegers(numbers_.readCount(), ScalarType::Int32);
    else if (keyword == "field")
      passOverField();
    else if (keyword == "point_data" || keyword == "cell_data")
      return false;
    else if (keyword == "metadata")
      numbers_.passOverMetadata(components_);
    else
      numbers_.text().fail("unknown section " + quoted(std::string_view(keyword)));
    return true;
  }

  /** \brief Arrays that belong to the whole, such as a time. */
  void
  passOverField()
  {
    numbers_.text().word();
    const std::size_t arrays = numbers_.readCount();
    for (std::size_t i = 0; i < arrays; ++i) {
      numbers_.text().needLine("an array of the field");
      if (toLower(numbers_.text().word()) == "metadata" && numbers_.text().atLineEnd()) { // of the array before
        numbers_.passOverMetadata(components_);
        numbers_.text().needLine("an array of the field");
        numbers_.text().word();
      }
      components_ = numbers_.passOverArray();
    }
  }

  void
  readPoints()
  {
    const std::size_t count = numbers_.readCount();
    const ScalarType type = numbers_.readType();
    if (!surface_.points.empty())
      numbers_.text().fail("a second list of points");
    reading_.single_precision = is_binary_ && type == ScalarType::Float32;
    surface_.points = numbers_.readPoints(count, type, reading_.origin);
    components_ = 3;
  }

  CornerLists
  readLists()
  {
    const std::size_t count = numbers_.readCount();
    const std::size_t size = numbers_.readCount();
    CornerLists lists;
    if (is_listed_apart_) {
      numbers_.text().needLineEnd();
      for (const std::int64_t begin : numbers_.readNamedIntegers("OFFSETS", count)) {
        if (begin < 0 || begin > static_cast<std::int64_t>(size) ||
            (!lists.begins.empty() && static_cast<std::size_t>(begin) < lists.begins.back()))
          numbers_.text().fail("offset " + std::to_string(begin) + " among " + std::to_string(size) + " corners");
        lists.begins.push_back(static_cast<std::size_t>(begin));
      }
      lists.corners = numbers_.readNamedIntegers("CONNECTIVITY", size);
      components_ = 1;
      return lists;
    }
    const std::vector<std::int64_t> integers = numbers_.readIntegers(size, ScalarType::Int32);
    lists.begins.push_back(0);
    std::size_t next = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t corners = next < size ? integers[next] : -1;
      if (corners < 0 || !fitsInto(static_cast<std::uint64_t>(corners), 1, size - next - 1))
        numbers_.text().fail("list " + std::to_string(i) + " of corners reaches beyond the " + std::to_string(size) +
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
        numbers_.text().fail("a face refers to point " + std::to_string(corner) + " of " +
                             std::to_string(surface_.size()) + ", numbered from 0");
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
      numbers_.text().fail("there are " + std::to_string(types_.size()) + " types of cells, not as many as cells");
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
  VtkNumbers numbers_;
  bool is_binary_ = false;
  bool is_listed_apart_ = false; ///< offsets and corners in a list each
  bool has_cells_ = false;
  std::size_t components_ = 1; ///< of the array that was read last
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
