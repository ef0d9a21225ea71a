#include "model/write_model.h"

#include "io/write/output_file.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace pcl {
namespace symmetry {
namespace {

static_assert(sizeof(Vector3) == 3 * sizeof(float), "points are written as they lie in memory");

std::string
ending(const std::string& path)
{
  std::string text = std::filesystem::path(path).extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

void
writePoints(std::ostream& stream, const Surface& surface)
{
  stream.write(reinterpret_cast<const char*>(surface.points.data()),
               static_cast<std::streamsize>(surface.size() * sizeof(Vector3)));
}

void
writePly(std::ostream& stream, const Surface& surface)
{
  stream << "ply\nformat binary_little_endian 1.0\nelement vertex " << surface.size()
         << "\nproperty float x\nproperty float y\nproperty float z\n";
  if (surface.hasFaces())
    stream << "element face " << surface.triangles.size() << "\nproperty list uchar int vertex_indices\n";
  stream << "end_header\n";
  writePoints(stream, surface);
  std::array<char, 1 + sizeof(Triangle)> record = {3};
  for (const Triangle& triangle : surface.triangles) {
    std::memcpy(record.data() + 1, triangle.data(), sizeof(Triangle));
    stream.write(record.data(), static_cast<std::streamsize>(record.size()));
  }
}

void
writePcd(std::ostream& stream, const Surface& surface)
{
  stream
      << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
      << "WIDTH " << surface.size() << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << surface.size()
      << "\nDATA binary\n";
  writePoints(stream, surface);
}

void
writeOff(std::ostream& stream, const Surface& surface)
{
  stream << "OFF\n" << surface.size() << ' ' << surface.triangles.size() << " 0\n";
  for (const Vector3& point : surface.points)
    stream << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
  for (const Triangle& triangle : surface.triangles)
    stream << "3 " << triangle[0] << ' ' << triangle[1] << ' ' << triangle[2] << '\n';
}

void
writeObj(std::ostream& stream, const Surface& surface)
{
  for (const Vector3& point : surface.points)
    stream << "v " << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
  for (const Triangle& triangle : surface.triangles)
    stream << "f " << triangle[0] + 1 << ' ' << triangle[1] + 1 << ' ' << triangle[2] + 1 << '\n';
}

using SurfaceWriter = void (*)(std::ostream&, const Surface&);

SurfaceWriter
findWriter(const std::string& path)
{
  const std::string format = ending(path);
  if (format == ".ply")
    return writePly;
  if (format == ".pcd")
    return writePcd;
  if (format == ".off")
    return writeOff;
  if (format == ".obj")
    return writeObj;
  throw std::invalid_argument(path + ": the ending '" + format + "' is none of .ply, .off, .obj, .pcd");
}

} // namespace

void
checkSurfaceFileName(const std::string& path)
{
  findWriter(path);
}

void
writePlainSurface(const std::string& path, const Surface& surface)
{
  const SurfaceWriter writer = findWriter(path);
  std::ostringstream stream;
  stream << std::setprecision(std::numeric_limits<float>::max_digits10);
  writer(stream, surface);
  writeWholeFile(path, stream.str());
}

void
writeTruth(const std::string& path, const std::vector<Index>& partners)
{
  std::ostringstream stream;
  for (std::size_t i = 0; i < partners.size(); ++i)
    if (partners[i] != no_index)
      stream << i + 1 << ' ' << partners[i] + 1 << '\n';
  writeWholeFile(path, stream.str());
}

} // namespace symmetry
} // namespace pcl
