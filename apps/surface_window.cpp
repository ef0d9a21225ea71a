#include "surface_window.h"

#include "io/write/output_file.h"
#include "picture/palette.h"

#include <pcl/common/common.h>
#include <pcl/conversions.h>
#include <pcl/exceptions.h>
#include <vtkObject.h>
#include <vtkPNGWriter.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <iostream>
#include <limits>
#include <memory>

namespace pcl {
namespace symmetry {
namespace {

PointCloud<PointXYZRGB>::Ptr
colouredBySide(const LabelledSurface& surface)
{
  const auto cloud = make_shared<PointCloud<PointXYZRGB>>();
  fromPCLPointCloud2(surface.mesh.cloud, *cloud);
  for (std::size_t i = 0; i < surface.labels.size(); ++i) {
    const Colour colour = colourOf(static_cast<Side>(surface.labels[i]));
    (*cloud)[i].r = colour[0];
    (*cloud)[i].g = colour[1];
    (*cloud)[i].b = colour[2];
  }
  return cloud;
}

} // namespace

SurfaceWindow::SurfaceWindow(const LabelledSurface& surface, bool on_screen)
    : surface_(surface),
      cloud_(colouredBySide(surface)),
      window_(vtkSmartPointer<vtkRenderWindow>::New()),
      visualizer_(makeVisualizer(on_screen))
{
  visualizer_->setBackgroundColor(1.0, 1.0, 1.0);
  visualizer_->setShowFPS(false);
  visualizer_->setSize(1000, 800);
  if (surface_.mesh.polygons.empty())
    visualizer_->addPointCloud<PointXYZRGB>(cloud_, "surface");
  else
    visualizer_->addPolygonMesh<PointXYZRGB>(cloud_, surface_.mesh.polygons, "surface");
  visualizer_->setPointCloudRenderingProperties(visualization::PCL_VISUALIZER_POINT_SIZE, 3, "surface");
  lookAtSurface();
}

void
SurfaceWindow::addPartnerLines(std::size_t count)
{
  std::vector<std::size_t> matched;
  for (std::size_t i = 0; i < surface_.partners.size(); ++i)
    if (surface_.labels[i] == static_cast<std::int64_t>(Side::Source) && surface_.partners[i] >= 0)
      matched.push_back(i);
  const std::size_t lines = std::min(count, matched.size());
  for (std::size_t line = 0; line < lines; ++line) {
    const std::size_t i = matched[line * matched.size() / lines];
    visualizer_->addLine(point(i), partnerOf(i), 0.4, 0.4, 0.4, "partners" + std::to_string(line));
  }
}

void
SurfaceWindow::saveScreenshot(const std::string& path)
{
  // PCL's own function of this name needs an interactor, which an off-screen window has not.
  window_->Render();
  const auto image = vtkSmartPointer<vtkWindowToImageFilter>::New();
  image->SetInput(window_);
  const auto writer = vtkSmartPointer<vtkPNGWriter>::New();
  writer->SetInputConnection(image->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* const png = writer->GetResult();
  if (writer->GetErrorCode() != 0 || png == nullptr)
    throw IOException(path + ": no picture could be made");
  const auto size = static_cast<std::size_t>(png->GetNumberOfValues());
  writeWholeFile(path, {reinterpret_cast<const char*>(png->GetPointer(0)), size});
}

void
SurfaceWindow::run()
{
  visualizer_->registerPointPickingCallback(
      [this](const visualization::PointPickingEvent& event) { showPicked(event); });
  visualizer_->spin();
}

visualization::PCLVisualizer::Ptr
SurfaceWindow::makeVisualizer(bool on_screen) const
{
  // PCL 1.13 calls functions that VTK 9.1 warns about at every click.
  vtkObject::GlobalWarningDisplayOff();
  window_->SetOffScreenRendering(on_screen ? 0 : 1);
  const auto renderer = vtkSmartPointer<vtkRenderer>::New();
  return std::make_shared<visualization::PCLVisualizer>(renderer, window_, "pcl_symmetry_viewer", on_screen);
}

/** Looks along the thinnest direction, y or z upwards. */
void
SurfaceWindow::lookAtSurface()
{
  PointXYZRGB low;
  PointXYZRGB high;
  getMinMax3D(*cloud_, low, high);
  const Eigen::Vector3f centre = 0.5F * (low.getVector3fMap() + high.getVector3fMap());
  const Eigen::Vector3f extent = high.getVector3fMap() - low.getVector3fMap();
  size_ = extent.norm();
  Eigen::Index thinnest = 0;
  extent.minCoeff(&thinnest);
  const Eigen::Vector3f up = thinnest == 1 ? Eigen::Vector3f::UnitZ() : Eigen::Vector3f::UnitY();
  Eigen::Vector3f eye = centre;
  eye[thinnest] += 2.0F * static_cast<float>(size_);
  visualizer_->setCameraPosition(eye[0], eye[1], eye[2], centre[0], centre[1], centre[2], up[0], up[1], up[2]);
  visualizer_->resetCamera();
}

void
SurfaceWindow::showPicked(const visualization::PointPickingEvent& event)
{
  if (event.getPointIndex() == -1)
    return;
  PointXYZRGB picked;
  event.getPoint(picked.x, picked.y, picked.z);
  const std::size_t i = nearestPoint(picked);
  visualizer_->removeShape("picked");
  visualizer_->removeShape("partner");
  visualizer_->removeShape("connection");
  const double radius = 0.01 * size_;
  visualizer_->addSphere(point(i), radius, 0.8, 0.0, 0.5, "picked");
  std::cout << "point " << i << ", partner " << surface_.partners[i] << ", label " << surface_.labels[i] << std::endl;
  if (surface_.partners[i] < 0)
    return;
  visualizer_->addSphere(partnerOf(i), radius, 0.0, 0.6, 0.3, "partner");
  visualizer_->addLine(point(i), partnerOf(i), 0.0, 0.6, 0.3, "connection");
}

/** The number that a pick delivers counts the points of the drawn object, which leaves out points that are not finite.
 */
std::size_t
SurfaceWindow::nearestPoint(const PointXYZRGB& position) const
{
  std::size_t nearest = 0;
  float smallest = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < cloud_->size(); ++i) {
    const float distance = (point(i).getVector3fMap() - position.getVector3fMap()).squaredNorm();
    if (distance < smallest) {
      smallest = distance;
      nearest = i;
    }
  }
  return nearest;
}

} // namespace symmetry
} // namespace pcl
