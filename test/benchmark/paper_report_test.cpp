#include "benchmark/paper_report.h"
#include "benchmark/runs.h"

#include <gtest/gtest.h>

namespace pcl {
namespace symmetry {
namespace {

using test::makeFailedRun;
using test::makeRun;
using test::makeUnscoredRun;

/** Two cats, one of which is half wrong with the staged method, and a lizard. */
PaperRuns
makeRuns()
{
  PaperRuns runs;
  runs.staged = {makeRun("TOSCA", "cat", "cat0", 4), makeRun("TOSCA", "cat", "cat1", 2),
                 makeRun("TOSCA", "lizard", "lizard0", 4)};
  runs.robust = {makeRun("TOSCA", "cat", "cat0", 4), makeRun("TOSCA", "cat", "cat1", 4),
                 makeRun("TOSCA", "lizard", "lizard0", 0)};
  return runs;
}

bool
contains(const std::string& page, const std::string& text)
{
  return page.find(text) != std::string::npos;
}

TEST(PaperReport, PublishedRatesStandBesideOurs)
{
  const std::string page = describePaper(makeRuns(), {}, {});
  EXPECT_TRUE(contains(page, "\n| TOSCA cat (2) | 65/64 | 75.0/50 | 100.0/100 | 96/100 | 66/54 |\n")) << page;
  EXPECT_TRUE(contains(page, "\n| TOSCA lizard (1) |  | 100.0/100 | 0.0/0 |  |  |\n"))
      << "of which nothing is published";
  EXPECT_FALSE(contains(page, "\n| cat |")) << "a row a class";
}

TEST(PaperReport, RowsOfThePaperStandThereAlsoWithoutModels)
{
  const std::string page = describePaper({}, {}, {});
  for (const char* row : {"| victoria | 78/75 |  |  | 96/100 | 83/63 |", "| gorilla | 98/100 |  |  | 100/100 |  |",
                          "| david | 95/100 |  |  | 96/100 | 82/57 |", "| wolf | 97/100 |  |  | 100/100 | 100/100 |",
                          "| cat | 65/64 |  |  | 96/100 | 66/54 |", "| michael | 88/90 |  |  | 97/100 | 87/75 |",
                          "| SCAPE | 81/75 |  |  |  |  |", "| KIDS | 84/88 |  |  |  |  |",
                          "| as published | 12500 | 7 + 23 | |", "| as published | 27000 | 27 + 105 | |"})
    EXPECT_TRUE(contains(page, std::string("\n") + row + "\n")) << row << '\n' << page;
  EXPECT_FALSE(contains(page, "Figure 5")) << "there are no pictures";
}

TEST(PaperReport, ASetThatIsOneClassIsFoundByItsName)
{
  PaperRuns runs;
  runs.staged = {makeRun("scape", "mesh", "mesh000", 4)};
  runs.robust = runs.staged;
  const std::string page = describePaper(runs, {}, {});
  EXPECT_TRUE(contains(page, "\n| scape mesh (1) | 81/75 | 100.0/100 | 100.0/100 |  |  |\n")) << page;
}

TEST(PaperReport, SecondsAreSplitAtTheDenseMap)
{
  PaperRuns runs = makeRuns();
  runs.staged[1].seconds = {{"graph", 0.5}, {"matching", 0.5}, {"dense", 2.0}, {"axis", 1.0}};
  const std::string page = describePaper(runs, {}, {});
  EXPECT_TRUE(contains(page, "\n| TOSCA cat (2) | 4 | 0.75 + 2.00 | 1.50 |\n")) << page;
}

TEST(PaperReport, FailedRunsCountAndAreNamed)
{
  PaperRuns runs = makeRuns();
  runs.staged[1] = makeFailedRun("TOSCA", "cat", "cat_1");
  const std::string page = describePaper(runs, {}, {});
  EXPECT_TRUE(contains(page, "| TOSCA cat (2) | 65/64 | 50.0/50 | 100.0/100 |")) << page;
  EXPECT_TRUE(contains(page, "\n- TOSCA/cat\\_1, staged, failed: cat\\_1.off: \"broken\", truncated\n")) << page;
}

TEST(PaperReport, RunsWithoutGroundTruthAreNoPartOfTheMeans)
{
  PaperRuns runs = makeRuns();
  ModelRun unscored = makeUnscoredRun("TOSCA", "cat9");
  unscored.model.class_name = "cat";
  unscored.points = 4000;
  runs.staged.push_back(unscored);
  runs.robust.push_back(unscored);
  EXPECT_TRUE(contains(describePaper(runs, {}, {}), "\n| TOSCA cat (2) | 4 | 0.50 + 1.00 | 1.50 |\n"));
}

TEST(PaperReport, PicturesAreLinkedAndMissingMapsSaid)
{
  const PaperRuns runs = makeRuns();
  const std::vector<PaperPicture> pictures = {
      {runs.staged[0].model, Method::Staged, SymmetryStatus::NoSymmetry, "", ""},
      {runs.robust[0].model, Method::Robust, SymmetryStatus::Symmetric, "cat0.png", "cat0_colours.png"}};
  const std::string page = describePaper(runs, {}, pictures);
  EXPECT_TRUE(contains(page, "\nTOSCA/cat0, staged: no map (no\\_symmetry)\n")) << page;
  const std::size_t colours = page.find("![TOSCA/cat0, robust](cat0_colours.png)");
  const std::size_t matches = page.find("![TOSCA/cat0, robust](cat0.png)");
  ASSERT_NE(colours, std::string::npos) << page;
  ASSERT_NE(matches, std::string::npos) << page;
  EXPECT_LT(page.find("## Figure 5"), colours);
  EXPECT_LT(colours, page.find("## Figures 6 to 9"));
  EXPECT_LT(page.find("## Figures 6 to 9"), matches);
}

TEST(PaperReport, ParametersAreNamed)
{
  SymmetryParameters parameters;
  EXPECT_TRUE(contains(describePaper({}, parameters, {}),
                       "metric geodesic, extremities nine, landmarks 100, samples 100 (staged) and 1500 (robust)."));
  parameters.staged.extremities = ExtremePoints::FirstFour;
  parameters.robust.samples = 1000;
  EXPECT_TRUE(contains(describePaper({}, parameters, {}),
                       "extremities four, landmarks 100, samples 100 (staged) and 1000 (robust)."));
}

TEST(PaperReport, ANameDoesNotBreakATable)
{
  PaperRuns runs;
  runs.staged = {makeRun("a|b", "<c>", "x", 4)};
  runs.robust = runs.staged;
  EXPECT_TRUE(contains(describePaper(runs, {}, {}), "\n| a\\|b \\<c> (1) |"));
}

} // namespace
} // namespace symmetry
} // namespace pcl
