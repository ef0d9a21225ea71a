// Parameters out of range, in terms of the command line.
#include "cli/parameter_options.h"
#include "cli/program.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

template <typename Change>
std::string
refusal(Change change)
{
  SymmetryParameters parameters;
  change(parameters);
  try {
    checkParameterOptions(parameters);
  }
  catch (const UsageError& error) {
    return error.what();
  }
  return {};
}

TEST(ParameterOptions, DefaultsAreTaken)
{
  EXPECT_EQ(refusal([](SymmetryParameters& /*all*/) {}), "");
}

TEST(ParameterOptions, RefusalsNameTheOption)
{
  const auto begins = [](const std::string& message, const std::string& option) {
    return message.compare(0, option.size() + 4, option + " is ") == 0;
  };
  EXPECT_EQ(refusal([](SymmetryParameters& p) { p.k_search = 2; }), "--neighbours is 2, allowed are 3 to 256");
  EXPECT_TRUE(begins(refusal([](SymmetryParameters& p) { p.outlier_deviations = -1.0F; }), "--outliers"));
  EXPECT_TRUE(begins(refusal([](SymmetryParameters& p) { p.radius = -1.0F; }), "--radius"));
  EXPECT_TRUE(begins(refusal([](SymmetryParameters& p) { p.staged.landmarks = 9; }), "--landmarks"));
  EXPECT_TRUE(begins(refusal([](SymmetryParameters& p) { p.robust.samples = 29; }), "--samples"));
  EXPECT_TRUE(begins(refusal([](SymmetryParameters& p) { p.staged.samples = 19; }), "--samples"));
  EXPECT_TRUE(begins(refusal([](SymmetryParameters& p) { p.alternatives = 0; }), "--alternatives"));
}

TEST(ParameterOptions, SamplesAreThoseOfTheMethodThatIsChosen)
{
  SymmetryParameters robust;
  setSamples(robust, 40);
  EXPECT_EQ(robust.robust.samples, 40);
  EXPECT_EQ(robust.staged.samples, 100);
  SymmetryParameters staged;
  staged.method = Method::Staged;
  setSamples(staged, 25);
  EXPECT_EQ(staged.robust.samples, 1500);
  EXPECT_EQ(staged.staged.samples, 25);
  setSamples(staged, 0);
  EXPECT_EQ(staged.staged.samples, 25) << "0 changes nothing";
}

TEST(ParameterOptions, WhatHasNoOptionKeepsItsName)
{
  EXPECT_EQ(refusal([](SymmetryParameters& p) {
              p.staged.embedding_dimensions = 1;
            }).compare(0, 27, "staged.embedding_dimensions"),
            0);
}

} // namespace
