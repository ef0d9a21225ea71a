#include "estimation/enum_names.h"
#include "refuse_argument.h"

#include <pcl/symmetry/symmetry.h>

namespace pcl {
namespace symmetry {
namespace {

template <typename Number>
void
checkRange(const char* name, Number value, Number minimum, Number maximum)
{
  if (!(value >= minimum && value <= maximum)) { // also true of NaN
    refuseArgument(name, " is ", value, ", allowed are ", minimum, " to ", maximum);
  }
}

template <typename Enum, std::size_t count>
void
checkNamed(const char* name, const EnumName<Enum> (&table)[count], Enum value)
{
  for (const EnumName<Enum>& entry : table) {
    if (entry.value == value) {
      return;
    }
  }
  refuseArgument(name, " is ", static_cast<int>(value), ", which is none of ", allNames(table));
}

} // namespace

const char*
toString(SymmetryStatus status)
{
  return nameOf(status_names, status);
}

void
checkParameters(const SymmetryParameters& parameters)
{
  checkNamed("method", method_names, parameters.method);
  checkNamed("metric", metric_names, parameters.metric);
  checkNamed("normals", normal_source_names, parameters.normals);
  checkNamed("components", component_use_names, parameters.components);
  checkNamed("staged.extremities", extreme_points_names, parameters.staged.extremities);
  checkNamed("staged.pairing", pairing_names, parameters.staged.pairing);
  constexpr float largest = 1e30F;
  checkRange("k_search", parameters.k_search, 3, 256);
  checkRange("radius", parameters.radius, 0.0F, largest);
  checkRange("outlier_deviations", parameters.outlier_deviations, 0.0F, largest);
  checkRange("robust.samples", parameters.robust.samples, 30, 20000);
  checkRange("staged.landmarks", parameters.staged.landmarks, 10, 1000);
  checkRange("staged.samples", parameters.staged.samples, 20, 20000);
  checkRange("staged.embedding_dimensions", parameters.staged.embedding_dimensions, 2, 20);
  checkRange("alternatives", parameters.alternatives, 1, 100);
}

} // namespace symmetry
} // namespace pcl
