/** \file
 * \brief pcl_symmetry_viewer: shows a labelled surface; Shift and a click on a point lights up its partner.
 */
#include "cli/command_line.h"
#include "cli/output_names.h"
#include "surface_window.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

using namespace pcl::symmetry;

namespace {

constexpr const char* program = "pcl_symmetry_viewer";

struct Options {
  std::string file;
  unsigned partners = 0;
  std::string screenshot; ///< empty: show a window
};

CommandLine
describeOptions(Options& options)
{
  OptionGroup group("Options");
  group.count("partners", options.partners, 10000, "draw this many lines between partners");
  group.file("screenshot", options.screenshot, "render into this .png file and exit");
  CommandLine line(
      program, "pcl_symmetry_viewer FILE [options]\n\n"
               "Shows a .ply or .pcd file written by pcl_intrinsic_symmetry: source side blue, target side orange,\n"
               "axis dark red. Shift and left click on a point lights up its partner.\n");
  line.addLast(group);
  return line;
}

int
show(const Options& options)
{
  const LabelledSurface surface = readLabelledSurface(options.file);
  // Without an X server VTK would end the program with a signal.
  const char* const display = std::getenv("DISPLAY");
  if (display == nullptr || *display == '\0')
    throw std::runtime_error("no display: DISPLAY is not set");
  const bool on_screen = options.screenshot.empty();
  SurfaceWindow window(surface, on_screen);
  window.addPartnerLines(options.partners);
  if (on_screen)
    window.run();
  else
    window.saveScreenshot(options.screenshot);
  return exit_done;
}

int
runWith(Options& options, const CommandLine& line)
{
  options.file = line.onlyWord("FILE", "a labelled surface");
  checkEnding("screenshot", options.screenshot, {".png"});
  return show(options);
}

} // namespace

int
main(int argc, char** argv)
{
  return runCommand(program, argc, argv, describeOptions, runWith);
}
