#include "benchmark/whole_file.h"

#include <pcl/exceptions.h>

#include <cstdio>
#include <fstream>

namespace pcl {
namespace symmetry {

void
writeWholeFile(const std::string& path, const std::string& content)
{
  const std::string beside = path + ".part";
  std::ofstream file(beside, std::ios::binary);
  file << content;
  file.close();
  if (!file || std::rename(beside.c_str(), path.c_str()) != 0) {
    std::remove(beside.c_str());
    throw pcl::IOException(path + ": cannot be written");
  }
}

} // namespace symmetry
} // namespace pcl
