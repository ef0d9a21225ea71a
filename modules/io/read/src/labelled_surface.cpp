#include "io/read/labelled_surface.h"

#include "io/read/scalar_type.h"

#include <pcl/symmetry/impl/plain_exception.h>
#include <pcl/symmetry/surface_io.h>

#include <pcl/exceptions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

ScalarType
integerType(const PCLPointField& field, const std::string& path)
{
  switch (field.datatype) {
  case PCLPointField::INT8:
    return ScalarType::Int8;
  case PCLPointField::UINT8:
    return ScalarType::UInt8;
  case PCLPointField::INT16:
    return ScalarType::Int16;
  case PCLPointField::UINT16:
    return ScalarType::UInt16;
  case PCLPointField::INT32:
    return ScalarType::Int32;
  case PCLPointField::UINT32:
    return ScalarType::UInt32;
  default:
    throw detail::PlainException<IOException>(path + ": field '" + field.name + "' holds no integers");
  }
}

/** \brief One integer field of all points, checked to be in [least, end). */
std::vector<std::int64_t>
integerField(
    const PCLPointCloud2& cloud, const std::string& name, std::int64_t least, std::int64_t end, const std::string& path)
{
  const auto field = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [&name](const PCLPointField& f) { return f.name == name; });
  if (field == cloud.fields.end())
    throw detail::PlainException<IOException>(path + ": has no field '" + name +
                                              "', so it was not written by pcl_intrinsic_symmetry");
  const ScalarType type = integerType(*field, path);
  const char* const first = reinterpret_cast<const char*>(cloud.data.data()) + field->offset;
  std::vector<std::int64_t> values;
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  for (std::size_t i = 0; i < points; ++i) {
    values.push_back(loadInteger(first + i * cloud.point_step, type, false));
    if (values.back() < least || values.back() >= end)
      throw detail::PlainException<IOException>(path + ": " + name + " " + std::to_string(values.back()) +
                                                " of point " + std::to_string(i) + " is out of range");
  }
  return values;
}

/** \brief Makes double coordinates, which files at map coordinates have, floats as PCL's point types want them: relative
 * to the first finite point, since what is shown need not be at its place. */
void
toFloatPositions(PCLPointCloud2& cloud)
{
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  for (PCLPointField& field : cloud.fields) {
    if ((field.name != "x" && field.name != "y" && field.name != "z") || field.datatype != PCLPointField::FLOAT64)
      continue;
    double origin = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < points; ++i) {
      char* const bytes = reinterpret_cast<char*>(cloud.data.data()) + i * cloud.point_step + field.offset;
      const auto value = loadScalar<double>(bytes, false);
      if (!std::isfinite(origin))
        origin = value;
      const auto moved = static_cast<float>(value - origin);
      std::memcpy(bytes, &moved, sizeof(moved));
    }
    field.datatype = PCLPointField::FLOAT32; // the other half of each value becomes padding
  }
}

PolygonMesh
readMesh(const std::string& path)
{
  const std::string ending = fileEnding(path);
  PolygonMesh mesh;
  int status = 0;
  if (ending == ".ply")
    status = PLYReader().read(path, mesh);
  else if (ending == ".pcd")
    status = PCDReader().read(path, mesh.cloud);
  else
    throw detail::PlainException<IOException>(path + ": is neither .ply nor .pcd");
  if (status < 0 || mesh.cloud.data.empty())
    throw detail::PlainException<IOException>(path + ": cannot be read, or holds no points");
  toFloatPositions(mesh.cloud);
  return mesh;
}

} // namespace

LabelledSurface
readLabelledSurface(const std::string& path)
{
  LabelledSurface surface;
  surface.mesh = readMesh(path);
  const PCLPointCloud2& cloud = surface.mesh.cloud;
  const auto points = static_cast<std::int64_t>(cloud.width) * cloud.height;
  surface.partners = integerField(cloud, "partner", -1, points, path);
  surface.labels = integerField(cloud, "label", 0, 4, path);
  return surface;
}

} // namespace symmetry
} // namespace pcl
