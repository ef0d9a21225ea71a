#include "base/large_memory.h"

#include <cstdint>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace pcl {
namespace symmetry {
namespace {

constexpr std::size_t large_page = std::size_t{2} << 20U;

} // namespace

void
preferLargePages(void* memory, std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t small_page = 4096; // where pages are larger the call may fail, which does no harm
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t begin = (address + small_page - 1) / small_page * small_page;
  const std::uintptr_t end = (address + bytes) / small_page * small_page;
  if (bytes >= large_page) {
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE); // NOLINT(performance-no-int-to-ptr)
  }
#else
  static_cast<void>(memory);
  static_cast<void>(bytes);
#endif
}

float*
FloatBlock::reserve(std::size_t count)
{
  constexpr std::size_t cache_line = 64;
  if (floats_ == nullptr || count > capacity_) {
    const std::size_t alignment = count * sizeof(float) < large_page ? cache_line : large_page;
    const std::size_t bytes = (count * sizeof(float) / alignment + 1) * alignment;
    floats_.reset(); // before the new block is there
    capacity_ = 0;
    floats_.reset(static_cast<float*>(std::aligned_alloc(alignment, bytes)));
    if (floats_ == nullptr) {
      throw std::bad_alloc();
    }
    capacity_ = bytes / sizeof(float);
    preferLargePages(floats_.get(), bytes);
  }
  return floats_.get();
}

} // namespace symmetry
} // namespace pcl
