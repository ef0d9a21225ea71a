#include "io/output_file.h"

#include <pcl/symmetry/surface_io.h>

#include <pcl/exceptions.h>

#include <cerrno>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>

namespace pcl {
namespace symmetry {

void
checkWritable(const std::string& path)
{
  struct stat status = {};
  const bool is_special = ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
  // Opening a pipe and closing it again would tell its reader that all is said.
  if (!is_special)
    OutputFile file(path);
  else if (::access(path.c_str(), W_OK) != 0)
    throw IOException(path + ": cannot be written: " + std::strerror(errno));
}

} // namespace symmetry
} // namespace pcl
