/** \file
 * \brief A small software rasteriser: opaque shapes with a depth buffer, then lines blended over them.
 */
#pragma once

#include "picture/palette.h"

#include <array>
#include <cstdint>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A place on the image: x to the right and y down in pixels; a larger depth is nearer to the viewer. */
struct ScreenPoint {
  float x = 0.0F;
  float y = 0.0F;
  float depth = 0.0F;
};

/** \brief Corner of a triangle. */
struct ShadedCorner {
  ScreenPoint place;
  Colour colour = {0, 0, 0};
  float brightness = 1.0F; ///< factor of the colour, in [0, 1]
};

/** \brief How much of its colour a blended shape gives to a pixel, in [0, 1]. */
struct Opacity {
  float in_front = 1.0F; ///< of what is already there
  float behind = 0.0F;   ///< hidden by it
};

/** \brief A colour made darker by a factor in [0, 1]. */
Colour
shade(const Colour& colour, float brightness);

/** \brief Pixels, row by row from the top, red green blue. */
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/** \brief An image under construction, white at first. What lies outside is cut off.
 *
 * Opaque shapes are drawn until they have covered the image pass_limit times over, and lines as often: a few thousand
 * faces, each as large as the image, would otherwise take minutes. What belongs to a surface of any shape covers it
 * less than ten times. */
class Rasterizer {
public:
  /** \brief How often the image may be drawn over. */
  static constexpr int pass_limit = 64;

  Rasterizer(int width, int height);

  /** \brief Whether triangles that together take so many pixels can all be drawn. */
  bool
  hasRoomFor(double pixels) const
  {
    return pixels <= static_cast<double>(fills_left_);
  }

  /** \brief Pixels that a triangle takes: those of the box around it. */
  double
  pixelsOf(const std::array<ShadedCorner, 3>& corners) const;

  /** \brief Fills a triangle. Brightness runs smoothly from corner to corner, while each pixel takes the colour of the
   * corner that is nearest in barycentric terms, which keeps the borders between labels sharp. */
  void
  fillTriangle(const std::array<ShadedCorner, 3>& corners);

  /** \brief Fills a disc that faces the viewer. */
  void
  fillDisc(const ScreenPoint& centre, float radius, const Colour& colour);

  /** \brief Draws a line with round ends over what is there, as opaque as its depth says; depths stay as they were. */
  void
  blendSegment(
      const ScreenPoint& begin, const ScreenPoint& end, float radius, const Colour& colour, const Opacity& opacity);

  /** \brief The image, with \a factor x \a factor pixels averaged into one. */
  Image
  reduce(int factor) const;

private:
  std::size_t
  pixel(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  void
  setIfNearer(int x, int y, float depth, const Colour& colour);

  void
  blend(int x, int y, float depth, const Colour& colour, const Opacity& opacity);

  int width_;
  int height_;
  std::int64_t fills_left_;  ///< pixels of opaque shapes
  std::int64_t blends_left_; ///< pixels of lines
  std::vector<Colour> colours_;
  std::vector<float> depths_;
};

} // namespace symmetry
} // namespace pcl
