// Seconds, counted from the start, as a clock of the test's own counts them.
#include "cli/stopwatch.h"

#include <gtest/gtest.h>

#include <thread>

using pcl::symmetry::Stopwatch;

TEST(Stopwatch, CountsSeconds)
{
  using Clock = std::chrono::steady_clock;
  const auto before = Clock::now();
  const Stopwatch watch;
  const auto after = Clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const double least = std::chrono::duration<double>(Clock::now() - after).count();
  const double seconds = watch.seconds();
  const double most = std::chrono::duration<double>(Clock::now() - before).count();
  EXPECT_GE(seconds, least);
  EXPECT_LE(seconds, most);
  EXPECT_GE(watch.seconds(), seconds);
}
