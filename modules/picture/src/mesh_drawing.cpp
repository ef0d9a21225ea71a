#include "picture/mesh_drawing.h"

#include "base/vector_math.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

constexpr float panel_pixels = 640000.0F; ///< of a picture

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

} // namespace

Projection::Projection(const PictureView& view, int width, int height)
    : view_(view),
      width_(width),
      height_(height),
      scale_(std::min(static_cast<float>(width) / view.width, static_cast<float>(height) / view.height))
{
}

ScreenPoint
Projection::project(const Vector3& point) const
{
  const Vector3 offset = point - view_.centre;
  return {0.5F * static_cast<float>(width_) + scale_ * dot(offset, view_.right),
          0.5F * static_cast<float>(height_) - scale_ * dot(offset, view_.up), scale_ * dot(offset, view_.toward)};
}

float
Projection::brightness(const Vector3& normal) const
{
  constexpr float ambient = 0.42F;
  const float length = norm(normal);
  if (!(length > 0.0F) || !std::isfinite(length))
    return 0.8F;
  const Vector3 lamp = normalized(-0.35F * view_.right + 0.45F * view_.up + view_.toward);
  const float sign = dot(normal, view_.toward) < 0.0F ? -1.0F : 1.0F;
  return ambient + (1.0F - ambient) * std::max(0.0F, sign * dot(normal, lamp) / length);
}

std::array<int, 2>
panelSize(const PictureView& view)
{
  const float aspect = std::clamp(view.width / view.height, 0.5F, 1.6F);
  return {static_cast<int>(std::lround(std::sqrt(panel_pixels * aspect))),
          static_cast<int>(std::lround(std::sqrt(panel_pixels / aspect)))};
}

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

void
drawMesh(const Surface& surface,
         const std::vector<Vector3>& normals,
         const std::vector<Colour>& colours,
         const Projection& projection,
         Rasterizer& canvas)
{
  std::vector<ShadedCorner> corners(surface.size());
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (isFinite(surface.points[i]))
      corners[i] = {projection.project(surface.points[i]), colours[i], projection.brightness(normals[i])};
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

} // namespace symmetry
} // namespace pcl
