/** \file
 * \brief Loops over independent items on several threads.
 */
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief Number of threads to use: \a requested, or one per core where it is 0; never more than there are items. */
inline unsigned
threadCount(unsigned requested, std::size_t items)
{
  const unsigned wanted = requested == 0 ? std::max(1U, std::thread::hardware_concurrency()) : requested;
  return static_cast<unsigned>(std::min<std::size_t>(wanted, std::max<std::size_t>(items, 1)));
}

/** \brief Calls make_worker () once per thread and the worker it returns with every block [begin, end) of \a grain
 * items that falls to that thread.
 *
 * Blocks are handed out as threads become free, so a worker must not let its result depend on which blocks it gets. The
 * first exception ends the loop and is thrown in the calling thread. Where no further thread can be had (a limit of the
 * system's), those that there are do all of the work.
 */
template <typename MakeWorker>
void
parallelBlocks(std::size_t items, std::size_t grain, unsigned threads, MakeWorker make_worker)
{
  const std::size_t blocks = (items + grain - 1) / grain;
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    try {
      auto worker = make_worker();
      for (std::size_t block = next++; block < blocks; block = next++) {
        worker(block * grain, std::min(items, (block + 1) * grain));
      }
    }
    catch (...) {
      const std::lock_guard<std::mutex> lock(failure_mutex);
      failure = std::current_exception();
      next = blocks;
    }
  };
  std::vector<std::thread> helpers;
  const unsigned count = threadCount(threads, blocks);
  helpers.reserve(count);
  try {
    while (helpers.size() + 1 < count) {
      helpers.emplace_back(work);
    }
  }
  catch (const std::system_error&) { // no more than these
  }
  work();
  for (std::thread& helper : helpers) {
    helper.join();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}

/** \brief Calls function (i) for every i in [0, items), in no particular order. */
template <typename Function>
void
parallelFor(std::size_t items, unsigned threads, Function function, std::size_t grain = 1)
{
  parallelBlocks(items, grain, threads, [&function] {
    return [&function](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        function(i);
      }
    };
  });
}

} // namespace symmetry
} // namespace pcl
