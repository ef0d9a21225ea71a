#include "io/sample_result.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using Report = TemporaryFolder;
using Json = nlohmann::ordered_json;

TEST_F(Report, HoldsWhatWasFound)
{
  writeReport(path("report.json"), "some file.ply", {}, roofSymmetry());
  const Json report = Json::parse(read(path("report.json")));
  EXPECT_EQ(report.at("status"), "symmetric");
  EXPECT_EQ(report.at("message"), "");
  EXPECT_EQ(report.at("confidence"), 0.9); // not 0.8999999761581421
  EXPECT_EQ(report.at("diameter"), 3.5);
  EXPECT_EQ(report.at("matches"), 2);
  const Json& input = report.at("input");
  EXPECT_EQ(input.at("file"), "some file.ply");
  EXPECT_TRUE(input.at("notes").empty());
  EXPECT_EQ(input.at("points"), 6);
  EXPECT_EQ(input.at("faces"), 4);
  EXPECT_EQ(input.at("used"), 5);
  EXPECT_EQ(input.at("dropped"), 1);
  EXPECT_EQ(input.at("non_finite"), 1);
  EXPECT_EQ(input.at("components"), 1);
  const Json& map = report.at("map");
  EXPECT_EQ(map.at("matched"), 5);
  EXPECT_EQ(map.at("axis"), 2);
  EXPECT_EQ(map.at("axis_curves"), 1);
  EXPECT_EQ(map.at("involution"), 1.0);
  EXPECT_FALSE(report.contains("alternatives"));
  EXPECT_TRUE(report.at("version").is_string());
}

TEST_F(Report, StepsAreInOrderAndSumUpToTheTotal)
{
  SymmetryResult result = roofSymmetry();
  result.seconds = {{"read", 0.1}, {"graph", 0.2}, {"axis", 1e-7}, {"write", 0.3000004}};
  writeReport(path("report.json"), "a.ply", {}, result);
  const Json seconds = Json::parse(read(path("report.json"))).at("seconds");
  std::vector<std::string> names;
  double sum = 0.0;
  for (const auto& [name, value] : seconds.items()) {
    names.push_back(name);
    sum += name == "total" ? 0.0 : value.get<double>();
  }
  EXPECT_EQ(names, (std::vector<std::string>{"read", "graph", "axis", "write", "total"}));
  EXPECT_NEAR(seconds.at("total").get<double>(), sum, 1e-9);
  EXPECT_NEAR(sum, 0.6, 1e-5);
}

TEST_F(Report, HasTheMirrorPlaneWhereThereIsOne)
{
  SymmetryResult result = roofSymmetry();
  writeReport(path("report.json"), "a.ply", {}, result);
  EXPECT_FALSE(Json::parse(read(path("report.json"))).contains("mirror_plane"));
  result.plane.normal = {0.0, 1.0, 0.0};
  result.plane.offset = 2.5;
  result.plane.rms = 0.25;
  result.plane.to_x = {{{0, 1, 0, -2.5}, {-1, 0, 0, 0}, {0, 0, 1, 0}}};
  writeReport(path("report.json"), "a.ply", {}, result);
  const Json expected = {{"normal", {0.0, 1.0, 0.0}},
                         {"offset", 2.5},
                         {"rms", 0.25},
                         {"to_x", {{0.0, 1.0, 0.0, -2.5}, {-1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}}}};
  EXPECT_EQ(Json::parse(read(path("report.json"))).at("mirror_plane"), expected);
}

TEST_F(Report, NamesAllParameters)
{
  SymmetryParameters parameters;
  parameters.method = Method::Staged;
  parameters.metric = Metric::Euclidean;
  parameters.normals = NormalSource::Given;
  parameters.staged.pairing = PairingFeature::BySurfaceSize;
  parameters.components = ComponentUse::Largest;
  parameters.radius = 0.1F;
  parameters.label_axis = false;
  parameters.threads = 2;
  writeReport(path("report.json"), "a.ply", parameters, roofSymmetry());
  const Json written = Json::parse(read(path("report.json"))).at("parameters");
  const Json expected = {{"method", "staged"},
                         {"robust", {{"samples", 1500}}},
                         {"staged",
                          {{"landmarks", 100},
                           {"samples", 100},
                           {"embedding_dimensions", 3},
                           {"extremities", "nine"},
                           {"pairing", "size"}}},
                         {"metric", "euclidean"},
                         {"k_search", 10},
                         {"radius", 0.1},
                         {"normals", "given"},
                         {"components", "largest"},
                         {"outlier_deviations", 0.0},
                         {"sparse_only", false},
                         {"label_axis", false},
                         {"alternatives", 1},
                         {"threads", 2}};
  EXPECT_EQ(written, expected);
}

TEST_F(Report, ListsAlternativesAndRotationsApartWhereThereAreSeveral)
{
  SymmetryResult result = roofSymmetry();
  result.alternatives = {{{}, -1.5F, 0.9F, true}, {{}, 2.0F, 0.25F, true}};
  result.rotations = {{{}, 1.0F, 0.5F, false}};
  writeReport(path("report.json"), "a.ply", {}, result);
  const Json report = Json::parse(read(path("report.json")));
  ASSERT_EQ(report.at("alternatives").size(), 2U);
  EXPECT_EQ(report["alternatives"][1], Json({{"score", 2.0}, {"confidence", 0.25}, {"reverses_orientation", true}}));
  ASSERT_EQ(report.at("rotations").size(), 1U);
  EXPECT_EQ(report["rotations"][0], Json({{"score", 1.0}, {"confidence", 0.5}, {"reverses_orientation", false}}));
}

TEST_F(Report, IsJsonWhateverTheNumbersAndNames)
{
  SymmetryResult result = roofSymmetry();
  result.diameter = std::numeric_limits<float>::infinity();
  result.map.involution = std::numeric_limits<float>::quiet_NaN();
  result.input.notes = {"line 3: \"passed over\""};
  result.input.used = 7; // more than the points: dropped must not wrap round
  writeReport(path("report.json"), "quote \" and \xFF", {}, result);
  const Json report = Json::parse(read(path("report.json")));
  EXPECT_TRUE(report.at("diameter").is_null());
  EXPECT_TRUE(report.at("map").at("involution").is_null());
  EXPECT_EQ(report.at("input").at("dropped"), 0);
  EXPECT_EQ(report.at("input").at("notes").at(0), "line 3: \"passed over\"");
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
