#include "io/read/column_names.h"

#include "io/read/point_fields.h"
#include "io/read/text_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t no_axis = 3;
constexpr std::string_view blanks = " \t\"'";

std::string_view
trimmed(std::string_view word)
{
  const std::size_t begin = word.find_first_not_of(blanks);
  return begin == std::string_view::npos ? std::string_view()
                                         : word.substr(begin, word.find_last_not_of(blanks) + 1 - begin);
}

std::vector<std::string_view>
split(std::string_view line, char separator)
{
  std::vector<std::string_view> words;
  const std::string_view ends = separator == ' ' ? std::string_view(" \t") : std::string_view(&separator, 1);
  while (!line.empty()) {
    const std::size_t end = std::min(line.find_first_of(ends), line.size());
    const std::string_view word = trimmed(line.substr(0, end));
    if (!word.empty() || separator != ' ')
      words.push_back(word);
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return words;
}

/** \brief One spelling for what has several. */
std::string
usualName(const std::string& name)
{
  static const std::array<std::array<const char*, 4>, 6> spellings = {{{"nx", "normal_x", "normalx", "n_x"},
                                                                       {"ny", "normal_y", "normaly", "n_y"},
                                                                       {"nz", "normal_z", "normalz", "n_z"},
                                                                       {"red", "r", "rf", "red"},
                                                                       {"green", "g", "gf", "green"},
                                                                       {"blue", "b", "bf", "blue"}}};
  const std::string small = toLower(name);
  for (const auto& words : spellings)
    if (std::find(words.begin(), words.end(), small) != words.end())
      return words.front();
  return name;
}

/** \brief Columns of numbers, row by row. */
struct Table {
  const std::vector<float>& values;
  std::size_t columns;

  std::size_t
  rows() const
  {
    return values.size() / columns;
  }

  float
  at(std::size_t row, std::size_t column) const
  {
    return values[row * columns + column];
  }

  Vector3
  vectorAt(std::size_t row, std::size_t first) const
  {
    return {at(row, first), at(row, first + 1), at(row, first + 2)};
  }
};

/** \brief Whether three columns are vectors of length 1; rows without one (zero, not a number) may be there. */
bool
areNormals(const Table& table, std::size_t first)
{
  constexpr float tolerance = 0.02F; // two digits behind the point are the fewest that are written
  bool is_any = false;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Vector3 v = table.vectorAt(row, first);
    const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (std::isnan(length) || length == 0.0F)
      continue;
    if (std::abs(length - 1.0F) > tolerance)
      return false;
    is_any = true;
  }
  return is_any;
}

/** \brief Whether three columns are whole numbers up to 255. */
bool
areColours(const Table& table, std::size_t first)
{
  for (std::size_t row = 0; row < table.rows(); ++row)
    for (const float value : table.vectorAt(row, first))
      if (!(value >= 0.0F && value <= 255.0F) || value != std::floor(value))
        return false;
  return true;
}

/** \brief Names for columns that have none. */
std::vector<std::string>
guessNames(const Table& table)
{
  std::vector<std::string> names(table.columns);
  bool has_normals = false;
  bool has_colours = false;
  std::size_t column = 0;
  while (column < table.columns) {
    const auto name = [&](std::initializer_list<const char*> three) {
      std::copy(three.begin(), three.end(), names.begin() + static_cast<std::ptrdiff_t>(column));
      column += 3;
    };
    if (column + 3 <= table.columns && !has_normals && areNormals(table, column)) {
      name({"nx", "ny", "nz"});
      has_normals = true;
    }
    else if (column + 3 <= table.columns && !has_colours && areColours(table, column)) {
      name({"red", "green", "blue"});
      has_colours = true;
    }
    else {
      names[column] = "column_" + std::to_string(column + 4); // behind x, y and z
      ++column;
    }
  }
  return names;
}

} // namespace

ColumnNames::ColumnNames(std::string_view line, char separator, std::size_t count) : axes_(count, no_axis)
{
  const std::vector<std::string_view> words =
      split(line, line.find(separator) == std::string_view::npos ? ' ' : separator);
  std::array<std::size_t, 3> column_of{count, count, count};
  for (std::size_t column = 0; column < words.size(); ++column)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (toLower(words[column]) == std::string(1, "xyz"[axis]) && column_of[axis] == count)
        column_of[axis] = column;
  const bool is_named = words.size() == count &&
                        std::all_of(column_of.begin(), column_of.end(), [&](std::size_t c) { return c < count; });
  for (std::size_t axis = 0; axis < std::min<std::size_t>(3, count); ++axis)
    axes_[is_named ? column_of[axis] : axis] = axis;
  for (std::size_t column = 0; is_named && column < count; ++column)
    if (axes_[column] == no_axis)
      names_.push_back(usualName(plainFieldName(words[column], column)));
  is_named_ = is_named;
}

void
ColumnNames::deliver(const std::vector<float>& values, Surface& surface) const
{
  const std::size_t columns = size() - 3;
  if (columns == 0)
    return;
  const Table table{values, columns};
  const std::vector<std::string> names = is_named_ ? names_ : guessNames(table);
  const auto find = [&](const char* name) {
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
  };
  const std::array<std::size_t, 3> normal{find("nx"), find("ny"), find("nz")};
  const bool has_normals = std::all_of(normal.begin(), normal.end(), [&](std::size_t c) { return c < columns; });
  for (std::size_t row = 0; has_normals && row < surface.size(); ++row)
    surface.normals.push_back({table.at(row, normal[0]), table.at(row, normal[1]), table.at(row, normal[2])});
  FieldCollector fields;
  const auto is_kept = [&](std::size_t c) {
    return !has_normals || std::find(normal.begin(), normal.end(), c) == normal.end();
  };
  for (std::size_t c = 0; c < columns; ++c)
    if (is_kept(c))
      fields.add(c, names[c], ScalarType::Float32, 1);
  fields.resize(surface.size());
  for (std::size_t c = 0; c < columns; ++c)
    fields.copy(c, {reinterpret_cast<const char*>(values.data() + c), columns * sizeof(float), ScalarType::Float32,
                    /*swap_bytes=*/false});
  surface.fields = fields.take(0, 0);
}

} // namespace symmetry
} // namespace pcl
