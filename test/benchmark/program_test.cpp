// What pcl_symmetry_benchmark promises its users: exit status, tables, files, messages.
#include "apps/run_program.h"
#include "model/articulated_body.h"
#include "model/write_model.h"
#include "support/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using Arguments = std::vector<std::string>;

ProgramRun
runBenchmark(const Arguments& arguments)
{
  return runProgram("pcl_symmetry_benchmark", arguments);
}

/** A square of 5 x 5 vertices and its left-right mirror, 1-based. */
class BenchmarkProgramTest : public TemporaryFolder {
protected:
  BenchmarkProgramTest()
  {
    std::string off = "OFF\n25 32 0\n";
    std::string truth;
    std::string faces;
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 5; ++i) {
        const int a = 5 * j + i;
        off += std::to_string(i) + " " + std::to_string(j) + " 0\n";
        truth += std::to_string(5 * j + 4 - i + 1) + "\n";
        if (i < 4 && j < 4) {
          faces += "3 " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(a + 6) + "\n";
          faces += "3 " + std::to_string(a) + " " + std::to_string(a + 6) + " " + std::to_string(a + 5) + "\n";
        }
      }
    mesh_ = write("square.off", off + faces);
    truth_ = write("square_sym.txt", truth);
  }

  Arguments
  scoreArguments(const std::string& map) const
  {
    return {"--score", map, "--mesh", mesh_, "--truth", truth_};
  }

  /** A data set of one human, below the folder of the test. */
  std::string
  writeHuman() const
  {
    ModelParameters parameters;
    parameters.vertices = 2500;
    const Model model = makeModel(parameters);
    std::string truth;
    for (const Index partner : model.partners)
      truth += std::to_string(partner + 1) + " ";
    write("sets/MADE/sym.txt", truth);
    writePlainSurface(path("sets/MADE/human.off"), model.surface);
    return path("sets");
  }

  std::string mesh_;
  std::string truth_;
};

TEST_F(BenchmarkProgramTest, ScoresAnExistingMap)
{
  std::string map = "vertex,partner,confidence\n";
  for (int v = 0; v < 25; ++v)
    map += std::to_string(v) + "," + std::to_string(v / 5 * 5 + 4 - v % 5) + ",1\n";
  const ProgramRun right = runBenchmark(scoreArguments(write("right.csv", map)));
  EXPECT_EQ(right.exit_status, 0) << right.errors;
  EXPECT_EQ(right.output, "correspondence rate 1.0000  mean geodesic error 0.0000  matched 25/25\n");

  const ProgramRun empty = runBenchmark(scoreArguments(write("empty.csv", "vertex,partner\n")));
  EXPECT_EQ(empty.output, "correspondence rate 0.0000  mean geodesic error 1.0000  matched 0/25\n");
}

TEST_F(BenchmarkProgramTest, WritesTheScoreAsJson)
{
  Arguments arguments = scoreArguments(write("half.csv", "0,4\n"));
  arguments.insert(arguments.end(), {"--json", path("score.json")});
  EXPECT_EQ(runBenchmark(arguments).exit_status, 0);
  const nlohmann::json score = nlohmann::json::parse(read(path("score.json")));
  EXPECT_EQ(score["truth"], 25);
  EXPECT_EQ(score["matched"], 1);
  EXPECT_DOUBLE_EQ(score["correspondence_rate"].get<double>(), 1.0 / 25.0);
}

