/** \file
 * \brief What the first words of an OFF file say, and the two ways to read on from there.
 */
#pragma once

#include "io/read/file_content.h"
#include "io/read/readers.h"
#include "io/read/text_scanner.h"

#include <cstddef>

namespace pcl {
namespace symmetry {

constexpr TextSyntax off_syntax = {/*hash_comments=*/true, /*backslash_continues=*/false};

/** \brief What the keyword promises, and where the counts begin. */
struct OffHeader {
  bool texture = false;     ///< ST: two numbers a point
  bool colours = false;     ///< C
  bool normals = false;     ///< N
  bool homogeneous = false; ///< 4: each position has a fourth number, its divisor
  bool dimension = false;   ///< n: the number of dimensions comes before the counts
  bool binary = false;
  std::size_t end_byte = 0;
  std::size_t end_line = 0;
};

/** \brief The counts that both kinds of file begin with. */
struct OffCounts {
  std::size_t points = 0;
  std::size_t faces = 0;
};

/** \brief Reads the keyword, which may be glued to the counts (`OFF490 518 0`) or missing. */
OffHeader
readOffHeader(const FileContent& file);

/** \brief Reads the text behind the keyword. */
Surface
readOffText(const FileContent& file, const OffHeader& header, const Reading& reading);

/** \brief Reads what follows `OFF BINARY`: integers and floats of four bytes, all big-endian. */
Surface
readOffBinary(const FileContent& file, const OffHeader& header, const Reading& reading);

} // namespace symmetry
} // namespace pcl
