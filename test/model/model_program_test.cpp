// What pcl_symmetry_model promises its users: exit status, files, messages.
#include "apps/run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

using namespace pcl::symmetry::test;

namespace {

ProgramRun
makeBody(const std::vector<std::string>& arguments)
{
  return runProgram("pcl_symmetry_model", arguments);
}

TEST(ModelProgram, WritesTheBodyAndItsTruth)
{
  const ScratchFolder folder;
  const ProgramRun run = makeBody({folder.file("dog.off"), "--body", "quadruped", "--vertices", "2000", "--bend", "0",
                                   "--truth", folder.file("dog.txt")});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_NE(run.output.find("quadruped"), std::string::npos);
  std::istringstream off(readBytes(folder.file("dog.off")));
  std::string word;
  std::size_t points = 0;
  off >> word >> points;
  EXPECT_NEAR(static_cast<double>(points), 2000.0, 1.0);
  std::istringstream truth(readBytes(folder.file("dog.txt")));
  std::size_t lines = 0;
  std::size_t vertex = 0;
  std::size_t partner = 0;
  while (truth >> vertex >> partner) {
    EXPECT_EQ(vertex, ++lines);
    EXPECT_GE(partner, 1U);
    EXPECT_LE(partner, points);
  }
  EXPECT_EQ(lines, points);
}

TEST(ModelProgram, TheTruthDoesNotOverwriteTheBody)
{
  const ScratchFolder folder;
  const ProgramRun run = makeBody({folder.file("body.ply"), "--truth", folder.file("./body.ply")});
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_NE(run.errors.find("would be overwritten"), std::string::npos) << run.errors;
  EXPECT_FALSE(std::filesystem::exists(folder.file("body.ply")));
}

TEST(ModelProgram, AppliesEveryDisturbance)
{
  const ScratchFolder folder;
  const ProgramRun run = makeBody({folder.file("cloud.pcd"),
                                   "--vertices",
                                   "2000",
                                   "--holes",
                                   "3",
                                   "--thin",
                                   "4",
                                   "--drop",
                                   "0.1",
                                   "--no-faces",
                                   "--noise",
                                   "0.01",
                                   "--outliers",
                                   "0.02",
                                   "--shuffle",
                                   "--uneven",
                                   "5",
                                   "--jitter",
                                   "0.2",
                                   "--retriangulate",
                                   "--truth",
                                   folder.file("truth.txt")});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_NE(run.output.find(" 0 triangles"), std::string::npos);
  const std::string truth = readBytes(folder.file("truth.txt"));
  EXPECT_GT(std::count(truth.begin(), truth.end(), '\n'), 100);
}

TEST(ModelProgram, SameOptionsGiveTheSameBytes)
{
  const ScratchFolder folder;
  const std::vector<std::string> options = {"--vertices", "1500", "--noise", "0.005", "--shuffle", "--seed", "9", "-q"};
  for (const char* name : {"a.ply", "b.ply"}) {
    std::vector<std::string> arguments = {folder.file(name)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = makeBody(arguments);
    ASSERT_EQ(run.exit_status, 0) << run.errors;
    EXPECT_EQ(run.output, "");
  }
  EXPECT_EQ(readBytes(folder.file("a.ply")), readBytes(folder.file("b.ply")));
}

TEST(ModelProgram, HelpAndVersionSucceed)
{
  const ProgramRun help = makeBody({"--help"});
  EXPECT_EQ(help.exit_status, 0);
  EXPECT_NE(help.output.find("--retriangulate"), std::string::npos);
  const ProgramRun version = makeBody({"--version"});
  EXPECT_EQ(version.exit_status, 0);
  EXPECT_EQ(version.output, std::string("pcl_symmetry_model ") + PCL_SYMMETRY_VERSION + "\n");
}

TEST(ModelProgram, WrongUsageEndsWithTwoAndAMessage)
{
  const ScratchFolder folder;
  const std::string output = folder.file("a.ply");
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {output, "--body", "centipede"},
      {output, "--vertices", "many"},
      {output, "--vertices", "12x"},
      {output, "--vertices", "-2000"},
      {output, "--vertices=-2000"},
      {output, "--vertices", "10"},
      {output, "--seed", "-1"},
      {output, "--bend", "nan"},
      {output, "--bend", "2"},
      {output, "--noise", "1.5"},
      {output, "--holes", "2", "--hole-share", "1"},
      {output, "--drop", "1"},
      {output, "--thin", "0"},
      {output, "--outliers", "2"},
      {output, "--unknown"},
      {output, "--vert", "2000"},
      {output, output},
      {folder.file("a.stl")},
  };
  for (const std::vector<std::string>& arguments : wrong) {
    std::string line;
    for (const std::string& argument : arguments)
      line += " " + argument;
    const ProgramRun run = makeBody(arguments);
    EXPECT_EQ(run.exit_status, 2) << line;
    EXPECT_NE(run.errors.find("pcl_symmetry_model: "), std::string::npos) << line;
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ModelProgram, UnwritableOutputEndsWithOneAndNamesTheFile)
{
  const ScratchFolder folder;
  const std::string output = folder.file("missing/a.ply");
  const ProgramRun run = makeBody({output, "--vertices", "1000"});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.errors.find(output), std::string::npos);
}

} // namespace
