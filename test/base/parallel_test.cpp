#include "base/parallel.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using namespace pcl::symmetry;

namespace {

TEST(ParallelFor, VisitsEveryItemOnce)
{
  for (const unsigned threads : {0U, 1U, 2U, 7U}) {
    const ThreadScope scope(threads);
    for (const std::size_t grain : {1U, 3U, 1000U}) {
      std::vector<int> visits(101, 0);
      parallelFor(
          visits.size(), [&visits](std::size_t i) { ++visits[i]; }, grain);
      EXPECT_EQ(visits, std::vector<int>(101, 1)) << threads << " threads, grain " << grain;
    }
  }
}

TEST(ParallelFor, HasNothingToDoWithoutItems)
{
  const ThreadScope scope(4);
  bool called = false;
  parallelFor(0, [&called](std::size_t) { called = true; });
  EXPECT_FALSE(called);
}

TEST(ParallelBlocks, MakesAWorkerPerThreadAtMostAndHandsOutWholeBlocks)
{
  for (const unsigned threads : {1U, 3U}) {
    const ThreadScope scope(threads);
    std::atomic<unsigned> workers{0};
    std::atomic<std::size_t> items{0};
    std::atomic<bool> aligned{true};
    parallelBlocks(25, 10, [&] {
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

TEST(ParallelFor, LoopsWithinLoopsAreNotSharedOutAgain)
{
  const ThreadScope scope(4);
  std::vector<unsigned> threads(40);
  parallelFor(threads.size(), [&threads](std::size_t i) { threads[i] = threadCount(1000); });
  EXPECT_EQ(threads, std::vector<unsigned>(40, 1U));
  EXPECT_EQ(threadCount(1000), 4U) << "and the scope is what it was";
}

TEST(ParallelFor, ThrowsInTheCallingThreadWhatAnItemThrows)
{
  for (const unsigned threads : {1U, 2U, 5U}) {
    const ThreadScope scope(threads);
    std::string message;
    try {
      parallelFor(100, [](std::size_t i) {
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
  EXPECT_THROW(parallelFor(1000,
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
  const ThreadScope scope(2);
  EXPECT_THROW(parallelBlocks(10, 1, make_worker), std::bad_alloc);
}

} // namespace
