#include "benchmark/error_curve_plot.h"
#include "benchmark/report_files.h"
#include "benchmark/report_table.h"
#include "benchmark/runs.h"
#include "support/temporary_folder.h"

#include <nlohmann/json.hpp>
#include <pcl/exceptions.h>

namespace pcl {
namespace symmetry {
namespace {

using nlohmann::json;

std::vector<ModelRun>
makeRuns()
{
  std::vector<ModelRun> runs{test::makeRun("TOSCA", "cat", "cat0", 4), test::makeRun("TOSCA", "dog", "dog0", 2),
                             test::makeFailedRun("KIDS", "kids", "a"), test::makeUnscoredRun("clouds", "horse")};
  runs[1].seconds.emplace_back("axis", 0.25);
  return runs;
}

std::vector<std::string>
split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
    parts.push_back(part);
  return parts;
}

class ReportTest : public test::TemporaryFolder {};

TEST_F(ReportTest, RefusalsAreCountedPerSet)
{
  std::vector<ModelRun> runs{test::makeUnscoredRun("A", "x"), test::makeUnscoredRun("A", "x"),
                             test::makeUnscoredRun("A", "x"), test::makeUnscoredRun("B", "x"),
                             test::makeFailedRun("B", "x", "a")};
  for (ModelRun& run : runs)
    run.status = SymmetryStatus::Symmetric;
  runs[0].status = SymmetryStatus::NoSymmetry;
  runs[1].confidence = 0.4F;
  runs[2].confidence = 0.5F;
  runs[3].status = SymmetryStatus::PartlySymmetric;
  runs[3].odd_part = OddPartAccuracy{0.1, 0.15, 0.98};
  std::ostringstream out;
  printRefusals(out, runs);
  std::vector<std::string> lines = split(out.str(), '\n');
  ASSERT_EQ(lines.size(), 3U);
  const auto figures = [](const std::string& line) {
    std::istringstream stream(line.substr(1));
    std::vector<int> numbers;
    for (int number = 0; stream >> number;)
      numbers.push_back(number);
    return numbers;
  };
  EXPECT_EQ(figures(lines[1]), (std::vector<int>{3, 1, 0, 1, 1}));
  EXPECT_EQ(figures(lines[2]), (std::vector<int>{1, 0, 1, 0, 0, 1})) << "a failure is no answer";
  EXPECT_NE(lines[2].find(" 1.50    98.0"), std::string::npos) << lines[2];
}

TEST_F(ReportTest, JsonHoldsModelsGroupsCurvesAndConfidence)
{
  RunOptions options;
  options.as_cloud = true;
  options.disturbance.noise = 0.005;
  writeJsonReport(path("report.json"), makeRuns(), options);
  const json report = json::parse(read(path("report.json")));
  EXPECT_EQ(report["parameters"]["as_cloud"], true);
  EXPECT_EQ(report["parameters"]["noise"], 0.005);
  ASSERT_EQ(report["models"].size(), 4U);
  EXPECT_EQ(report["models"][0]["status"], "symmetric");
  EXPECT_EQ(report["models"][0]["correspondence_rate"], 1.0);
  EXPECT_EQ(report["models"][1]["seconds"]["axis"], 0.25);
  EXPECT_EQ(report["models"][1]["seconds"]["total"], 1.75);
  EXPECT_EQ(report["models"][1]["below_0.20"], 0.5);
  EXPECT_EQ(report["models"][2]["status"], "failed");
  EXPECT_EQ(report["models"][2]["correspondence_rate"], 0.0);
  EXPECT_EQ(report["models"][2]["message"], "a.off: \"broken\", truncated");
  EXPECT_TRUE(report["models"][3]["correspondence_rate"].is_null()) << "not scored";
  EXPECT_EQ(report["classes"].size(), 3U);
  EXPECT_EQ(report["sets"][0]["correspondence_rate"], 0.75);
  EXPECT_EQ(report["curves"][0]["shares"].size(), report["curves"][0]["thresholds"].size());
  EXPECT_EQ(report["confidence"]["all_runs"]["area_under_roc"], 1.0);
  EXPECT_EQ(report["confidence"]["delivered_maps"]["maps"], 2);
  EXPECT_EQ(report["confidence"]["vertices"].back()["accuracy"], 0.75);
}

TEST_F(ReportTest, CsvHasOneLinePerModelAndAColumnPerStep)
{
  std::vector<ModelRun> runs = makeRuns();
  runs.erase(runs.begin() + 2); // its message holds a comma
  writeCsvReport(path("report.csv"), runs);
  const std::vector<std::string> lines = split(read(path("report.csv")), '\n');
  ASSERT_EQ(lines.size(), 4U);
  const std::vector<std::string> columns = split(lines[0], ',');
  const auto value = [&](std::size_t line, const std::string& column) {
    const auto found = std::find(columns.begin(), columns.end(), column);
    return split(lines[line], ',').at(static_cast<std::size_t>(found - columns.begin()));
  };
  EXPECT_EQ(value(1, "model"), "cat0");
  EXPECT_EQ(value(1, "correspondence_rate"), "1.0");
  EXPECT_EQ(value(1, "seconds_axis"), "") << "a step that this model did not have";
  EXPECT_EQ(value(2, "seconds_axis"), "0.25");
  EXPECT_EQ(value(2, "seconds_total"), "1.75");
  EXPECT_EQ(value(3, "correspondence_rate"), "");
}

TEST_F(ReportTest, CsvQuotesTextThatWouldBreakTheTable)
{
  writeCsvReport(path("report.csv"), {test::makeFailedRun("KIDS", "kids", "a")});
  EXPECT_NE(read(path("report.csv")).find(",\"a.off: \"\"broken\"\", truncated\","), std::string::npos);
}

TEST_F(ReportTest, FilesAppearWholeOrNotAtAll)
{
  EXPECT_THROW(writeCsvReport(path("missing/report.csv"), makeRuns()), pcl::IOException);
  write("taken/file", "");
  EXPECT_THROW(writeErrorCurves(path("taken"), {}), pcl::IOException) << "a folder is in the way";
  std::size_t entries = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path(""))) {
    EXPECT_EQ(entry.path().filename(), "taken") << "left behind";
    ++entries;
  }
  EXPECT_EQ(entries, 1U);
}

