// Any bytes as any format: the first byte says which, the rest is the file.
#include "fuzz/fuzzed_file.h"

#include <array>
#include <cstdint>

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const std::array<const char*, 7> formats = {"pcd", "ply", "obj", "off", "stl", "xyz", "vtk"};
  if (size == 0)
    return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  pcl::symmetry::test::readFuzzed(bytes, formats[data[0] % formats.size()]);
  return 0;
}
