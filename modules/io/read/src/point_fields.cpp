#include "io/read/point_fields.h"

#include <utility>

namespace pcl {
namespace symmetry {

void
FieldCollector::add(std::size_t number, const std::string& name, ScalarType type, std::size_t count)
{
  if (number >= slots_.size())
    slots_.resize(number + 1, none);
  slots_[number] = kept_.fields.size();
  kept_.fields.push_back({name, kindOf(type), sizeOf(type), count, {}});
}

void
FieldCollector::resize(std::size_t points)
{
  for (PointField& field : kept_.fields)
    field.values.resize(points * field.count * field.value_bytes);
}

void
FieldCollector::copy(std::size_t number, const ScalarColumn& column)
{
  if (!keeps(number))
    return;
  PointField& field = kept_.fields[slots_[number]];
  const std::size_t point_bytes = field.count * field.value_bytes;
  const char* from = column.first;
  for (auto to = field.values.begin(); to != field.values.end(); from += column.stride)
    for (std::size_t i = 0; i < point_bytes; i += field.value_bytes) {
      const auto end = std::copy_n(from + i, field.value_bytes, to);
      if (column.swap_bytes)
        std::reverse(to, end);
      to = end;
    }
}

char*
FieldCollector::place(std::size_t number, std::size_t point, std::size_t index)
{
  PointField& field = kept_.fields[slots_[number]];
  return field.values.data() + (point * field.count + index) * field.value_bytes;
}

std::shared_ptr<const PointFields>
FieldCollector::take(std::size_t width, std::size_t height)
{
  if (kept_.fields.empty() && width == 0)
    return nullptr;
  kept_.width = width;
  kept_.height = height;
  return std::make_shared<const PointFields>(std::move(kept_));
}

std::shared_ptr<const PointFields>
colourFields(const std::vector<float>& values, std::size_t points)
{
  const std::size_t channels = points == 0 ? 0 : values.size() / points;
  if ((channels != 3 && channels != 4) || values.size() != channels * points)
    return nullptr;
  static const std::string names[] = {"red", "green", "blue", "alpha"};
  FieldCollector fields;
  for (std::size_t i = 0; i < channels; ++i)
    fields.add(i, names[i], ScalarType::Float32, 1);
  fields.resize(points);
  for (std::size_t i = 0; i < channels; ++i)
    fields.copy(
        i, {reinterpret_cast<const char*>(values.data() + i), channels * sizeof(float), ScalarType::Float32, false});
  return fields.take(0, 0);
}

} // namespace symmetry
} // namespace pcl