TEST(ErrorCurvePlotTest, DrawsALabelledLinePerCurve)
{
  const std::string svg = drawErrorCurves({{"A & B", {0.0, 0.25}, {0.0, 1.0}}, {"C", {0.0, 0.25}, {0.5, 0.5}}});
  // The plot area is 70 to 550 wide and 30 to 420 high.
  EXPECT_NE(svg.find("points='70.0,420.0 550.0,30.0'"), std::string::npos) << svg;
  EXPECT_NE(svg.find("points='70.0,225.0 550.0,225.0'"), std::string::npos) << svg;
  EXPECT_NE(svg.find(">A &amp; B</text>"), std::string::npos);
  EXPECT_NE(svg.find(">0.25</text>"), std::string::npos) << "end of the axis";
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
}

TEST(ReportTableTest, ShowsFailuresAndWhatWasNotScored)
{
  std::ostringstream out;
  for (const ModelRun& run : makeRuns())
    printModel(out, run, false);
  const std::vector<std::string> lines = split(out.str(), '\n');
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_NE(lines[0].find("TOSCA/cat0"), std::string::npos);
  EXPECT_NE(lines[0].find("100.0  0.0000        4/4"), std::string::npos) << lines[0];
  EXPECT_NE(lines[1].find(" 50.0  0.1000        4/4"), std::string::npos) << lines[1];
  EXPECT_NE(lines[2].find("failed: a.off"), std::string::npos);
  EXPECT_NE(lines[3].find("-       -          -"), std::string::npos) << lines[3];
}

TEST(ReportTableTest, VerboseAddsStepsAndMessage)
{
  ModelRun run = test::makeRun("KIDS", "kids", "a", 4);
  run.message = "a note";
  std::ostringstream out;
  printModel(out, run, true);
  EXPECT_NE(out.str().find("graph 0.500, dense 1.000, total 1.500"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("message: a note"), std::string::npos);
}

TEST(ReportTableTest, SummariesShowClassesThenTheirSet)
{
  const std::vector<GroupSummary> classes = summariseClasses(makeRuns());
  std::ostringstream out;
  printSummaries(out, classes, summariseSets(classes));
  const std::vector<std::string> lines = split(out.str(), '\n');
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_NE(lines[3].find("TOSCA (mean of classes)           2    75.0    50.0   0.0500"), std::string::npos)
      << lines[3];
  EXPECT_NE(lines[5].find("1 failed"), std::string::npos);
}

} // namespace
} // namespace symmetry
} // namespace pcl
