#include "io/read/pcd_header.h"

#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

#include <map>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Bytes that the values of one point may take; keeps all products of sizes far from overflow. */
constexpr std::size_t point_byte_limit = 1 << 20;

/** \brief The lines of the header, as words; fields are made of several lines together. */
struct HeaderLines {
  std::map<std::string, std::vector<std::string>> words;
  std::map<std::string, std::size_t> numbers;
};

HeaderLines
readLines(TextScanner& text)
{
  static const std::vector<std::string> keywords = {"VERSION", "FIELDS", "COLUMNS",   "SIZE",   "TYPE", "COUNT",
                                                    "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
  HeaderLines lines;
  for (;;) {
    text.needLine("a line of the header, up to 'DATA',");
    const std::string keyword(text.word());
    bool known = false;
    for (const std::string& candidate : keywords)
      known = known || keyword == candidate;
    if (!known)
      text.fail("unexpected " + quoted(keyword) + " in the header: not a PCD file?");
    if (!lines.numbers.emplace(keyword, text.line()).second)
      text.fail("a second line " + quoted(keyword));
    std::vector<std::string>& words = lines.words[keyword];
    for (std::string_view word = text.word(); !word.empty(); word = text.word())
      words.emplace_back(word);
    if (keyword == "DATA")
      return lines;
  }
}

/** \brief Takes the header apart, with complaints that name the line. */
class PcdHeaderReader {
public:
  explicit PcdHeaderReader(const FileContent& file)
      : file_(file), text_(file, {/*hash_comments=*/true, /*backslash_continues=*/false}), lines_(readLines(text_))
  {
  }

  PcdHeader
  read()
  {
    PcdHeader header;
    header.format = readFormat();
    header.fields = readFields();
    header.points = readPoints(header);
    text_.finishLine();
    header.end_byte = text_.position();
    header.end_line = text_.line();
    return header;
  }

private:
  bool
  has(const std::string& keyword) const
  {
    return lines_.words.count(keyword) != 0;
  }

  [[noreturn]] void
  failAt(const std::string& keyword, const std::string& reason) const
  {
    file_.failAtLine(lines_.numbers.at(keyword), reason);
  }

  /** \brief The words of a line that must be there. */
  const std::vector<std::string>&
  wordsOf(const std::string& keyword, std::size_t count) const
  {
    if (!has(keyword))
      file_.fail("the header has no line '" + keyword + "'");
    const std::vector<std::string>& words = lines_.words.at(keyword);
    if (words.size() != count)
      failAt(keyword,
             "'" + keyword + "' has " + std::to_string(words.size()) + " values instead of " + std::to_string(count));
    return words;
  }

  std::size_t
  toSize(const std::string& keyword, const std::string& word, std::uint64_t least, std::uint64_t most) const
  {
    std::int64_t value = 0;
    if (!parseInteger(word, value) || value < static_cast<std::int64_t>(least) ||
        value > static_cast<std::int64_t>(most))
      failAt(keyword, quoted(word) + " is no possible value of '" + keyword + "'");
    return static_cast<std::size_t>(value);
  }

  PcdFormat
  readFormat() const
  {
    const std::string word = toLower(wordsOf("DATA", 1).front());
    if (word == "ascii")
      return PcdFormat::Text;
    if (word == "binary")
      return PcdFormat::Binary;
    if (word == "binary_compressed")
      return PcdFormat::Compressed;
    failAt("DATA", quoted(wordsOf("DATA", 1).front()) + " is not a kind of data: ascii, binary or binary_compressed");
  }

  std::vector<PcdField>
  readFields() const
  {
    const std::string names_line = has("COLUMNS") && !has("FIELDS") ? "COLUMNS" : "FIELDS";
    if (!has(names_line))
      file_.fail("the header has no line 'FIELDS'");
    const std::vector<std::string>& names = lines_.words.at(names_line);
    const std::vector<std::string>& sizes = wordsOf("SIZE", names.size());
    const std::vector<std::string>& types = wordsOf("TYPE", names.size());
    const std::vector<std::string> ones(names.size(), "1");
    const std::vector<std::string>& counts = has("COUNT") ? wordsOf("COUNT", names.size()) : ones;

    std::vector<PcdField> fields(names.size());
    std::size_t point_bytes = 0;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      fields[i].name = names[i];
      fields[i].value_bytes = toSize("SIZE", sizes[i], 1, point_byte_limit);
      fields[i].count = toSize("COUNT", counts[i], 0, point_byte_limit); // 0: the field is named, but takes no room
      fields[i].is_number = findType(toLower(types[i]), fields[i].value_bytes, fields[i].type);
      point_bytes += fields[i].bytes();
      if (point_bytes > point_byte_limit)
        failAt("SIZE", "the fields of one point take more than " + std::to_string(point_byte_limit) + " bytes");
    }
    return fields;
  }

  static bool
  findType(const std::string& letter, std::size_t bytes, ScalarType& type)
  {
    static const std::map<std::pair<std::string, std::size_t>, ScalarType> types = {
        {{"i", 1}, ScalarType::Int8},   {{"i", 2}, ScalarType::Int16},  {{"i", 4}, ScalarType::Int32},
        {{"i", 8}, ScalarType::Int64},  {{"u", 1}, ScalarType::UInt8},  {{"u", 2}, ScalarType::UInt16},
        {{"u", 4}, ScalarType::UInt32}, {{"u", 8}, ScalarType::UInt64}, {{"f", 4}, ScalarType::Float32},
        {{"f", 8}, ScalarType::Float64}};
    const auto found = types.find({letter, bytes});
    if (found == types.end())
      return false;
    type = found->second;
    return true;
  }

  std::size_t
  readPoints(PcdHeader& header) const
  {
    const std::uint64_t width = toSize("WIDTH", wordsOf("WIDTH", 1).front(), 0, point_limit);
    const std::uint64_t height = has("HEIGHT") ? toSize("HEIGHT", wordsOf("HEIGHT", 1).front(), 0, point_limit) : 1;
    if (height != 0 && width > point_limit / height)
      failAt("WIDTH", "more points than can be numbered");
    if (has("POINTS") && toSize("POINTS", wordsOf("POINTS", 1).front(), 0, point_limit) != width * height)
      failAt("POINTS", "POINTS is not WIDTH times HEIGHT");
    header.width = height > 1 ? static_cast<std::size_t>(width) : 0;
    return static_cast<std::size_t>(width * height);
  }

  const FileContent& file_;
  TextScanner text_;
  HeaderLines lines_;
};

} // namespace

PcdHeader
readPcdHeader(const FileContent& file)
{
  return PcdHeaderReader(file).read();
}

std::size_t
PcdHeader::pointBytes() const
{
  std::size_t bytes = 0;
  for (const PcdField& field : fields)
    bytes += field.bytes();
  return bytes;
}

} // namespace symmetry
} // namespace pcl
