/** \file
 * \brief pcl_symmetry_viewer: shows a labelled surface; Shift and a click on a point lights up its partner.
 */
#include "base/error_text.h"
#include "io/write/output_file.h"
#include "picture/palette.h"

#include <boost/program_options.hpp>
#include <pcl/common/common.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/visualization/pcl_visualizer.h>
#include <vtkObject.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <limits>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace po = boost::program_options;

namespace {

constexpr int exit_done = 0;
constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;

/** What the viewer needs of a file of pcl_intrinsic_symmetry. */
struct LabelledSurface {
  Cloud::Ptr cloud{new Cloud};         ///< coloured by side
  std::vector<pcl::Vertices> polygons; ///< empty for a point cloud
  std::vector<std::int64_t> partners;  ///< -1: none
  std::vector<std::int64_t> labels;    ///< 0 none, 1 source side, 2 target side, 3 axis
  double size = 1.0;                   ///< diagonal of the bounding box
  Eigen::Vector3f centre{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f extent{0.0F, 0.0F, 0.0F};
};

template <typename Stored>
std::int64_t
load(const std::uint8_t* bytes)
{
  Stored value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<std::int64_t>(value);
}

std::int64_t
loadInteger(const pcl::PCLPointField& field, const std::uint8_t* bytes, const std::string& path)
{
  switch (field.datatype) {
  case pcl::PCLPointField::INT8:
    return load<std::int8_t>(bytes);
  case pcl::PCLPointField::UINT8:
    return load<std::uint8_t>(bytes);
  case pcl::PCLPointField::INT16:
    return load<std::int16_t>(bytes);
  case pcl::PCLPointField::UINT16:
    return load<std::uint16_t>(bytes);
  case pcl::PCLPointField::INT32:
    return load<std::int32_t>(bytes);
  case pcl::PCLPointField::UINT32:
    return load<std::uint32_t>(bytes);
  default:
    throw std::runtime_error(path + ": field '" + field.name + "' holds no integers");
  }
}

/** One integer field of all points, checked to be in [least, end). */
std::vector<std::int64_t>
integerField(const pcl::PCLPointCloud2& cloud,
             const std::string& name,
             std::int64_t least,
             std::int64_t end,
             const std::string& path)
{
  const auto field = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [&name](const pcl::PCLPointField& f) { return f.name == name; });
  if (field == cloud.fields.end())
    throw std::runtime_error(path + ": has no field '" + name + "', so it was not written by pcl_intrinsic_symmetry");
  std::vector<std::int64_t> values;
  const std::size_t points = std::size_t{cloud.width} * cloud.height;
  for (std::size_t i = 0; i < points; ++i) {
    values.push_back(loadInteger(*field, cloud.data.data() + i * cloud.point_step + field->offset, path));
    if (values.back() >= least && values.back() < end)
      continue;
    std::ostringstream message;
    message << path << ": " << name << ' ' << values.back() << " of point " << i << " is out of range";
    throw std::runtime_error(message.str());
  }
  return values;
}

/** \brief Ending of a file's name in lower case, with the dot. */
std::string
endingOf(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

pcl::PolygonMesh
readFile(const std::string& path)
{
  const std::string ending = endingOf(path);
  pcl::PolygonMesh mesh;
  int status = 0;
  if (ending == ".ply")
    status = pcl::PLYReader().read(path, mesh);
  else if (ending == ".pcd")
    status = pcl::PCDReader().read(path, mesh.cloud);
  else
    throw std::runtime_error(path + ": is neither .ply nor .pcd");
  if (status < 0 || mesh.cloud.data.empty())
    throw std::runtime_error(path + ": cannot be read, or holds no points");
  return mesh;
}

void
colourBySide(LabelledSurface& surface)
{
  for (std::size_t i = 0; i < surface.labels.size(); ++i) {
    const pcl::symmetry::Color colour = pcl::symmetry::colorOf(static_cast<pcl::symmetry::Side>(surface.labels[i]));
    (*surface.cloud)[i].r = colour[0];
    (*surface.cloud)[i].g = colour[1];
    (*surface.cloud)[i].b = colour[2];
  }
}

LabelledSurface
readLabelledSurface(const std::string& path)
{
  pcl::PolygonMesh mesh = readFile(path);
  LabelledSurface surface;
  const auto points = static_cast<std::int64_t>(mesh.cloud.width) * mesh.cloud.height;
  surface.partners = integerField(mesh.cloud, "partner", -1, points, path);
  surface.labels = integerField(mesh.cloud, "label", 0, 4, path);
  pcl::fromPCLPointCloud2(mesh.cloud, *surface.cloud);
  surface.polygons = std::move(mesh.polygons);
  colourBySide(surface);
  pcl::PointXYZRGB low;
  pcl::PointXYZRGB high;
  pcl::getMinMax3D(*surface.cloud, low, high);
  surface.centre = 0.5F * (low.getVector3fMap() + high.getVector3fMap());
  surface.extent = high.getVector3fMap() - low.getVector3fMap();
  surface.size = surface.extent.norm();
  return surface;
}

class Viewer {
public:
  Viewer(const LabelledSurface& surface, bool on_screen)
      : surface_(surface), window_(vtkSmartPointer<vtkRenderWindow>::New()), visualizer_(makeVisualizer(on_screen))
  {
    visualizer_->setBackgroundColor(1.0, 1.0, 1.0);
    visualizer_->setShowFPS(false);
    visualizer_->setSize(1000, 800);
    if (surface_.polygons.empty())
      visualizer_->addPointCloud<pcl::PointXYZRGB>(surface_.cloud, "surface");
    else
      visualizer_->addPolygonMesh<pcl::PointXYZRGB>(surface_.cloud, surface_.polygons, "surface");
    visualizer_->setPointCloudRenderingProperties(pcl::visualization::PCL_VISUALIZER_POINT_SIZE, 3, "surface");
    lookAtSurface();
  }

  /** Lines between partners, from points spread evenly over the numbers of the source side. */
  void
  addPartnerLines(std::size_t count)
  {
    std::vector<std::size_t> matched;
    for (std::size_t i = 0; i < surface_.partners.size(); ++i)
      if (surface_.labels[i] == 1 && surface_.partners[i] >= 0)
        matched.push_back(i);
    const std::size_t lines = std::min(count, matched.size());
    for (std::size_t line = 0; line < lines; ++line) {
      const std::size_t i = matched[line * matched.size() / lines];
      visualizer_->addLine(point(i), partnerOf(i), 0.4, 0.4, 0.4, "partners" + std::to_string(line));
    }
  }

  /** PCL's own function of this name needs an interactor, which an off-screen window has not. */
  void
  saveScreenshot(const std::string& path)
  {
    window_->Render();
    const auto image = vtkSmartPointer<vtkWindowToImageFilter>::New();
    image->SetInput(window_);
    const auto writer = vtkSmartPointer<vtkPNGWriter>::New();
    writer->SetInputConnection(image->GetOutputPort());
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* const png = writer->GetResult();
    if (writer->GetErrorCode() != 0 || png == nullptr)
      throw std::runtime_error(path + ": no picture could be made");
    const auto size = static_cast<std::size_t>(png->GetNumberOfValues());
    pcl::symmetry::writeWholeFile(path, {reinterpret_cast<const char*>(png->GetPointer(0)), size});
  }

  void
  run()
  {
    visualizer_->registerPointPickingCallback(
        [this](const pcl::visualization::PointPickingEvent& event) { showPicked(event); });
    visualizer_->spin();
  }

private:
  pcl::visualization::PCLVisualizer::Ptr
  makeVisualizer(bool on_screen) const
  {
    window_->SetOffScreenRendering(on_screen ? 0 : 1);
    const auto renderer = vtkSmartPointer<vtkRenderer>::New();
    return std::make_shared<pcl::visualization::PCLVisualizer>(renderer, window_, "pcl_symmetry_viewer", on_screen);
  }

  /** Looks along the thinnest direction, y or z upwards. */
  void
  lookAtSurface()
  {
    Eigen::Index thinnest = 0;
    surface_.extent.minCoeff(&thinnest);
    const Eigen::Vector3f up = thinnest == 1 ? Eigen::Vector3f::UnitZ() : Eigen::Vector3f::UnitY();
    Eigen::Vector3f eye = surface_.centre;
    eye[thinnest] += 2.0F * static_cast<float>(surface_.size);
    const Eigen::Vector3f& centre = surface_.centre;
    visualizer_->setCameraPosition(eye[0], eye[1], eye[2], centre[0], centre[1], centre[2], up[0], up[1], up[2]);
    visualizer_->resetCamera();
  }

  void
  showPicked(const pcl::visualization::PointPickingEvent& event)
  {
    if (event.getPointIndex() == -1)
      return;
    pcl::PointXYZRGB picked;
    event.getPoint(picked.x, picked.y, picked.z);
    const std::size_t i = nearestPoint(picked);
    visualizer_->removeShape("picked");
    visualizer_->removeShape("partner");
    visualizer_->removeShape("connection");
    const double radius = 0.01 * surface_.size;
    visualizer_->addSphere(point(i), radius, 0.8, 0.0, 0.5, "picked");
    std::cout << "point " << i << ", partner " << surface_.partners[i] << ", label " << surface_.labels[i] << std::endl;
    if (surface_.partners[i] < 0)
      return;
    visualizer_->addSphere(partnerOf(i), radius, 0.0, 0.6, 0.3, "partner");
    visualizer_->addLine(point(i), partnerOf(i), 0.0, 0.6, 0.3, "connection");
  }

  /** The number that a pick delivers counts the points of the drawn object, which leaves out points that are not
   * finite. */
  std::size_t
  nearestPoint(const pcl::PointXYZRGB& position) const
  {
    std::size_t nearest = 0;
    float smallest = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < surface_.cloud->size(); ++i) {
      const float distance = (point(i).getVector3fMap() - position.getVector3fMap()).squaredNorm();
      if (distance < smallest) {
        smallest = distance;
        nearest = i;
      }
    }
    return nearest;
  }

  const pcl::PointXYZRGB&
  point(std::size_t i) const
  {
    return (*surface_.cloud)[i];
  }

  const pcl::PointXYZRGB&
  partnerOf(std::size_t i) const
  {
    return point(static_cast<std::size_t>(surface_.partners[i]));
  }

  const LabelledSurface& surface_;
  vtkSmartPointer<vtkRenderWindow> window_;
  pcl::visualization::PCLVisualizer::Ptr visualizer_;
};

po::options_description
describeOptions()
{
  po::options_description options("Options");
  options.add_options()("partners", po::value<int>()->default_value(0), "draw this many lines between partners")(
      "screenshot", po::value<std::string>(),
      "render into this .png file and exit")("help", "print this text")("version", "print the version");
  return options;
}

int
show(const po::variables_map& arguments)
{
  const int partners = arguments["partners"].as<int>();
  if (partners < 0 || partners > 10000)
    throw po::error("--partners " + std::to_string(partners) + " is not in [0, 10000]");
  if (arguments.count("file") == 0)
    throw po::error("FILE, a labelled surface, is missing");
  if (arguments.count("screenshot") > 0 && endingOf(arguments["screenshot"].as<std::string>()) != ".png")
    throw po::error("--screenshot writes .png, not '" + arguments["screenshot"].as<std::string>() + "'");
  const LabelledSurface surface = readLabelledSurface(arguments["file"].as<std::string>());
  // Without an X server VTK would end the program with a signal.
  const char* const display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0')
    throw std::runtime_error("no display: DISPLAY is not set");
  // PCL 1.13 calls functions that VTK 9.1 warns about at every click.
  vtkObject::GlobalWarningDisplayOff();
  const bool on_screen = arguments.count("screenshot") == 0;
  Viewer viewer(surface, on_screen);
  viewer.addPartnerLines(static_cast<std::size_t>(partners));
  if (on_screen)
    viewer.run();
  else
    viewer.saveScreenshot(arguments["screenshot"].as<std::string>());
  return exit_done;
}

int
run(int argc, char** argv)
{
  const po::options_description visible = describeOptions();
  po::options_description all;
  all.add(visible).add_options()("file", po::value<std::string>());
  po::positional_options_description positional;
  positional.add("file", 1);
  const auto style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::variables_map arguments;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(), arguments);
  if (arguments.count("help") > 0) {
    std::cout << "Usage: pcl_symmetry_viewer FILE [options]\n\n"
                 "Shows a .ply or .pcd file written by pcl_intrinsic_symmetry: source side blue, target side orange,\n"
                 "axis dark red. Shift and left click on a point lights up its partner.\n\n"
              << visible;
    return exit_done;
  }
  if (arguments.count("version") > 0) {
    std::cout << "pcl_symmetry_viewer " PCL_SYMMETRY_VERSION "\n";
    return exit_done;
  }
  return show(arguments);
}

} // namespace

int
main(int argc, char** argv)
{
  try {
    return run(argc, argv);
  }
  catch (const po::error& error) {
    std::cerr << "pcl_symmetry_viewer: " << error.what() << " (see --help)\n";
    return exit_usage;
  }
  catch (const std::exception& error) {
    std::cerr << "pcl_symmetry_viewer: " << pcl::symmetry::errorText(error) << '\n';
    return exit_failed;
  }
}
