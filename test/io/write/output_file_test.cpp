// Files that appear whole or not at all. Links, and failures of the writers: writers_test.cpp.
#include "io/write/output_file.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using OutputFileTest = TemporaryFolder;

TEST_F(OutputFileTest, AppearsAtTheEnd)
{
  const std::string old = write("a", "old");
  {
    OutputFile file(old);
    file.write("new ");
    file.write("content");
    EXPECT_EQ(read(old), "old");
    EXPECT_EQ(countFiles(), 2U) << "written beside its place";
    file.commit();
  }
  EXPECT_EQ(read(old), "new content");
  EXPECT_EQ(countFiles(), 1U);
}

TEST_F(OutputFileTest, LeavesNothingBehindWithoutTheEnd)
{
  const std::string old = write("a", "old");
  {
    OutputFile file(old);
    file.write("new");
    OutputFile other(path("b"));
    other.write("new");
  }
  EXPECT_EQ(read(old), "old");
  EXPECT_EQ(countFiles(), 1U);
}

TEST_F(OutputFileTest, KeepsTheRightsOfTheFileItReplaces)
{
  const std::string old = write("a", "old");
  ASSERT_EQ(::chmod(old.c_str(), 0640), 0);
  writeWholeFile(old, "new");
  struct stat status = {};
  ASSERT_EQ(::stat(old.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777U, 0640U);
  EXPECT_EQ(read(old), "new");
}

TEST_F(OutputFileTest, RefusesPlacesThatCannotBeWritten)
{
  EXPECT_EQ(messageOf<IOException>([this] { writeWholeFile(path("no/a"), "x"); }),
            path("no/a") + ": cannot be written: No such file or directory");
  EXPECT_EQ(messageOf<IOException>([this] { writeWholeFile(path(""), "x"); }),
            path("") + ": cannot be written: Is a directory");
  EXPECT_THROW(checkOutputFile(path("no/a")), IOException);
  EXPECT_NO_THROW(checkOutputFile(path("a")));
  EXPECT_EQ(countFiles(), 0U);
}

TEST_F(OutputFileTest, RefusesNamesThatAreTooLong)
{
  EXPECT_THROW(checkOutputFile(path(std::string(300, 'a'))), IOException);
  EXPECT_THROW(writeWholeFile(path(std::string(300, 'a')), "x"), IOException);
  EXPECT_NO_THROW(writeWholeFile(path(std::string(250, 'a')), "x")) << "though no name beside it is longer";
  EXPECT_THROW(checkOutputFile(write("a", "x") + "/b"), IOException);
  EXPECT_EQ(countFiles(), 2U);
}

TEST_F(OutputFileTest, ReplacesWhatAProcessThatWasKilledHasLeft)
{
  const std::string file = write("a", "old");
  const auto begin = [&file] {
    OutputFile begun(file);
    begun.write("half");
    ::raise(SIGKILL);
  };
  EXPECT_EXIT(begin(), testing::KilledBySignal(SIGKILL), "");
  EXPECT_EQ(countFiles(), 2U) << "nobody can remove it then";
  writeWholeFile(file, "new");
  EXPECT_EQ(read(file), "new");
  EXPECT_EQ(countFiles(), 1U);
}

TEST_F(OutputFileTest, WritersOfOneFileDoNotDisturbEachOther)
{
  OutputFile first(path("a"));
  first.write("first");
  OutputFile second(path("a"));
  second.write("second");
  EXPECT_EQ(countFiles(), 2U);
  first.commit();
  EXPECT_EQ(read(path("a")), "first");
  second.commit();
  EXPECT_EQ(read(path("a")), "second");
  EXPECT_EQ(countFiles(), 1U);
}

TEST_F(OutputFileTest, WritesToWhatIsOpenAlready)
{
  const std::string log = write("log", "old ");
  const int descriptor = ::open(log.c_str(), O_WRONLY | O_APPEND);
  ASSERT_GE(descriptor, 0);
  const std::string name = "/dev/fd/" + std::to_string(descriptor);
  EXPECT_NO_THROW(checkOutputFile(name));
  EXPECT_TRUE(areOneFile(name, name)) << "two outputs would be mixed";
  writeWholeFile(name, "new");
  ::close(descriptor);
  EXPECT_EQ(read(log), "old new");
  EXPECT_THROW(checkOutputFile(name), IOException) << "closed";

  const int reading = ::open(log.c_str(), O_RDONLY);
  EXPECT_THROW(checkOutputFile("/dev/fd/" + std::to_string(reading)), IOException);
  ::close(reading);
}

TEST_F(OutputFileTest, WritesToDevicesDirectly)
{
  EXPECT_NO_THROW(writeWholeFile("/dev/null", "x"));
  EXPECT_NO_THROW(checkOutputFile("/dev/null"));
  EXPECT_THROW(writeWholeFile("/dev/full", "x"), IOException);
  EXPECT_EQ(::access("/dev/null", W_OK), 0) << "it is still there";
}

TEST_F(OutputFileTest, OneFileHasManyNames)
{
  const std::string file = write("folder/a", "x");
  std::filesystem::create_symlink("folder/a", path("link"));
  std::filesystem::create_hard_link(file, path("hard"));
  for (const std::string& other : {path("folder/../folder/a"), path("link"), path("hard")}) {
    EXPECT_TRUE(areOneFile(file, other)) << other;
    EXPECT_TRUE(areOneFile(other, file)) << other;
  }
  EXPECT_TRUE(areOneFile(path("new"), path("folder/../new"))) << "a file that is not there yet";
  EXPECT_FALSE(areOneFile(path("new"), path("newer")));
  EXPECT_FALSE(areOneFile(file, write("b", "x"))) << "equal content is not enough";
  EXPECT_FALSE(areOneFile("", ""));
  EXPECT_FALSE(areOneFile("/dev/null", "/dev/null")) << "nothing is lost in a device";
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
