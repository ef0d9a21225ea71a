// By itself, so that a program without readers of surfaces does not load their library.
#include "cli/output_names.h"
#include "cli/program.h"

#include <pcl/symmetry/surface_io.h>

#include <algorithm>

namespace pcl {
namespace symmetry {

void
checkEnding(const char* option, const std::string& file, const std::vector<std::string>& endings)
{
  if (file.empty() || std::find(endings.begin(), endings.end(), fileEnding(file)) != endings.end())
    return;
  std::string names;
  for (const std::string& ending : endings)
    names += (names.empty() ? "" : " or ") + ending;
  throw UsageError("--" + std::string(option) + " writes " + names + ", not '" + file + "'");
}

} // namespace symmetry
} // namespace pcl
