// A file in memory, byte by byte, and messages that name it. What cannot be read at all: broken_files_test.cpp.
#include "io/read/file_content.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

#include <sys/stat.h>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using FileContentTest = TemporaryFolder;

TEST_F(FileContentTest, HoldsEveryByte)
{
  std::string bytes;
  for (int i = 0; i < 100000; ++i)
    bytes += static_cast<char>(i * 7 % 256);
  const FileContent file(write("bytes", bytes));
  EXPECT_EQ(file.size(), bytes.size());
  EXPECT_EQ(file.view(), bytes);
  EXPECT_EQ(file.data(), file.view().data());
}

TEST_F(FileContentTest, RefusesWhatIsNoFileWithBytes)
{
  const auto complaint = [](const std::string& name) {
    return messageOf<IOException>([&name] { FileContent file(name); });
  };
  EXPECT_EQ(complaint(write("empty", "")), path("empty") + ": is empty");
  EXPECT_EQ(complaint(path("")), path("") + ": is a directory");
  EXPECT_EQ(complaint(path("none")), path("none") + ": cannot be opened: No such file or directory");
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(complaint(path("pipe")), path("pipe") + ": is not a regular file") << "and does not wait for a writer";
}

TEST_F(FileContentTest, ComplaintsNameThePlace)
{
  const FileContent file(write("a", "x"));
  EXPECT_EQ(messageOf<IOException>([&] { file.fail("is odd"); }), path("a") + ": is odd");
  EXPECT_EQ(messageOf<IOException>([&] { file.failAtLine(3, "is odd"); }), path("a") + ": line 3: is odd");
  EXPECT_EQ(messageOf<IOException>([&] { file.failAtByte(0, "is odd"); }), path("a") + ": byte 0: is odd");
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
