// What the class is handed by its callers, checked before it is relied on.
#include "base/vector_math.h"
#include "refuse_argument.h"

#include <pcl/symmetry/impl/surface_estimation.h>

#include <pcl/common/io.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** Bytes of one value; 0: PCL knows no such type. */
std::size_t
sizeOfType(std::uint8_t datatype)
{
  const int size = getFieldSize(datatype);
  return size > 0 ? static_cast<std::size_t>(size) : 0;
}

void
checkField(const PCLPointField& field, std::size_t point_step)
{
  const std::size_t size = sizeOfType(field.datatype);
  if (size == 0) {
    refuseArgument("field ", field.name, " of the cloud has unknown type ", static_cast<int>(field.datatype));
  }
  const std::size_t values = std::max<std::size_t>(field.count, 1); // PCL takes 0 for 1
  if (std::size_t{field.offset} + size * values > point_step) {
    refuseArgument("field ", field.name, " of the cloud ends at byte ", field.offset + size * values, ", a point has ",
                   point_step, " bytes");
  }
}

void
checkCoordinates(const PCLPointCloud2& cloud)
{
  int first_type = -1;
  for (const char* name : {"x", "y", "z"}) {
    const int field = getFieldIndex(cloud, name);
    const int type = field < 0 ? -1 : int{cloud.fields[static_cast<std::size_t>(field)].datatype};
    // Conversion would leave zeros without a word.
    if (type != PCLPointField::FLOAT32 && type != PCLPointField::FLOAT64) {
      refuseArgument("the mesh's cloud has no float or double field ", name);
    }
    first_type = first_type < 0 ? type : first_type;
    if (type != first_type) {
      refuseArgument("of the fields x y z of the mesh's cloud some are float and some double: ", name);
    }
  }
}

bool
isAscending(const std::vector<float>& squared_distances, std::size_t count)
{
  if (squared_distances.size() < count) {
    return false;
  }
  for (std::size_t i = 1; i < count; ++i) {
    if (!(squared_distances[i - 1] <= squared_distances[i])) { // also where one is not a number
      return false;
    }
  }
  return true;
}

} // namespace

void
detail::appendNeighbours(const std::vector<Vector3>& points,
                         int k,
                         int count,
                         const Indices& found,
                         const std::vector<float>& squared_distances,
                         std::vector<Index>& neighbours)
{
  const std::size_t point = neighbours.size() / static_cast<std::size_t>(k);
  if (count < 0 || count > k || static_cast<std::size_t>(count) > found.size()) {
    refuseArgument("the search method returned ", count, " neighbours in a list of ", found.size(), " for point ",
                   point, ", asked for were ", k);
  }
  for (int i = 0; i < count; ++i) {
    const auto index = found[static_cast<std::size_t>(i)];
    if (index < 0 || static_cast<std::size_t>(index) >= points.size()) {
      refuseArgument("the search method returned neighbour ", index, " of point ", point, ", there are ", points.size(),
                     " points");
    }
    neighbours.push_back(static_cast<Index>(index));
  }
  if (!isAscending(squared_distances, static_cast<std::size_t>(count))) {
    std::stable_sort(neighbours.end() - count, neighbours.end(), [&](Index a, Index b) {
      return distance(points[a], points[point]) < distance(points[b], points[point]);
    });
  }
  neighbours.resize((point + 1) * static_cast<std::size_t>(k), no_index);
}

void
detail::checkLayout(const PCLPointCloud2& cloud)
{
  checkCoordinates(cloud);
  for (const PCLPointField& field : cloud.fields) {
    checkField(field, cloud.point_step);
  }
  if (cloud.is_bigendian != 0) {
    refuseArgument("the cloud says that it is big-endian: its bytes would have to be swapped first");
  }
  const std::uint64_t points = std::uint64_t{cloud.width} * cloud.height;
  if (points > static_cast<std::uint64_t>(std::numeric_limits<Index>::max())) {
    refuseArgument("the cloud has ", cloud.width, " x ", cloud.height, " points, at most ",
                   std::numeric_limits<Index>::max(), " are possible");
  }
  if (cloud.row_step < std::uint64_t{cloud.width} * cloud.point_step) {
    refuseArgument("the rows of the cloud have ", cloud.row_step, " bytes, too few for ", cloud.width, " points of ",
                   cloud.point_step);
  }
  const std::uint64_t bytes = std::uint64_t{cloud.row_step} * cloud.height;
  if (cloud.data.size() != bytes) {
    refuseArgument("the cloud holds ", cloud.data.size(), " bytes, ", cloud.height, " rows of ", cloud.row_step,
                   " are ", bytes);
  }
  if (bytes > std::numeric_limits<std::uint32_t>::max()) {
    refuseArgument("the cloud holds ", bytes, " bytes, PCL converts at most ",
                   std::numeric_limits<std::uint32_t>::max());
  }
}

} // namespace symmetry
} // namespace pcl
