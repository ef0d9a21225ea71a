/** \file
 * \brief Loops over independent items on several threads.
 */
#pragma once

#include "base/heartbeat.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <new>
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

/** \brief Threads that are waited for, however the place is left. */
class JoinedThreads {
public:
  JoinedThreads() = default;
  JoinedThreads(const JoinedThreads&) = delete;
  JoinedThreads&
  operator=(const JoinedThreads&) = delete;
  JoinedThreads(JoinedThreads&&) = delete;
  JoinedThreads&
  operator=(JoinedThreads&&) = delete;
  ~JoinedThreads()
  {
    join();
  }

  /** \brief Starts up to \a count threads, fewer where the system has no more threads or memory. */
  template <typename Work>
  void
  start(std::size_t count, const Work& work)
  {
    try {
      threads_.reserve(count);
      while (threads_.size() < count) {
        threads_.emplace_back(std::cref(work));
      }
    }
    catch (const std::system_error&) { // no more than these
    }
    catch (const std::bad_alloc&) {
    }
  }

  void
  join()
  {
    for (std::thread& thread : threads_) {
      thread.join();
    }
    threads_.clear();
  }

private:
  std::vector<std::thread> threads_;
};

/** \brief Calls make_worker () once per thread and the worker it returns with every block [begin, end) of \a grain
 * items that falls to that thread.
 *
 * Blocks are handed out as threads become free, so a worker must not let its result depend on which blocks it gets. The
 * first exception ends the loop and is thrown in the calling thread. Where no further thread can be had (a limit of the
 * system's, no memory), those that there are do all of the work. The calling thread calls heartbeat () before each block.
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
        heartbeat();
        worker(block * grain, std::min(items, (block + 1) * grain));
      }
    }
    catch (...) {
      const std::lock_guard<std::mutex> lock(failure_mutex);
      failure = failure ? failure : std::current_exception();
      next = blocks;
    }
  };
  JoinedThreads helpers;
  helpers.start(threadCount(threads, blocks) - 1, work);
  work();
  helpers.join();
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
