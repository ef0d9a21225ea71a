#include "base/thread_scope.h"

#include <algorithm>
#include <thread>

namespace pcl {
namespace symmetry {
namespace {

thread_local unsigned allowed = 1;

} // namespace

ThreadScope::ThreadScope(unsigned threads) : outer_(allowed)
{
  allowed = threads == 0 ? std::max(1U, std::thread::hardware_concurrency()) : threads;
}

ThreadScope::~ThreadScope()
{
  allowed = outer_;
}

unsigned
threadCount(std::size_t items)
{
  return static_cast<unsigned>(std::min<std::size_t>(allowed, std::max<std::size_t>(items, 1)));
}

} // namespace symmetry
} // namespace pcl
