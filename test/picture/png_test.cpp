// Images as PNG: taken apart by the test itself, chunk by chunk, and by VTK's reader.
#include "picture/png.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <utility>

using namespace pcl::symmetry;

namespace {

/** An image without two equal pixels. */
Image
gradient(int width, int height)
{
  Image image;
  image.width = width;
  image.height = height;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int channel : {x, y, 255 - x})
        image.pixels.push_back(static_cast<std::uint8_t>(channel));
  return image;
}

std::uint32_t
bigEndian(const std::string& bytes, std::size_t begin)
{
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = number << 8 | static_cast<std::uint8_t>(bytes[begin + i]);
  return number;
}

Image
decode(const std::string& bytes)
{
  vtkNew<vtkPNGReader> reader;
  std::string copy = bytes; // VTK takes no const bytes
  reader->SetMemoryBuffer(copy.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(copy.size()));
  reader->Update();
  vtkImageData* const data = reader->GetOutput();
  Image image;
  image.width = data->GetDimensions()[0];
  image.height = data->GetDimensions()[1];
  for (int y = image.height - 1; y >= 0; --y)
    for (int x = 0; x < image.width; ++x) {
      const auto* const pixel = static_cast<const std::uint8_t*>(data->GetScalarPointer(x, y, 0));
      image.pixels.insert(image.pixels.end(), pixel, pixel + 3);
    }
  return image;
}

TEST(Png, HeaderSaysSizeAndKind)
{
  const std::string bytes = encodePng(gradient(7, 3));
  ASSERT_GT(bytes.size(), 33U);
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(bytes.substr(12, 4), "IHDR");
  EXPECT_EQ(bigEndian(bytes, 16), 7U);
  EXPECT_EQ(bigEndian(bytes, 20), 3U);
  EXPECT_EQ(bytes[24], 8) << "bits per channel";
  EXPECT_EQ(bytes[25], 2) << "red, green and blue";
  EXPECT_EQ(bytes.substr(bytes.size() - 8, 4), "IEND");
}

TEST(Png, ReadsBackAsItWas)
{
  for (const auto& [width, height] : {std::pair(1, 1), {7, 3}, {64, 200}}) {
    const Image image = gradient(width, height);
    const Image again = decode(encodePng(image));
    EXPECT_EQ(again.width, width);
    EXPECT_EQ(again.height, height);
    EXPECT_EQ(again.pixels, image.pixels) << width << " x " << height;
  }
}

TEST(Png, IsTheSameEachTime)
{
  EXPECT_EQ(encodePng(gradient(20, 20)), encodePng(gradient(20, 20)));
}

} // namespace
