/** \file
 * \brief The header of a PLY file.
 */
#pragma once

#include "io/read/file_content.h"
#include "io/read/scalar_type.h"

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

enum class PlyFormat { Text, LittleEndian, BigEndian };

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::Float32; ///< of the value, or of each value of the list
  bool is_list = false;
  ScalarType count_type = ScalarType::UInt8; ///< of the number of values of the list
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t line = 0; ///< of the header

  bool
  hasLists() const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::Text;
  std::vector<PlyElement> elements;
  std::size_t end_byte = 0; ///< where the data begin
  std::size_t end_line = 0; ///< number of the line that begins there
  std::size_t columns = 0;  ///< of an organised cloud as PCL writes it; 0: none
  std::size_t rows = 0;
  std::vector<std::string> notes; ///< what was passed over
};

/** \brief Reads the header and checks that all elements together may fit into the rest of the file.
 * \throws pcl::IOException is no PLY header, or promises more than the file can hold
 */
PlyHeader
readPlyHeader(const FileContent& file);

} // namespace symmetry
} // namespace pcl
