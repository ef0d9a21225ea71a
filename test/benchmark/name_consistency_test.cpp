#include "benchmark/name_consistency.h"
#include "model/articulated_body.h"
#include "model/write_model.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

#include <sstream>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

class NameConsistency : public TemporaryFolder {
protected:
  /** \brief A human in a pose, with the file of its sides. \param[in] left what its left is called */
  BenchmarkModel
  human(const std::string& name, double bend, const std::string& class_name, int left) const
  {
    ModelParameters parameters;
    parameters.vertices = 3000;
    parameters.bend = bend;
    writePlainSurface(path(name + ".off"), makeModel(parameters).surface);
    parameters.bend = 0.0;
    std::string sides;
    for (const Vector3& p : makeModel(parameters).surface.points)
      sides += std::to_string(p[0] > 0.01F ? left : p[0] < -0.01F ? 3 - left : 3) + "\n";
    write(name + "_side.txt", sides);
    BenchmarkModel model;
    model.file = path(name + ".off");
    model.name = name;
    model.set = "set";
    model.class_name = class_name;
    return model;
  }
};

TEST_F(NameConsistency, CountsPairsWhoseNamesAreKept)
{
  const std::vector<BenchmarkModel> models = {human("a", 0.3, "one", 1), human("b", 1.0, "one", 1),
                                              human("c", 0.6, "two", 2)};
  const auto fail = [](const NamedModel& model) {
    ADD_FAILURE() << model.failure;
  };
  const std::vector<NamePairs> rows = compareAllNames(models, RunOptions{}, {"two"}, 1, fail);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].pairs, 1U);
  EXPECT_EQ(rows[1].pairs, 2U);
  for (const NamePairs& row : rows) {
    EXPECT_EQ(row.by_shape, row.pairs);
    EXPECT_EQ(row.by_reference, row.pairs);
  }
  // With the other names of class two its pairs are wrong.
  EXPECT_EQ(compareAllNames(models, RunOptions{}, {}, 1, fail)[1].by_reference, 0U);
}

TEST_F(NameConsistency, PrintsSumsWithinAndAcrossClasses)
{
  std::ostringstream out;
  printNames(out, {{"set/a", "set/a", 4, 3, 4, 0}, {"set/a", "set/b", 2, 0, 1, 2}});
  const std::string text = out.str();
  EXPECT_NE(text.find("within classes                                        4      75.0      100.0       0.0"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("across classes                                        2       0.0       50.0     100.0"),
            std::string::npos)
      << text;
}

TEST_F(NameConsistency, TruthIsFoundAndReadStrictly)
{
  BenchmarkModel model;
  model.name = "body";
  model.file = path("body.off");
  EXPECT_EQ(findSideTruth(model), "");
  write("side.txt", "1 2\n3 0\n");
  EXPECT_EQ(findSideTruth(model), path("side.txt"));
  const std::vector<Side> sides = {Side::Source, Side::Target, Side::Axis, Side::None};
  EXPECT_EQ(readSideTruth(path("side.txt"), 4), sides);
  EXPECT_THROW(readSideTruth(path("side.txt"), 5), IOException);
  write("side.txt", "1 2 4\n");
  EXPECT_THROW(readSideTruth(path("side.txt"), 3), IOException);
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
