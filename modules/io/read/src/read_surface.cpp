#include "base/map_offset.h"
#include "io/read/readers.h"

#include <pcl/symmetry/surface_io.h>

#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

Surface
readByEnding(const FileContent& file, const std::string& ending, Reading& reading)
{
  if (ending == ".ply")
    return readPly(file, reading);
  if (ending == ".pcd")
    return readPcd(file, reading);
  if (ending == ".obj")
    return readObj(file, reading);
  if (ending == ".off")
    return readOff(file, reading);
  if (ending == ".stl")
    return readStl(file, reading);
  if (ending == ".xyz" || ending == ".txt" || ending == ".asc" || ending == ".pts")
    return readXyz(file, reading);
  if (ending == ".vtk")
    return readVtk(file, reading);
#ifdef PCL_SYMMETRY_WITH_ASSIMP
  if (ending == ".glb" || ending == ".gltf" || ending == ".3mf")
    return readScene(file, ending, reading);
#endif
  for (const char* optional : {".glb", ".gltf", ".3mf"})
    if (ending == optional)
      file.fail(ending +
                " files are read where the library is built with PCL_SYMMETRY_WITH_ASSIMP, which this one is not");
  for (const char* xml : {".vtp", ".vtu"})
    if (ending == xml)
      file.fail(ending + " files, VTK's XML, are not read: save the surface as a legacy file, .vtk, or as .ply");
  file.fail("unknown ending '" + ending +
            "': a surface is read from .pcd, .ply, .obj, .off, .stl, .vtk or .xyz (.txt, .asc, " +
            ".pts), or from such a file compressed, with .gz behind");
}

/** \brief Names what is no text of any format, and yet may have the right ending. */
void
checkBeginning(const FileContent& file)
{
  const std::string_view beginning = file.view().substr(0, 2);
  if (file.isGzip())
    file.fail("is compressed by gzip: its name must end in .gz");
  if (beginning == "\xFF\xFE" || beginning == "\xFE\xFF")
    file.fail("is text in UTF-16: only ASCII and UTF-8 are read");
}

/** \brief Refuses floats that have lost the shape: digits that were never written cannot be restored. */
void
checkResolution(const FileContent& file, const Surface& surface)
{
  constexpr double minimum_steps = 500.0;
  const double steps = stepsAcross(surface);
  if (steps < minimum_steps)
    file.fail("holds its coordinates as floats, too far from the origin: they leave " +
              std::to_string(static_cast<int>(steps)) + " steps across the whole surface; write the file in double " +
              "precision, or nearer to the origin");
}

} // namespace

Surface
readSurface(const std::string& path)
{
  return readSurface(path, "");
}

Surface
readSurface(const std::string& path, const std::string& format)
{
  FileContent file(path);
  std::string ending = format.empty() ? fileEnding(path) : "." + format;
  if (ending == ".gz") {
    file.unpackGzip();
    ending = fileEnding(path.substr(0, path.size() - ending.size()));
  }
  else if (!format.empty() && file.isGzip()) {
    file.unpackGzip();
  }
  checkBeginning(file);
  Reading reading;
  Surface surface = readByEnding(file, ending, reading);
  if (surface.points.empty())
    file.fail("holds no point");

  // Far from the origin floats are too coarse: read again, nearer to it.
  const std::array<double, 3> offset = findOffset(surface.points);
  if (offset != reading.origin) {
    Reading nearer;
    nearer.origin = offset;
    Surface moved = readByEnding(file, ending, nearer);
    moved.offset = offset;
    if (stepsAcross(moved) < HUGE_VAL) { // points all at one place may stay there
      if (nearer.single_precision)
        checkResolution(file, moved);
      surface = std::move(moved);
    }
  }
  surface.notes = std::move(reading.notes);
  return surface;
}

} // namespace symmetry
} // namespace pcl
