/** \file
 * \brief Draws a mesh into an image, lit from above.
 */
#pragma once

#include "picture/picture_view.h"
#include "picture/rasterizer.h"

#include <array>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Pictures are drawn so many times as wide and as high, and reduced at the end: edges become smooth. */
constexpr int supersampling = 2;

/** \brief A view with the size of its image. */
class Projection {
public:
  Projection(const PictureView& view, int width, int height);

  ScreenPoint
  project(const Vector3& point) const;

  /** \brief Pixels per unit of the points. */
  float
  scale() const
  {
    return scale_;
  }

  /** \brief Brightness of a surface with this normal, of either sign, by a lamp above the viewer's left shoulder. */
  float
  brightness(const Vector3& normal) const;

private:
  PictureView view_;
  int width_;
  int height_;
  float scale_;
};

/** \brief Width and height in pixels of the picture of a view: the shape of what is shown, within limits, and always
 * about the same area. */
std::array<int, 2>
panelSize(const PictureView& view);

/** \brief One normal per point, the sum of those of its faces, of any length. */
std::vector<Vector3>
meshNormals(const Surface& surface);

/** \brief Draws all faces whose corners are finite.
 * \param[in] surface with faces
 * \param[in] normals one per point, of any length
 * \param[in] colours one per point, unshaded
 * \param[in] projection to the size of \a canvas
 * \param[in,out] canvas where there is no room for all faces (see Rasterizer), the nearest ones are drawn */
void
drawMesh(const Surface& surface,
         const std::vector<Vector3>& normals,
         const std::vector<Colour>& colours,
         const Projection& projection,
         Rasterizer& canvas);

/** \brief Two images of one height as one. */
Image
sideBySide(const Image& left, const Image& right);

} // namespace symmetry
} // namespace pcl
