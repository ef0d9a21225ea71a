/** \file
 * \brief How programs and reports spell the values of the public enumerations: one table each.
 */
#pragma once

#include <pcl/symmetry/symmetry_parameters.h>
#include <pcl/symmetry/symmetry_result.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pcl {
namespace symmetry {

template <typename Enum>
struct EnumName {
  Enum value;
  const char* name;
};

constexpr EnumName<Method> method_names[] = {{Method::Robust, "robust"}, {Method::Staged, "staged"}};

constexpr EnumName<Metric> metric_names[] = {{Metric::Geodesic, "geodesic"}, {Metric::Euclidean, "euclidean"}};

constexpr EnumName<NormalSource> normal_source_names[] = {{NormalSource::Estimate, "estimate"},
                                                          {NormalSource::Given, "given"}};

constexpr EnumName<ComponentUse> component_use_names[] = {{ComponentUse::All, "all"},
                                                          {ComponentUse::Largest, "largest"}};

constexpr EnumName<PairingFeature> pairing_names[] = {{PairingFeature::AverageGeodesicDistance, "agd"},
                                                      {PairingFeature::MinimalGeodesicDistance, "mgd"},
                                                      {PairingFeature::BySurfaceSize, "size"}};

constexpr EnumName<ExtremePoints> extreme_points_names[] = {{ExtremePoints::AmongNine, "nine"},
                                                            {ExtremePoints::FirstFour, "four"}};

constexpr EnumName<bool> switch_names[] = {{true, "on"}, {false, "off"}};

constexpr EnumName<SymmetryStatus> status_names[] = {{SymmetryStatus::Symmetric, "symmetric"},
                                                     {SymmetryStatus::PartlySymmetric, "partly_symmetric"},
                                                     {SymmetryStatus::NoSymmetry, "no_symmetry"},
                                                     {SymmetryStatus::TooFewPoints, "too_few_points"},
                                                     {SymmetryStatus::Cancelled, "cancelled"}};

/** \brief Name of a value; "unknown" where the table has none. */
template <typename Enum, std::size_t Count>
constexpr const char*
nameOf(const EnumName<Enum> (&table)[Count], Enum value)
{
  for (const EnumName<Enum>& entry : table) {
    if (entry.value == value) {
      return entry.name;
    }
  }
  return "unknown";
}

/** \brief The value of this name, in exactly these letters; nothing where the table has no such name. */
template <typename Enum, std::size_t Count>
std::optional<Enum>
valueOf(const EnumName<Enum> (&table)[Count], std::string_view name)
{
  for (const EnumName<Enum>& entry : table) {
    if (name == entry.name) {
      return entry.value;
    }
  }
  return std::nullopt;
}

/** \brief All names of a table for a person: "agd or mgd or size". */
template <typename Enum, std::size_t Count>
std::string
allNames(const EnumName<Enum> (&table)[Count])
{
  std::string names;
  for (const EnumName<Enum>& entry : table) {
    names += (names.empty() ? "" : " or ") + std::string(entry.name);
  }
  return names;
}

} // namespace symmetry
} // namespace pcl
