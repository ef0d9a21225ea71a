/** \file
 * \brief The header of a PCD file.
 */
#pragma once

#include "io/read/file_content.h"
#include "io/read/scalar_type.h"

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

enum class PcdFormat { Text, Binary, Compressed };

struct PcdField {
  std::string name;
  std::size_t value_bytes = 0;
  std::size_t count = 1;  ///< values per point
  bool is_number = false; ///< \a type holds; false for padding and the like, which are only passed over
  ScalarType type = ScalarType::Float32;

  std::size_t
  bytes() const
  {
    return value_bytes * count;
  }
};

struct PcdHeader {
  std::vector<PcdField> fields;
  std::size_t points = 0; ///< of all rows of an organised cloud
  std::size_t width = 0;  ///< of the rows of an organised cloud; otherwise 0
  PcdFormat format = PcdFormat::Text;
  std::size_t end_byte = 0; ///< where the data begin
  std::size_t end_line = 0; ///< number of the line that begins there

  std::size_t
  pointBytes() const;
};

/** \brief Reads the header and checks that its lines agree with each other.
 * \throws pcl::IOException is no PCD header
 */
PcdHeader
readPcdHeader(const FileContent& file);

} // namespace symmetry
} // namespace pcl
