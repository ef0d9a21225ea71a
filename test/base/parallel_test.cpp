#include "base/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using namespace pcl::symmetry;

namespace {

/** Read when the program runs: GCC 12 warns about vectors that a constant keeps from growing. */
const volatile unsigned one_thread = 1;
const volatile unsigned four_threads = 4;

TEST(ThreadCount, IsThatAskedForButNoMoreThanItems)
{
  EXPECT_EQ(threadCount(3, 100), 3U);
  EXPECT_EQ(threadCount(8, 5), 5U);
  EXPECT_EQ(threadCount(8, 0), 1U);
  EXPECT_EQ(threadCount(0, 1000000), std::max(1U, std::thread::hardware_concurrency()));
}

TEST(ParallelFor, VisitsEveryItemOnce)
{
  for (const unsigned threads : {0U, 1U, 2U, 7U}) {
    for (const std::size_t grain : {1U, 3U, 1000U}) {
      std::vector<int> visits(101, 0);
      parallelFor(
          visits.size(), threads, [&visits](std::size_t i) { ++visits[i]; }, grain);
      EXPECT_EQ(visits, std::vector<int>(101, 1)) << threads << " threads, grain " << grain;
    }
  }
}

TEST(ParallelFor, HasNothingToDoWithoutItems)
{
  bool called = false;
  parallelFor(0, four_threads, [&called](std::size_t) { called = true; });
  EXPECT_FALSE(called);
}

TEST(ParallelBlocks, MakesAWorkerPerThreadAtMostAndHandsOutWholeBlocks)
{
  for (const unsigned threads : {1U, 3U}) {
    std::atomic<unsigned> workers{0};
    std::atomic<std::size_t> items{0};
    std::atomic<bool> aligned{true};
    parallelBlocks(25, 10, threads, [&] {
      ++workers;
      return [&](std::size_t begin, std::size_t end) {
        aligned = aligned && begin % 10 == 0 && end == std::min<std::size_t>(begin + 10, 25);
        items += end - begin;
      };
    });
    EXPECT_GE(workers, 1U);
    EXPECT_LE(workers, threads);
    EXPECT_EQ(items, 25U);
    EXPECT_TRUE(aligned);
  }
}

TEST(ParallelFor, ThrowsInTheCallingThreadWhatAnItemThrows)
{
  for (const unsigned threads : {1U, 2U, 5U}) {
    std::string message;
    try {
      parallelFor(100, threads, [](std::size_t i) {
        if (i == 37) {
          throw std::runtime_error("item 37");
        }
      });
    }
    catch (const std::runtime_error& error) {
      message = error.what();
    }
    EXPECT_EQ(message, "item 37") << threads;
  }
}

TEST(ParallelFor, EndsWithTheFirstException)
{
  std::size_t visited = 0;
  EXPECT_THROW(parallelFor(1000, one_thread,
                           [&visited](std::size_t i) {
                             if (i == 10) {
                               throw std::invalid_argument("");
                             }
                             ++visited;
                           }),
               std::invalid_argument);
  EXPECT_EQ(visited, 10U);
}

TEST(ParallelBlocks, ThrowsWhatTheMakingOfAWorkerThrows)
{
  const auto make_worker = []() -> void (*)(std::size_t, std::size_t) {
    throw std::bad_alloc();
  };
  EXPECT_THROW(parallelBlocks(10, 1, 2, make_worker), std::bad_alloc);
}

} // namespace
