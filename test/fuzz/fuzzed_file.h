/** \file
 * \brief Bytes as a file that readers take, without a disk.
 */
#pragma once

#include <pcl/symmetry/surface_io.h>

#include <pcl/exceptions.h>

#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief Reads bytes as a format. What is read is checked; what is refused may be so by an IOException only. */
inline void
readFuzzed(std::string_view bytes, const std::string& format)
{
  static const int file = ::memfd_create("fuzzed", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  if (::ftruncate(file, 0) != 0 || ::pwrite(file, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    std::abort();
  try {
    const Surface surface = readSurface(path, format);
    if (surface.points.empty() || (!surface.normals.empty() && surface.normals.size() != surface.size()))
      std::abort();
    for (const Triangle& triangle : surface.triangles)
      for (const Index corner : triangle)
        if (corner < 0 || static_cast<std::size_t>(corner) >= surface.size())
          std::abort();
  }
  catch (const IOException& /*refused*/) {
  }
}

} // namespace test
} // namespace symmetry
} // namespace pcl
