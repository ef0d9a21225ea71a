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
  checkNamed("extremities", extreme_points_names, parameters.extremities);
  checkNamed("components", component_use_names, parameters.components);
  checkNamed("pairing", pairing_names, parameters.pairing);
  constexpr float largest = 1e30F;
  checkRange("k_search", parameters.k_search, 3, 256);
  checkRange("radius", parameters.radius, 0.0F, largest);
  checkRange("outlier_deviations", parameters.outlier_deviations, 0.0F, largest);
  checkRange("landmarks", parameters.landmarks, 10, 1000);
  if (parameters.samples != 0) {
    checkRange("samples", parameters.samples, parameters.method == Method::Robust ? 30 : 20, 20000);
  }
  checkRange("embedding_dimensions", parameters.embedding_dimensions, 2, 20);
  checkRange("alternatives", parameters.alternatives, 1, 100);
}

} // namespace symmetry
} // namespace pcl
