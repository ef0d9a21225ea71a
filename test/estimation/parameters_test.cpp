// Ranges of the parameters, and names of outcomes.
#include <pcl/symmetry/symmetry.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>

#include <algorithm>
#include <limits>
#include <string>

using namespace pcl::symmetry;

namespace {

/** What checkParameters () says of a change to the defaults; empty where it accepts it. */
template <typename Change>
std::string
complaint(Change change)
{
  SymmetryParameters parameters;
  change(parameters);
  try {
    checkParameters(parameters);
  }
  catch (const pcl::BadArgumentException& error) {
    return error.what();
  }
  return {};
}

struct Range {
  const char* name;
  int& (*member)(SymmetryParameters& parameters);
  int least;
  int most;
};

class RangeTest : public testing::TestWithParam<Range> {};

TEST_P(RangeTest, EndsAreAllowedAndWhatLiesBeyondIsNot)
{
  const auto [name, member, least, most] = GetParam();
  const auto complaint_at = [member = member](int value) {
    return complaint([&](SymmetryParameters& parameters) { member(parameters) = value; });
  };
  EXPECT_EQ(complaint_at(least), "");
  EXPECT_EQ(complaint_at(most), "");
  for (const int value : {least - 1, most + 1, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
    const std::string message = complaint_at(value);
    for (const std::string& part :
         {std::string(name), std::to_string(value), std::to_string(least), std::to_string(most)}) {
      EXPECT_NE(message.find(part), std::string::npos) << '"' << part << "\" is not in \"" << message << '"';
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Parameters,
    RangeTest,
    testing::Values(Range{"k_search", [](SymmetryParameters& p) -> int& { return p.k_search; }, 3, 256},
                    Range{"robust.samples", [](SymmetryParameters& p) -> int& { return p.robust.samples; }, 30, 20000},
                    Range{"staged.landmarks", [](SymmetryParameters& p) -> int& { return p.staged.landmarks; }, 10,
                          1000},
                    Range{"staged.samples", [](SymmetryParameters& p) -> int& { return p.staged.samples; }, 20, 20000},
                    Range{"staged.embedding_dimensions",
                          [](SymmetryParameters& p) -> int& { return p.staged.embedding_dimensions; }, 2, 20},
                    Range{"alternatives", [](SymmetryParameters& p) -> int& { return p.alternatives; }, 1, 100}),
    [](const testing::TestParamInfo<Range>& tested) {
      std::string name = tested.param.name;
      std::replace(name.begin(), name.end(), '.', '_');
      return name;
    });

TEST(Parameters, DefaultsAreAllowed)
{
  EXPECT_EQ(complaint([](SymmetryParameters&) {}), "");
}

TEST(Parameters, LengthsAreNumbersThatAreNotNegative)
{
  for (float SymmetryParameters::*member : {&SymmetryParameters::radius, &SymmetryParameters::outlier_deviations}) {
    const auto complaint_at = [member](float value) {
      return complaint([&](SymmetryParameters& parameters) { parameters.*member = value; });
    };
    EXPECT_EQ(complaint_at(0.0F), "");
    EXPECT_EQ(complaint_at(2.5F), "");
    EXPECT_NE(complaint_at(-0.5F).find("-0.5"), std::string::npos);
    EXPECT_NE(complaint_at(std::numeric_limits<float>::quiet_NaN()), "");
    EXPECT_NE(complaint_at(std::numeric_limits<float>::infinity()), "");
  }
}

TEST(Parameters, EstimationChecksThem)
{
  SymmetryParameters parameters;
  parameters.staged.landmarks = 1;
  EXPECT_THROW(estimateIntrinsicSymmetry({}, parameters), pcl::BadArgumentException);
}

TEST(SymmetryStatus, HasTheNamesOfReports)
{
  EXPECT_STREQ(toString(SymmetryStatus::Symmetric), "symmetric");
  EXPECT_STREQ(toString(SymmetryStatus::NoSymmetry), "no_symmetry");
  EXPECT_STREQ(toString(SymmetryStatus::TooFewPoints), "too_few_points");
  EXPECT_STREQ(toString(SymmetryStatus::Cancelled), "cancelled");
}

} // namespace
