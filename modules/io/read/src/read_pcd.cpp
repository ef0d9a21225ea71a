#include "io/read/pcd_header.h"
#include "io/read/readers.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <pcl/io/lzf.h>

#include <algorithm>
#include <array>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t no_field = std::numeric_limits<std::size_t>::max();

/** \brief Numbers of the fields that make positions and normals. */
struct FieldUse {
  std::array<std::size_t, 3> position = {no_field, no_field, no_field};
  std::array<std::size_t, 3> normal = {no_field, no_field, no_field};
  bool has_normals = false;
};

/** \brief The field of that name; names in capitals count where none is spelled as it should be. */
std::size_t
findField(const FileContent& file, const PcdHeader& header, const std::string& name)
{
  const bool exact = std::any_of(header.fields.begin(), header.fields.end(),
                                 [&name](const PcdField& field) { return field.name == name; });
  std::size_t found = no_field;
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    if ((exact ? header.fields[i].name : toLower(header.fields[i].name)) != name)
      continue;
    if (found != no_field)
      file.fail("has two fields '" + name + "'");
    if (header.fields[i].count != 1 || !header.fields[i].is_number)
      file.fail("field '" + name + "' is not one number of a known type");
    found = i;
  }
  return found;
}

FieldUse
findFields(const FileContent& file, const PcdHeader& header)
{
  static const std::array<std::string, 3> positions = {"x", "y", "z"};
  static const std::array<std::string, 3> normals = {"normal_x", "normal_y", "normal_z"};
  FieldUse use;
  use.has_normals = true;
  for (std::size_t i = 0; i < 3; ++i) {
    use.position[i] = findField(file, header, positions[i]);
    use.normal[i] = findField(file, header, normals[i]);
    if (use.position[i] == no_field)
      file.fail("has no field '" + positions[i] + "'");
    use.has_normals = use.has_normals && use.normal[i] != no_field;
  }
  return use;
}

/** \brief Copies positions and normals; offsets[i] and strides[i] place field i in \a data. */
void
copyFields(const char* data,
           const PcdHeader& header,
           const std::vector<std::size_t>& offsets,
           const std::vector<std::size_t>& strides,
           const FieldUse& use,
           const std::array<double, 3>& origin,
           Surface& surface)
{
  const auto column = [&](std::size_t field) {
    return ScalarColumn{data + offsets[field], strides[field], header.fields[field].type, false};
  };
  for (std::size_t i = 0; i < 3; ++i) {
    copyColumn(column(use.position[i]), i, surface.points, origin[i]);
    if (use.has_normals)
      copyColumn(column(use.normal[i]), i, surface.normals);
  }
}

/** \brief Points one after the other, each with all its fields. */
void
readBinary(const FileContent& file,
           const PcdHeader& header,
           const FieldUse& use,
           const std::array<double, 3>& origin,
           Surface& surface)
{
  if (!fitsInto(header.points, header.pointBytes(), file.size() - header.end_byte))
    file.failAtByte(file.size(), "the file ends before the last of its " + std::to_string(header.points) + " points");
  std::vector<std::size_t> offsets;
  std::size_t offset = 0;
  for (const PcdField& field : header.fields) {
    offsets.push_back(offset);
    offset += field.bytes();
  }
  surface.points.resize(header.points);
  surface.normals.resize(use.has_normals ? header.points : 0);
  const std::vector<std::size_t> strides(header.fields.size(), header.pointBytes());
  copyFields(file.data() + header.end_byte, header, offsets, strides, use, origin, surface);
}

