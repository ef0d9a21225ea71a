#include "benchmark/run.h"
#include "model/articulated_body.h"
#include "model/write_model.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <algorithm>

namespace pcl {
namespace symmetry {
namespace {

/** The true partners of a sphere: the point with the opposite x. */
std::string
mirrorTruth(const Surface& sphere)
{
  std::string truth;
  for (const Vector3& p : sphere.points) {
    const Vector3 mirrored{-p[0], p[1], p[2]};
    const auto partner = std::find(sphere.points.begin(), sphere.points.end(), mirrored);
    truth += std::to_string(partner - sphere.points.begin() + 1) + "\n";
  }
  return truth;
}

/** A data set of three ellipsoids and a broken file. */
class RunTest : public test::TemporaryFolder {
protected:
  RunTest()
  {
    options_.parameters.method = Method::Staged;
    options_.parameters.threads = 1;
    const Surface sphere = test::sphereMesh(4);
    for (const auto& [name, height] : {std::pair("a", 2.0F), std::pair("b", 3.0F), std::pair("c", 4.0F)}) {
      write(std::string("Made/") + name + "_sym.txt", mirrorTruth(sphere));
      writePlainSurface(path(std::string("Made/") + name + ".off"), test::scaled(sphere, {1.0F, 1.5F, height}));
    }
    write("Made/broken.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n");
    write("Made/broken_sym.txt", "1 2 3\n");
    models_ = findModels(path("Made"));
  }

  std::vector<BenchmarkModel> models_;
  RunOptions options_;
};

TEST_F(RunTest, AFailureIsPartOfTheResultAndTheOthersGoOn)
{
  const std::vector<ModelRun> runs = runModels(models_, options_, 1);
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_EQ(runs[2].model.name, "broken");
  EXPECT_NE(runs[2].failure.find("broken.off"), std::string::npos) << runs[2].failure;
  EXPECT_NE(runs[2].failure.front(), ':') << runs[2].failure;
  EXPECT_FALSE(runs[2].score);
  for (const std::size_t i : {0U, 1U, 3U}) {
    EXPECT_EQ(runs[i].failure, "");
    EXPECT_EQ(runs[i].partners.size(), runs[i].points);
    EXPECT_GT(runs[i].totalSeconds(), 0.0);
    ASSERT_TRUE(runs[i].score);
    EXPECT_GT(runs[i].score->errors.size(), 100U);
  }
}

TEST_F(RunTest, ResultsAndTheirOrderDoNotDependOnTheJobs)
{
  std::vector<std::string> order;
  const auto note = [&order](const ModelRun& run) {
    order.push_back(run.model.name);
  };
  const std::vector<ModelRun> one = runModels(models_, options_, 1);
  const std::vector<ModelRun> three = runModels(models_, options_, 3, note);
  EXPECT_EQ(order, (std::vector<std::string>{"a", "b", "broken", "c"}));
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].model.name, three[i].model.name);
    EXPECT_EQ(one[i].partners, three[i].partners);
    EXPECT_EQ(one[i].confidences, three[i].confidences);
    EXPECT_EQ(one[i].correspondenceRate(), three[i].correspondenceRate());
  }
}

TEST_F(RunTest, ACloudIsScoredOnItsMesh)
{
  options_.as_cloud = true;
  const ModelRun run = runModel(models_[0], options_);
  ASSERT_EQ(run.failure, "");
  EXPECT_GT(run.faces, 0U);
  ASSERT_TRUE(run.score);
  EXPECT_GT(run.score->area, 0.0);
}

TEST_F(RunTest, PointsThatWereDroppedAreNotScored)
{
  const std::size_t all = runModel(models_[0], options_).score->errors.size();
  options_.as_cloud = true;
  options_.disturbance = {0.002, 0.2, 0.02, 9};
  const ModelRun run = runModel(models_[0], options_);
  ASSERT_EQ(run.failure, "");
  EXPECT_EQ(run.partners.size(), run.points);
  EXPECT_LE(run.score->map_size, run.points - run.points / 5);
  EXPECT_LT(run.score->errors.size(), all);
  EXPECT_GT(run.score->errors.size(), all * 6 / 10);
}

TEST_F(RunTest, WhereHolesWereCutOnlyPairsThatAreLeftAreScored)
{
  options_.disturbance.holes = 1;
  options_.disturbance.hole_share = 0.3;
  const ModelRun run = runModel(models_[0], options_);
  ASSERT_EQ(run.failure, "");
  const Surface mesh = readSurface(models_[0].file);
  const std::vector<Index> left = disturb(mesh, options_.disturbance).origins; // ascending: there is nothing else
  const auto is_left = [&left](Index v) {
    return std::binary_search(left.begin(), left.end(), v);
  };
  std::size_t expected = 0;
  for (const TruePartner& pair : subsampleTruth(readGroundTruth(models_[0].truth)))
    expected += is_left(pair.vertex) && is_left(pair.partner) ? 1 : 0;
  EXPECT_EQ(run.score->errors.size(), expected);
  EXPECT_GT(expected, 40U);
}

TEST_F(RunTest, AVariantIsScoredOnTheModelItself)
{
  addVariants(models_, variant_count);
  const ModelRun as_it_is = runModel(models_[0], options_);
  for (std::size_t i = 1; i <= variant_count; ++i) {
    const ModelRun run = runModel(models_[i], options_);
    ASSERT_EQ(run.failure, "") << run.model.name;
    EXPECT_EQ(run.partners.size(), run.points);
    ASSERT_TRUE(run.score);
    EXPECT_EQ(run.score->errors.size(), as_it_is.score->errors.size()) << "whatever became of the vertices";
    EXPECT_EQ(run.score->isRight(), as_it_is.score->isRight()) << run.model.name;
  }
}

TEST_F(RunTest, WithoutALimbThereIsNothingToScore)
{
  ModelParameters parameters;
  parameters.vertices = 1500;
  const Model human = makeModel(parameters);
  std::string truth;
  for (const Index partner : human.partners)
    truth += std::to_string(partner + 1) + "\n";
  write("Human/human_sym.txt", truth); // makes the folder
  writePlainSurface(path("Human/human.off"), human.surface);
  const std::vector<BenchmarkModel> models = findModels(path("Human"));
  ASSERT_EQ(models.size(), 1U);
  options_.cut_limb = Limb::Farthest;
  for (const bool as_cloud : {false, true}) {
    options_.as_cloud = as_cloud;
    const ModelRun run = runModel(models[0], options_);
    EXPECT_EQ(run.failure, "");
    EXPECT_FALSE(run.score);
    EXPECT_EQ(run.partners.size(), human.surface.size());
  }
}

TEST_F(RunTest, AModelWithoutTruthIsRunButNotScored)
{
  models_[0].truth.clear();
  const ModelRun run = runModel(models_[0], options_);
  EXPECT_EQ(run.failure, "");
  EXPECT_FALSE(run.score);
  EXPECT_EQ(run.correspondenceRate(), 0.0);
}

TEST_F(RunTest, ATruthForAnotherModelIsAFailure)
{
  models_[0].truth = write("other.txt", "1 2 999999\n");
  EXPECT_NE(runModel(models_[0], options_).failure.find("other.txt: vertex 999998"), std::string::npos);
}

} // namespace
} // namespace symmetry
} // namespace pcl
