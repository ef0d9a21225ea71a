#include "io/write/output_file.h"

#include <pcl/symmetry/surface_io.h>

namespace pcl {
namespace symmetry {

void
checkWritable(const std::string& path)
{
  checkOutputFile(path);
}

void
removeUnfinishedFiles() noexcept
{
  removePartFiles();
}

} // namespace symmetry
} // namespace pcl
