/** \file
 * \brief Loops over independent items on several threads.
 */
#pragma once

#include "base/heartbeat.h"
#include "base/thread_scope.h"

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
 * items that falls to that thread. There are as many threads as the innermost ThreadScope allows.
 *
 * Blocks are handed out as threads become free, so a worker must not let its result depend on which blocks it gets. The
 * first exception ends the loop and is thrown in the calling thread. Where no further thread can be had (a limit of the
 * system's, no memory), those that there are do all of the work. The calling thread calls heartbeat () before each block.
 */
template <typename MakeWorker>
void
parallelBlocks(std::size_t items, std::size_t grain, MakeWorker make_worker)
{
  const std::size_t blocks = (items + grain - 1) / grain;
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    const ThreadScope one_thread(1);
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
  helpers.start(threadCount(blocks) - 1, work);
  work();
  helpers.join();
  if (failure) {
    std::rethrow_exception(failure);
  }
}

/** \brief Calls function (i) for every i in [0, items), in no particular order. */
template <typename Function>
void
parallelFor(std::size_t items, Function function, std::size_t grain = 1)
{
  parallelBlocks(items, grain, [&function] {
    return [&function](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        function(i);
      }
    };
  });
}

} // namespace symmetry
} // namespace pcl
