#include "apps/hostile_inputs.h"

#include <cstdint>
#include <cstring>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

std::string
repeated(const std::string& text, int count)
{
  std::string all;
  for (int i = 0; i < count; ++i)
    all += text;
  return all;
}

std::string
ply(const std::string& format, const std::string& vertices, const std::string& rest)
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\n" + rest;
}

std::string
pcd(const std::string& size,
    const std::string& type,
    const std::string& count,
    const std::string& width,
    const std::string& data)
{
  return "VERSION .7\nFIELDS x y z\nSIZE " + size + "\nTYPE " + type + "\nCOUNT " + count + "\nWIDTH " + width +
         "\nHEIGHT 1\nPOINTS " + width + "\nDATA " + data;
}

const std::string list = "element face 1\nproperty list ";
const std::string zeros(1000, '\0');
const std::string lines = repeated("0 0 0\n", 100);

/** \brief Column of a compressed PCD that unpacks to a thousand million zeros: references back to themselves. */
std::string
bomb()
{
  const std::string unpacked("\x00\x2C\x68\x59", 4); // 1.5e9
  std::string packed = std::string(1, '\0') + '\0';
  while (packed.size() < 900000)
    packed += std::string("\xE0\xFF\x00", 3); // 264 bytes, from one byte back
  const auto size = static_cast<std::uint32_t>(packed.size());
  std::string sizes(4, '\0');
  std::memcpy(&sizes[0], &size, sizeof size);
  return pcd("1 1 1", "U U U", "1 1 1", "500000000", "binary_compressed\n") + sizes + unpacked + packed;
}

} // namespace

const std::vector<HostileFile>&
hostileFiles()
{
  static const std::vector<HostileFile> files = {
      {"EmptyPly", "a.ply",
       [] {
         return std::string();
       }},
      {"EmptyPcd", "a.pcd",
       [] {
         return std::string();
       }},
      {"OnlyZeros", "a.stl",
       [] {
         return zeros;
       }},
      {"PlyOfTwoThousandMillionPoints", "a.ply",
       [] {
         return ply("ascii", "2147483647", "end_header\n") + lines;
       }},
      {"PlyOfMorePointsThanNumbers", "a.ply",
       [] {
         return ply("ascii", "9223372036854775808", "end_header\n") + lines;
       }},
      {"PlyOfFewerPointsThanNone", "a.ply",
       [] {
         return ply("ascii", "-1", "end_header\n") + lines;
       }},
      {"BinaryPlyOfTooManyPoints", "a.ply",
       [] {
         return ply("binary_little_endian", "1000000000", "end_header\n") + zeros;
       }},
      {"PlyOfTwoThousandMillionFaces", "a.ply",
       [] {
         return ply("ascii", "1", "element face 2000000000\nproperty list uchar int vertex_indices\nend_header\n") +
                lines;
       }},
      {"PlyOfFacesWithoutProperties", "a.ply",
       [] {
         return "ply\nformat ascii 1.0\nelement face 2000000000\n" + ply("ascii", "1", "end_header\n").substr(21);
       }},
      {"PlyOfAHundredThousandElements", "a.ply",
       [] {
         return ply("ascii", "1", repeated("element a 2147483647\n", 50000) + "end_header\n");
       }},
      {"PlyOfPointsWithoutPlaces", "a.ply",
       [] {
         return std::string("ply\nformat ascii 1.0\nelement vertex 2000000000\nend_header\n");
       }},
      {"PlyListOfThousandsOfMillions", "a.ply",
       [] {
         return ply("binary_little_endian", "4", list + "uint int vertex_indices\nend_header\n") +
                std::string(48, '\0') + "\xFF\xFF\xFF\x7F" + zeros;
       }},
      {"PlyListCountedByANegative", "a.ply",
       [] {
         return ply("binary_little_endian", "4", list + "int int vertex_indices\nend_header\n") +
                std::string(48, '\0') + "\xFB\xFF\xFF\xFF" + zeros;
       }},
      {"PlyWithoutAnEndOfTheHeader", "a.ply",
       [] {
         return ply("ascii", "3", "") + lines;
       }},
      {"PlyWithTwoZ", "a.ply",
       [] {
         return ply("ascii", "3", "property float z\nend_header\n") + "0 0 0 0\n0 0 0 0\n0 0 0 0\n";
       }},
      {"PlyWithAZeroByte", "a.ply",
       [] {
         return ply("ascii", "3", "end_header\n") + std::string("0 0\0 0\n0 0 0\n0 0 0\n", 19);
       }},
      {"PcdOfTooManyPoints", "a.pcd",
       [] {
         return pcd("4 4 4", "F F F", "1 1 1", "2147483647", "binary\n") + zeros;
       }},
      {"PcdOfMorePointsThanNumbers", "a.pcd",
       [] {
         return pcd("4 4 4", "F F F", "1 1 1", "9223372036854775808", "binary\n") + zeros;
       }},
      {"PcdOfAStrangeSize", "a.pcd",
       [] {
         return pcd("4 3 4", "F F F", "1 1 1", "10", "ascii\n") + lines;
       }},
      {"PcdOfAStrangeType", "a.pcd",
       [] {
         return pcd("4 4 4", "F X F", "1 1 1", "10", "ascii\n") + lines;
       }},
      {"PcdOfHugeFields", "a.pcd",
       [] {
         return pcd("4 4 4", "F F F", "1 1 2000000000", "10", "binary\n") + zeros;
       }},
      {"PcdThatUnpacksToAThousandMillion", "a.pcd", bomb},
      {"PcdThatLiesAboutItsSizes", "a.pcd",
       [] {
         return pcd("4 4 4", "F F F", "1 1 1", "10", "binary_compressed\n") +
                std::string("\x14\0\0\0\xFF\xFF\xFF\xFF", 8) + zeros;
       }},
      {"OffOfTooManyPoints", "a.off",
       [] {
         return "OFF\n2147483647 2147483647 0\n" + lines;
       }},
      {"OffOfMorePointsThanNumbers", "a.off",
       [] {
         return "OFF\n9223372036854775808 0 0\n" + lines;
       }},
      {"OffOfAPointThatIsNotThere", "a.off",
       [] {
         return std::string("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 99999\n");
       }},
      {"OffOfANegativePoint", "a.off",
       [] {
         return std::string("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n");
       }},
      {"OffThatIsOneNumber", "a.off",
       [] {
         return "OFF " + std::string(1000000, '9');
       }},
      {"ObjThatIsOneLine", "a.obj",
       [] {
         return "v 0 0 0 " + repeated("1 ", 500000);
       }},
      {"StlThatLiesAboutItsFaces", "a.stl",
       [] {
         return std::string(80, '\0') + std::string("\0\0\0\x80", 4) + zeros;
       }},
      {"StlOfSpaces", "a.stl",
       [] {
         return "solid x\n" + std::string(1000000, ' ');
       }},
      {"WebPage", "a.ply",
       [] {
         return std::string("<html>404</html>");
       }},
      {"Utf16", "a.obj",
       [] {
         return std::string("\xFF\xFEv\0 \0", 6);
       }},
      {"GzipUnderAnotherName", "a.ply",
       [] {
         return std::string("\x1F\x8B\x08\0\0", 5) + zeros;
       }},
      {"NoGzipUnderItsName", "a.ply.gz",
       [] {
         return lines;
       }},
  };
  return files;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
