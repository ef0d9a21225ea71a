#include "io/read/vtk_numbers.h"

#include "io/read/surface_builder.h"

#include <string>
#include <utility>

namespace pcl {
namespace symmetry {

std::size_t
VtkNumbers::readCount()
{
  const std::int64_t count = text_->integer();
  if (count < 0 || static_cast<std::uint64_t>(count) > point_limit)
    text_->fail(std::to_string(count) + " is no number of anything that can be read");
  return static_cast<std::size_t>(count);
}

/** \brief The type of numbers that a word in small letters names. */
ScalarType
VtkNumbers::typeOf(std::string_view name) const
{
  static const std::array<std::pair<const char*, ScalarType>, 15> types = {
      {{"char", ScalarType::Int8},
       {"signed_char", ScalarType::Int8},
       {"unsigned_char", ScalarType::UInt8},
       {"short", ScalarType::Int16},
       {"unsigned_short", ScalarType::UInt16},
       {"int", ScalarType::Int32},
       {"unsigned_int", ScalarType::UInt32},
       {"long", ScalarType::Int64},
       {"unsigned_long", ScalarType::UInt64},
       {"vtktypeint64", ScalarType::Int64},
       {"vtktypeuint64", ScalarType::UInt64},
       {"vtktypeint32", ScalarType::Int32},
       {"vtkidtype", ScalarType::Int32}, // is written with 4 bytes
       {"float", ScalarType::Float32},
       {"double", ScalarType::Float64}}};
  for (const auto& [known, type] : types)
    if (name == known)
      return type;
  text_->fail(quoted(name) + " is no type of numbers");
}

ScalarType
VtkNumbers::readType()
{
  return typeOf(toLower(text_->word()));
}

/** \brief Goes to a byte, behind numbers; whatever is on its line begins a line. */
void
VtkNumbers::goTo(std::size_t byte)
{
  const std::size_t line = text_->line();
  text_.emplace(file_, TextSyntax{}, byte, line);
}

/** \brief The numbers behind the line as a column; the next line is that behind them. */
ScalarColumn
VtkNumbers::takeBinary(std::size_t count, ScalarType type)
{
  text_->finishLine();
  const std::size_t begin = text_->position();
  if (!fitsInto(count, sizeOf(type), text_->remaining()))
    file_.failAtByte(file_.size(), "the file ends within " + std::to_string(count) + " numbers that begin at byte " +
                                       std::to_string(begin));
  goTo(begin + count * sizeOf(type));
  return {file_.data() + begin, sizeOf(type), type, /*swap_bytes=*/true};
}

/** \brief Makes sure that the file may hold so many numbers, and that each is found on this line or a later one. */
void
VtkNumbers::expectText(std::size_t count)
{
  text_->needLineEnd();
  if (!fitsInto(count, 2, text_->remaining() + 1))
    text_->fail("the file is too short for " + std::to_string(count) + " numbers, or truncated");
}

void
VtkNumbers::toNumber()
{
  if (text_->atLineEnd())
    text_->needLine("a number");
}

std::vector<Vector3>
VtkNumbers::readPoints(std::size_t count, ScalarType type, const std::array<double, 3>& origin)
{
  std::vector<Vector3> points;
  if (is_binary_) {
    ScalarColumn column = takeBinary(3 * count, type);
    column.stride *= 3;
    points.resize(count);
    for (std::size_t axis = 0; axis < 3; ++axis, column.first += sizeOf(type))
      copyColumn(column, axis, points, origin[axis]);
    return points;
  }
  expectText(3 * count);
  points.resize(count);
  for (Vector3& point : points)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      toNumber();
      point[axis] = text_->numberFrom(origin[axis]);
    }
  return points;
}

std::vector<std::int64_t>
VtkNumbers::readIntegers(std::size_t count, ScalarType type)
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

std::vector<std::int64_t>
VtkNumbers::readNamedIntegers(const char* name, std::size_t count)
{
  text_->needLine(name);
  std::string word = toLower(text_->word());
  if (word == "metadata") {
    passOverMetadata(1);
    text_->needLine(name);
    word = toLower(text_->word());
  }
  if (word != toLower(name))
    text_->fail(std::string("'") + name + "' is expected");
  const ScalarType type = readType();
  if (!isInteger(type))
    text_->fail(std::string(name) + " are no integers");
  return readIntegers(count, type);
}

void
VtkNumbers::passOver(std::size_t count, ScalarType type)
{
  if (is_binary_) {
    takeBinary(count, type);
    return;
  }
  expectText(count);
  for (std::size_t i = 0; i < count; ++i) {
    toNumber();
    text_->preciseNumber();
  }
}

std::size_t
VtkNumbers::passOverArray()
{
  const std::size_t components = readCount();
  const std::uint64_t values = std::uint64_t{components} * readCount();
  if (values > point_limit)
    text_->fail("an array of " + std::to_string(values) + " values");
  const auto count = static_cast<std::size_t>(values);
  const std::string type = toLower(text_->word());
  if (type == "string" || type == "utf8_string")
    passOverStrings(count);
  else if (type == "bit" && is_binary_)
    takeBinary((count + 7) / 8, ScalarType::UInt8);
  else
    passOver(count, type == "bit" ? ScalarType::UInt8 : typeOf(type));
  return components;
}

void
VtkNumbers::passOverStrings(std::size_t count)
{
  if (!is_binary_) { // a line each, which may be empty
    text_->needLineEnd();
    for (std::size_t i = 0; i < count; ++i)
      if (!text_->nextLineOrEmpty())
        text_->fail("the file ends within " + std::to_string(count) + " strings");
    return;
  }
  text_->finishLine();
  std::size_t next = text_->position();
  for (std::size_t i = 0; i < count; ++i) {
    // Two bits of the first byte say how many bytes the length takes: 3 one, 2 two, 1 four, 0 eight.
    const auto first = static_cast<unsigned char>(next < file_.size() ? file_.data()[next] : 0);
    const std::size_t bytes = std::size_t{8} >> (first >> 6U);
    if (!fitsInto(bytes, 1, file_.size() - next))
      file_.failAtByte(file_.size(), "the file ends within " + std::to_string(count) + " strings");
    std::uint64_t length = first & 0x3FU;
    for (std::size_t k = 1; k < bytes; ++k)
      length = length << 8U | static_cast<unsigned char>(file_.data()[next + k]);
    next += bytes;
    if (!fitsInto(length, 1, file_.size() - next))
      file_.failAtByte(file_.size(), "the file ends within a string of " + std::to_string(length) + " bytes");
    next += static_cast<std::size_t>(length);
  }
  goTo(next);
}

void
VtkNumbers::passOverMetadata(std::size_t components)
{
  std::int64_t keys = 0; // still to come
  while (text_->nextLineOrEmpty()) {
    if (text_->atLineEnd()) {
      if (keys <= 0)
        return;
      continue; // an empty string of a list, before the next key
    }
    const std::string word = toLower(text_->word());
    if (word == "component_names") {
      for (std::size_t i = 0; i < components && text_->nextLineOrEmpty(); ++i)
        ;
    }
    else if (word == "information")
      keys = text_->integer();
    else if (word == "name")
      --keys;
    else if (word != "data" && !text_->atLineEnd()) // VTK writes strings as single words
      text_->fail("METADATA has no empty line at its end, before " + quoted(word));
  }
}

} // namespace symmetry
} // namespace pcl
