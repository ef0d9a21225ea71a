/** \file
 * \brief How many threads a computation may use.
 */
#pragma once

#include <cstddef>

namespace pcl {
namespace symmetry {

/** \brief While it lives, loops that the thread that made it shares out (parallel.h) run on so many threads.
 *
 * No result depends on the number of threads, so that it is no argument of the functions in between. Scopes may be
 * nested: the innermost counts. A thread without a scope has one thread, and so has each thread of a loop, so that loops
 * within loops are not shared out again. */
class ThreadScope {
public:
  /** \param[in] threads 0: one per core */
  explicit ThreadScope(unsigned threads);
  ThreadScope(const ThreadScope&) = delete;
  ThreadScope&
  operator=(const ThreadScope&) = delete;
  ThreadScope(ThreadScope&&) = delete;
  ThreadScope&
  operator=(ThreadScope&&) = delete;
  ~ThreadScope();

private:
  unsigned outer_;
};

/** \brief Threads for \a items things to do: those of the innermost scope, but no more than there are items; at least 1. */
unsigned
threadCount(std::size_t items);

} // namespace symmetry
} // namespace pcl
