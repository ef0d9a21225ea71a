#include "io/read/text_scanner.h"

#include <pcl/symmetry/surface_io.h>

namespace pcl {
namespace symmetry {

std::string
fileEnding(const std::string& path)
{
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string::npos ? std::string() : toLower(name.substr(dot));
}

} // namespace symmetry
} // namespace pcl
