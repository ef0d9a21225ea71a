#include "cli/parameter_options.h"

#include "cli/program.h"

#include <pcl/symmetry/symmetry.h>

#include <pcl/exceptions.h>

#include <string>
#include <utility>

namespace pcl {
namespace symmetry {
namespace {

/** \brief A message that begins with the name of a parameter, with that of its option instead. */
std::string
inOptions(const std::string& message)
{
  for (const auto& [parameter, option] : {std::pair("k_search", "--neighbours"),
                                          {"outlier_deviations", "--outliers"},
                                          {"radius", "--radius"},
                                          {"staged.landmarks", "--landmarks"},
                                          {"staged.samples", "--samples"},
                                          {"robust.samples", "--samples"},
                                          {"alternatives", "--alternatives"}})
    if (message.rfind(parameter, 0) == 0)
      return option + message.substr(std::string(parameter).size());
  return message;
}

} // namespace

void
setSamples(SymmetryParameters& parameters, int samples)
{
  if (samples != 0)
    (parameters.method == Method::Robust ? parameters.robust.samples : parameters.staged.samples) = samples;
}

void
checkParameterOptions(const SymmetryParameters& parameters)
{
  try {
    checkParameters(parameters);
  }
  catch (const BadArgumentException& error) {
    throw UsageError(inOptions(errorText(error)));
  }
}

} // namespace symmetry
} // namespace pcl
