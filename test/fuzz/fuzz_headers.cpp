// Files of PLY and PCD that are right but for a few places: header and data belong together, of any elements, properties,
// fields and types that there are; now and then one of the words, counts or values is any other.
#include "fuzz/fuzzed_file.h"
#include "io/read/scalar_type.h"

#include <pcl/io/lzf.h>

#include <algorithm>
#include <cstdint>
#include <fuzzer/FuzzedDataProvider.h>
#include <utility>
#include <vector>

using namespace pcl::symmetry;

namespace {

using Choice = FuzzedDataProvider;

/** Whether this place is to be wrong. No bytes left: all is right. */
bool
isWrong(Choice& choice)
{
  return choice.ConsumeIntegral<std::uint8_t>() >= 250;
}

std::string
anyNumber(Choice& choice)
{
  switch (choice.ConsumeIntegralInRange(0, 3)) {
  case 0:
    return std::to_string(choice.ConsumeIntegral<std::int64_t>());
  case 1:
    return std::to_string(choice.ConsumeIntegral<std::uint32_t>());
  case 2:
    return choice.ConsumeRandomLengthString(12);
  default:
    return std::to_string(choice.ConsumeIntegralInRange(-2, 40));
  }
}

std::string
count(Choice& choice, std::size_t right)
{
  return isWrong(choice) ? anyNumber(choice) : std::to_string(right);
}

std::string
word(Choice& choice, const std::string& right)
{
  return isWrong(choice) ? choice.ConsumeRandomLengthString(12) : right;
}

/** A type and its names in both formats. */
struct NamedType {
  ScalarType type;
  const char* ply;
  const char* pcd;
};

constexpr NamedType types[] = {
    {ScalarType::Float32, "float", "F"}, {ScalarType::Float64, "double", "F"}, {ScalarType::Int8, "char", "I"},
    {ScalarType::UInt8, "uint8", "U"},   {ScalarType::Int16, "short", "I"},    {ScalarType::UInt16, "ushort", "U"},
    {ScalarType::Int32, "int32", "I"},   {ScalarType::UInt32, "uint", "U"},    {ScalarType::Int64, "int64", "I"},
    {ScalarType::UInt64, "uint64", "U"},
};

/** A column of numbers: property or field. */
struct Column {
  std::string name;
  NamedType type;
  std::size_t values = 1;
  bool is_list = false;
};

NamedType
anyType(Choice& choice, std::size_t first = 0)
{
  return types[choice.ConsumeIntegralInRange<std::size_t>(first, std::size(types) - 1)];
}

/** Positions, and whatever else, in any order. */
std::vector<Column>
columnsOfPoints(Choice& choice, const std::vector<std::string>& others)
{
  std::vector<Column> columns;
  for (const char* name : {"x", "y", "z"}) {
    columns.push_back({name, choice.ConsumeBool() ? types[0] : anyType(choice)});
  }
  for (const std::string& name : others) {
    if (choice.ConsumeBool()) {
      columns.push_back({name, anyType(choice), choice.ConsumeIntegralInRange<std::size_t>(0, 3)});
    }
  }
  if (choice.ConsumeBool()) {
    std::swap(columns.front(), columns[choice.ConsumeIntegralInRange<std::size_t>(0, columns.size() - 1)]);
  }
  if (isWrong(choice)) {
    columns.erase(columns.begin());
  }
  return columns;
}

/** Appends a value, as a word or as bytes. */
void
append(std::string& data, Choice& choice, ScalarType type, bool is_text, bool is_swapped, std::int64_t value)
{
  if (isWrong(choice)) {
    data += is_text ? anyNumber(choice) + " " : choice.ConsumeBytesAsString(sizeOf(type));
    return;
  }
  if (is_text) {
    data += std::to_string(value) + (type == ScalarType::Float32 ? ".5 " : " ");
    return;
  }
  std::string bytes(sizeOf(type), '\0');
  storeScalar(bytes.data(), type, static_cast<double>(value));
  if (is_swapped) {
    std::reverse(bytes.begin(), bytes.end());
  }
  data += bytes;
}

std::string
plyFile(Choice& choice)
{
  const int format = choice.ConsumeIntegralInRange(0, 2);
  const bool is_text = format == 0;
  const auto points = choice.ConsumeIntegralInRange<std::size_t>(0, 9);
  const std::string format_name = is_text ? "ascii" : format == 1 ? "binary_little_endian" : "binary_big_endian";
  std::string header = "ply\nformat " + word(choice, format_name) + " 1.0\n";
  std::string data;
  std::vector<std::string> elements = {"vertex", "face", "edge", "tristrips"};
  if (choice.ConsumeBool()) {
    std::swap(elements[0], elements[choice.ConsumeIntegralInRange<std::size_t>(0, 3)]);
  }
  for (const std::string& name : elements) {
    const bool is_vertex = name == "vertex";
    if (!is_vertex && !choice.ConsumeBool()) {
      continue;
    }
    const std::size_t records = is_vertex ? points : choice.ConsumeIntegralInRange<std::size_t>(0, 6);
    const std::vector<Column> columns =
        is_vertex ? columnsOfPoints(choice, {"nx", "ny", "nz", "red", "quality"})
                  : std::vector<Column>{{choice.ConsumeBool() ? "vertex_indices" : "vertex_index", anyType(choice, 2),
                                         1, name != "edge" || choice.ConsumeBool()},
                                        {"flags", anyType(choice), 1, choice.ConsumeBool()}};
    header += "element " + word(choice, name) + " " + count(choice, records) + "\n";
    const NamedType count_type = anyType(choice, 2);
    for (const Column& column : columns) {
      header += "property " + (column.is_list ? std::string("list ") + count_type.ply + " " : std::string()) +
                word(choice, column.type.ply) + " " + word(choice, column.name) + "\n";
    }
    for (std::size_t record = 0; record < records; ++record) {
      for (const Column& column : columns) {
        const std::size_t values = column.is_list ? choice.ConsumeIntegralInRange<std::size_t>(0, 5) : 1;
        if (column.is_list) {
          append(data, choice, count_type.type, is_text, format == 2, static_cast<std::int64_t>(values));
        }
        for (std::size_t k = 0; k < values; ++k) {
          append(data, choice, column.type.type, is_text, format == 2,
                 choice.ConsumeIntegralInRange<std::int64_t>(
                     0, is_vertex || points == 0 ? 9 : static_cast<std::int64_t>(points) - 1));
        }
      }
      data += is_text ? "\n" : "";
    }
  }
  return header + word(choice, "end_header") + "\n" + data;
}

/** Column by column, packed. */
std::string
compressed(Choice& choice, const std::vector<Column>& columns, std::size_t points)
{
  std::string data;
  for (const Column& column : columns) {
    for (std::size_t i = 0; i < points * column.values; ++i) {
      append(data, choice, column.type.type, false, false, choice.ConsumeIntegralInRange<std::int64_t>(0, 9));
    }
  }
  std::string packed(2 * data.size() + 16, '\0');
  packed.resize(pcl::lzfCompress(data.data(), static_cast<unsigned>(data.size()), packed.data(),
                                 static_cast<unsigned>(packed.size())));
  std::string sizes(8, '\0');
  storeScalar(sizes.data(), ScalarType::UInt32, static_cast<double>(packed.size()));
  storeScalar(sizes.data() + 4, ScalarType::UInt32, static_cast<double>(data.size()));
  if (isWrong(choice)) {
    sizes = choice.ConsumeBytesAsString(8);
  }
  if (isWrong(choice)) {
    packed = choice.ConsumeRandomLengthString(100);
  }
  return sizes + packed;
}

std::string
pcdFile(Choice& choice)
{
  const int format = choice.ConsumeIntegralInRange(0, 2);
  const auto width = choice.ConsumeIntegralInRange<std::size_t>(0, 6);
  const auto height = choice.ConsumeIntegralInRange<std::size_t>(1, 3);
  const std::vector<Column> columns =
      columnsOfPoints(choice, {"normal_x", "normal_y", "normal_z", "rgb", "_", "label"});
  std::string lines[4] = {"FIELDS", "SIZE", "TYPE", "COUNT"};
  for (const Column& column : columns) {
    lines[0] += " " + word(choice, column.name);
    lines[1] += " " + count(choice, sizeOf(column.type.type));
    lines[2] += " " + word(choice, column.type.pcd);
    lines[3] += " " + count(choice, column.values);
  }
  std::string header = "VERSION .7\n";
  for (const std::string& line : lines) {
    header += isWrong(choice) ? "" : line + "\n";
  }
  header += "WIDTH " + count(choice, width) + "\nHEIGHT " + count(choice, height) + "\nPOINTS " +
            count(choice, width * height) + "\nDATA " +
            word(choice, format == 0   ? "ascii"
                         : format == 1 ? "binary"
                                       : "binary_compressed") +
            "\n";
  if (format == 2) {
    return header + compressed(choice, columns, width * height);
  }
  std::string data;
  for (std::size_t i = 0; i < width * height; ++i) {
    for (const Column& column : columns) {
      for (std::size_t k = 0; k < column.values; ++k) {
        append(data, choice, column.type.type, format == 0, false, choice.ConsumeIntegralInRange<std::int64_t>(0, 9));
      }
    }
    data += format == 0 ? "\n" : "";
  }
  return header + data;
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  Choice choice(bytes, size);
  const bool is_ply = choice.ConsumeBool();
  std::string file = is_ply ? plyFile(choice) : pcdFile(choice);
  if (isWrong(choice)) {
    file.resize(choice.ConsumeIntegralInRange<std::size_t>(0, file.size()));
  }
  pcl::symmetry::test::readFuzzed(file, is_ply ? "ply" : "pcd");
  return 0;
}
