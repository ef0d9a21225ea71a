/** \file
 * \brief Runs a part of a test on a given number of threads.
 */
#pragma once

#include "base/thread_scope.h"

namespace pcl {
namespace symmetry {
namespace test {

/** \brief What function () returns where loops may use so many threads (0: one per core). */
template <typename Function>
auto
withThreads(unsigned threads, Function function)
{
  const ThreadScope scope(threads);
  return function();
}

} // namespace test
} // namespace symmetry
} // namespace pcl
