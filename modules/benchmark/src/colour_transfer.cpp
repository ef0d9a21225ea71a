#include "benchmark/colour_transfer.h"

#include "base/bounding_box.h"
#include "base/vector_math.h"
#include "io/write/output_file.h"
#include "picture/mesh_drawing.h"
#include "picture/png.h"

#include <algorithm>
#include <cmath>

namespace pcl {
namespace symmetry {
namespace {

/** \brief The box of the finite points. */
BoundingBox
boxOf(const Surface& surface)
{
  BoundingBox box;
  for (const Vector3& point : surface.points)
    if (isFinite(point))
      box.extend(point);
  return box;
}

/** \brief A place as a colour: a channel for each axis, light enough for shading to be seen on it. */
Colour
colourAt(const Vector3& point, const BoundingBox& box)
{
  constexpr float darkest = 40.0F; // of 255, by eye
  Colour colour = {0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const float extent = box.high[k] - box.low[k];
    const float share = extent > 0.0F ? std::clamp((point[k] - box.low[k]) / extent, 0.0F, 1.0F) : 0.5F;
    colour[k] = static_cast<std::uint8_t>(std::lround(darkest + (255.0F - darkest) * share));
  }
  return colour;
}

Image
drawPanel(const Surface& surface, const std::vector<Colour>& colours, const PictureView& view)
{
  const auto [width, height] = panelSize(view);
  Rasterizer canvas(supersampling * width, supersampling * height);
  drawMesh(surface, meshNormals(surface), colours, Projection(view, supersampling * width, supersampling * height),
           canvas);
  return canvas.reduce(supersampling);
}

} // namespace

std::vector<Colour>
transferColours(const Surface& surface, const SymmetryResult& result)
{
  const BoundingBox box = boxOf(surface);
  std::vector<Colour> colours(surface.size(), colourOf(Side::None));
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const Index painted = result.sides[i] == Side::Target ? result.partners[i] : static_cast<Index>(i);
    if (result.sides[i] == Side::None || painted == no_index)
      continue;
    const Vector3& place = surface.points[static_cast<std::size_t>(painted)];
    if (isFinite(place))
      colours[i] = colourAt(place, box);
  }
  return colours;
}

void
writeColourTransfer(const std::string& path, const Surface& surface, const SymmetryResult& result)
{
  const std::vector<Colour> colours = transferColours(surface, result);
  const PictureView view = chooseView(surface, result, findPartnerPairs(surface, result));
  writeWholeFile(
      path, encodePng(sideBySide(drawPanel(surface, colours, view), drawPanel(surface, colours, view.fromBehind()))));
}

} // namespace symmetry
} // namespace pcl
