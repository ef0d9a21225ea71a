// Whichever allocation fails, in whichever thread: the caller gets std::bad_alloc, and the process goes on.
#include "model/articulated_body.h"
#include "neighbour_search.h"
#include "support/with_threads.h"

#include <pcl/symmetry/symmetry.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr long never = std::numeric_limits<long>::max();

std::atomic<long> allocations_left{never}; ///< until one fails
std::atomic<long> failures_left{0};        ///< of those that follow

void*
allocate(std::size_t size)
{
  if (allocations_left.load() != never && --allocations_left < 0 && --failures_left >= 0) {
    throw std::bad_alloc();
  }
  void* const memory = std::malloc(size);
  if (memory == nullptr) {
    throw std::bad_alloc();
  }
  return memory;
}

} // namespace

// Those of the whole process, libraries included.
void*
operator new(std::size_t size)
{
  return allocate(size);
}

void*
operator new[](std::size_t size)
{
  return allocate(size);
}

// The sanitizers' own would take its memory from elsewhere than the others.
void*
operator new(std::size_t size, const std::nothrow_t& /*no_exception*/) noexcept
{
  try {
    return allocate(size);
  }
  catch (const std::bad_alloc& /*as wanted*/) {
    return nullptr;
  }
}

void
operator delete(void* memory) noexcept
{
  std::free(memory);
}

void
operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

void
operator delete[](void* memory) noexcept
{
  std::free(memory);
}

void
operator delete[](void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace {

using namespace pcl::symmetry;

/** Whether work ends with std::bad_alloc where so many allocations succeed, and then so many do not. */
template <typename Work>
bool
runsOutOfMemory(Work work, long allocations, long failures)
{
  failures_left = failures;
  allocations_left = allocations;
  try {
    work();
    allocations_left = never;
    return false;
  }
  catch (const std::bad_alloc&) {
    allocations_left = never;
    return true;
  }
}

/** Number of allocations of work. */
template <typename Work>
long
allocationsOf(Work work)
{
  const long many = never - 1;
  work(); // what is made once per process
  allocations_left = many;
  work();
  return many - allocations_left.exchange(never);
}

template <typename Work>
void
expectExceptions(Work work)
{
  const long all = allocationsOf(work);
  ASSERT_GT(all, 1000);
  constexpr long places = 40;
  long exceptions = 0;
  for (long i = 0; i < places; ++i) {
    // A single failure may hit the making of a thread, which the others stand in for.
    const long failures = i % 2 == 0 ? 1 : 1000000;
    exceptions += runsOutOfMemory(work, i * all / places, failures) ? 1 : 0;
  }
  EXPECT_GT(exceptions, places / 2);
  EXPECT_FALSE(runsOutOfMemory(work, never, 0));
}

void
estimate(const Surface& surface)
{
  SymmetryParameters parameters;
  parameters.threads = 4;
  parameters.robust.samples = 300; // less to do
  const SymmetryResult result = estimateIntrinsicSymmetry(surface, parameters);
  EXPECT_TRUE(hasMap(result.status) || result.status == SymmetryStatus::NoSymmetry);
}

Surface
smallBody()
{
  ModelParameters model;
  model.vertices = 1000;
  return makeModel(model).surface;
}

TEST(OutOfMemory, IsAnExceptionWhereverItHappensToAMesh)
{
  const Surface mesh = smallBody();
  expectExceptions([&mesh] { estimate(mesh); });
}

TEST(OutOfMemory, IsAnExceptionWhereverItHappensToACloud)
{
  Surface cloud = smallBody();
  cloud.triangles.clear();
  expectExceptions([&cloud] { estimate(cloud); });
}

TEST(OutOfMemory, IsAnExceptionWhereverItHappensInTheNeighbourSearch)
{
  const Surface cloud = smallBody();
  expectExceptions([&cloud] { test::withThreads(3, [&cloud] { return searchByKdTree(cloud.points, 8); }); });
}

} // namespace
