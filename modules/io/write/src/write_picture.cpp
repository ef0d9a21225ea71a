#include "base/vector_math.h"
#include "io/write/output_file.h"
#include "io/write/result_check.h"
#include "picture/cloud_shading.h"
#include "picture/mesh_drawing.h"
#include "picture/picture_view.h"
#include "picture/png.h"
#include "picture/rasterizer.h"

#include <pcl/symmetry/impl/plain_exception.h>
#include <pcl/symmetry/surface_io.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t partner_lines = 40;
constexpr float line_radius = 0.8F; ///< in pixels of the finished picture, as the next two
constexpr float dot_radius = 3.0F;
constexpr float axis_radius = 2.2F;
constexpr Colour line_colour = {40, 40, 48};

/** \brief All that both views draw. */
struct Drawing {
  const Surface& surface;
  const SymmetryResult& result;
  std::vector<Vector3> normals; ///< per point
  std::vector<Colour> colours;  ///< per point, unshaded
  std::vector<float> spacings;  ///< per point of a cloud
  std::vector<PartnerPair> lines;
};

/** \brief Side colours, paler where the confidence is low. */
std::vector<Colour>
pointColours(const SymmetryResult& result)
{
  constexpr float pale = 225.0F;
  std::vector<Colour> colours;
  colours.reserve(result.sides.size());
  for (std::size_t i = 0; i < result.sides.size(); ++i) {
    Colour colour = colourOf(result.sides[i] == Side::Axis ? Side::None : result.sides[i]);
    const float share =
        result.sides[i] == Side::None ? 1.0F : 0.35F + 0.65F * std::clamp(result.confidences[i], 0.0F, 1.0F);
    for (std::uint8_t& channel : colour)
      channel = static_cast<std::uint8_t>(std::lround(pale + share * (static_cast<float>(channel) - pale)));
    colours.push_back(colour);
  }
  return colours;
}

/** \brief Evenly spread pairs of decent confidence, by farthest-point sampling of their sources. */
std::vector<PartnerPair>
chooseLines(const Surface& surface, const SymmetryResult& result, std::vector<PartnerPair> pairs)
{
  const auto is_doubtful = [&](const PartnerPair& pair) {
    return result.confidences[static_cast<std::size_t>(pair.source)] < 0.5F;
  };
  const auto position = [&](const PartnerPair& pair) {
    return surface.points[static_cast<std::size_t>(pair.source)];
  };
  if (!std::all_of(pairs.begin(), pairs.end(), is_doubtful))
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), is_doubtful), pairs.end());
  std::vector<float> distances(pairs.size(), std::numeric_limits<float>::infinity());
  std::vector<PartnerPair> lines;
  std::size_t next = 0;
  while (lines.size() < std::min(partner_lines, pairs.size())) {
    lines.push_back(pairs[next]);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      distances[i] = std::min(distances[i], distance(position(pairs[i]), position(lines.back())));
    next = static_cast<std::size_t>(std::max_element(distances.begin(), distances.end()) - distances.begin());
  }
  return lines;
}

void
drawCloud(const Drawing& drawing, const Projection& projection, Rasterizer& canvas)
{
  // Discs overlap, so that the far side does not shine through, but stay small enough to show the shape.
  constexpr float smallest = 0.75F * supersampling;
  constexpr float largest = 14.0F * supersampling;
  for (std::size_t i = 0; i < drawing.surface.size(); ++i) {
    if (!isFinite(drawing.surface.points[i]))
      continue;
    const float radius = std::clamp(drawing.spacings[i] * projection.scale(), smallest, largest);
    const Colour colour = shade(drawing.colours[i], projection.brightness(drawing.normals[i]));
    canvas.fillDisc(projection.project(drawing.surface.points[i]), radius, colour);
  }
}

void
drawAxis(const Drawing& drawing, const Projection& projection, float lift, Rasterizer& canvas)
{
  const Opacity opacity = {1.0F, 0.0F};
  const auto place = [&](const AxisPoint& axis_point) {
    ScreenPoint point = projection.project(axis_point.position);
    point.depth += lift; // the line lies in the surface, and should not sink into it
    return point;
  };
  for (const Polyline& line : drawing.result.axis) {
    const std::size_t count = line.curve.size();
    const std::size_t segments = line.closed ? count : std::max<std::size_t>(count, 1) - 1;
    for (std::size_t i = 0; i < segments; ++i)
      canvas.blendSegment(place(line.curve[i]), place(line.curve[(i + 1) % count]), axis_radius * supersampling,
                          colourOf(Side::Axis), opacity);
  }
}

void
drawPartnerLines(const Drawing& drawing, const Projection& projection, float lift, Rasterizer& canvas)
{
  const Opacity line_opacity = {0.85F, 0.3F};
  const Opacity dot_opacity = {1.0F, 0.25F};
  for (const PartnerPair& line : drawing.lines) {
    ScreenPoint source = projection.project(drawing.surface.points[static_cast<std::size_t>(line.source)]);
    ScreenPoint target = projection.project(drawing.surface.points[static_cast<std::size_t>(line.target)]);
    source.depth += lift;
    target.depth += lift;
    canvas.blendSegment(source, target, line_radius * supersampling, line_colour, line_opacity);
    canvas.blendSegment(source, source, dot_radius * supersampling, line_colour, dot_opacity);
    canvas.blendSegment(target, target, dot_radius * supersampling, line_colour, dot_opacity);
  }
}

Image
drawPanel(const Drawing& drawing, const PictureView& view, int width, int height)
{
  Rasterizer canvas(supersampling * width, supersampling * height);
  const Projection projection(view, supersampling * width, supersampling * height);
  const float lift = 0.012F * static_cast<float>(supersampling * std::max(width, height));
  if (drawing.surface.hasFaces())
    drawMesh(drawing.surface, drawing.normals, drawing.colours, projection, canvas);
  else
    drawCloud(drawing, projection, canvas);
  drawAxis(drawing, projection, lift, canvas);
  drawPartnerLines(drawing, projection, lift, canvas);
  return canvas.reduce(supersampling);
}

} // namespace

void
writePicture(const std::string& path, const Surface& surface, const SymmetryResult& result)
{
  checkResult(result, surface.size());
  if (fileEnding(path) != ".png")
    throw detail::PlainException<IOException>(path + ": unknown ending '" + fileEnding(path) +
                                              "': a picture is written as .png");
  const std::vector<PartnerPair> pairs = findPartnerPairs(surface, result);
  const PictureView view = chooseView(surface, result, pairs);

  Drawing drawing = {surface, result, surface.normals, pointColours(result), {}, chooseLines(surface, result, pairs)};
  if (surface.hasFaces()) {
    drawing.normals = meshNormals(surface);
  }
  else {
    CloudShading shading = estimateCloudShading(surface.points);
    drawing.spacings = std::move(shading.spacings);
    if (drawing.normals.empty())
      drawing.normals = std::move(shading.normals);
  }
  const auto [width, height] = panelSize(view);
  writeWholeFile(path, encodePng(sideBySide(drawPanel(drawing, view, width, height),
                                            drawPanel(drawing, view.fromBehind(), width, height))));
}

} // namespace symmetry
} // namespace pcl
