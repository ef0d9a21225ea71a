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
  EXPECT_TRUE(begins(refusal([](SymmetryParameters& p) { p.landmarks = 9; }), "--landmarks"));
  EXPECT_TRUE(begins(refusal([](SymmetryParameters& p) { p.samples = 5; }), "--samples"));
  EXPECT_TRUE(begins(refusal([](SymmetryParameters& p) { p.alternatives = 0; }), "--alternatives"));
}

TEST(ParameterOptions, WhatHasNoOptionKeepsItsName)
{
  EXPECT_EQ(refusal([](SymmetryParameters& p) { p.embedding_dimensions = 1; }).compare(0, 20, "embedding_dimensions"),
            0);
}

} // namespace
