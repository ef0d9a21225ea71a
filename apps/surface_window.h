/** \file
 * \brief A window that shows a labelled surface.
 */
#pragma once

#include "io/read/labelled_surface.h"

#include <pcl/visualization/pcl_visualizer.h>
#include <vtkRenderWindow.h>

#include <string>

namespace pcl {
namespace symmetry {

/** \brief Draws a surface coloured by side; a pick lights up the partner of a point and is printed. */
class SurfaceWindow {
public:
  /** \param[in] surface must outlive the window
   * \param[in] on_screen false: only for a screenshot */
  SurfaceWindow(const LabelledSurface& surface, bool on_screen);

  /** \brief Lines between partners, from points spread evenly over the numbers of the source side. */
  void
  addPartnerLines(std::size_t count);

  /** \brief Renders into a .png file.
   * \throws pcl::IOException cannot be written */
  void
  saveScreenshot(const std::string& path);

  /** \brief Returns when the window is closed. */
  void
  run();

private:
  using Cloud = PointCloud<PointXYZRGB>;

  visualization::PCLVisualizer::Ptr
  makeVisualizer(bool on_screen) const;

  void
  lookAtSurface();

  void
  showPicked(const visualization::PointPickingEvent& event);

  std::size_t
  nearestPoint(const PointXYZRGB& position) const;

  const PointXYZRGB&
  point(std::size_t i) const
  {
    return (*cloud_)[i];
  }

  const PointXYZRGB&
  partnerOf(std::size_t i) const
  {
    return point(static_cast<std::size_t>(surface_.partners[i]));
  }

  const LabelledSurface& surface_;
  Cloud::Ptr cloud_;  ///< coloured by side
  double size_ = 1.0; ///< diagonal of the bounding box
  vtkSmartPointer<vtkRenderWindow> window_;
  visualization::PCLVisualizer::Ptr visualizer_;
};

} // namespace symmetry
} // namespace pcl
