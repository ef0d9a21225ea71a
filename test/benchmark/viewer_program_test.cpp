// What pcl_symmetry_viewer promises where nothing can be shown: exit status and messages.
#include "apps/run_program.h"
#include "support/temporary_folder.h"

#include <cstdlib>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

class ViewerProgramTest : public TemporaryFolder {
protected:
  ViewerProgramTest()
  {
    unsetenv("DISPLAY");
  }

  /** A .pcd file of two points with these fields behind x y z, all of them 4-byte integers. */
  std::string
  writePoints(const std::string& fields, const std::string& first, const std::string& second) const
  {
    std::string sizes;
    std::string types;
    std::string counts;
    for (const char c : fields)
      if (c == ' ') {
        sizes += " 4";
        types += " I";
        counts += " 1";
      }
    return write("points.pcd", "VERSION .7\nFIELDS x y z" + fields + "\nSIZE 4 4 4" + sizes + "\nTYPE F F F" + types +
                                   "\nCOUNT 1 1 1" + counts +
                                   "\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA ascii\n" + "0 0 0" +
                                   first + "\n1 0 0" + second + "\n");
  }

  static void
  expectFailure(const std::string& file, const std::string& reason)
  {
    const ProgramRun run = runProgram("pcl_symmetry_viewer", {file, "--screenshot", file + ".png"});
    EXPECT_EQ(run.exit_status, 1) << reason;
    EXPECT_NE(run.errors.find(reason), std::string::npos) << run.errors;
    EXPECT_FALSE(std::filesystem::exists(file + ".png"));
  }
};

TEST_F(ViewerProgramTest, SaysWhyItCannotShow)
{
  expectFailure(path("missing.ply"), "missing.ply: cannot be read");
  expectFailure(write("notes.txt", "x"), "notes.txt: is neither .ply nor .pcd");
  expectFailure(writePoints(" label", " 1", " 2"), "has no field 'partner'");
  expectFailure(writePoints(" partner", " 1", " 0"), "has no field 'label'");
  expectFailure(writePoints(" label partner", " 1 1", " 2 2"), "partner 2 of point 1 is out of range");
  expectFailure(writePoints(" label partner", " 4 1", " 2 0"), "label 4 of point 0 is out of range");
  expectFailure(writePoints(" label partner", " 1 1", " 2 0"), "no display");
}

TEST_F(ViewerProgramTest, WrongUsageEndsWithTwo)
{
  EXPECT_EQ(runProgram("pcl_symmetry_viewer", {}).exit_status, 2);
  EXPECT_EQ(runProgram("pcl_symmetry_viewer", {"a.ply", "b.ply"}).exit_status, 2);
  EXPECT_EQ(runProgram("pcl_symmetry_viewer", {"a.ply", "--partners", "-1"}).exit_status, 2);
  EXPECT_EQ(runProgram("pcl_symmetry_viewer", {"a.ply", "--partners", "few"}).exit_status, 2);
  EXPECT_EQ(runProgram("pcl_symmetry_viewer", {"a.ply", "--unknown"}).exit_status, 2);
}

TEST_F(ViewerProgramTest, HelpAndVersionEndWithZero)
{
  EXPECT_EQ(runProgram("pcl_symmetry_viewer", {"--help"}).exit_status, 0);
  EXPECT_EQ(runProgram("pcl_symmetry_viewer", {"--version"}).output, "pcl_symmetry_viewer " PCL_SYMMETRY_VERSION "\n");
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
