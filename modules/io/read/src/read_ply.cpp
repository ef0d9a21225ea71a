#include "io/read/ply_header.h"
#include "io/read/readers.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Delivers the values of ascii records, one record a line. */
class TextRecords {
public:
  TextRecords(const FileContent& file, const PlyHeader& header) : text_(file, {}, header.end_byte, header.end_line)
  {
  }

  void
  beginRecord()
  {
    text_.needLine("a further record");
  }

  /** \brief Ends a line; \a lenient: what is left of it is passed over and counted. */
  void
  endRecord(bool lenient)
  {
    if (lenient && !text_.atLineEnd()) {
      first_surplus_ = surplus_ == 0 ? text_.line() : first_surplus_;
      ++surplus_;
    }
    else {
      text_.needLineEnd();
    }
  }

  float
  number(ScalarType /*type*/, double origin)
  {
    return text_.numberFrom(origin);
  }

  std::int64_t
  integer(ScalarType /*type*/)
  {
    return text_.integer();
  }

  void
  skip(ScalarType /*type*/, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
      text_.number();
  }

  bool
  mayHold(ScalarType /*type*/, std::uint64_t count) const
  {
    return fitsInto(count, 2, text_.remaining());
  }

  void
  finish(std::vector<std::string>& notes)
  {
    if (text_.nextLine())
      text_.fail("unexpected " + quoted(text_.word()) + " behind the last record");
    if (surplus_ > 0)
      notes.push_back("line " + std::to_string(first_surplus_) +
                      ": values behind those that the header announces were " + "passed over, here and in " +
                      std::to_string(surplus_ - 1) + " further lines");
  }

  /** \brief Most records of an element that the rest of the file can hold. */
  std::size_t
  mostRecords(const PlyElement& element) const
  {
    return text_.remaining() / (2 * element.properties.size() + 6); // the least face is "3 0 1 2"
  }

  [[noreturn]] void
  fail(const std::string& reason) const
  {
    text_.fail(reason);
  }

private:
  TextScanner text_;
  std::size_t surplus_ = 0; ///< lines with more values than announced
  std::size_t first_surplus_ = 0;
};

/** \brief Delivers the values of binary records. */
class BinaryRecords {
public:
  BinaryRecords(const FileContent& file, const PlyHeader& header)
      : file_(file), position_(header.end_byte), swap_bytes_(header.format == PlyFormat::BigEndian)
  {
  }

  void
  beginRecord()
  {
  }

  void
  endRecord(bool /*lenient*/)
  {
  }

  float
  number(ScalarType type, double origin)
  {
    return loadFloat(take(type, 1), type, swap_bytes_, origin);
  }

  std::int64_t
  integer(ScalarType type)
  {
    return loadInteger(take(type, 1), type, swap_bytes_);
  }

  void
  skip(ScalarType type, std::size_t count)
  {
    take(type, count);
  }

  bool
  mayHold(ScalarType type, std::uint64_t count) const
  {
    return fitsInto(count, sizeOf(type), file_.size() - position_);
  }

  std::size_t
  mostRecords(const PlyElement& element) const
  {
    return (file_.size() - position_) / std::max<std::size_t>(element.properties.size(), 4); // three corners of a byte
  }

  void
  finish(std::vector<std::string>& /*notes*/)
  {
    // Bytes behind the last record are padding of some writers.
  }

  /** \brief All records of an element without lists at once.
   * \return one column per property */
  std::vector<ScalarColumn>
  takeColumns(const PlyElement& element)
  {
    std::size_t record_bytes = 0;
    for (const PlyProperty& property : element.properties)
      record_bytes += sizeOf(property.type);
    const char* first = take(ScalarType::UInt8, element.count * record_bytes);
    std::vector<ScalarColumn> columns;
    for (const PlyProperty& property : element.properties) {
      columns.push_back({first, record_bytes, property.type, swap_bytes_});
      first += sizeOf(property.type);
    }
    return columns;
  }

  [[noreturn]] void
  fail(const std::string& reason) const
  {
    file_.failAtByte(position_, reason);
  }

private:
  const char*
  take(ScalarType type, std::size_t count)
  {
    if (!mayHold(type, count))
      file_.failAtByte(file_.size(), "the file ends within a record");
    const char* const bytes = file_.data() + position_;
    position_ += count * sizeOf(type);
    return bytes;
  }

  const FileContent& file_;
  std::size_t position_;
  bool swap_bytes_;
};

/** \brief What becomes of a property. */
enum class Role { Skip, Position, Normal, Polygon, Strip };

struct PropertyUse {
  Role role = Role::Skip;
  std::size_t component = 0; ///< of the position or the normal
};

PropertyUse
useOf(const PlyElement& element, const PlyProperty& property)
{
  static const std::string positions[] = {"x", "y", "z"};
  static const std::string normals[] = {"nx", "ny", "nz"};
  if (element.name == "vertex" && !property.is_list) {
    const std::string name = toLower(property.name); // some write X Y Z
    for (std::size_t i = 0; i < 3; ++i) {
      if (name == positions[i])
        return {Role::Position, i};
      if (name == normals[i])
        return {Role::Normal, i};
    }
  }
  if (property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index")) {
    if (element.name == "face")
      return {Role::Polygon, 0};
    if (element.name == "tristrips")
      return {Role::Strip, 0};
  }
  return {};
}

/** \brief Builds the surface from the records. */
class PlyReader {
public:
  PlyReader(const FileContent& file, const PlyHeader& header, Reading& reading)
      : file_(file), header_(header), reading_(reading)
  {
    const PlyElement& vertices = findVertices();
    if (countUses(vertices, Role::Position) != 3)
      file_.failAtLine(vertices.line, "element 'vertex' needs the properties x, y and z, once each");
    surface_.points.resize(vertices.count);
    if (countUses(vertices, Role::Normal) == 3)
      surface_.normals.resize(vertices.count);
  }

