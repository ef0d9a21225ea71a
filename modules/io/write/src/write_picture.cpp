#include "base/vector_math.h"
#include "io/write/output_file.h"
#include "io/write/result_check.h"
#include "picture/cloud_shading.h"
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

constexpr int supersampling = 2;
constexpr float panel_pixels = 640000.0F; ///< of one of the two views
constexpr std::size_t partner_lines = 40;
constexpr float line_radius = 0.8F; ///< in pixels of the finished picture, as the next two
constexpr float dot_radius = 3.0F;
constexpr float axis_radius = 2.2F;
constexpr Colour line_colour = {40, 40, 48};

/** \brief A view with the size of its image. */
class Projection {
public:
  Projection(const PictureView& view, int width, int height)
      : view_(view),
        width_(width),
        height_(height),
        scale_(std::min(static_cast<float>(width) / view.width, static_cast<float>(height) / view.height))
  {
  }

  ScreenPoint
  project(const Vector3& point) const
  {
    const Vector3 offset = point - view_.centre;
    return {0.5F * static_cast<float>(width_) + scale_ * dot(offset, view_.right),
            0.5F * static_cast<float>(height_) - scale_ * dot(offset, view_.up), scale_ * dot(offset, view_.toward)};
  }

  float
  scale() const
  {
    return scale_;
  }

  /** \brief Brightness of a surface with this normal, of either sign, by a lamp above the viewer's left shoulder. */
  float
  brightness(const Vector3& normal) const
  {
    constexpr float ambient = 0.42F;
    const float length = norm(normal);
    if (!(length > 0.0F) || !std::isfinite(length))
      return 0.8F;
    const Vector3 lamp = normalized(-0.35F * view_.right + 0.45F * view_.up + view_.toward);
    const float sign = dot(normal, view_.toward) < 0.0F ? -1.0F : 1.0F;
    return ambient + (1.0F - ambient) * std::max(0.0F, sign * dot(normal, lamp) / length);
  }

private:
  PictureView view_;
  int width_;
  int height_;
  float scale_;
};

/** \brief All that both views draw. */
struct Drawing {
  const Surface& surface;
  const SymmetryResult& result;
  std::vector<Vector3> normals; ///< per point
  std::vector<Colour> colours;  ///< per point, unshaded
  std::vector<float> spacings;  ///< per point of a cloud
  std::vector<PartnerPair> lines;
};

std::vector<Vector3>
meshNormals(const Surface& surface)
{
  std::vector<Vector3> normals(surface.size(), Vector3{0.0F, 0.0F, 0.0F});
  for (const Triangle& triangle : surface.triangles) {
    const auto corner = [&](std::size_t i) {
      return surface.points[static_cast<std::size_t>(triangle[i])];
    };
    const Vector3 normal = cross(corner(1) - corner(0), corner(2) - corner(0)); // as long as the triangle is large
    for (const Index index : triangle)
      normals[static_cast<std::size_t>(index)] = normals[static_cast<std::size_t>(index)] + normal;
  }
  return normals;
}

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

using ShadedFace = std::array<ShadedCorner, 3>;

/** \brief Depth of the corner that is nearest to the viewer. */
float
nearestDepth(const ShadedFace& face)
{
  const float depth = std::max({face[0].place.depth, face[1].place.depth, face[2].place.depth});
  return std::isfinite(depth) ? depth : std::numeric_limits<float>::lowest();
}

/** \brief Draws faces, which are so large that there is no room for all of them, the nearest first: they hide most of
 * those that are not drawn. */
template <typename FaceOf>
void
drawNearestFirst(std::size_t count, FaceOf face_of, Rasterizer& canvas)
{
  std::vector<std::pair<float, std::size_t>> order;
  order.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    order.emplace_back(-nearestDepth(face_of(i)), i);
  std::sort(order.begin(), order.end());
  for (const auto& [depth, i] : order)
    canvas.fillTriangle(face_of(i));
}

void
drawMesh(const Drawing& drawing, const Projection& projection, Rasterizer& canvas)
{
  const Surface& surface = drawing.surface;
  std::vector<ShadedCorner> corners(surface.size());
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (isFinite(surface.points[i]))
      corners[i] = {projection.project(surface.points[i]), drawing.colours[i],
                    projection.brightness(drawing.normals[i])};
    else
      corners[i].place.x = std::numeric_limits<float>::quiet_NaN(); // its faces are not drawn
  const std::size_t count = surface.triangles.size();
  const auto face_of = [&](std::size_t i) -> ShadedFace {
    const auto corner = [&](std::size_t k) -> const ShadedCorner& {
      return corners[static_cast<std::size_t>(surface.triangles[i][k])];
    };
    return {corner(0), corner(1), corner(2)};
  };
  double pixels = 0.0;
  for (std::size_t i = 0; i < count; ++i)
    pixels += canvas.pixelsOf(face_of(i));
  if (!canvas.hasRoomFor(pixels))
    return drawNearestFirst(count, face_of, canvas);
  for (std::size_t i = 0; i < count; ++i)
    canvas.fillTriangle(face_of(i));
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
    drawMesh(drawing, projection, canvas);
  else
    drawCloud(drawing, projection, canvas);
  drawAxis(drawing, projection, lift, canvas);
  drawPartnerLines(drawing, projection, lift, canvas);
  return canvas.reduce(supersampling);
}

Image
sideBySide(const Image& left, const Image& right)
{
  Image image;
  image.width = left.width + right.width;
  image.height = left.height;
  const auto row = [](const Image& part, int y) {
    return part.pixels.begin() + static_cast<std::ptrdiff_t>(3) * part.width * y;
  };
  for (int y = 0; y < image.height; ++y) {
    image.pixels.insert(image.pixels.end(), row(left, y), row(left, y + 1));
    image.pixels.insert(image.pixels.end(), row(right, y), row(right, y + 1));
  }
  return image;
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
  // The shape of the panels follows that of the surface, within limits.
  const float aspect = std::clamp(view.width / view.height, 0.5F, 1.6F);
  const int width = static_cast<int>(std::lround(std::sqrt(panel_pixels * aspect)));
  const int height = static_cast<int>(std::lround(std::sqrt(panel_pixels / aspect)));
  writeWholeFile(path, encodePng(sideBySide(drawPanel(drawing, view, width, height),
                                            drawPanel(drawing, view.fromBehind(), width, height))));
}

} // namespace symmetry
} // namespace pcl
