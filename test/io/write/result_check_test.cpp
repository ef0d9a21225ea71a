// Results that belong to a surface, and all the ways not to.
#include "io/sample_result.h"
#include "io/write/result_check.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

#include <cmath>
#include <limits>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

/** What is said about the result of the roof after a change; empty where nothing is. */
template <typename Change>
std::string
complaint(Change change)
{
  SymmetryResult result = roofSymmetry();
  change(result);
  return messageOf<BadArgumentException>([&result] { checkResult(result, roof().size()); });
}

TEST(ResultCheck, AcceptsWhatBelongsToTheSurface)
{
  EXPECT_EQ(complaint([](SymmetryResult& /*as it is*/) {}), "");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.partners.assign(6, no_index); }), "");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.axis = {Polyline{{0, 5}, false}}; }), "");
}

TEST(ResultCheck, ArraysHaveAnEntryForEachPoint)
{
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.partners.pop_back(); }), "the result has 5 partners for 6 points");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.confidences.push_back(1.0F); }),
            "the result has 7 confidences for 6 points");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.sides.clear(); }), "the result has 0 sides for 6 points");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.regions.clear(); }), "the result has 0 regions for 6 points");
}

TEST(ResultCheck, ConfidencesAreNumbersAndLabelsAmongThoseThatThereAre)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(complaint([=](SymmetryResult& r) { r.confidences[3] = nan; }), "the result has confidence nan for point 3");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.support[0] = HUGE_VALF; }), "the result has support inf for point 0");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.sides[1] = static_cast<Side>(4); }),
            "the result has side 4 for point 1, allowed are 0 to 3");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.regions[5] = static_cast<Region>(255); }),
            "the result has region 255 for point 5, allowed are 0 to 5");
}

TEST(ResultCheck, IndicesAreThoseOfPoints)
{
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.partners[2] = 6; }), "the result has partner 6 for 6 points");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.partners[2] = -2; }), "the result has partner -2 for 6 points");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.matches[0].source = no_index; }),
            "the result has source -1 for 6 points");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.matches[0].target = 6; }), "the result has target 6 for 6 points");
  EXPECT_EQ(complaint([](SymmetryResult& r) { r.matches[1].midpoint = 9; }), "the result has midpoint 9 for 6 points");
  EXPECT_EQ(complaint([](SymmetryResult& r) {
              r.axis.push_back({{no_index}, false, {}});
            }),
            "the result has axis point -1 for 6 points");
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