  Surface
  read()
  {
    reading_.single_precision = hasSinglePrecision();
    if (header_.format == PlyFormat::Text)
      readElements(TextRecords(file_, header_));
    else
      readElements(BinaryRecords(file_, header_));
    return std::move(surface_);
  }

private:
  const PlyElement&
  findVertices() const
  {
    const PlyElement* found = nullptr;
    for (const PlyElement& element : header_.elements) {
      if (element.name != "vertex")
        continue;
      if (found != nullptr)
        file_.failAtLine(element.line, "a second element 'vertex'");
      found = &element;
    }
    if (found == nullptr)
      file_.fail("the header has no element 'vertex'");
    return *found;
  }

  bool
  hasSinglePrecision() const
  {
    const PlyElement& vertices = findVertices();
    return header_.format != PlyFormat::Text &&
           std::any_of(vertices.properties.begin(), vertices.properties.end(), [&](const PlyProperty& property) {
             return useOf(vertices, property).role == Role::Position && property.type == ScalarType::Float32;
           });
  }

  static std::size_t
  countUses(const PlyElement& element, Role role)
  {
    std::size_t seen = 0; // one bit per component
    std::size_t count = 0;
    for (const PlyProperty& property : element.properties) {
      const PropertyUse use = useOf(element, property);
      if (use.role != role)
        continue;
      ++count;
      seen |= std::size_t{1} << use.component;
    }
    return seen == 7 ? count : 0;
  }

  template <typename Records>
  void
  readElements(Records records)
  {
    for (const PlyElement& element : header_.elements) {
      if (!readColumns(element, records))
        readRecords(element, records);
    }
    records.finish(reading_.notes);
  }

  bool
  readColumns(const PlyElement& /*element*/, TextRecords& /*records*/)
  {
    return false;
  }

  /** \brief The short way for records of equal size; false where there are lists. */
  bool
  readColumns(const PlyElement& element, BinaryRecords& records)
  {
    if (element.hasLists())
      return false;
    const std::vector<ScalarColumn> columns = records.takeColumns(element);
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const PropertyUse use = useOf(element, element.properties[i]);
      if (use.role == Role::Position)
        copyColumn(columns[i], use.component, surface_.points, reading_.origin[use.component]);
      else if (use.role == Role::Normal && !surface_.normals.empty())
        copyColumn(columns[i], use.component, surface_.normals);
    }
    return true;
  }

  template <typename Records>
  void
  readRecords(const PlyElement& element, Records& records)
  {
    std::vector<PropertyUse> uses;
    for (const PlyProperty& property : element.properties)
      uses.push_back(useOf(element, property));
    const bool is_vertex = element.name == "vertex";
    if (element.name == "face" && !uses.empty()) // a promise that costs nothing reserves nothing
      surface_.triangles.reserve(std::min(element.count, records.mostRecords(element)));
    for (std::size_t i = 0; i < element.count && !uses.empty(); ++i) {
      records.beginRecord();
      for (std::size_t j = 0; j < uses.size(); ++j) {
        if (element.properties[j].is_list)
          readList(element.properties[j], uses[j].role, records);
        else
          readValue(element.properties[j].type, uses[j], i, records);
      }
      records.endRecord(/*lenient=*/!is_vertex);
    }
  }

  template <typename Records>
  void
  readValue(ScalarType type, PropertyUse use, std::size_t record, Records& records)
  {
    if (use.role == Role::Position)
      surface_.points[record][use.component] = records.number(type, reading_.origin[use.component]);
    else if (use.role == Role::Normal && !surface_.normals.empty())
      surface_.normals[record][use.component] = records.number(type, 0.0);
    else
      records.skip(type, 1);
  }

  template <typename Records>
  void
  readList(const PlyProperty& property, Role role, Records& records)
  {
    const std::int64_t count = records.integer(property.count_type);
    if (count < 0 || !records.mayHold(property.type, static_cast<std::uint64_t>(count)))
      records.fail("a list of " + std::to_string(count) + " values, which the file cannot hold: truncated or damaged");
    if (role == Role::Skip) {
      records.skip(property.type, static_cast<std::size_t>(count));
      return;
    }
    if (!isInteger(property.type))
      records.fail("the corners of a face are of no integer type");
    corners_.resize(static_cast<std::size_t>(count));
    for (Index& corner : corners_)
      corner = readCorner(property.type, role, records);
    if (role == Role::Polygon)
      appendPolygon(corners_, surface_.triangles);
    else
      appendStrip(corners_, surface_.triangles);
  }

  template <typename Records>
  Index
  readCorner(ScalarType type, Role role, Records& records)
  {
    const std::int64_t corner = records.integer(type);
    const bool ends_strip = role == Role::Strip && corner == no_index;
    if (!ends_strip && (corner < 0 || corner >= static_cast<std::int64_t>(surface_.size())))
      records.fail("the face refers to point " + std::to_string(corner) + " of " + std::to_string(surface_.size()) +
                   ", numbered from 0");
    return static_cast<Index>(corner);
  }

  const FileContent& file_;
  const PlyHeader& header_;
  Reading& reading_;
  Surface surface_;
  std::vector<Index> corners_;
};

} // namespace

Surface
readPly(const FileContent& file, Reading& reading)
{
  const PlyHeader header = readPlyHeader(file);
  reading.notes = header.notes;
  return PlyReader(file, header, reading).read();
}

} // namespace symmetry
} // namespace pcl
