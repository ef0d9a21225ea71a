// What pcl_intrinsic_symmetry promises its users: exit status, files, messages.
#include "apps/run_program.h"
#include "model/articulated_body.h"
#include "model/write_model.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

const std::string program = "pcl_intrinsic_symmetry";

/** \brief A symmetric body and one without symmetry, made once for all tests. */
class IntrinsicSymmetryProgram : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    models = new ScratchFolder;
    writeBody(Body::Human, "human.ply");
    writeBody(Body::Helix, "helix.ply");
  }

  static void
  TearDownTestSuite()
  {
    delete models;
    models = nullptr;
  }

  static void
  writeBody(Body body, const std::string& name)
  {
    ModelParameters parameters;
    parameters.body = body;
    parameters.vertices = 4000;
    writePlainSurface(models->file(name), makeModel(parameters).surface);
  }

  static std::string
  human()
  {
    return models->file("human.ply");
  }

  static ScratchFolder* models;
  ScratchFolder results_;
};

ScratchFolder* IntrinsicSymmetryProgram::models = nullptr;

std::size_t
countLines(const std::string& text)
{
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST_F(IntrinsicSymmetryProgram, WritesEveryFileItIsAskedFor)
{
  const std::string labelled = results_.file("labelled.ply");
  const std::string map = results_.file("map.csv");
  const std::string correspondences = results_.file("correspondences.csv");
  const std::string axis = results_.file("axis.ply");
  const std::string report_file = results_.file("report.json");
  const std::string picture = results_.file("picture.png");
  const ProgramRun run =
      runProgram(program, {human(), "-o", labelled, "--map", map, "--correspondences", correspondences, "--axis", axis,
                           "--report", report_file, "--picture", picture});
  ASSERT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_EQ(countLines(run.output), 1U) << run.output;

  EXPECT_NE(readBytes(labelled).find("label"), std::string::npos);
  EXPECT_EQ(readBytes(map).rfind("vertex,partner,confidence\n0,", 0), 0U);
  const std::size_t points = readSurface(human()).size();
  EXPECT_EQ(countLines(readBytes(map)), points + 1);
  EXPECT_EQ(readBytes(correspondences).rfind("source,target,midpoint,cost\n", 0), 0U);
  EXPECT_GT(countLines(readBytes(correspondences)), 10U);
  EXPECT_EQ(readBytes(axis).rfind("ply", 0), 0U);
  EXPECT_EQ(readBytes(picture).substr(1, 3), "PNG");

  const nlohmann::json report = nlohmann::json::parse(readBytes(report_file));
  EXPECT_EQ(report.at("status"), "symmetric");
  EXPECT_EQ(report.at("input").at("points"), points);
  EXPECT_EQ(report.at("map").at("matched"), points);
  EXPECT_EQ(report.at("parameters").at("method"), "robust");
  double sum = 0.0;
  for (const auto& [step, seconds] : report.at("seconds").items())
    if (step != "total")
      sum += seconds.get<double>();
  EXPECT_NEAR(sum, report.at("seconds").at("total").get<double>(), 0.02);
}

TEST_F(IntrinsicSymmetryProgram, GivesTheSameBytesForAnyNumberOfThreads)
{
  const auto labelled = [&](const std::string& threads) {
    const std::string file = results_.file("labelled_" + threads + ".ply");
    const ProgramRun run = runProgram(program, {human(), "-o", file, "--threads", threads});
    EXPECT_EQ(run.exit_status, 0) << run.errors;
    return readBytes(file);
  };
  EXPECT_EQ(labelled("1"), labelled("2"));
}

TEST_F(IntrinsicSymmetryProgram, NamesTheSidesLikeAReference)
{
  const std::string reference = results_.file("reference.ply");
  ASSERT_EQ(runProgram(program, {human(), "-o", reference, "--label-axis", "off"}).exit_status, 0);
  const std::string report_file = results_.file("report.json");
  const ProgramRun run = runProgram(program, {human(), "--like", reference, "--report", report_file});
  ASSERT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_NE(run.output.find("sides named by reference, margin "), std::string::npos) << run.output;
  const auto names = nlohmann::json::parse(readBytes(report_file)).at("side_names");
  EXPECT_EQ(names.at("by"), "reference");
  EXPECT_EQ(names.at("exchanged"), false);
  EXPECT_GT(names.at("margin"), 0.1);

  const ProgramRun unlabelled = runProgram(program, {human(), "--like", human()});
  EXPECT_EQ(unlabelled.exit_status, 1);
  EXPECT_NE(unlabelled.errors.find(human() + ": has no integers 'label'"), std::string::npos) << unlabelled.errors;
}

TEST_F(IntrinsicSymmetryProgram, EndsWithThreeWhereThereIsNoSymmetry)
{
  const std::string report_file = results_.file("report.json");
  const ProgramRun run = runProgram(program, {models->file("helix.ply"), "--report", report_file});
  EXPECT_EQ(run.exit_status, 3) << run.output << run.errors;
  const nlohmann::json report = nlohmann::json::parse(readBytes(report_file));
  EXPECT_EQ(report.at("status"), "no_symmetry");
}

TEST_F(IntrinsicSymmetryProgram, NamesAFileItCannotRead)
{
  const std::string missing = results_.file("missing.ply");
  ProgramRun run = runProgram(program, {missing});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.errors.find(missing), std::string::npos) << run.errors;

  const std::string broken = results_.file("broken.ply");
  std::ofstream(broken) << readBytes(human()).substr(0, 5000);
  run = runProgram(program, {broken});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.errors.find(broken), std::string::npos) << run.errors;
}

