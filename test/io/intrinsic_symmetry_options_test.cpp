// What the options of pcl_intrinsic_symmetry do: parameters in the report, refused combinations, what is said where.
#include "apps/run_program.h"
#include "support/shapes.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

/** \brief A mesh of a handful of points: all but the estimation itself can be tried with it. */
class IntrinsicSymmetryOptions : public testing::Test {
protected:
  IntrinsicSymmetryOptions() : input_(folder_.file("five.off"))
  {
    std::ofstream(input_) << "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 nan 9\n3 0 1 2\n3 0 2 3\n";
  }

  ProgramRun
  run(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), input_);
    return runProgram("pcl_intrinsic_symmetry", arguments);
  }

  nlohmann::json
  report() const
  {
    return nlohmann::json::parse(readBytes(folder_.file("report.json")));
  }

  ScratchFolder folder_;
  std::string input_;
};

TEST_F(IntrinsicSymmetryOptions, TooFewPointsCannotBeComputedButAreReported)
{
  const std::string labelled = folder_.file("labelled.PLY");
  const ProgramRun failed = run({"--report", folder_.file("report.json"), "-o", labelled});
  EXPECT_EQ(failed.exit_status, 1);
  EXPECT_NE(failed.errors.find(input_ + ": too_few_points"), std::string::npos) << failed.errors;
  EXPECT_EQ(report().at("status"), "too_few_points");
  EXPECT_NE(report().at("message"), "");
  EXPECT_EQ(report().at("input").at("file"), input_);
  EXPECT_EQ(report().at("input").at("points"), 5);
  EXPECT_EQ(report().at("input").at("faces"), 2);
  EXPECT_FALSE(std::filesystem::exists(labelled)) << "what an earlier run has found is not replaced by nothing";
}

TEST_F(IntrinsicSymmetryOptions, ParametersReachTheReport)
{
  run({"--report", folder_.file("report.json"),
       "--method", "staged",
       "--metric", "euclidean",
       "--sparse", "-k",
       "17",       "--landmarks",
       "55",       "--samples",
       "200",      "--alternatives",
       "3",        "--radius",
       "0.25",     "--normals",
       "estimate", "--outliers",
       "2.5",      "--pairing",
       "mgd",      "--threads",
       "2",        "--components",
       "largest",  "--label-axis",
       "off",      "--extremities",
       "four",     "--as-cloud"});
  const nlohmann::json parameters = report().at("parameters");
  EXPECT_EQ(parameters.at("method"), "staged");
  EXPECT_EQ(parameters.at("metric"), "euclidean");
  EXPECT_EQ(parameters.at("sparse_only"), true);
  EXPECT_EQ(parameters.at("label_axis"), false);
  EXPECT_EQ(parameters.at("k_search"), 17);
  EXPECT_EQ(parameters.at("staged").at("landmarks"), 55);
  EXPECT_EQ(parameters.at("staged").at("samples"), 200);
  EXPECT_EQ(parameters.at("robust").at("samples"), 1500);
  EXPECT_EQ(parameters.at("alternatives"), 3);
  EXPECT_EQ(parameters.at("radius"), 0.25);
  EXPECT_EQ(parameters.at("normals"), "estimate");
  EXPECT_EQ(parameters.at("outlier_deviations"), 2.5);
  EXPECT_EQ(parameters.at("staged").at("extremities"), "four");
  EXPECT_EQ(parameters.at("staged").at("pairing"), "mgd");
  EXPECT_EQ(parameters.at("components"), "largest");
  EXPECT_EQ(parameters.at("threads"), 2);
  EXPECT_EQ(report().at("input").at("faces"), 0);
}

TEST_F(IntrinsicSymmetryOptions, WrongUsageIsRefusedBeforeAnythingIsWritten)
{
  const std::string output = folder_.file("out.ply");
  const std::vector<std::vector<std::string>> wrong = {{"--radius", "-1"},
                                                       {"--radius", "nan"},
                                                       {"--radius", "1m"},
                                                       {"--outliers", "-1"},
                                                       {"--normals", "none"},
                                                       {"--components", "2"},
                                                       {"--pairing", "both"},
                                                       {"--sparse", "--map", folder_.file("map.csv")},
                                                       {"--extremities", "5"},
                                                       {"--alternatives", "0"},
                                                       {"--samples", "3"},
                                                       {"--threads", "99999"},
                                                       {"--land", "100"},
                                                       {"-k", "10", "-k", "11"},
                                                       {"--axis", folder_.file("axis.obj")},
                                                       {"--picture", folder_.file("picture.jpg")},
                                                       {"--map", ""},
                                                       {"-o", output, "--axis", output},
                                                       {"--map", folder_.file("x"), "--report", folder_.file("./x")},
                                                       {"--samples", "25"},
                                                       {"--sparse", "--like", folder_.file("reference.ply")},
                                                       {"--like", output, "-o", output},
                                                       {"--map", input_}};
  for (const std::vector<std::string>& arguments : wrong) {
    const ProgramRun refused = run(arguments);
    SCOPED_TRACE(arguments.front() + " " + arguments.back() + ": " + refused.errors);
    EXPECT_EQ(refused.exit_status, 2);
    EXPECT_NE(refused.errors.find("--help"), std::string::npos);
    EXPECT_EQ(refused.output, "");
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1); // the input
  EXPECT_EQ(readBytes(input_).substr(0, 4), "OFF\n");
}

TEST_F(IntrinsicSymmetryOptions, QuietSaysNothingButErrors)
{
  const std::string sphere = folder_.file("sphere.ply");
  const Surface surface = sphereMesh(4);
  SymmetryResult none;
  none.partners.assign(surface.size(), no_index);
  none.confidences.assign(surface.size(), 0.0F);
  none.support.assign(surface.size(), 0.0F);
  none.sides.assign(surface.size(), Side::None);
  none.regions.assign(surface.size(), Region::None);
  writeLabelledSurface(sphere, surface, none);
  const ProgramRun loud = runProgram("pcl_intrinsic_symmetry", {sphere});
  EXPECT_EQ(std::count(loud.output.begin(), loud.output.end(), '\n'), 1) << loud.output;
  EXPECT_EQ(loud.errors, ""); // progress is for terminals only
  const ProgramRun quiet = runProgram("pcl_intrinsic_symmetry", {sphere, "--quiet"});
  EXPECT_EQ(quiet.exit_status, loud.exit_status);
  EXPECT_EQ(quiet.output + quiet.errors, "");
  EXPECT_NE(run({"--quiet"}).errors, "");
}

TEST_F(IntrinsicSymmetryOptions, NormalsOfAFileWithoutAnyCannotBeUsed)
{
  const std::string cloud = folder_.file("grid.obj");
  std::ofstream file(cloud);
  for (int i = 0; i < 2000; ++i)
    file << "v " << i % 50 << ' ' << i / 50 << " 0\n";
  file.close();
  const ProgramRun failed = runProgram("pcl_intrinsic_symmetry", {cloud, "--normals", "given"});
  EXPECT_EQ(failed.exit_status, 1);
  EXPECT_NE(failed.errors.find(cloud + ": "), std::string::npos) << failed.errors;
  EXPECT_NE(failed.errors.find("normals"), std::string::npos) << failed.errors;
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
