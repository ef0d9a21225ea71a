#include "io/write/output_file.h"
#include "io/write/position_writer.h"
#include "io/write/record_writer.h"
#include "io/write/result_check.h"

#include <pcl/symmetry/impl/plain_exception.h>
#include <pcl/symmetry/surface_io.h>

#include <pcl/exceptions.h>

#include <array>
#include <string>
#include <vector>

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
    const auto count = static_cast<Index>(line.curve.size());
    for (Index i = 1; i < count; ++i)
      edges.push_back({first + i - 1, first + i});
    if (line.closed && count > 2)
      edges.push_back({first + count - 1, first});
    first += count;
  }
  return edges;
}

std::size_t
countPlaces(const std::vector<Polyline>& axis)
{
  std::size_t count = 0;
  for (const Polyline& line : axis)
    count += line.curve.size();
  return count;
}

/** \brief Names of what is written of each place besides x y z. */
constexpr std::array<const char*, 7> float_names = {"normal_x", "normal_y", "normal_z",  "across_x",
                                                    "across_y", "across_z", "arc_length"};

/** \brief The values that belong to these names. */
std::array<float, 7>
floatsOf(const AxisPoint& point)
{
  return {point.normal[0], point.normal[1], point.normal[2], point.across[0],
          point.across[1], point.across[2], point.arc_length};
}

/** \brief Places in order: x y z, directions, length, number of the nearest point, number of the curve from 0. */
void
appendPlaces(std::string& bytes, const Surface& surface, const std::vector<Polyline>& axis)
{
  for (std::size_t curve = 0; curve < axis.size(); ++curve) {
    for (const AxisPoint& point : axis[curve].curve) {
      appendPosition(bytes, surface, point.position);
      appendBytes(bytes, floatsOf(point));
      appendBytes(bytes, point.nearest);
      appendBytes(bytes, static_cast<Index>(curve));
    }
  }
}

std::string
toPly(const Surface& surface, const std::vector<Polyline>& axis)
{
  const auto edges = polylineEdges(axis);
  std::string bytes = "ply\nformat binary_little_endian 1.0\n"
                      "comment index: number of the nearest vertex of the surface; curve: number of the polyline\n";
  bytes += "element vertex " + std::to_string(countPlaces(axis)) + "\n" + plyPosition(surface);
  for (const std::string name : float_names)
    bytes += "property float " + (name.rfind("normal_", 0) == 0 ? "n" + name.substr(7) : name) + "\n";
  bytes += "property int index\nproperty int curve\n";
  bytes +=
      "element edge " + std::to_string(edges.size()) + "\nproperty int vertex1\nproperty int vertex2\nend_header\n";
  appendPlaces(bytes, surface, axis);
  for (const std::array<Index, 2>& edge : edges)
    appendBytes(bytes, edge);
  return bytes;
}

std::string
toPcd(const Surface& surface, const std::vector<Polyline>& axis)
{
  std::string names;
  std::string sizes;
  std::string types;
  std::string counts;
  for (const std::string name : float_names) {
    names += " " + name;
    sizes += " 4";
    types += " F";
    counts += " 1";
  }
  const std::string places = std::to_string(countPlaces(axis));
  std::string bytes =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z" + names + " index curve\n";
  bytes += "SIZE " + pcdPositionSizes(surface) + sizes + " 4 4\nTYPE F F F" + types + " I I\nCOUNT 1 1 1" + counts +
           " 1 1\n";
  bytes += "WIDTH " + places + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + places + "\nDATA binary\n";
  appendPlaces(bytes, surface, axis);
  return bytes;
}

std::string
toCsv(const Surface& surface, const std::vector<Polyline>& axis)
{
  std::string text = "curve,x,y,z";
  for (const std::string name : float_names)
    text += "," + name;
  text += ",index,closed\n";
  for (std::size_t curve = 0; curve < axis.size(); ++curve) {
    for (const AxisPoint& point : axis[curve].curve) {
      appendNumber(text, curve);
      for (std::size_t i = 0; i < 3; ++i) {
        text += ',';
        if (needsDoubles(surface))
          appendNumber(text, double{point.position[i]} + surface.offset[i]);
        else
          appendNumber(text, point.position[i]);
      }
      for (const float value : floatsOf(point)) {
        text += ',';
        appendNumber(text, value);
      }
      text += ',';
      appendNumber(text, point.nearest);
      text += axis[curve].closed ? ",1\n" : ",0\n";
    }
  }
  return text;
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
  else if (ending == ".csv")
    writeWholeFile(path, toCsv(surface, result.axis));
  else
    throw detail::PlainException<IOException>(path + ": unknown ending '" + ending +
                                              "': an axis is written as .ply, .pcd or .csv");
}

} // namespace symmetry
} // namespace pcl
