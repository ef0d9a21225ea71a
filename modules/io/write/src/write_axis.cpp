#include "io/write/output_file.h"
#include "io/write/position_writer.h"
#include "io/write/result_check.h"

#include <pcl/symmetry/impl/plain_exception.h>
#include <pcl/symmetry/surface_io.h>

#include <pcl/exceptions.h>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Edges within each polyline, in numbers of the written vertices; a closed one has one more. */
std::vector<std::array<Index, 2>>
polylineEdges(const std::vector<Polyline>& axis)
{
  std::vector<std::array<Index, 2>> edges;
  Index first = 0;
  for (const Polyline& line : axis) {
    const auto count = static_cast<Index>(line.points.size());
    for (Index i = 1; i < count; ++i)
      edges.push_back({first + i - 1, first + i});
    if (line.closed && count > 2)
      edges.push_back({first + count - 1, first});
    first += count;
  }
  return edges;
}

std::size_t
countPoints(const std::vector<Polyline>& axis)
{
  std::size_t count = 0;
  for (const Polyline& line : axis)
    count += line.points.size();
  return count;
}

/** \brief Points in order: x y z, number of the point in the surface, number of the curve from 0. */
void
appendPoints(std::string& bytes, const Surface& surface, const std::vector<Polyline>& axis)
{
  for (std::size_t curve = 0; curve < axis.size(); ++curve) {
    for (const Index index : axis[curve].points) {
      appendPosition(bytes, surface, static_cast<std::size_t>(index));
      appendBytes(bytes, index);
      appendBytes(bytes, static_cast<Index>(curve));
    }
  }
}

std::string
toPly(const Surface& surface, const std::vector<Polyline>& axis)
{
  const auto edges = polylineEdges(axis);
  std::string bytes = "ply\nformat binary_little_endian 1.0\n"
                      "comment index: number of the vertex in the surface; curve: number of the polyline\n";
  bytes += "element vertex " + std::to_string(countPoints(axis)) + "\n";
  bytes += plyPosition(surface) + "property int index\nproperty int curve\n";
  bytes +=
      "element edge " + std::to_string(edges.size()) + "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  appendPoints(bytes, surface, axis);
  for (const std::array<Index, 2>& edge : edges)
    appendBytes(bytes, edge);
  return bytes;
}

std::string
toPcd(const Surface& surface, const std::vector<Polyline>& axis)
{
  const std::string points = std::to_string(countPoints(axis));
  std::string bytes = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z index curve\n";
  bytes += "SIZE " + pcdPositionSizes(surface) + " 4 4\nTYPE F F F I I\nCOUNT 1 1 1 1 1\n";
  bytes += "WIDTH " + points + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points + "\nDATA binary\n";
  appendPoints(bytes, surface, axis);
  return bytes;
}

} // namespace

void
writeAxis(const std::string& path, const Surface& surface, const SymmetryResult& result)
{
  checkResult(result, surface.size());
  const std::string ending = fileEnding(path);
  if (ending == ".ply")
    writeWholeFile(path, toPly(surface, result.axis));
  else if (ending == ".pcd")
    writeWholeFile(path, toPcd(surface, result.axis));
  else
    throw detail::PlainException<IOException>(path + ": unknown ending '" + ending +
                                              "': an axis is written as .ply or .pcd");
}

} // namespace symmetry
} // namespace pcl
