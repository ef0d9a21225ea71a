#include "benchmark/ablation.h"
#include "benchmark/runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace pcl {
namespace symmetry {
namespace {

using test::makeFailedRun;
using test::makeRun;

/** A run of a cat or dog of which so many of four vertices are right. */
ModelRun
timedRun(const std::string& class_name, int right_vertices, double seconds)
{
  ModelRun run = makeRun("Made", class_name, class_name + "0", right_vertices);
  run.seconds = {{"estimation", seconds}};
  return run;
}

TEST(Ablations, BeginWithTheWholeMethodAndHaveNamesOfTheirOwn)
{
  const std::vector<Ablation> changes = ablations();
  std::set<std::string> names;
  for (const Ablation& change : changes) {
    names.insert(change.name);
  }
  EXPECT_EQ(names.size(), changes.size());
  EXPECT_EQ(changes.front().settings.contenders, RobustSettings{}.contenders);
  EXPECT_TRUE(std::any_of(changes.begin(), changes.end(),
                          [](const Ablation& change) { return !change.settings.search.sign_patterns; }));
}

TEST(Ablations, ClassesCountAlikeAndTimesAreRelative)
{
  // Two cats, of which the second is slow, and a dog; a rate of 75 % is not right.
  const std::vector<ModelRun> whole{timedRun("cat", 4, 2.0), timedRun("cat", 2, 8.0), timedRun("dog", 4, 1.0)};
  const std::vector<ModelRun> less{timedRun("cat", 2, 1.0), timedRun("cat", 2, 4.0), timedRun("dog", 3, 1.0)};
  std::ostringstream out;
  printAblations(out, {whole, less});
  const std::string table = out.str();
  EXPECT_NE(table.find("Made"), std::string::npos);
  EXPECT_NE(table.find("87.5 / 75.0    1.00"), std::string::npos) << table;
  EXPECT_NE(table.find("62.5 /  0.0    0.50"), std::string::npos) << table;
}

TEST(Ablations, AFailureCountsAsWrongAndHasNoTime)
{
  const std::vector<ModelRun> runs{timedRun("cat", 4, 2.0), makeFailedRun("Made", "cat", "cat1")};
  std::ostringstream out;
  printAblations(out, {runs});
  EXPECT_NE(out.str().find("50.0 / 50.0    1.00"), std::string::npos) << out.str();
}

TEST(Ablations, WithoutModelsThereIsATableWithoutSets)
{
  std::ostringstream out;
  printAblations(out, std::vector<std::vector<ModelRun>>(ablations().size()));
  EXPECT_NE(out.str().find("whole method"), std::string::npos);
}

} // namespace
} // namespace symmetry
} // namespace pcl
