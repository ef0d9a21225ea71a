// Headers of PLY and PCD that are nearly right, with any data behind: elements, properties, types and counts are chosen
// from those that there are, and now and then anything is put in their place.
#include "fuzz/fuzzed_file.h"

#include <cstdint>
#include <fuzzer/FuzzedDataProvider.h>

namespace {

using Choice = FuzzedDataProvider;

std::string
number(Choice& choice, int usual)
{
  switch (choice.ConsumeIntegralInRange(0, 15)) {
  case 0:
    return std::to_string(choice.ConsumeIntegral<std::int64_t>());
  case 1:
    return std::to_string(choice.ConsumeIntegral<std::uint32_t>());
  case 2:
    return choice.ConsumeRandomLengthString(12);
  default:
    return std::to_string(choice.ConsumeIntegralInRange(0, usual));
  }
}

std::string
plyType(Choice& choice)
{
  return choice.PickValueInArray({"float", "double", "char", "uchar", "short", "ushort", "int", "uint", "float32",
                                  "float64", "int8", "uint8", "int16", "uint16", "int32", "uint32", "half"});
}

std::string
plyProperty(Choice& choice)
{
  const std::string name = choice.PickValueInArray(
      {"x", "y", "z", "nx", "ny", "nz", "red", "vertex_indices", "vertex_index", "alpha", "quality"});
  if (choice.ConsumeIntegralInRange(0, 3) == 0)
    return "property list " + plyType(choice) + " " + plyType(choice) + " " + name + "\n";
  return "property " + plyType(choice) + " " + name + "\n";
}

std::string
plyHeader(Choice& choice)
{
  std::string text = std::string("ply\nformat ") +
                     choice.PickValueInArray({"ascii", "binary_little_endian", "binary_big_endian"}) + " 1.0\n";
  for (int elements = choice.ConsumeIntegralInRange(0, 4); elements > 0; --elements) {
    const std::string name = choice.PickValueInArray({"vertex", "face", "tristrips", "edge", "camera"});
    text += "element " + name + " " + number(choice, 12) + "\n";
    if (name == "vertex" && choice.ConsumeBool())
      text += "property float x\nproperty float y\nproperty float z\n";
    for (int properties = choice.ConsumeIntegralInRange(0, 4); properties > 0; --properties)
      text += plyProperty(choice);
  }
  return text + "end_header\n";
}

std::string
pcdHeader(Choice& choice)
{
  std::string fields;
  std::string sizes;
  std::string types;
  std::string counts;
  for (int field = choice.ConsumeIntegralInRange(1, 6); field > 0; --field) {
    fields +=
        std::string(" ") + choice.PickValueInArray({"x", "y", "z", "normal_x", "normal_y", "normal_z", "rgb", "_"});
    sizes += std::string(" ") + choice.PickValueInArray({"1", "2", "4", "8", "3"});
    types += std::string(" ") + choice.PickValueInArray({"F", "I", "U", "X"});
    counts += " " + number(choice, 3);
  }
  return "VERSION .7\nFIELDS" + fields + "\nSIZE" + sizes + "\nTYPE" + types + "\nCOUNT" + counts + "\nWIDTH " +
         number(choice, 12) + "\nHEIGHT " + number(choice, 3) + "\nPOINTS " + number(choice, 24) + "\nDATA " +
         choice.PickValueInArray({"ascii", "binary", "binary_compressed"}) + "\n";
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Choice choice(data, size);
  const bool is_ply = choice.ConsumeBool();
  const std::string header = is_ply ? plyHeader(choice) : pcdHeader(choice);
  pcl::symmetry::test::readFuzzed(header + choice.ConsumeRemainingBytesAsString(), is_ply ? "ply" : "pcd");
  return 0;
}
