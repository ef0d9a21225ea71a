// Files compressed by gzip, made by Boost's compressor.
#include "io/read/file_content.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <gtest/gtest.h>
#include <pcl/exceptions.h>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using Gzip = TemporaryFolder;

std::string
packed(const std::string& content)
{
  std::string bytes;
  boost::iostreams::filtering_ostream stream;
  stream.push(boost::iostreams::gzip_compressor());
  stream.push(boost::iostreams::back_inserter(bytes));
  stream << content;
  boost::iostreams::close(stream);
  return bytes;
}

const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST_F(Gzip, TheNameSaysWhatIsInside)
{
  for (const auto& [name, content] : {std::pair{"a.off.gz", off}, std::pair{"b.OBJ.GZ", obj}}) {
    const Surface surface = readSurface(write(name, packed(content)));
    EXPECT_EQ(surface.size(), 3U);
    EXPECT_EQ(surface.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  }
  EXPECT_THROW(readSurface(write("c.gz", packed(off))), IOException) << "and nothing else does";
}

TEST_F(Gzip, ComplaintsNameTheFileAndTheLineOfItsText)
{
  const std::string file = write("word.off.gz", packed("OFF\n1 0 0\n0 abc 0\n"));
  const std::string message = messageOf<IOException>([&] { readSurface(file); });
  EXPECT_NE(message.find(file + ": line 3: 'abc'"), std::string::npos) << message;
}

TEST_F(Gzip, SeveralMembersAreOneFile)
{
  FileContent file(write("two", packed("first ") + packed("second")));
  file.unpackGzip();
  EXPECT_EQ(file.view(), "first second");
}

TEST_F(Gzip, LongFilesComeBackByteForByte)
{
  std::string text;
  for (int i = 0; i < 200000; ++i)
    text += std::to_string(i * 7919 % 100003) + ' ';
  FileContent file(write("long", packed(text)));
  file.unpackGzip();
  EXPECT_EQ(file.view(), text);
}

TEST_F(Gzip, TruncatedAnywhere)
{
  const std::string whole = packed(off);
  for (std::size_t size = 1; size < whole.size(); ++size)
    EXPECT_THROW(readSurface(write("cut.off.gz", whole.substr(0, size))), IOException) << size << " bytes";
}

TEST_F(Gzip, DamagedAnywhere)
{
  const std::string whole = packed(off);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    try {
      EXPECT_EQ(readSurface(write("damaged.off.gz", damaged)).size(), 3U) << "byte " << i; // of the header: no matter
    }
    catch (const IOException&) {
    }
  }
}

TEST_F(Gzip, ASmallFileCannotBecomeHuge)
{
  const std::string file = write("bomb.off.gz", packed("OFF\n" + std::string(std::size_t{160} << 20, ' ')));
  const std::string message = messageOf<IOException>([&] { readSurface(file); });
  EXPECT_NE(message.find("unpacks to more than"), std::string::npos) << message;
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
