#include "benchmark/data_set.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

#include <map>
#include <sstream>

namespace pcl {
namespace symmetry {
namespace {

class DataSetTest : public test::TemporaryFolder {
protected:
  void
  writeAll(const std::vector<std::string>& names) const
  {
    for (const std::string& name : names)
      write(name, "");
  }

  /** Folder and file of a truth, relative to the folder of the test. */
  std::string
  relative(std::string truth) const
  {
    const std::string prefix = path("");
    for (std::size_t at = truth.find(prefix); at != std::string::npos; at = truth.find(prefix))
      truth.erase(at, prefix.size());
    return truth;
  }

  /** Set, class, name and truth of every model, as text. */
  std::vector<std::string>
  describe(const std::string& folder) const
  {
    std::vector<std::string> lines;
    for (const BenchmarkModel& model : findModels(path(folder)))
      lines.push_back(model.set + " " + model.class_name + " " + model.name + " " + relative(model.truth));
    return lines;
  }
};

using Lines = std::vector<std::string>;

TEST_F(DataSetTest, FindsAllSetsBelowARoot)
{
  writeAll({"TOSCA/Meshes/cat10.off", "TOSCA/Meshes/cat2.off", "TOSCA/Corrs/cat.pid", "TOSCA/Corrs/cat.sym.info",
            "KIDS/b.off", "KIDS/a.off", "KIDS/sym.txt", "clouds/horse.pcd", "README.md", "notes/readme.txt"});
  EXPECT_EQ(describe(""),
            (Lines{"KIDS kids a KIDS/sym.txt", "KIDS kids b KIDS/sym.txt", "TOSCA cat cat2 TOSCA/Corrs/cat.pid",
                   "TOSCA cat cat10 TOSCA/Corrs/cat.pid", "clouds clouds horse "}));
}

TEST_F(DataSetTest, FindsOneSet)
{
  writeAll({"TOSCA/Meshes/wolf0.OFF", "TOSCA/Corrs/wolf.pid"});
  EXPECT_EQ(describe("TOSCA"), Lines{"TOSCA wolf wolf0 TOSCA/Corrs/wolf.pid"});
  EXPECT_EQ(describe("TOSCA/"), Lines{"TOSCA wolf wolf0 TOSCA/Corrs/wolf.pid"});
}

TEST_F(DataSetTest, NumberedModelsHaveTheirOwnLandmarks)
{
  const std::map<int, std::string> class_names{{1, "human"},        {20, "human"},  {41, "glasses"},    {61, "plane"},
                                               {81, "ant"},         {101, "chair"}, {161, "teddy"},     {201, "plier"},
                                               {221, "fish"},       {241, "bird"},  {281, "armadillo"}, {301, "bust"},
                                               {381, "four-legged"}};
  Lines expected;
  for (const auto& [number, class_name] : class_names) {
    const std::string model = std::to_string(number);
    const int class_number = (number - 1) / 20 + 1;
    writeAll({"SHREC07/Meshes/" + model + ".off", "SHREC07/Corrs/" + model + ".vts"});
    std::ostringstream line;
    line << "SHREC07 " << class_name << ' ' << number << " SHREC07/Corrs/" << number << ".vts:SHREC07/Corrs/"
         << class_number << ".sym.info";
    expected.push_back(line.str());
  }
  EXPECT_EQ(describe("SHREC07"), expected);
}

TEST_F(DataSetTest, TheOnlyLandmarkFileIsForAllModels)
{
  writeAll({"SCAPE/Meshes/mesh000.off", "SCAPE/Meshes/mesh071.ply", "SCAPE/Corrs/scape.pid"});
  EXPECT_EQ(describe("SCAPE"),
            (Lines{"SCAPE scape mesh000 SCAPE/Corrs/scape.pid", "SCAPE scape mesh071 SCAPE/Corrs/scape.pid"}));
}

TEST_F(DataSetTest, AModelMayHaveItsOwnDenseTruth)
{
  writeAll({"TopKids/kid00.off", "TopKids/kid03.off", "TopKids/kid04.off", "TopKids/kid00_sym.txt",
            "TopKids/kid03_sym.txt"});
  EXPECT_EQ(describe(""), (Lines{"TopKids topkids kid00 TopKids/kid00_sym.txt",
                                 "TopKids topkids kid03 TopKids/kid03_sym.txt", "TopKids topkids kid04 "}));
}

TEST_F(DataSetTest, ModelsWithoutLandmarksHaveNoTruth)
{
  writeAll({"TOSCA/Meshes/cat0.off", "TOSCA/Meshes/dragon1.off", "TOSCA/Corrs/cat.pid", "TOSCA/Corrs/dog.pid"});
  EXPECT_EQ(describe(""), (Lines{"TOSCA cat cat0 TOSCA/Corrs/cat.pid", "TOSCA dragon dragon1 "}));
}

TEST_F(DataSetTest, RejectsFoldersWithoutModels)
{
  writeAll({"empty/readme.txt", "file.off"});
  EXPECT_THROW(findModels(path("missing")), pcl::IOException);
  EXPECT_THROW(findModels(path("empty")), pcl::IOException);
  EXPECT_THROW(findModels(path("file.off")), pcl::IOException);
}

} // namespace
} // namespace symmetry
} // namespace pcl
