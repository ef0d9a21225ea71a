#include "io/read/column_names.h"
#include "io/read/readers.h"
#include "io/read/surface_builder.h"
#include "io/read/text_scanner.h"

namespace pcl {
namespace symmetry {
namespace {

/** \brief Where the rows begin, and what is known of their columns before one is read. */
struct XyzLayout {
  std::size_t begin = 0; ///< byte of the first row
  std::size_t line = 1;  ///< its line
  char separator = ' ';
  std::string names; ///< the last line before the rows that is no number, without the marks of a comment
  std::size_t names_line = 0;
  bool is_comment = false; ///< that line: names nothing where it does not fit
};

/** Within which the next row shows what parts its values. */
constexpr std::size_t longest_line = 100;

/** \brief Length of the mark that begins a comment, 0 for a line that is none. */
std::size_t
commentMark(std::string_view line)
{
  if (line.substr(0, 2) == "//")
    return 2;
  return line.substr(0, 1) == "#" || line.substr(0, 1) == "%" ? 1 : 0;
}

/** \brief Which character parts the values of a row: a semicolon, or else a comma, or else blanks. */
char
separatorOf(std::string_view row)
{
  for (const char separator : {';', ','})
    if (row.find(separator) != std::string_view::npos)
      return separator;
  return ' ';
}

bool
beginsWithNumber(std::string_view line)
{
  const std::string_view word = line.substr(0, line.find_first_of(" \t,;"));
  const std::string small = toLower(word);
  const std::size_t sign = small.find_first_not_of("+-") == std::string::npos ? 0 : small.find_first_not_of("+-");
  const std::string_view digits = std::string_view(small).substr(sign);
  return digits.substr(0, 3) == "nan" || digits.substr(0, 3) == "inf" ||
         (!digits.empty() && digits.find_first_not_of("0123456789.e+-") == std::string_view::npos &&
          digits.find_first_of("0123456789") != std::string_view::npos);
}

/** \brief Finds the first row, and the line before it that may name the columns. */
XyzLayout
findLayout(const FileContent& file)
{
  XyzLayout layout;
  TextScanner text(file);
  while (text.nextLine()) {
    layout.begin = text.position();
    layout.line = text.line();
    const std::string_view rest = file.view().substr(layout.begin);
    const std::string_view line = rest.substr(0, rest.find_first_of("\r\n"));
    const std::size_t mark = commentMark(line);
    if (mark == 0 && beginsWithNumber(line)) {
      layout.separator = separatorOf(line);
      if (line.find_first_of(" \t,;") == std::string_view::npos) // the number of points, more likely than not
        layout.separator = separatorOf(rest.substr(line.size()).substr(0, longest_line));
      return layout;
    }
    if (!layout.names.empty() && !layout.is_comment)
      break; // neither names, of which there is one line, nor numbers
    layout.names = line.substr(mark);
    layout.names_line = layout.line;
    layout.is_comment = mark > 0;
  }
  if (!layout.names.empty() && !layout.is_comment)
    file.failAtLine(layout.line, layout.line == layout.names_line ? "holds no row of numbers below its names"
                                                                  : "holds neither names of columns nor numbers");
  file.fail("holds no row of numbers");
}

/** \brief Reads rows of equally many numbers. */
class XyzReader {
public:
  XyzReader(const FileContent& file, const XyzLayout& layout, const Reading& reading)
      : origin_(reading.origin),
        layout_(layout),
        text_(
            file, {/*hash_comments=*/true, /*backslash_continues=*/false, layout.separator}, layout.begin, layout.line)
  {
  }

  Surface
  read()
  {
    passOverCount();
    while (nextRow(text_))
      readRow();
    if (announced_ >= 0 && announced_ != static_cast<std::int64_t>(surface_.size()))
      text_.fail("the first line announces " + std::to_string(announced_) + " points, but there are " +
                 std::to_string(surface_.size()));
    columns_.deliver(rest_, surface_);
    return std::move(surface_);
  }

private:
  /** \brief Goes to the next line that holds numbers; false at the end. */
  static bool
  nextRow(TextScanner& text)
  {
    while (text.nextLine())
      if (commentMark(text.ahead(2)) == 0)
        return true;
    return false;
  }

  /** \brief Number of words of the next row. */
  static std::size_t
  countWords(TextScanner text)
  {
    std::size_t words = 0;
    if (nextRow(text))
      while (!text.word().empty())
        ++words;
    return words;
  }

  /** \brief A first line of one integer is the number of points; the row behind it tells the columns. */
  void
  passOverCount()
  {
    if (countWords(text_) == 1) {
      nextRow(text_);
      announced_ = text_.integer();
    }
    learnColumns(countWords(text_));
  }

  void
  learnColumns(std::size_t count)
  {
    columns_ = ColumnNames(layout_.names, layout_.separator, count);
    if (!layout_.names.empty() && !layout_.is_comment && !columns_.isNamed())
      text_.fail("the line above names no columns x, y and z, or not as many as there are: " +
                 quoted(std::string_view(layout_.names)));
    if (count == 0)
      text_.fail("the file ends where rows of numbers are expected");
    if (count < 3 && nextRow(text_))
      text_.fail("a row of " + std::to_string(count) + " values, which is no position");
    surface_.points.reserve(text_.remaining() / (2 * count));
    rest_.reserve(surface_.points.capacity() * (count - 3));
  }

  void
  readRow()
  {
    if (surface_.size() >= point_limit)
      text_.fail("more points than can be numbered");
    Vector3 point = {};
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      if (text_.atLineEnd())
        text_.fail("a row of " + std::to_string(column) + " values, the first one has " +
                   std::to_string(columns_.size()));
      const std::size_t axis = columns_.axisOf(column);
      if (axis < 3)
        point[axis] = text_.numberFrom(origin_[axis]);
      else
        rest_.push_back(text_.number());
    }
    text_.needLineEnd();
    surface_.points.push_back(point);
  }

  const std::array<double, 3>& origin_;
  const XyzLayout& layout_;
  TextScanner text_;
  ColumnNames columns_;
  Surface surface_;
  std::vector<float> rest_; ///< row by row, what is no position
  std::int64_t announced_ = -1;
};

} // namespace

Surface
readXyz(const FileContent& file, Reading& reading)
{
  const XyzLayout layout = findLayout(file);
  return XyzReader(file, layout, reading).read();
}

} // namespace symmetry
} // namespace pcl
