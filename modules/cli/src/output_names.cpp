#include "cli/output_names.h"

#include "cli/program.h"
#include "io/write/output_file.h"

#include <algorithm>

namespace pcl {
namespace symmetry {

void
checkDistinct(const std::vector<std::string>& outputs, std::vector<std::string> inputs)
{
  // What comes from standard input is not overwritten by what goes to standard output.
  inputs.erase(std::remove(inputs.begin(), inputs.end(), standard_stream), inputs.end());
  for (const std::string& file : outputs) {
    const auto is_file = [&file](const std::string& other) {
      return areOneFile(file, other);
    };
    if (std::any_of(inputs.begin(), inputs.end(), is_file))
      throw UsageError("'" + file + "' would be overwritten: each file needs a name of its own");
    inputs.push_back(file);
  }
}

void
checkWritableFiles(const std::vector<std::string>& outputs)
{
  for (const std::string& file : outputs)
    if (!file.empty())
      checkOutputFile(file);
}

} // namespace symmetry
} // namespace pcl
