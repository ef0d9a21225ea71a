#include "io/read/off_header.h"
#include "io/read/readers.h"

namespace pcl {
namespace symmetry {

Surface
readOff(const FileContent& file, Reading& reading)
{
  const OffHeader header = readOffHeader(file);
  reading.single_precision = header.binary;
  return header.binary ? readOffBinary(file, header, reading) : readOffText(file, header, reading);
}

} // namespace symmetry
} // namespace pcl
