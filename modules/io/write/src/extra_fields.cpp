#include "io/write/extra_fields.h"

#include "io/write/record_writer.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

bool
isLongInteger(const PointField& field)
{
  return field.value_bytes == 8 && field.kind != 'F';
}

const char*
plyType(const PointField& field)
{
  static const std::map<std::pair<char, std::size_t>, const char*> names = {
      {{'I', 1}, "char"},   {{'I', 2}, "short"}, {{'I', 4}, "int"},  {{'U', 1}, "uchar"},
      {{'U', 2}, "ushort"}, {{'U', 4}, "uint"},  {{'F', 4}, "float"}};
  const auto found = names.find({field.kind, field.value_bytes});
  return found == names.end() ? "double" : found->second;
}

template <typename Number>
double
longToDouble(const char* value)
{
  Number number = 0;
  std::memcpy(&number, value, sizeof(number));
  return static_cast<double>(number);
}

} // namespace

ExtraFields::ExtraFields(const Surface& surface, std::vector<std::string> taken)
{
  if (surface.fields == nullptr)
    return;
  for (const PointField& field : surface.fields->fields) {
    // A caller may have changed the points, or made the field.
    if (field.count == 0 || field.values.size() != surface.size() * field.count * field.value_bytes)
      continue;
    std::string name = field.name;
    while (std::find(taken.begin(), taken.end(), name) != taken.end())
      name = "input_" + name;
    taken.push_back(name);
    fields_.push_back(&field);
    names_.push_back(std::move(name));
  }
}

std::string
ExtraFields::plyProperties() const
{
  std::string text;
  for (std::size_t i = 0; i < fields_.size(); ++i)
    for (std::size_t k = 0; k < fields_[i]->count; ++k)
      text += std::string("property ") + plyType(*fields_[i]) + " " + names_[i] +
              (fields_[i]->count > 1 ? "_" + std::to_string(k) : std::string()) + "\n";
  return text;
}

std::string
ExtraFields::pcdNames() const
{
  std::string text;
  for (const std::string& name : names_)
    text += " " + name;
  return text;
}

std::string
ExtraFields::pcdSizes() const
{
  std::string text;
  for (const PointField* field : fields_)
    text += " " + std::to_string(field->value_bytes);
  return text;
}

std::string
ExtraFields::pcdTypes() const
{
  std::string text;
  for (const PointField* field : fields_)
    text += std::string(" ") + field->kind;
  return text;
}

std::string
ExtraFields::pcdCounts() const
{
  std::string text;
  for (const PointField* field : fields_)
    text += " " + std::to_string(field->count);
  return text;
}

void
ExtraFields::appendPly(std::string& bytes, std::size_t point) const
{
  for (const PointField* field : fields_) {
    const std::size_t point_bytes = field->count * field->value_bytes;
    const char* const values = field->values.data() + point * point_bytes;
    if (!isLongInteger(*field)) {
      bytes.append(values, point_bytes);
      continue;
    }
    for (std::size_t i = 0; i < point_bytes; i += field->value_bytes)
      appendBytes(bytes, field->kind == 'I' ? longToDouble<std::int64_t>(values + i)
                                            : longToDouble<std::uint64_t>(values + i));
  }
}

void
ExtraFields::appendPcd(std::string& bytes, std::size_t point) const
{
  for (const PointField* field : fields_) {
    const std::size_t point_bytes = field->count * field->value_bytes;
    bytes.append(field->values.data() + point * point_bytes, point_bytes);
  }
}

} // namespace symmetry
} // namespace pcl
