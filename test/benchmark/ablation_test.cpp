#include "benchmark/ablation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace pcl {
namespace symmetry {
namespace {

AblationRun
makeRun(const std::string& class_name, double rate, double seconds)
{
  AblationRun run;
  run.model.set = "Made";
  run.model.class_name = class_name;
  run.rate = rate;
  run.seconds = seconds;
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
  // Two cats, of which the second is slow, and a dog.
  const std::vector<AblationRun> whole{makeRun("cat", 1.0, 2.0), makeRun("cat", 0.5, 8.0), makeRun("dog", 1.0, 1.0)};
  const std::vector<AblationRun> less{makeRun("cat", 0.5, 1.0), makeRun("cat", 0.5, 4.0), makeRun("dog", 0.8, 1.0)};
  std::ostringstream out;
  printAblations(out, {whole, less});
  const std::string table = out.str();
  EXPECT_NE(table.find("Made"), std::string::npos);
  EXPECT_NE(table.find("87.5 / 75.0    1.00"), std::string::npos) << table;
  EXPECT_NE(table.find("65.0 / 50.0    0.50"), std::string::npos) << table;
}

TEST(Ablations, WithoutModelsThereIsATableWithoutSets)
{
  std::ostringstream out;
  printAblations(out, std::vector<std::vector<AblationRun>>(ablations().size()));
  EXPECT_NE(out.str().find("whole method"), std::string::npos);
}

} // namespace
} // namespace symmetry
} // namespace pcl
