#include "io/readers.h"

#include <pcl/symmetry/surface_io.h>

namespace pcl {
namespace symmetry {
namespace {

Surface
readByEnding(const FileContent& file, const std::string& ending)
{
  if (ending == ".ply")
    return readPly(file);
  if (ending == ".pcd")
    return readPcd(file);
  if (ending == ".obj")
    return readObj(file);
  if (ending == ".off")
    return readOff(file);
  if (ending == ".stl")
    return readStl(file);
  file.fail("unknown ending '" + ending + "': a surface is read from .pcd, .ply, .obj, .off or .stl");
}

} // namespace

Surface
readSurface(const std::string& path)
{
  const FileContent file(path);
  Surface surface = readByEnding(file, fileEnding(path));
  if (surface.points.empty())
    file.fail("holds no point");
  return surface;
}

} // namespace symmetry
} // namespace pcl