/** \brief All fields, unpacked: fields one after the other, each of all points. */
std::vector<char>
unpack(const FileContent& file, const PcdHeader& header)
{
  constexpr std::size_t sizes_bytes = 2 * sizeof(std::uint32_t);
  // One compressed byte stands for at most 88: a back reference of three bytes repeats at most 264.
  constexpr std::uint64_t largest_ratio = 88;
  const std::size_t available = file.size() - header.end_byte;
  if (available < sizes_bytes)
    file.failAtByte(file.size(), "the file ends before the sizes of its compressed data");
  const char* const sizes = file.data() + header.end_byte;
  const auto compressed = loadScalar<std::uint32_t>(sizes, false);
  const auto uncompressed = loadScalar<std::uint32_t>(sizes + sizeof(std::uint32_t), false);
  if (compressed > available - sizes_bytes)
    file.failAtByte(file.size(), "the file ends within its compressed data");
  if (!fitsInto(header.points, header.pointBytes(), uncompressed) ||
      uncompressed != header.points * header.pointBytes() || uncompressed > largest_ratio * compressed)
    file.failAtByte(header.end_byte,
                    "the sizes of the compressed data do not belong to " + std::to_string(header.points) + " points");

  const std::uint64_t needed = header.points * std::max<std::uint64_t>(header.pointBytes(), sizeof(Vector3));
  if (needed > mostUnpacked(compressed))
    file.failAtByte(header.end_byte, std::to_string(compressed) + " compressed bytes stand for " +
                                         std::to_string(header.points) +
                                         " points, more than can differ: write the file as binary if they are wanted");

  std::vector<char> data(uncompressed);
  if (uncompressed > 0 && lzfDecompress(sizes + sizes_bytes, compressed, data.data(), uncompressed) != uncompressed)
    file.failAtByte(header.end_byte + sizes_bytes, "the compressed data are damaged");
  return data;
}

/** \brief Fields one after the other, each of all points, compressed as a whole. */
void
readCompressed(const FileContent& file,
               const PcdHeader& header,
               const FieldUse& use,
               const std::array<double, 3>& origin,
               Surface& surface)
{
  std::vector<char> data = unpack(file, header);
  std::vector<std::size_t> offsets;
  std::vector<std::size_t> strides;
  std::size_t offset = 0;
  for (const PcdField& field : header.fields) {
    offsets.push_back(offset);
    strides.push_back(field.bytes());
    offset += field.bytes() * header.points;
  }
  surface.points.resize(header.points);
  surface.normals.resize(use.has_normals ? header.points : 0);
  copyFields(data.data(), header, offsets, strides, use, origin, surface);
}
/** \brief One point a line. */
void
readText(const FileContent& file,
         const PcdHeader& header,
         const FieldUse& use,
         const std::array<double, 3>& origin,
         Surface& surface)
{
  struct Destination {
    std::vector<Vector3>* vectors = nullptr;
    std::size_t component = 0;
    double origin = 0.0;
  };
  std::vector<Destination> destinations(header.fields.size());
  std::size_t values = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    destinations[use.position[i]] = {&surface.points, i, origin[i]};
    if (use.has_normals)
      destinations[use.normal[i]] = {&surface.normals, i, 0.0};
  }
  for (const PcdField& field : header.fields)
    values += field.count;
  if (!fitsInto(header.points, 2 * values, file.size() - header.end_byte + 1))
    file.fail("the file is too short for " + std::to_string(header.points) + " points, or truncated");

  surface.points.resize(header.points);
  surface.normals.resize(use.has_normals ? header.points : 0);
  TextScanner text(file, {/*hash_comments=*/true, /*backslash_continues=*/false}, header.end_byte, header.end_line);
  for (std::size_t point = 0; point < header.points; ++point) {
    text.needLine("a further point");
    for (std::size_t i = 0; i < header.fields.size(); ++i) {
      for (std::size_t j = 0; j < header.fields[i].count; ++j) {
        const float value = text.numberFrom(destinations[i].origin);
        if (destinations[i].vectors != nullptr)
          (*destinations[i].vectors)[point][destinations[i].component] = value;
      }
    }
    text.needLineEnd();
  }
  if (text.nextLine())
    text.fail("unexpected " + quoted(text.word()) + " behind the last point");
}

} // namespace

Surface
readPcd(const FileContent& file, Reading& reading)
{
  const PcdHeader header = readPcdHeader(file);
  const FieldUse use = findFields(file, header);
  Surface surface;
  reading.single_precision =
      header.format != PcdFormat::Text && header.fields[use.position[0]].type == ScalarType::Float32;
  if (header.format == PcdFormat::Text)
    readText(file, header, use, reading.origin, surface);
  else if (header.format == PcdFormat::Binary)
    readBinary(file, header, use, reading.origin, surface);
  else
    readCompressed(file, header, use, reading.origin, surface);
  return surface;
}

} // namespace symmetry
} // namespace pcl
