#include "base/map_offset.h"

#include <pcl/symmetry/impl/surface_estimation.h>

#include <pcl/common/io.h>

#include <cstring>

namespace pcl {
namespace symmetry {
namespace {

using Place = std::array<double, 3>;

/** Where the values of x, y and z lie within a point. */
std::array<std::size_t, 3>
positionOffsets(const PCLPointCloud2& cloud)
{
  std::array<std::size_t, 3> offsets{};
  const char* names[] = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k) {
    offsets[k] = cloud.fields[static_cast<std::size_t>(getFieldIndex(cloud, names[k]))].offset;
  }
  return offsets;
}

} // namespace

std::optional<detail::MovedCloud>
detail::withFloatPositions(const PCLPointCloud2& cloud)
{
  if (cloud.fields[static_cast<std::size_t>(getFieldIndex(cloud, "x"))].datatype != PCLPointField::FLOAT64) {
    return std::nullopt;
  }
  const std::array<std::size_t, 3> offsets = positionOffsets(cloud);
  std::vector<std::size_t> starts;
  for (std::size_t row = 0; row < cloud.height; ++row) {
    for (std::size_t column = 0; column < cloud.width; ++column) {
      starts.push_back(row * cloud.row_step + column * cloud.point_step);
    }
  }
  const auto place_at = [&](std::size_t start) {
    Place place{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::memcpy(&place[k], cloud.data.data() + start + offsets[k], sizeof place[k]);
    }
    return place;
  };
  std::vector<Vector3> rounded;
  rounded.reserve(starts.size());
  for (const std::size_t start : starts) {
    const Place place = place_at(start);
    rounded.push_back({static_cast<float>(place[0]), static_cast<float>(place[1]), static_cast<float>(place[2])});
  }
  MovedCloud moved{cloud, findOffset(rounded)};
  for (const std::size_t start : starts) {
    const Place place = place_at(start);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto near = static_cast<float>(place[k] - moved.offset[k]);
      std::memcpy(moved.cloud.data.data() + start + offsets[k], &near, sizeof near); // the rest of the double is unused
    }
  }
  for (PCLPointField& field : moved.cloud.fields) {
    if (field.name == "x" || field.name == "y" || field.name == "z") {
      field.datatype = PCLPointField::FLOAT32;
    }
  }
  return moved;
}

} // namespace symmetry
} // namespace pcl
