// Names of the values of enumerations: what the one direction says, the other one understands.
#include "estimation/enum_names.h"

#include <gtest/gtest.h>

#include <set>

using namespace pcl::symmetry;

namespace {

/** Each value has a name of its own that leads back to it; \a last is the last enumerator. */
template <typename Enum, std::size_t count>
void
expectRoundTrip(const EnumName<Enum> (&table)[count], Enum last)
{
  EXPECT_EQ(count, static_cast<std::size_t>(last) + 1) << "each enumerator has an entry";
  std::set<std::string> names;
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = static_cast<Enum>(i);
    const std::string name = nameOf(table, value);
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(valueOf(table, name), value) << name;
  }
  EXPECT_STREQ(nameOf(table, static_cast<Enum>(count)), "unknown");
  EXPECT_EQ(valueOf(table, "unknown"), std::nullopt);
  EXPECT_EQ(valueOf(table, ""), std::nullopt);
}

TEST(EnumNames, LeadThereAndBack)
{
  expectRoundTrip(method_names, Method::Staged);
  expectRoundTrip(metric_names, Metric::Euclidean);
  expectRoundTrip(normal_source_names, NormalSource::Given);
  expectRoundTrip(extreme_points_names, ExtremePoints::FirstFour);
  expectRoundTrip(component_use_names, ComponentUse::Largest);
  expectRoundTrip(pairing_names, PairingFeature::BySurfaceSize);
  expectRoundTrip(status_names, SymmetryStatus::Cancelled);
}

TEST(EnumNames, AreThoseOfReportsAndOptions)
{
  EXPECT_EQ(allNames(method_names), "robust or staged");
  EXPECT_EQ(allNames(metric_names), "geodesic or euclidean");
  EXPECT_EQ(allNames(normal_source_names), "estimate or given");
  EXPECT_EQ(allNames(extreme_points_names), "nine or four");
  EXPECT_EQ(allNames(component_use_names), "all or largest");
  EXPECT_EQ(allNames(pairing_names), "agd or mgd or size");
  EXPECT_EQ(allNames(status_names), "symmetric or partly_symmetric or no_symmetry or too_few_points or cancelled");
}

TEST(EnumNames, AreSpelledExactly)
{
  EXPECT_EQ(valueOf(method_names, "Robust"), std::nullopt);
  EXPECT_EQ(valueOf(method_names, "robust "), std::nullopt);
  EXPECT_EQ(valueOf(method_names, "rob"), std::nullopt);
}

} // namespace
