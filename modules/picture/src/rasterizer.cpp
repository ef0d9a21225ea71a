#include "picture/rasterizer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace {

/** \brief Pixels whose centres lie in [least, most], cut to [0, size); none where a bound is not a number. */
struct PixelRange {
  PixelRange(float least, float most, int size)
  {
    if (!(least <= most))
      return;
    const auto limit = static_cast<float>(size);
    begin = static_cast<int>(std::clamp(std::ceil(least - 0.5F), 0.0F, limit));
    end = static_cast<int>(std::clamp(std::floor(most - 0.5F) + 1.0F, 0.0F, limit));
  }

  int begin = 0;
  int end = 0; ///< one behind the last

  std::int64_t
  size() const
  {
    return std::int64_t{end} - begin;
  }
};

/** \brief Columns and rows of the box around a triangle. */
std::array<PixelRange, 2>
boxAround(const std::array<ShadedCorner, 3>& corners, int width, int height)
{
  const ScreenPoint& a = corners[0].place;
  const ScreenPoint& b = corners[1].place;
  const ScreenPoint& c = corners[2].place;
  return {PixelRange(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), width),
          PixelRange(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), height)};
}

/** \brief Twice the signed area of the triangle a, b, (x, y). */
float
edgeFunction(const ScreenPoint& a, const ScreenPoint& b, float x, float y)
{
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

std::uint8_t
mix(std::uint8_t below, std::uint8_t above, float opacity)
{
  const auto from = static_cast<float>(below);
  return static_cast<std::uint8_t>(std::lround(from + opacity * (static_cast<float>(above) - from)));
}

} // namespace

Colour
shade(const Colour& colour, float brightness)
{
  const float factor = std::clamp(brightness, 0.0F, 1.0F);
  Colour shaded = colour;
  for (std::uint8_t& channel : shaded)
    channel = static_cast<std::uint8_t>(static_cast<float>(channel) * factor);
  return shaded;
}

Rasterizer::Rasterizer(int width, int height)
    : width_(width),
      height_(height),
      fills_left_(std::int64_t{pass_limit} * width * height),
      blends_left_(fills_left_),
      colours_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), Colour{255, 255, 255}),
      depths_(colours_.size(), -std::numeric_limits<float>::infinity())
{
}

void
Rasterizer::setIfNearer(int x, int y, float depth, const Colour& colour)
{
  const std::size_t i = pixel(x, y);
  if (depth <= depths_[i])
    return;
  depths_[i] = depth;
  colours_[i] = colour;
}

void
Rasterizer::blend(int x, int y, float depth, const Colour& colour, const Opacity& opacity)
{
  const std::size_t i = pixel(x, y);
  const float share = depth >= depths_[i] ? opacity.in_front : opacity.behind;
  for (std::size_t channel = 0; channel < 3; ++channel)
    colours_[i][channel] = mix(colours_[i][channel], colour[channel], share);
}

void
Rasterizer::fillTriangle(const std::array<ShadedCorner, 3>& corners)
{
  const ScreenPoint& a = corners[0].place;
  const ScreenPoint& b = corners[1].place;
  const ScreenPoint& c = corners[2].place;
  const float area = edgeFunction(a, b, c.x, c.y);
  if (area == 0.0F || !std::isfinite(area) || fills_left_ <= 0)
    return;
  const auto [columns, rows] = boxAround(corners, width_, height_);
  fills_left_ -= columns.size() * rows.size();
  for (int y = rows.begin; y < rows.end; ++y) {
    for (int x = columns.begin; x < columns.end; ++x) {
      const float centre_x = static_cast<float>(x) + 0.5F;
      const float centre_y = static_cast<float>(y) + 0.5F;
      const std::array<float, 3> weights = {edgeFunction(b, c, centre_x, centre_y) / area,
                                            edgeFunction(c, a, centre_x, centre_y) / area,
                                            edgeFunction(a, b, centre_x, centre_y) / area};
      if (weights[0] < 0.0F || weights[1] < 0.0F || weights[2] < 0.0F)
        continue;
      float depth = 0.0F;
      float brightness = 0.0F;
      for (std::size_t i = 0; i < 3; ++i) {
        depth += weights[i] * corners[i].place.depth;
        brightness += weights[i] * corners[i].brightness;
      }
      const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
      setIfNearer(x, y, depth, shade(corners[static_cast<std::size_t>(nearest)].colour, brightness));
    }
  }
}

