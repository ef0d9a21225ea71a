#include "io/read/scalar_type.h"

#include <pcl/symmetry/impl/plain_exception.h>
#include <pcl/symmetry/surface_io.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace pcl {
namespace symmetry {
namespace {

ScalarType
integerType(const PointField& field, const std::string& path)
{
  if (field.count == 1) {
    switch (field.value_bytes) {
    case 1:
      return field.kind == 'U' ? ScalarType::UInt8 : ScalarType::Int8;
    case 2:
      return field.kind == 'U' ? ScalarType::UInt16 : ScalarType::Int16;
    case 4:
      return field.kind == 'U' ? ScalarType::UInt32 : ScalarType::Int32;
    default:
      break;
    }
  }
  throw detail::PlainException<IOException>(path + ": field '" + field.name + "' holds no integers of 1 to 4 bytes");
}

/** \brief The values of an integer field of all points, checked to be in [least, end). */
std::vector<std::int64_t>
integerField(
    const Surface& surface, const std::string& name, std::int64_t least, std::int64_t end, const std::string& path)
{
  const std::vector<PointField> none;
  const std::vector<PointField>& fields = surface.fields ? surface.fields->fields : none;
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const PointField& f) { return f.name == name; });
  if (field == fields.end() || field->kind == 'F')
    throw detail::PlainException<IOException>(path + ": has no integers '" + name +
                                              "', as the labelled surfaces of pcl_intrinsic_symmetry --output have");
  const ScalarType type = integerType(*field, path);
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    values.push_back(loadInteger(field->values.data() + i * field->value_bytes, type, false));
    if (values.back() < least || values.back() >= end)
      throw detail::PlainException<IOException>(path + ": " + name + " " + std::to_string(values.back()) +
                                                " of point " + std::to_string(i) + " is out of range");
  }
  return values;
}

} // namespace

NameReference
readNameReference(const std::string& path, unsigned threads)
{
  const Surface surface = readSurface(path);
  std::vector<Side> sides;
  for (const std::int64_t label : integerField(surface, "label", 0, 4, path))
    sides.push_back(static_cast<Side>(label));
  std::vector<Index> partners;
  for (const std::int64_t partner :
       integerField(surface, "partner", no_index, static_cast<std::int64_t>(surface.size()), path))
    partners.push_back(static_cast<Index>(partner));
  try {
    return {surface, sides, partners, threads};
  }
  catch (const BadArgumentException& error) {
    throw detail::PlainException<IOException>(path + ": " + error.what());
  }
}

} // namespace symmetry
} // namespace pcl
