#include "io/read/ply_header.h"
#include "io/read/ply_records.h"
#include "io/read/point_fields.h"
#include "io/read/readers.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

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
    for (std::size_t i = 0; i < vertices.properties.size(); ++i) {
      const PlyProperty& property = vertices.properties[i];
      const Role role = useOf(vertices, property).role;
      if (!property.is_list && (role == Role::Skip || (role == Role::Normal && surface_.normals.empty())))
        fields_.add(i, property.name, property.type, 1);
    }
    fields_.resize(vertices.count);
  }

  Surface
  read()
  {
    reading_.single_precision = hasSinglePrecision();
    if (header_.format == PlyFormat::Text)
      readElements(TextRecords(file_, header_));
    else
      readElements(BinaryRecords(file_, header_));
    const bool is_raster = header_.rows > 1 && fitsInto(header_.rows, header_.columns, surface_.size()) &&
                           header_.rows * header_.columns == surface_.size();
    surface_.fields = fields_.take(is_raster ? header_.columns : 0, is_raster ? header_.rows : 0);
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
      else if (element.name == "vertex")
        fields_.copy(i, columns[i]);
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
          readValue(element.properties[j].type, uses[j], i, is_vertex ? j : no_field, records);
      }
      records.endRecord(/*lenient=*/!is_vertex);
    }
  }

  template <typename Records>
  void
  readValue(ScalarType type, PropertyUse use, std::size_t record, std::size_t field, Records& records)
  {
    if (use.role == Role::Position)
      surface_.points[record][use.component] = records.number(type, reading_.origin[use.component]);
    else if (use.role == Role::Normal && !surface_.normals.empty())
      surface_.normals[record][use.component] = records.number(type, 0.0);
    else if (fields_.keeps(field))
      records.store(type, fields_.place(field, record, 0));
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
  static constexpr std::size_t no_field = static_cast<std::size_t>(-1);

  FieldCollector fields_;
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
