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

std::string
plainFieldName(std::string_view word, std::size_t number)
{
  std::string name(word);
  for (char& c : name)
    if ((c < 'a' || c > 'z') && (c < 'A' || c > 'Z') && (c < '0' || c > '9'))
      c = '_';
  return name.empty() ? "column_" + std::to_string(number + 1) : name;
}

std::shared_ptr<const PointFields>
appearanceFields(const std::vector<float>& colours, const std::vector<float>& texture, std::size_t points)
{
  struct Channel {
    const char* name;
    const float* first;
    std::size_t stride;
  };
  std::vector<Channel> channels;
  const std::size_t colour_channels = points == 0 ? 0 : colours.size() / points;
  if ((colour_channels == 3 || colour_channels == 4) && colours.size() == colour_channels * points) {
    static const char* const names[] = {"red", "green", "blue", "alpha"};
    for (std::size_t i = 0; i < colour_channels; ++i)
      channels.push_back({names[i], colours.data() + i, colour_channels});
  }
  if (points > 0 && texture.size() == 2 * points) {
    channels.push_back({"u", texture.data(), 2});
    channels.push_back({"v", texture.data() + 1, 2});
  }
  FieldCollector fields;
  for (std::size_t i = 0; i < channels.size(); ++i)
    fields.add(i, channels[i].name, ScalarType::Float32, 1);
  fields.resize(points);
  for (std::size_t i = 0; i < channels.size(); ++i)
    fields.copy(i, {reinterpret_cast<const char*>(channels[i].first), channels[i].stride * sizeof(float),
                    ScalarType::Float32, /*swap_bytes=*/false});
  return fields.take(0, 0);
}

} // namespace symmetry
} // namespace pcl
