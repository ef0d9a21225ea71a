// What becomes of files and streams, whatever happens to pcl_intrinsic_symmetry.
#include "apps/run_program.h"
#include "model/articulated_body.h"
#include "model/write_model.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <fstream>
#include <sys/stat.h>
#include <thread>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

const std::string program = "pcl_intrinsic_symmetry";

class FilesAndSignals : public TemporaryFolder {
protected:
  static void
  SetUpTestSuite()
  {
    models = new ScratchFolder;
    ModelParameters parameters;
    parameters.vertices = 2000;
    writePlainSurface(human(), makeModel(parameters).surface);
  }

  static void
  TearDownTestSuite()
  {
    delete models;
    models = nullptr;
  }

  static std::string
  human()
  {
    return models->file("human.off");
  }

  /** \brief The map as a file has it. */
  std::string
  mapInFile() const
  {
    EXPECT_EQ(runProgram(program, {human(), "-q", "--map", path("map.csv")}).exit_status, 0);
    return read(path("map.csv"));
  }

  static ScratchFolder* models;
};

ScratchFolder* FilesAndSignals::models = nullptr;

TEST_F(FilesAndSignals, StandardInputAndOutputAreCalledDash)
{
  Streams streams;
  streams.input = human();
  const ProgramRun run = runProgram(program, {"-", "--format", "off", "--map", "-"}, streams);
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_EQ(run.output, mapInFile()) << "and nothing else";
  EXPECT_EQ(run.errors.rfind("symmetric", 0), 0U) << run.errors;
  EXPECT_EQ(countFiles(), 1U) << "none is called -";
  EXPECT_EQ(runProgram(program, {"-"}, streams).exit_status, 2) << "without a format";
  EXPECT_EQ(runProgram(program, {"-", "--format", "doc"}, streams).exit_status, 2);
  EXPECT_EQ(runProgram(program, {human(), "--map", "-", "--report", "-"}).exit_status, 2);
  EXPECT_EQ(runProgram(program, {human(), "-o", "-"}).exit_status, 2);
}

TEST_F(FilesAndSignals, FormatCountsMoreThanTheEnding)
{
  const std::string renamed = write("human.dat", read(human()));
  EXPECT_EQ(runProgram(program, {renamed}).exit_status, 1);
  EXPECT_EQ(runProgram(program, {renamed, "--format", "off"}).exit_status, 0);
}

TEST_F(FilesAndSignals, RedirectedStandardOutputIsNotReplaced)
{
  Streams streams;
  streams.output = write("log", "old\n");
  const ProgramRun run = runProgram(program, {human(), "-q", "--map", "/dev/stdout"}, streams);
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_EQ(read(path("log")), "old\n" + mapInFile());
}

TEST_F(FilesAndSignals, APipeIsWrittenTo)
{
  const std::string pipe = path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string piped;
  std::thread reader([&] { piped = readBytes(pipe); });
  const ProgramRun run = runProgram(program, {human(), "-q", "--map", pipe});
  reader.join();
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_EQ(piped, mapInFile());
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST_F(FilesAndSignals, NamesThatCannotBeAreFoundOutBeforeTheInputIsRead)
{
  for (const std::string& name : {path(std::string(300, 'a')), path("no/map.csv"), human() + "/map.csv"}) {
    const ProgramRun run = runProgram(program, {path("no_input.off"), "--map", name});
    EXPECT_EQ(run.exit_status, 1);
    EXPECT_NE(run.errors.find(name), std::string::npos) << run.errors;
  }
}

TEST_F(FilesAndSignals, TooFewPointsReplaceNothingButTheReport)
{
  const std::string few = write("few.off", "OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n");
  const std::string map = write("map.csv", "old");
  const ProgramRun run = runProgram(program, {few, "--map", map, "--report", path("report.json")});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_EQ(read(map), "old");
  EXPECT_EQ(nlohmann::json::parse(read(path("report.json"))).at("status"), "too_few_points");
}

TEST_F(FilesAndSignals, TooFewPointsAreExplained)
{
  const auto complaint = [this](const std::string& points) {
    return runProgram(program, {write("few.off", points)}).errors;
  };
  EXPECT_NE(complaint("OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n").find("of 4 points 4 at distinct"), std::string::npos);
  const std::string same = complaint("OFF\n4 0 0\n1 0 0\n1 0 0\n1 0 0\n1 0 0\n");
  EXPECT_NE(same.find("of 4 points 1 at distinct"), std::string::npos) << same;
  const std::string none = complaint("OFF\n3 0 0\nnan 0 0\n1 nan 0\n1 0 0\n");
  EXPECT_NE(none.find("of 3 points 2 are no finite places, 1 at distinct"), std::string::npos) << none;
}

TEST_F(FilesAndSignals, AnUnreadableInputLeavesAReport)
{
  const std::string broken = write("broken.off", "OFF\n3 0 0\n0 0\n");
  EXPECT_EQ(runProgram(program, {broken, "--report", path("report.json")}).exit_status, 1);
  const nlohmann::json report = nlohmann::json::parse(read(path("report.json")));
  EXPECT_EQ(report.at("status"), "failed");
  EXPECT_EQ(report.at("input").at("file"), broken);
  EXPECT_NE(report.at("message").get<std::string>().find("line"), std::string::npos);
}

TEST_F(FilesAndSignals, ALowConfidenceIsAWarning)
{
  // Random points in a cube: whatever is found, nobody should rely on it.
  std::string text = "OFF\n200 0 0\n";
  unsigned state = 1;
  for (int i = 0; i < 600; ++i) {
    state = state * 1664525U + 1013904223U;
    text += std::to_string(state >> 16U) + (i % 3 == 2 ? "\n" : " ");
  }
  const ProgramRun doubtful = runProgram(program, {write("cube.off", text)});
  const std::size_t place = doubtful.output.find("confidence ");
  ASSERT_NE(place, std::string::npos) << doubtful.output << doubtful.errors;
  const bool is_low = doubtful.exit_status == 0 && std::stod(doubtful.output.substr(place + 11)) < 0.66;
  EXPECT_EQ(doubtful.errors.find("warning: a confidence of") != std::string::npos, is_low) << doubtful.output;
  EXPECT_EQ(runProgram(program, {human()}).errors, "");
}

class EndedBySignal : public FilesAndSignals, public testing::WithParamInterface<int> {};

/** A pipe without a reader holds the program at its first file. What is half written: test/cli/program_test.cpp. */
TEST_P(EndedBySignal, LeavesFilesAsTheyWere)
{
  ASSERT_EQ(::mkfifo(path("pipe.ply").c_str(), 0600), 0);
  const std::string map = write("map.csv", "old");
  StartedProgram run(program, {human(), "-o", path("pipe.ply"), "--map", map});
  std::this_thread::sleep_for(std::chrono::milliseconds(500)); // the handlers are there after a few of them
  run.send(GetParam());
  const ProgramRun ended = run.wait();
  EXPECT_EQ(ended.exit_status, 128 + GetParam()) << ended.errors;
  EXPECT_EQ(read(map), "old");
  EXPECT_EQ(countFiles(), 2U);
}

INSTANTIATE_TEST_SUITE_P(Signals, EndedBySignal, testing::Values(SIGINT, SIGTERM, SIGHUP, SIGPIPE));

} // namespace