TEST_F(BenchmarkProgramTest, RunsADataSetAndWritesAllFiles)
{
  const std::string folder = writeHuman();
  const ProgramRun run =
      runBenchmark({folder, "--method", "staged", "--csv", path("out.csv"), "--json", path("out.json"), "--plot",
                    path("out.svg"), "--map-dir", path("maps"), "--verbose"});
  ASSERT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_NE(run.output.find("MADE/human"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("MADE (mean of classes)"), std::string::npos);
  EXPECT_NE(run.output.find("seconds:"), std::string::npos);
  const nlohmann::json report = nlohmann::json::parse(read(path("out.json")));
  EXPECT_EQ(report["parameters"]["method"], "staged");
  const double rate = report["models"][0]["correspondence_rate"];
  EXPECT_NE(read(path("out.csv")).find("MADE,made,human,"), std::string::npos);
  EXPECT_NE(read(path("out.svg")).find(">MADE</text>"), std::string::npos);

  // The map that was written scores as the table says.
  const ProgramRun again = runBenchmark({"--score", path("maps/MADE_human.csv"), "--mesh", folder + "/MADE/human.off",
                                         "--truth", folder + "/MADE/sym.txt", "--json", path("again.json")});
  ASSERT_EQ(again.exit_status, 0) << again.errors;
  EXPECT_EQ(nlohmann::json::parse(read(path("again.json")))["correspondence_rate"], rate);
}

TEST_F(BenchmarkProgramTest, WritesThePublishedFiguresBesideThoseOfBothMethods)
{
  const std::string folder = writeHuman();
  const ProgramRun run = runBenchmark({folder, "--paper", path("out/paper")});
  ASSERT_EQ(run.exit_status, 0) << run.errors;
  const std::string page = read(path("out/paper/paper.md"));
  std::string row = "\n| MADE (1) | ";
  for (const std::string method : {"staged", "robust"}) {
    EXPECT_EQ(runBenchmark({folder, "--method", method, "--json", path("out.json")}).exit_status, 0);
    const nlohmann::json report = nlohmann::json::parse(read(path("out.json")));
    std::array<char, 32> rate{};
    std::snprintf(rate.data(), rate.size(), " | %.1f/100",
                  100.0 * report["models"][0]["correspondence_rate"].get<double>());
    row += rate.data();
  }
  EXPECT_NE(page.find(row + " |  |  |\n"), std::string::npos) << row << '\n' << page;
  EXPECT_NE(page.find("\n| wolf | 97/100 |  |  | 100/100 | 100/100 |\n"), std::string::npos) << page;
  EXPECT_NE(page.find("(error_curves.svg)"), std::string::npos);
  EXPECT_NE(read(path("out/paper/error_curves.svg")).find(">MADE, staged</text>"), std::string::npos);
  for (const std::string name : {"MADE_human_staged", "MADE_human_robust"})
    for (const std::string kind : {".png", "_colours.png"}) {
      EXPECT_NE(page.find("](" + name + kind + ")"), std::string::npos) << name << kind;
      EXPECT_EQ(read(path("out/paper/" + name + kind)).substr(1, 3), "PNG");
    }
}

TEST_F(BenchmarkProgramTest, ThePaperCountsWhatFailsAndEndsWithOne)
{
  write("sets/MADE/broken.off", "OFF\n3 1 0\n0 0 0\n");
  const ProgramRun run = runBenchmark({writeHuman(), "--paper", path("paper")});
  EXPECT_EQ(run.exit_status, 1);
  const std::string page = read(path("paper/paper.md"));
  EXPECT_NE(page.find(" | 50.0/50 |  |  |\n"), std::string::npos) << page;
  EXPECT_NE(page.find("- MADE/broken, robust, failed: "), std::string::npos) << page;
  EXPECT_NE(page.find("(MADE_human_robust.png)"), std::string::npos) << "the first that did not fail";
}

TEST_F(BenchmarkProgramTest, ThePaperGoesWithWholeMeshesAndNoOtherOutput)
{
  const std::string folder = path("");
  for (const Arguments& other : std::vector<Arguments>{{"--csv", path("a.csv")},
                                                       {"--plot", path("a.svg")},
                                                       {"--map-dir", path("maps")},
                                                       {"--evidence", path("e.csv")},
                                                       {"--method", "staged"},
                                                       {"--as-cloud"},
                                                       {"--graph"},
                                                       {"--vary", "1"},
                                                       {"--noise", "0.01"},
                                                       {"--holes", "1"},
                                                       {"--thin", "2"},
                                                       {"--cut-limb", "other"}}) {
    Arguments arguments = {folder, "--paper", path("paper")};
    arguments.insert(arguments.end(), other.begin(), other.end());
    EXPECT_EQ(runBenchmark(arguments).exit_status, 2) << other.front();
  }
}

TEST_F(BenchmarkProgramTest, ComparesGraphs)
{
  const ProgramRun run = runBenchmark({writeHuman(), "--graph", "--jobs", "2"});
  ASSERT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_NE(run.output.find("MADE/human"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("MADE (mean of classes)"), std::string::npos) << run.output;
  write("sets/MADE/broken.off", "OFF\n3 1 0\n0 0 0\n");
  const ProgramRun failed = runBenchmark({path("sets"), "--graph"});
  EXPECT_EQ(failed.exit_status, 1);
  EXPECT_NE(failed.output.find("MADE/broken  failed: "), std::string::npos) << failed.output;
}

TEST_F(BenchmarkProgramTest, CountsTheBodiesThatArePartlySymmetricOrRefusedWithoutALimb)
{
  const ProgramRun run = runBenchmark({writeHuman(), "--cut-limb", "farthest"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_NE(run.output.find("partly_symmetric"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("refused  partial  conf. < 0.5"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("\nMADE "), std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("mean of classes"), std::string::npos) << "there is nothing to score";
  EXPECT_EQ(runBenchmark({writeHuman(), "--cut-limb", "third"}).exit_status, 2);
  EXPECT_EQ(runBenchmark({writeHuman(), "--cut-limb", "other", "--graph"}).exit_status, 2);
}

TEST_F(BenchmarkProgramTest, RunsVariantsBesideTheModel)
{
  const ProgramRun run = runBenchmark({writeHuman(), "--vary", "2"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_NE(run.output.find("~shuffled"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("MADE, as it is"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("MADE, half"), std::string::npos) << run.output;
  EXPECT_EQ(runBenchmark({writeHuman(), "--vary", "11"}).exit_status, 2) << "there are ten";
  EXPECT_EQ(runBenchmark({writeHuman(), "--vary", "1", "--cut-limb", "other"}).exit_status, 2);
}

TEST_F(BenchmarkProgramTest, ShowsWhatEachIngredientContributes)
{
  const ProgramRun run = runBenchmark({writeHuman(), "--ablation", "--threads", "1"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  EXPECT_NE(run.output.find("MADE"), std::string::npos) << run.output;
  const std::size_t whole = run.output.find("whole method");
  ASSERT_NE(whole, std::string::npos) << run.output;
  EXPECT_NE(run.output.find("100.0 /100.0    1.00", whole), std::string::npos) << "all right, in its own time";
  EXPECT_GT(std::count(run.output.begin(), run.output.end(), '\n'), 15) << "a line for each";
}

TEST_F(BenchmarkProgramTest, WritesTheEvidenceOfEveryMap)
{
  const ProgramRun run =
      runBenchmark({writeHuman(), "--evidence", path("evidence.csv"), "--vertex-evidence", path("vertices.csv")});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  const std::string vertices = read(path("vertices.csv"));
  EXPECT_EQ(
      vertices.rfind("set,model,input,number,map_confidence,vertex,error,local_change,fit_distance,reversal\n", 0), 0U);
  EXPECT_GT(std::count(vertices.begin(), vertices.end(), '\n'), 100) << "a line for every scored vertex";
  EXPECT_EQ(runBenchmark({writeHuman(), "--vertex-evidence", path("v.csv")}).exit_status, 2);
  std::istringstream table(read(path("evidence.csv")));
  std::string header;
  std::string row;
  ASSERT_TRUE(std::getline(table, header));
  ASSERT_TRUE(std::getline(table, row));
  EXPECT_EQ(header.rfind("set,class,model,input,number,cut,rate,confidence,score,", 0), 0U) << header;
  EXPECT_NE(header.find(",worst_local_change,"), std::string::npos);
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(row.begin(), row.end(), ','));
  EXPECT_EQ(row.rfind("MADE,", 0), 0U) << row;
  EXPECT_NE(row.find(",mesh,0,0,1,"), std::string::npos) << "the first interpretation, whole, all right: " << row;
  EXPECT_EQ(runBenchmark({writeHuman(), "--evidence", path("e.csv"), "--csv", path("c.csv")}).exit_status, 2);
}

TEST_F(BenchmarkProgramTest, WritesTheEvidenceOfEveryContender)
{
  const ProgramRun run = runBenchmark({writeHuman(), "--evidence", path("contenders.csv"), "--contenders"});
  EXPECT_EQ(run.exit_status, 0) << run.errors;
  std::istringstream table(read(path("contenders.csv")));
  std::string header;
  std::string row;
  ASSERT_TRUE(std::getline(table, header));
  ASSERT_TRUE(std::getline(table, row));
  EXPECT_NE(header.find(",misfit"), std::string::npos) << header;
  EXPECT_NE(row.find(",mesh,0,0,1,"), std::string::npos) << "the best one, whole, all right: " << row;
  EXPECT_EQ(runBenchmark({writeHuman(), "--contenders"}).exit_status, 2);
  EXPECT_EQ(
      runBenchmark({writeHuman(), "--evidence", path("e.csv"), "--vertex-evidence", path("v.csv"), "--contenders"})
          .exit_status,
      2);
}

TEST_F(BenchmarkProgramTest, AModelThatFailsIsReportedAndEndsWithOne)
{
  write("sets/MADE/broken.off", "OFF\n3 1 0\n0 0 0\n");
  write("sets/MADE/sym.txt", "1\n2\n3\n");
  const ProgramRun run = runBenchmark({path("sets"), "--jobs", "2"});
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_NE(run.output.find("MADE/broken"), std::string::npos);
  EXPECT_NE(run.output.find("failed: "), std::string::npos) << run.output;
}

TEST_F(BenchmarkProgramTest, LeavesOutModelsWithoutTruthUnlessAsked)
{
  const std::string folder = writeHuman();
  write("sets/clouds/broken.off", "");
  EXPECT_EQ(runBenchmark({folder, "--all", "--set", "clouds"}).exit_status, 1) << "it is run, and cannot be read";
  const ProgramRun none = runBenchmark({folder, "--set", "clouds"});
  EXPECT_EQ(none.exit_status, 1);
  EXPECT_NE(none.errors.find("1 models without ground truth are left out"), std::string::npos) << none.errors;
}

TEST_F(BenchmarkProgramTest, FilesThatCannotBeReadOrWrittenEndWithOne)
{
  const ProgramRun missing = runBenchmark({path("missing")});
  EXPECT_EQ(missing.exit_status, 1);
  EXPECT_EQ(missing.errors, "pcl_symmetry_benchmark: " + path("missing") + ": is no folder\n");
  EXPECT_EQ(runBenchmark(scoreArguments(path("missing.csv"))).exit_status, 1);
  EXPECT_EQ(runBenchmark(scoreArguments(write("bad.csv", "0,25\n"))).exit_status, 1);
  const ProgramRun early = runBenchmark({path(""), "--csv", path("no/folder.csv")});
  EXPECT_EQ(early.exit_status, 1);
  EXPECT_EQ(early.output, "") << "it is found out before anything is run";
  Arguments arguments = scoreArguments(write("map.csv", "0,4\n"));
  arguments.insert(arguments.end(), {"--json", path("no/folder.json")});
  EXPECT_EQ(runBenchmark(arguments).exit_status, 1);
}

TEST_F(BenchmarkProgramTest, WrongUsageEndsWithTwo)
{
  const std::string folder = path("");
  for (const Arguments& arguments :
       std::vector<Arguments>{{},
                              {folder, "--unknown"},
                              {folder, "--meth", "staged"},
                              {folder, "--method", "best"},
                              {folder, "--metric", "cosine"},
                              {folder, "--jobs", "-1"},
                              {folder, "--jobs", "two"},
                              {folder, "--threads", "-1"},
                              {folder, "-k", "1"},
                              {folder, "--landmarks", "5"},
                              {folder, "--noise", "-0.5"},
                              {folder, "--noise", "nan"},
                              {folder, "--drop", "1"},
                              {folder, "--holes", "-1"},
                              {folder, "--hole-share", "1"},
                              {folder, "--thin", "0"},
                              {folder, "--quantise", "2"},
                              {folder, "--bend", "-1"},
                              {folder, "--bend", "4"},
                              {folder, "--repeat", "-1"},
                              {folder, "--graph", "--as-cloud"},
                              {folder, "--ablation", "--csv", "file.csv"},
                              {folder, "--ablation", "--method", "staged"},
                              {folder, "--ablation", "--samples", "300"},
                              {folder, "--side-names", "--graph"},
                              {folder, "--side-names", "--csv", "file.csv"},
                              {folder, "--side-names", "--noise", "0.01"},
                              {folder, "--exchanged", "cat"},
                              {folder, "--graph", "--csv", "file.csv"},
                              {"--score", mesh_, "--mesh", mesh_, "--truth", truth_, "--csv", "file.csv"},
                              {"--score", mesh_, "--mesh", mesh_, "--truth", truth_, "--json", truth_},
                              {folder, "--csv"},
                              {folder, folder},
                              {folder, "--score", mesh_},
                              {"--score", mesh_, "--mesh", mesh_}}) {
    const ProgramRun run = runBenchmark(arguments);
    EXPECT_EQ(run.exit_status, 2) << (arguments.empty() ? "" : arguments.back()) << run.output;
    EXPECT_EQ(run.errors.compare(0, 24, "pcl_symmetry_benchmark: "), 0) << run.errors;
  }
}

TEST_F(BenchmarkProgramTest, HelpAndVersionEndWithZero)
{
  EXPECT_EQ(runBenchmark({"--help"}).exit_status, 0);
  EXPECT_NE(runBenchmark({"--help"}).output.find("Usage: pcl_symmetry_benchmark DIR"), std::string::npos);
  EXPECT_EQ(runBenchmark({"--version"}).output, "pcl_symmetry_benchmark " PCL_SYMMETRY_VERSION "\n");
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
