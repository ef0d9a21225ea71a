#include "picture/png.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace pcl {
namespace symmetry {

std::string
encodePng(const Image& image)
{
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::size_t row_bytes = 3 * static_cast<std::size_t>(image.width);
  auto* const pixels = static_cast<std::uint8_t*>(data->GetScalarPointer());
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    // VTK counts rows from the bottom.
    const std::uint8_t* const row = image.pixels.data() + (static_cast<std::size_t>(image.height) - 1 - y) * row_bytes;
    std::copy(row, row + row_bytes, pixels + y * row_bytes);
  }
  // In memory, since VTK does not report a failure to write a file.
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(data);
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)), static_cast<std::size_t>(bytes->GetNumberOfTuples())};
}

} // namespace symmetry
} // namespace pcl