TEST_F(IntrinsicSymmetryProgram, LeavesNoPartOfAFileItCannotWrite)
{
  const std::string file = results_.file("no_such_folder/labelled.ply");
  const ProgramRun run = runProgram(program, {human(), "-o", file});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.errors.find(file), std::string::npos) << run.errors;
  EXPECT_TRUE(std::filesystem::is_empty(results_.path()));
}

TEST_F(IntrinsicSymmetryProgram, RefusesWrongUsage)
{
  const std::vector<std::vector<std::string>> wrong{{},
                                                    {human(), human()},
                                                    {human(), "--no-such-option"},
                                                    {human(), "--method", "guess"},
                                                    {human(), "--metric", "taxicab"},
                                                    {human(), "-k", "abc"},
                                                    {human(), "-k", "12x"},
                                                    {human(), "-k", "-5"},
                                                    {human(), "--landmarks", "0"},
                                                    {human(), "--threads", "-1"},
                                                    {human(), "-o", results_.file("labelled.txt")},
                                                    {human(), "-o"}};
  for (const auto& arguments : wrong) {
    const ProgramRun run = runProgram(program, arguments);
    EXPECT_EQ(run.exit_status, 2) << (arguments.empty() ? "no argument" : arguments.back()) << ": " << run.errors;
    EXPECT_FALSE(run.errors.empty());
    EXPECT_TRUE(run.output.empty()) << run.output;
  }
}

TEST_F(IntrinsicSymmetryProgram, SaysWhatIsWrongInPlainWords)
{
  const ProgramRun range = runProgram(program, {human(), "--landmarks", "9"});
  EXPECT_EQ(range.errors, program + ": --landmarks is 9, allowed are 10 to 1000\nTry '" + program + " --help'.\n");
  const ProgramRun normals = runProgram(program, {human(), "--as-cloud", "--normals", "given"});
  EXPECT_EQ(normals.exit_status, 1);
  EXPECT_EQ(normals.errors, program + ": " + human() + ": given normals are asked for, but the cloud has none\n");
}

TEST_F(IntrinsicSymmetryProgram, ExplainsItself)
{
  const ProgramRun help = runProgram(program, {"--help"});
  EXPECT_EQ(help.exit_status, 0);
  for (const char* option :
       {"--output", "--map", "--correspondences", "--axis", "--report", "--picture", "--method", "--metric", "--sparse",
        "--as-cloud", "-k", "--landmarks", "--samples", "--threads", "--quiet", "--help", "--version"})
    EXPECT_NE(help.output.find(option), std::string::npos) << option;

  const ProgramRun version = runProgram(program, {"--version"});
  EXPECT_EQ(version.exit_status, 0);
  EXPECT_NE(version.output.find(PCL_SYMMETRY_VERSION), std::string::npos) << version.output;
}

/** \brief Sets an environment variable for the programs a test starts. */
class ScopedVariable {
public:
  ScopedVariable(const char* name, const char* value) : name_(name)
  {
    setenv(name, value, 1);
  }

  ~ScopedVariable()
  {
    unsetenv(name_);
  }

  ScopedVariable(const ScopedVariable&) = delete;
  ScopedVariable&
  operator=(const ScopedVariable&) = delete;
  ScopedVariable(ScopedVariable&&) = delete;
  ScopedVariable&
  operator=(ScopedVariable&&) = delete;

private:
  const char* name_;
};

TEST_F(IntrinsicSymmetryProgram, WritesTheSameBytesWithEveryInstructionSet)
{
  // One that the machine lacks means the best it has: these runs agree all the same.
  for (const std::string method : {"robust", "staged"}) {
    std::string expected;
    for (const char* set : {"baseline", "avx2", "avx512"}) {
      const ScopedVariable variable("PCL_SYMMETRY_INSTRUCTION_SET", set);
      const std::string map = results_.file(method + set + ".csv");
      const std::string matches = results_.file(method + set + "-matches.csv");
      ASSERT_EQ(
          runProgram(program, {human(), "--method", method, "--map", map, "--correspondences", matches}).exit_status,
          0);
      const std::string bytes = readBytes(map) + readBytes(matches);
      EXPECT_GT(countLines(bytes), 4000U);
      if (expected.empty()) {
        expected = bytes;
      }
      EXPECT_EQ(bytes, expected) << method << " with " << set;
    }
  }
}

} // namespace
