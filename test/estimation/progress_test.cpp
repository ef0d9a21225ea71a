// What a caller hears while the estimation runs, and how it stops.
#include "estimation/left_out_points.h"
#include "model/articulated_body.h"
#include "support/known_body.h"

#include <pcl/symmetry/symmetry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <string>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

class ProgressTest : public testing::TestWithParam<Method> {
protected:
  struct Call {
    std::string step;
    double fraction;
  };

  SymmetryResult
  run(std::size_t steps_until_cancelled)
  {
    SymmetryParameters parameters;
    parameters.method = GetParam();
    return estimateIntrinsicSymmetry(bentHuman().surface, parameters, [&](const char* step, double fraction) {
      // While a step runs it is announced again and again, how often depends on the machine.
      if (calls_.empty() || calls_.back().step != step || calls_.back().fraction != fraction) {
        calls_.push_back({step, fraction});
      }
      return calls_.size() < steps_until_cancelled;
    });
  }

  std::vector<Call> calls_;
};

TEST_P(ProgressTest, FractionsRiseAndStepsAreThoseThatAreTimed)
{
  const SymmetryResult result = run(1000);
  EXPECT_EQ(result.status, SymmetryStatus::Symmetric);
  ASSERT_GE(calls_.size(), 5U);
  EXPECT_EQ(calls_.front().step, "graph");
  EXPECT_EQ(calls_.front().fraction, 0.0);
  EXPECT_LT(calls_.back().fraction, 1.0);
  std::vector<std::string> steps;
  for (std::size_t i = 0; i < calls_.size(); ++i) {
    EXPECT_TRUE(i == 0 || calls_[i].fraction >= calls_[i - 1].fraction) << calls_[i].step;
    if (std::find(steps.begin(), steps.end(), calls_[i].step) == steps.end()) {
      steps.push_back(calls_[i].step);
    }
  }
  ASSERT_EQ(result.seconds.size(), steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(result.seconds[i].first, steps[i]);
    EXPECT_GE(result.seconds[i].second, 0.0);
  }
}

TEST_P(ProgressTest, CancellingAtAnyStepLeavesNothingAboutAnyPoint)
{
  run(1000);
  const std::size_t all = calls_.size();
  for (std::size_t last = 1; last <= all; ++last) {
    calls_.clear();
    const SymmetryResult result = run(last);
    SCOPED_TRACE(calls_.back().step);
    EXPECT_EQ(calls_.size(), last);
    EXPECT_EQ(result.status, SymmetryStatus::Cancelled);
    EXPECT_FALSE(result.message.empty());
    ASSERT_EQ(result.partners.size(), bentHuman().surface.size());
    for (std::size_t v = 0; v < result.partners.size(); ++v) {
      expectNothingAbout(result, v);
    }
    EXPECT_TRUE(result.matches.empty() && result.axis.empty() && result.extremities.empty() &&
                result.alternatives.empty());
    EXPECT_EQ(result.confidence, 0.0F);
  }
}

/** Longest time between two calls, on the processor: the machine may be busy with something else. */
class LongestSilence {
public:
  bool
  operator()()
  {
    const double now = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
    longest_ = std::max(longest_, now - last_);
    last_ = now;
    return true;
  }

  double
  seconds()
  {
    (*this)();
    return longest_;
  }

private:
  double last_ = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  double longest_ = 0.0;
};

TEST(Progress, IsHeardSeveralTimesASecond)
{
  ModelParameters model;
  model.vertices = 40000;
  Surface body = makeModel(model).surface;
  for (const bool as_cloud : {false, true}) {
    if (as_cloud) {
      body.triangles.clear();
    }
    SymmetryParameters parameters;
    parameters.threads = 1;
    LongestSilence silence;
    EXPECT_TRUE(
        hasMap(estimateIntrinsicSymmetry(body, parameters, [&](const char*, double) { return silence(); }).status));
#ifdef PCL_SYMMETRY_SANITIZED
    constexpr double longest = 5.0; // the thread sanitizer takes ten times as long
#else
    constexpr double longest = 0.5; // 0.1 on a machine of 2020
#endif
    EXPECT_LT(silence.seconds(), longest) << (as_cloud ? "cloud" : "mesh");
  }
}

TEST(Progress, ExceptionOfTheCallbackReachesTheCaller)
{
  struct Enough {};
  for (const int last : {0, 3, 7}) {
    int calls = 0;
    EXPECT_THROW(estimateIntrinsicSymmetry(bentHuman().surface, {},
                                           [&](const char*, double) -> bool {
                                             if (calls++ == last) {
                                               throw Enough();
                                             }
                                             return true;
                                           }),
                 Enough);
    EXPECT_EQ(calls, last + 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods,
                         ProgressTest,
                         testing::Values(Method::Robust, Method::Staged),
                         [](const testing::TestParamInfo<Method>& tested) {
                           return tested.param == Method::Robust ? "Robust" : "Staged";
                         });

} // namespace