double
Rasterizer::pixelsOf(const std::array<ShadedCorner, 3>& corners) const
{
  const auto [columns, rows] = boxAround(corners, width_, height_);
  return static_cast<double>(columns.size() * rows.size());
}

void
Rasterizer::fillDisc(const ScreenPoint& centre, float radius, const Colour& colour)
{
  if (fills_left_ <= 0)
    return;
  const PixelRange columns(centre.x - radius, centre.x + radius, width_);
  const PixelRange rows(centre.y - radius, centre.y + radius, height_);
  fills_left_ -= columns.size() * rows.size();
  for (int y = rows.begin; y < rows.end; ++y) {
    for (int x = columns.begin; x < columns.end; ++x) {
      const float dx = static_cast<float>(x) + 0.5F - centre.x;
      const float dy = static_cast<float>(y) + 0.5F - centre.y;
      if (dx * dx + dy * dy <= radius * radius)
        setIfNearer(x, y, centre.depth, colour);
    }
  }
}

void
Rasterizer::blendSegment(
    const ScreenPoint& begin, const ScreenPoint& end, float radius, const Colour& colour, const Opacity& opacity)
{
  const float dx = end.x - begin.x;
  const float dy = end.y - begin.y;
  const float squared_length = dx * dx + dy * dy;
  const PixelRange rows(std::min(begin.y, end.y) - radius, std::max(begin.y, end.y) + radius, height_);
  for (int y = rows.begin; y < rows.end && blends_left_ > 0; ++y) {
    const float centre_y = static_cast<float>(y) + 0.5F;
    // The part of the line within reach of this row, so that a long slanted line costs no whole rectangle.
    float least = std::min(begin.x, end.x);
    float most = std::max(begin.x, end.x);
    if (std::abs(dy) > radius) {
      const float slope = dx / dy;
      const float middle = begin.x + (centre_y - begin.y) * slope;
      least = std::max(least, middle - std::abs(slope) * radius);
      most = std::min(most, middle + std::abs(slope) * radius);
    }
    const PixelRange columns(least - radius, most + radius, width_);
    blends_left_ -= columns.size() + 1;
    for (int x = columns.begin; x < columns.end; ++x) {
      const float along = (static_cast<float>(x) + 0.5F - begin.x) * dx + (centre_y - begin.y) * dy;
      const float t = squared_length > 0.0F ? std::clamp(along / squared_length, 0.0F, 1.0F) : 0.0F;
      const float off_x = static_cast<float>(x) + 0.5F - (begin.x + t * dx);
      const float off_y = centre_y - (begin.y + t * dy);
      if (off_x * off_x + off_y * off_y <= radius * radius)
        blend(x, y, begin.depth + t * (end.depth - begin.depth), colour, opacity);
    }
  }
}

Image
Rasterizer::reduce(int factor) const
{
  Image image;
  image.width = width_ / factor;
  image.height = height_ / factor;
  image.pixels.reserve(3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      std::array<int, 3> sum = {0, 0, 0};
      for (int i = 0; i < factor * factor; ++i)
        for (std::size_t channel = 0; channel < 3; ++channel)
          sum[channel] += colours_[pixel(x * factor + i % factor, y * factor + i / factor)][channel];
      for (const int value : sum)
        image.pixels.push_back(static_cast<std::uint8_t>((value + factor * factor / 2) / (factor * factor)));
    }
  }
  return image;
}

} // namespace symmetry
} // namespace pcl
