#include "io/read/pcd_header.h"
#include "io/read/point_fields.h"
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
    file.failAtByte(header.end_byte,
                    std::to_string(compressed) + " compressed bytes stand for " + std::to_string(header.points) +
                        " points, which must repeat each other: write the file as binary if all are wanted");

  std::vector<char> data(uncompressed);
  if (uncompressed > 0 && lzfDecompress(sizes + sizes_bytes, compressed, data.data(), uncompressed) != uncompressed)
    file.failAtByte(header.end_byte + sizes_bytes, "the compressed data are damaged");
  return data;
}

/** \brief What is neither position nor normal nor padding, and of a known type. */
FieldCollector
findOtherFields(const PcdHeader& header, const FieldUse& use)
{
  FieldCollector fields;
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    const PcdField& field = header.fields[i];
    const auto is_among = [i](const std::array<std::size_t, 3>& used) {
      return std::find(used.begin(), used.end(), i) != used.end();
    };
    if (field.is_number && field.count > 0 && field.name != "_" && !is_among(use.position) &&
        !(use.has_normals && is_among(use.normal)))
      fields.add(i, field.name, field.type, field.count);
  }
  return fields;
}

/** \brief Stores the next word of a line; floats are rounded once. */
void
storeText(TextScanner& text, ScalarType type, char* to)
{
  storeScalar(to, type, type == ScalarType::Float32 ? double{text.number()} : text.preciseNumber());
}

/** \brief Fills the surface from one of the three kinds of data. */
class PcdReader {
public:
  PcdReader(const FileContent& file, const PcdHeader& header, Reading& reading)
      : file_(file),
        header_(header),
        use_(findFields(file, header)),
        origin_(reading.origin),
        fields_(findOtherFields(header, use_))
  {
    reading.single_precision =
        header.format != PcdFormat::Text && header.fields[use_.position[0]].type == ScalarType::Float32;
  }

  Surface
  read()
  {
    if (header_.format == PcdFormat::Text)
      readText();
    else if (header_.format == PcdFormat::Binary)
      readBinary();
    else
      readCompressed();
    surface_.fields = fields_.take(header_.width, header_.width == 0 ? 0 : header_.points / header_.width);
    return std::move(surface_);
  }

private:
  /** \brief Asks for memory; call it once the file is known to hold that many points. */
  void
  resize()
  {
    surface_.points.resize(header_.points);
    surface_.normals.resize(use_.has_normals ? header_.points : 0);
    fields_.resize(header_.points);
  }

  /** \brief Copies all that is wanted; offsets[i] and strides[i] place field i in \a data. */
  void
  copyFields(const char* data, const std::vector<std::size_t>& offsets, const std::vector<std::size_t>& strides)
  {
    const auto column = [&](std::size_t field) {
      return ScalarColumn{data + offsets[field], strides[field], header_.fields[field].type, false};
    };
    for (std::size_t i = 0; i < 3; ++i) {
      copyColumn(column(use_.position[i]), i, surface_.points, origin_[i]);
      if (use_.has_normals)
        copyColumn(column(use_.normal[i]), i, surface_.normals);
    }
    for (std::size_t i = 0; i < header_.fields.size(); ++i)
      fields_.copy(i, column(i));
  }

  /** \brief Points one after the other, each with all its fields. */
  void
  readBinary()
  {
    if (!fitsInto(header_.points, header_.pointBytes(), file_.size() - header_.end_byte))
      file_.failAtByte(file_.size(),
                       "the file ends before the last of its " + std::to_string(header_.points) + " points");
    std::vector<std::size_t> offsets;
    std::size_t offset = 0;
    for (const PcdField& field : header_.fields) {
      offsets.push_back(offset);
      offset += field.bytes();
    }
    resize();
    const std::vector<std::size_t> strides(header_.fields.size(), header_.pointBytes());
    copyFields(file_.data() + header_.end_byte, offsets, strides);
  }

  /** \brief Fields one after the other, each of all points, compressed as a whole. */
  void
  readCompressed()
  {
    const std::vector<char> data = unpack(file_, header_);
    std::vector<std::size_t> offsets;
    std::vector<std::size_t> strides;
    std::size_t offset = 0;
    for (const PcdField& field : header_.fields) {
      offsets.push_back(offset);
      strides.push_back(field.bytes());
      offset += field.bytes() * header_.points;
    }
    resize();
    copyFields(data.data(), offsets, strides);
  }

  /** \brief What becomes of a field: a component of positions or normals, or neither. */
  struct Destination {
    std::vector<Vector3>* vectors = nullptr;
    std::size_t component = 0;
    double origin = 0.0;
  };

  /** \brief One point a line. */
  void
  readText()
  {
    std::vector<Destination> destinations(header_.fields.size());
    std::size_t values = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      destinations[use_.position[i]] = {&surface_.points, i, origin_[i]};
      if (use_.has_normals)
        destinations[use_.normal[i]] = {&surface_.normals, i, 0.0};
    }
    for (const PcdField& field : header_.fields)
      values += field.count;
    if (!fitsInto(header_.points, 2 * values, file_.size() - header_.end_byte + 1))
      file_.fail("the file is too short for " + std::to_string(header_.points) + " points, or truncated");

    resize();
    TextScanner text(file_, {/*hash_comments=*/true, /*backslash_continues=*/false}, header_.end_byte,
                     header_.end_line);
    for (std::size_t point = 0; point < header_.points; ++point) {
      text.needLine("a further point");
      for (std::size_t i = 0; i < header_.fields.size(); ++i)
        for (std::size_t j = 0; j < header_.fields[i].count; ++j)
          readValue(text, destinations[i], point, i, j);
      text.needLineEnd();
    }
    if (text.nextLine())
      text.fail("unexpected " + quoted(text.word()) + " behind the last point");
  }

  void
  readValue(TextScanner& text, const Destination& to, std::size_t point, std::size_t field, std::size_t index)
  {
    if (to.vectors != nullptr)
      (*to.vectors)[point][to.component] = text.numberFrom(to.origin);
    else if (fields_.keeps(field))
      storeText(text, header_.fields[field].type, fields_.place(field, point, index));
    else
      text.number();
  }

  const FileContent& file_;
  const PcdHeader& header_;
  FieldUse use_;
  const std::array<double, 3>& origin_;
  FieldCollector fields_;
  Surface surface_;
};

} // namespace

Surface
readPcd(const FileContent& file, Reading& reading)
{
  const PcdHeader header = readPcdHeader(file);
  return PcdReader(file, header, reading).read();
}

} // namespace symmetry
} // namespace pcl
