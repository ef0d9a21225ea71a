#include "io/write/extra_fields.h"
#include "io/write/output_file.h"
#include "io/write/position_writer.h"
#include "io/write/result_check.h"
#include "picture/palette.h"

#include <pcl/symmetry/impl/plain_exception.h>
#include <pcl/symmetry/surface_io.h>

#include <pcl/exceptions.h>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Label, partner, confidence and region of a point, as both formats have them. */
void
appendLabels(std::string& bytes, const SymmetryResult& result, std::size_t point)
{
  appendBytes(bytes, static_cast<std::uint32_t>(result.sides[point]));
  appendBytes(bytes, result.partners[point]);
  appendBytes(bytes, result.confidences[point]);
  appendBytes(bytes, static_cast<std::uint8_t>(result.regions[point]));
  appendBytes(bytes, result.support[point]);
}

/** \brief Whether the points are an organised cloud still. */
bool
hasRaster(const Surface& surface)
{
  return surface.fields != nullptr && surface.fields->height > 1 && surface.size() % surface.fields->height == 0 &&
         surface.size() / surface.fields->height == surface.fields->width;
}

std::string
plyHeader(const Surface& surface, const ExtraFields& extra)
{
  std::string header = "ply\nformat binary_little_endian 1.0\n"
                       "comment label: 0 none, 1 source side, 2 target side, 3 axis\n"
                       "comment partner: number of the symmetric vertex, -1 none\n"
                       "comment support: 0 to 1, how well its surroundings have a counterpart\n"
                       "comment region: 0 none, 1 to 4 the limbs source1 target1 source2 target2, 5 centre\n";
  if (hasRaster(surface)) // as PCL writes it
    header += "obj_info num_cols " + std::to_string(surface.fields->width) + "\nobj_info num_rows " +
              std::to_string(surface.fields->height) + "\n";
  header += "element vertex " + std::to_string(surface.size()) + "\n";
  header += plyPosition(surface);
  if (!surface.normals.empty())
    header += "property float nx\nproperty float ny\nproperty float nz\n";
  header += "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            "property uint label\nproperty int partner\nproperty float confidence\nproperty uchar region\n"
            "property float support\n";
  header += extra.plyProperties();
  if (surface.hasFaces())
    header += "element face " + std::to_string(surface.triangles.size()) + "\nproperty list uchar int vertex_indices\n";
  return header + "end_header\n";
}

std::string
toPly(const Surface& surface, const SymmetryResult& result)
{
  // PCL makes one field, rgb, of red, green and blue.
  const ExtraFields extra(surface, {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue", "alpha", "rgb", "rgba",
                                    "label", "partner", "confidence", "region", "support"});
  std::string bytes = plyHeader(surface, extra);
  bytes.reserve(bytes.size() + 44 * surface.size() + 13 * surface.triangles.size());
  for (std::size_t i = 0; i < surface.size(); ++i) {
    appendPosition(bytes, surface, i);
    if (!surface.normals.empty())
      appendBytes(bytes, surface.normals[i]);
    appendBytes(bytes, colourOf(result.sides[i]));
    appendLabels(bytes, result, i);
    extra.appendPly(bytes, i);
  }
  for (const Triangle& triangle : surface.triangles) {
    appendBytes(bytes, std::uint8_t{3});
    appendBytes(bytes, triangle);
  }
  return bytes;
}

/** \brief A colour as PCL keeps it in the field rgb: the bytes of a float. */
std::uint32_t
packColour(const Colour& colour)
{
  return 0xFF000000U | std::uint32_t{colour[0]} << 16 | std::uint32_t{colour[1]} << 8 | std::uint32_t{colour[2]};
}

std::string
toPcd(const Surface& surface, const SymmetryResult& result)
{
  const bool has_normals = !surface.normals.empty();
  const ExtraFields extra(surface, {"x", "y", "z", "normal_x", "normal_y", "normal_z", "rgb", "rgba", "label",
                                    "partner", "confidence", "region", "support"});
  const std::string points = std::to_string(surface.size());
  std::string bytes = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n";
  bytes += std::string("FIELDS x y z") + (has_normals ? " normal_x normal_y normal_z" : "") +
           " rgb label partner confidence region support" + extra.pcdNames() + "\n";
  bytes +=
      "SIZE " + pcdPositionSizes(surface) + (has_normals ? " 4 4 4" : "") + " 4 4 4 4 1 4" + extra.pcdSizes() + "\n";
  bytes += std::string("TYPE F F F") + (has_normals ? " F F F" : "") + " F U I F U F" + extra.pcdTypes() + "\n";
  bytes += std::string("COUNT 1 1 1") + (has_normals ? " 1 1 1" : "") + " 1 1 1 1 1 1" + extra.pcdCounts() + "\n";
  const bool has_raster = hasRaster(surface);
  bytes += "WIDTH " + (has_raster ? std::to_string(surface.fields->width) : points) + "\nHEIGHT " +
           (has_raster ? std::to_string(surface.fields->height) : "1") + "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points +
           "\nDATA binary\n";
  bytes.reserve(bytes.size() + 45 * surface.size());
  for (std::size_t i = 0; i < surface.size(); ++i) {
    appendPosition(bytes, surface, i);
    if (has_normals)
      appendBytes(bytes, surface.normals[i]);
    appendBytes(bytes, packColour(colourOf(result.sides[i])));
    appendLabels(bytes, result, i);
    extra.appendPcd(bytes, i);
  }
  return bytes;
}

} // namespace

void
writeLabelledSurface(const std::string& path, const Surface& surface, const SymmetryResult& result)
{
  checkResult(result, surface.size());
  const std::string ending = fileEnding(path);
  if (ending == ".ply")
    writeWholeFile(path, toPly(surface, result));
  else if (ending == ".pcd")
    writeWholeFile(path, toPcd(surface, result));
  else
    throw detail::PlainException<IOException>(path + ": unknown ending '" + ending +
                                              "': a labelled surface is written as .ply or .pcd");
}

} // namespace symmetry
} // namespace pcl
