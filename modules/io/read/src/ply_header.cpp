#include "io/read/ply_header.h"

#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

ScalarType
readType(TextScanner& text)
{
  static const std::pair<std::string_view, ScalarType> types[] = {
      {"char", ScalarType::Int8},       {"int8", ScalarType::Int8},      {"uchar", ScalarType::UInt8},
      {"uint8", ScalarType::UInt8},     {"short", ScalarType::Int16},    {"int16", ScalarType::Int16},
      {"ushort", ScalarType::UInt16},   {"uint16", ScalarType::UInt16},  {"int", ScalarType::Int32},
      {"int32", ScalarType::Int32},     {"uint", ScalarType::UInt32},    {"uint32", ScalarType::UInt32},
      {"int64", ScalarType::Int64},     {"uint64", ScalarType::UInt64},  {"float", ScalarType::Float32},
      {"float32", ScalarType::Float32}, {"double", ScalarType::Float64}, {"float64", ScalarType::Float64}};
  const std::string_view name = text.word();
  for (const auto& [known, type] : types)
    if (name == known)
      return type;
  text.fail(quoted(name) + " is not a type of PLY");
}

std::string
readName(TextScanner& text)
{
  const std::string_view name = text.word();
  if (name.empty())
    text.fail("a name is missing");
  text.needLineEnd();
  return std::string(name);
}

PlyFormat
readFormat(TextScanner& text)
{
  const std::string_view format = text.word();
  const std::string_view version = text.word();
  if (version != "1.0")
    text.fail("version " + quoted(version) + " of PLY is not known, only 1.0");
  text.needLineEnd();
  if (format == "ascii")
    return PlyFormat::Text;
  if (format == "binary_little_endian")
    return PlyFormat::LittleEndian;
  if (format == "binary_big_endian")
    return PlyFormat::BigEndian;
  text.fail(quoted(format) + " is not a format of PLY");
}

PlyElement
readElement(TextScanner& text)
{
  PlyElement element;
  element.name = std::string(text.word());
  const std::int64_t count = text.integer();
  if (count < 0 || static_cast<std::uint64_t>(count) > point_limit)
    text.fail(std::to_string(count) + " is no number of elements");
  element.count = static_cast<std::size_t>(count);
  element.line = text.line();
  text.needLineEnd();
  return element;
}

PlyProperty
readProperty(TextScanner& text)
{
  PlyProperty property;
  TextScanner ahead = text;
  if (ahead.word() == "list") {
    text.word();
    property.is_list = true;
    property.count_type = readType(text);
    if (!isInteger(property.count_type))
      text.fail("the length of a list must be of an integer type");
  }
  property.type = readType(text);
  property.name = readName(text);
  return property;
}

/** \brief Reads `num_cols` or `num_rows` and its number; other words have no meaning. */
void
readRaster(TextScanner& text, PlyHeader& header)
{
  const std::string_view name = text.word();
  std::int64_t count = 0;
  if (!parseInteger(text.word(), count) || count < 1 || static_cast<std::uint64_t>(count) > point_limit)
    return;
  if (name == "num_cols")
    header.columns = static_cast<std::size_t>(count);
  else if (name == "num_rows")
    header.rows = static_cast<std::size_t>(count);
}

/** \brief Whether a word is a keyword with one letter, or two, too many, too few, or other ones. */
bool
isMisspelled(const std::string& word)
{
  for (const std::string keyword : {"format", "element", "property", "end_header", "comment", "obj_info"}) {
    // Levenshtein's distance, row by row.
    std::vector<std::size_t> row(keyword.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < word.size() && i < 2 * keyword.size(); ++i) {
      std::size_t diagonal = row[0]++;
      for (std::size_t j = 0; j < keyword.size(); ++j) {
        const std::size_t replaced = diagonal + (word[i] == keyword[j] ? 0 : 1);
        diagonal = row[j + 1];
        row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
      }
    }
    if (row.back() <= 2)
      return true;
  }
  return false;
}

/** \brief Reads the lines between the first and end_header; true where one of them gave the format. */
bool
readStatements(TextScanner& text, PlyHeader& header)
{
  bool has_format = false;
  for (;;) {
    text.needLine("'end_header'");
    const std::string_view keyword = text.word();
    if (keyword == "end_header")
      return has_format;
    if (keyword == "comment")
      continue;
    if (keyword == "obj_info") {
      readRaster(text, header);
      continue;
    }
    if (keyword == "format") {
      header.format = readFormat(text);
      has_format = true;
    }
    else if (keyword == "element") {
      header.elements.push_back(readElement(text));
    }
    else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(readProperty(text));
    }
    else if (keyword == "property" || isMisspelled(toLower(keyword))) {
      text.fail("unexpected " + quoted(keyword) + " in the header");
    }
    else if (header.notes.empty()) { // the second line of a comment, mostly
      header.notes.push_back("line " + std::to_string(text.line()) + ": lines of the header without keyword, first " +
                             quoted(keyword) + ", were passed over");
    }
  }
}

/** \brief Fewest bytes that a record can take. */
std::size_t
leastBytes(const PlyElement& element, PlyFormat format)
{
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties) {
    if (format == PlyFormat::Text)
      bytes += 2; // a digit and what separates it from the next
    else
      bytes += sizeOf(property.is_list ? property.count_type : property.type);
  }
  return bytes;
}

void
checkSize(const FileContent& file, const PlyHeader& header)
{
  // The last number of a text may lack its separator.
  std::size_t available = file.size() - header.end_byte + (header.format == PlyFormat::Text ? 1 : 0);
  for (const PlyElement& element : header.elements) {
    const std::size_t bytes = leastBytes(element, header.format);
    if (!fitsInto(element.count, bytes, available))
      file.failAtLine(element.line, "the file is too short for " + std::to_string(element.count) + " elements " +
                                        quoted(element.name) + ", or truncated");
    available -= element.count * bytes;
  }
}

} // namespace

bool
PlyElement::hasLists() const
{
  return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& p) { return p.is_list; });
}

PlyHeader
readPlyHeader(const FileContent& file)
{
  TextScanner text(file);
  text.needLine("'ply'");
  if (text.word() != "ply" || !text.atLineEnd())
    text.fail("does not begin with 'ply': not a PLY file");
  PlyHeader header;
  if (!readStatements(text, header))
    text.fail("the header has no 'format'");
  text.finishLine();
  header.end_byte = text.position();
  header.end_line = text.line();
  checkSize(file, header);
  return header;
}

} // namespace symmetry
} // namespace pcl
