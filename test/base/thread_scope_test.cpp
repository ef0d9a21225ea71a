#include "base/thread_scope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

using namespace pcl::symmetry;

namespace {

TEST(ThreadScope, GivesItsThreadsButNoMoreThanItems)
{
  const ThreadScope scope(3);
  EXPECT_EQ(threadCount(100), 3U);
  EXPECT_EQ(threadCount(2), 2U);
  EXPECT_EQ(threadCount(0), 1U);
}

TEST(ThreadScope, ZeroIsOnePerCore)
{
  const ThreadScope scope(0);
  EXPECT_EQ(threadCount(1000000), std::max(1U, std::thread::hardware_concurrency()));
}

TEST(ThreadScope, TheInnermostCounts)
{
  EXPECT_EQ(threadCount(100), 1U) << "without a scope";
  {
    const ThreadScope outer(5);
    {
      const ThreadScope inner(2);
      EXPECT_EQ(threadCount(100), 2U);
    }
    EXPECT_EQ(threadCount(100), 5U);
  }
  EXPECT_EQ(threadCount(100), 1U);
}

TEST(ThreadScope, IsOfOneThreadAlone)
{
  const ThreadScope scope(5);
  unsigned elsewhere = 0;
  std::thread([&elsewhere] { elsewhere = threadCount(100); }).join();
  EXPECT_EQ(elsewhere, 1U);
}

} // namespace
