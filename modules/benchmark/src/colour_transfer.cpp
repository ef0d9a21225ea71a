#include "benchmark/colour_transfer.h"

#include "base/vector_math.h"
#include "io/write/output_file.h"
#include "picture/mesh_drawing.h"
#include "picture/png.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** \brief The box of the finite points. */
struct Box {
  Vector3 least = {0.0F, 0.0F, 0.0F};
  Vector3 most = {0.0F, 0.0F, 0.0F};
};

Box
boxOf(const Surface& surface)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Box box = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const Vector3& point : surface.points)
    for (std::size_t k = 0; isFinite(point) && k < 3; ++k) {
      box.least[k] = std::min(box.least[k], point[k]);
      box.most[k] = std::max(box.most[k], point[k]);
    }
  return box;
}

/** \brief Light enough for shading to be seen on it. */
Colour
colourAt(const Vector3& point, const Box& box)
{
  constexpr float darkest = 40.0F;
  Colour colour = {0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const float extent = box.most[k] - box.least[k];
    const float share = extent > 0.0F ? std::clamp((point[k] - box.least[k]) / extent, 0.0F, 1.0F) : 0.5F;
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
  const Box box = boxOf(surface);
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
