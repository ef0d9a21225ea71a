#include "base/heartbeat.h"
#include "base/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

using namespace pcl::symmetry;

namespace {

using Clock = std::chrono::steady_clock;

/** Calls heartbeat () all the time for so long. */
void
beatFor(std::chrono::milliseconds duration)
{
  const auto end = Clock::now() + duration;
  while (Clock::now() < end) {
    heartbeat();
  }
}

TEST(Heartbeat, ComesAFewTimesASecond)
{
  int beats = 0;
  const HeartbeatScope scope([&beats] { ++beats; });
  heartbeat();
  EXPECT_EQ(beats, 0) << "not at once";
  beatFor(std::chrono::milliseconds(500));
  EXPECT_GE(beats, 3); // ten where nothing else runs
  EXPECT_LE(beats, 10);
}

TEST(Heartbeat, IsThatOfTheInnermostScope)
{
  int outer = 0;
  int inner = 0;
  const HeartbeatScope scope([&outer] { ++outer; });
  {
    const HeartbeatScope nested([&inner] { ++inner; });
    beatFor(std::chrono::milliseconds(120));
  }
  EXPECT_EQ(outer, 0);
  EXPECT_GT(inner, 0);
  heartbeat();
  EXPECT_EQ(outer, 1);
}

TEST(Heartbeat, IsOfTheThreadThatAskedForIt)
{
  heartbeat(); // nobody did
  int beats = 0;
  const HeartbeatScope scope([&beats] { ++beats; });
  std::thread([] { beatFor(std::chrono::milliseconds(120)); }).join();
  EXPECT_EQ(beats, 0);
}

TEST(Heartbeat, EndsAParallelLoopByAnException)
{
  for (const unsigned threads : {1U, 3U}) {
    const ThreadScope some_threads(threads);
    const HeartbeatScope scope([] { throw std::runtime_error("enough"); });
    const auto begin = Clock::now();
    EXPECT_THROW(parallelFor(100000, [](std::size_t) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }),
                 std::runtime_error);
    EXPECT_LT(Clock::now() - begin, std::chrono::seconds(10));
  }
}

} // namespace
