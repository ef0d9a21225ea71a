// Whichever allocation fails, in whichever thread: the caller gets std::bad_alloc, and the process goes on.
#include "model/articulated_body.h"

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

enum class Outcome { Result, OutOfMemory };

/** Runs with so many allocations that succeed, and then so many that do not. */
Outcome
runWith(const Surface& surface, long allocations, long failures)
{
  SymmetryParameters parameters;
  parameters.threads = 4;
  parameters.robust.samples = 300; // less to do
  failures_left = failures;
  allocations_left = allocations;
  try {
    const SymmetryResult result = estimateIntrinsicSymmetry(surface, parameters);
    allocations_left = never;
    EXPECT_TRUE(hasMap(result.status) || result.status == SymmetryStatus::NoSymmetry);
    return Outcome::Result;
  }
  catch (const std::bad_alloc&) {
    allocations_left = never;
    return Outcome::OutOfMemory;
  }
}

/** Number of allocations of a whole run. */
long
allocationsOf(const Surface& surface)
{
  const long many = never - 1;
  runWith(surface, many, 0); // what is made once per process
  SymmetryParameters parameters;
  parameters.threads = 4;
  parameters.robust.samples = 300;
  allocations_left = many;
  estimateIntrinsicSymmetry(surface, parameters);
  return many - allocations_left.exchange(never);
}

// Of a mesh: FLANN allocates in a parallel region that no exception can leave, see doc/failure_modes.md.
TEST(OutOfMemory, IsAnExceptionWhereverItHappens)
{
  ModelParameters model;
  model.vertices = 1000;
  const Surface body = makeModel(model).surface;
  const long all = allocationsOf(body);
  ASSERT_GT(all, 1000);
  constexpr long places = 40;
  long exceptions = 0;
  for (long i = 0; i < places; ++i) {
    // A single failure may hit the making of a thread, which the others stand in for.
    const long failures = i % 2 == 0 ? 1 : 1000000;
    exceptions += runWith(body, i * all / places, failures) == Outcome::OutOfMemory ? 1 : 0;
  }
  EXPECT_GT(exceptions, places / 2);
  EXPECT_EQ(runWith(body, never, 0), Outcome::Result);
}

} // namespace
