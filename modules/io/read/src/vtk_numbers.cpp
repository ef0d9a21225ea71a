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

ScalarType
VtkNumbers::readType()
{
  static const std::array<std::pair<const char*, ScalarType>, 13> types = {
      {{"char", ScalarType::Int8},
       {"unsigned_char", ScalarType::UInt8},
       {"short", ScalarType::Int16},
       {"unsigned_short", ScalarType::UInt16},
       {"int", ScalarType::Int32},
       {"unsigned_int", ScalarType::UInt32},
       {"long", ScalarType::Int64},
       {"unsigned_long", ScalarType::UInt64},
       {"vtktypeint64", ScalarType::Int64},
       {"vtktypeint32", ScalarType::Int32},
       {"vtkidtype", ScalarType::Int32}, // is written with 4 bytes
       {"float", ScalarType::Float32},
       {"double", ScalarType::Float64}}};
  const std::string name = toLower(text_->word());
  for (const auto& [known, type] : types)
    if (name == known)
      return type;
  text_->fail(quoted(std::string_view(name)) + " is no type of numbers");
}

/** \brief The numbers behind the line as a column; the next line is that behind them. */
ScalarColumn
VtkNumbers::takeBinary(std::size_t count, ScalarType type)
{
  text_->finishLine();
  const std::size_t begin = text_->position();
  const std::size_t line = text_->line();
  if (!fitsInto(count, sizeOf(type), text_->remaining()))
    file_.failAtByte(file_.size(), "the file ends within " + std::to_string(count) + " numbers that begin at byte " +
                                       std::to_string(begin));
  text_.emplace(file_, TextSyntax{}, begin + count * sizeOf(type), line);
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
  if (toLower(text_->word()) != toLower(name))
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

} // namespace symmetry
} // namespace pcl
