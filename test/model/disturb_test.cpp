#include "base/vector_math.h"
#include "mesh_checks.h"
#include "model/disturb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

std::size_t
index(Index vertex)
{
  return static_cast<std::size_t>(vertex);
}

const Model&
human()
{
  static const Model model = [] {
    ModelParameters parameters;
    parameters.vertices = 4000;
    parameters.bend = 0.0;
    return makeModel(parameters);
  }();
  return model;
}

/** \brief The rest pose shows the truth: partners are mirror images. Points without a partner are counted. */
std::size_t
checkTruth(const Model& model)
{
  EXPECT_EQ(model.partners.size(), model.surface.size());
  std::size_t without = 0;
  for (std::size_t v = 0; v < model.partners.size(); ++v) {
    if (model.partners[v] == no_index) {
      ++without;
      continue;
    }
    const Vector3& here = model.surface.points[v];
    EXPECT_EQ(model.surface.points[index(model.partners[v])], (Vector3{-here[0], here[1], here[2]}));
    EXPECT_EQ(model.partners[index(model.partners[v])], static_cast<Index>(v));
  }
  return without;
}

void
expectSame(const Model& a, const Model& b)
{
  EXPECT_EQ(a.surface.points, b.surface.points);
  EXPECT_EQ(a.surface.triangles, b.surface.triangles);
  EXPECT_EQ(a.partners, b.partners);
}

TEST(AddNoise, HasTheStandardDeviationThatWasAskedFor)
{
  Model model = human();
  addNoise(model, 0.01, 3);
  double low[3];
  double high[3];
  double squared_diagonal = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    low[k] = 1e9;
    high[k] = -1e9;
    for (const Vector3& p : human().surface.points) {
      low[k] = std::min(low[k], static_cast<double>(p[k]));
      high[k] = std::max(high[k], static_cast<double>(p[k]));
    }
    squared_diagonal += (high[k] - low[k]) * (high[k] - low[k]);
  }
  double squares = 0.0;
  double sums[3] = {0, 0, 0};
  const auto n = static_cast<double>(model.surface.size());
  for (std::size_t v = 0; v < model.surface.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto moved = static_cast<double>(model.surface.points[v][k] - human().surface.points[v][k]);
      squares += moved * moved;
      sums[k] += moved / n;
    }
  const double deviation = 0.01 * std::sqrt(squared_diagonal);
  EXPECT_NEAR(std::sqrt(squares / n), deviation, 0.04 * deviation);
  for (const double mean : sums)
    EXPECT_NEAR(mean, 0.0, 0.04 * deviation);
  EXPECT_EQ(model.surface.triangles, human().surface.triangles);
  EXPECT_EQ(model.partners, human().partners);
}

TEST(CutHoles, LeavesAMeshWithHolesAndTheTruthOfTheRest)
{
  Model model = human();
  cutHoles(model, 4, 0.1, 6);
  const Topology topology = topologyOf(model.surface.size(), model.surface.triangles);
  EXPECT_GT(topology.boundary_edges, 30U);
  const double left = static_cast<double>(model.surface.size()) / static_cast<double>(human().surface.size());
  EXPECT_GT(left, 0.88); // a few more go than the share: those that no triangle holds any longer
  EXPECT_LT(left, 0.98); // holes may overlap
  std::set<Index> used;
  for (const Triangle& t : model.surface.triangles)
    used.insert(t.begin(), t.end());
  EXPECT_EQ(used.size(), model.surface.size());
  const std::size_t gone = human().surface.size() - model.surface.size();
  const std::size_t without = checkTruth(model);
  EXPECT_GT(without, 0U);
  EXPECT_LE(without, gone);
}

TEST(CutHoles, WorksOnCloudsAndCanDoNothing)
{
  Model model = human();
  dropFaces(model);
  cutHoles(model, 1, 0.2, 6);
  EXPECT_EQ(model.surface.size(), human().surface.size() - human().surface.size() / 5);
  checkTruth(model);
  Model untouched = human();
  cutHoles(untouched, 0, 0.2, 6);
  expectSame(untouched, human());
}

TEST(ThinOut, DropsPointsOnOneSideAndAllFaces)
{
  Model model = human();
  thinOut(model, 10.0, 2);
  EXPECT_FALSE(model.surface.hasFaces());
  const double left = static_cast<double>(model.surface.size()) / static_cast<double>(human().surface.size());
  EXPECT_GT(left, 0.15);
  EXPECT_LT(left, 0.75);
  EXPECT_GT(checkTruth(model), 0U);
  Model whole = human();
  thinOut(whole, 1.0, 2);
  EXPECT_EQ(whole.surface.points, human().surface.points);
}

TEST(DropPoints, DropsTheShareExactly)
{
  Model model = human();
  dropPoints(model, 0.25, 2);
  EXPECT_EQ(model.surface.size(), human().surface.size() - human().surface.size() / 4);
  EXPECT_FALSE(model.surface.hasFaces());
  EXPECT_GT(checkTruth(model), 0U);
}

TEST(ShuffleVertices, KeepsShapeAndTruth)
{
  Model model = human();
  shuffleVertices(model, 4);
  EXPECT_NE(model.surface.points, human().surface.points);
  EXPECT_EQ(checkTruth(model), 0U);
  std::vector<Vector3> points = model.surface.points;
  std::vector<Vector3> before = human().surface.points;
  std::sort(points.begin(), points.end());
  std::sort(before.begin(), before.end());
  EXPECT_EQ(points, before);
  EXPECT_NEAR(volumeOf(toMesh(model.surface)), volumeOf(toMesh(human().surface)), 1e-9);
  EXPECT_EQ(topologyOf(model.surface.size(), model.surface.triangles).euler, 2);
}

TEST(AddOutliers, AppendsPointsWithoutPartner)
{
  Model model = human();
  addOutliers(model, 0.05, 4);
  const std::size_t before = human().surface.size();
  ASSERT_EQ(model.surface.size(), before + before / 20);
  EXPECT_TRUE(std::equal(human().surface.points.begin(), human().surface.points.end(), model.surface.points.begin()));
  EXPECT_EQ(checkTruth(model), before / 20);
}

TEST(Quantise, RoundsToMultiplesOfTheStep)
{
  Model model;
  model.surface.points = {{0, 0, 0}, {3, 4, 0}, {1.2F, 1.3F, -0.1F}};
  model.partners = {0, 1, 2};
  quantise(model, 0.1); // the diagonal is 5 and a little more
  const double step = 0.1 * std::sqrt(25.01);
  EXPECT_NEAR(model.surface.points[2][0], 2.0 * step, 1e-6);
  EXPECT_NEAR(model.surface.points[2][1], 3.0 * step, 1e-6);
  EXPECT_EQ(model.surface.points[2][2], 0.0F);
  EXPECT_NEAR(model.surface.points[1][0], 6.0 * step, 1e-6);
  Model whole = human();
  quantise(whole, 0.0);
  expectSame(whole, human());
}

/** A thin rod, as a limb is: bent, its ends come nearer to each other, but it stays as long. */
TEST(Bend, KeepsTheLengthOfWhatIsThin)
{
  constexpr std::size_t count = 1001;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Model rod;
    for (std::size_t i = 0; i < count; ++i)
      rod.surface.points.push_back({7.0F, 0.01F * static_cast<float>(i), -2.0F}); // ten long
    rod.partners.assign(count, no_index);
    bend(rod, 1.5, seed);
    const std::vector<Vector3>& points = rod.surface.points;
    double length = 0.0;
    for (std::size_t i = 1; i < count; ++i)
      length += double{distance(points[i - 1], points[i])};
    EXPECT_NEAR(length, 10.0, 1.0) << seed;
    EXPECT_LT(distance(points.front(), points.back()), 0.999 * length) << seed;
    EXPECT_LT(distance(points[count / 2], {7.0F, 5.0F, -2.0F}), 1e-4F) << "the centre stays";
  }
}

TEST(Bend, LeavesNoNormalsAndCanDoNothing)
{
  Model model = human();
  bend(model, 0.0, 1);
  expectSame(model, human());
  model.surface.normals.assign(model.surface.size(), {0, 0, 1});
  bend(model, 0.3, 1);
  EXPECT_TRUE(model.surface.normals.empty());
  EXPECT_EQ(model.surface.triangles, human().surface.triangles);
  EXPECT_NE(model.surface.points, human().surface.points);
}

TEST(RepeatPoints, AppendsCopiesAndTellsOfWhich)
{
  Model model = human();
  const std::vector<Index> originals = repeatPoints(model, 0.25, 4);
  const std::size_t before = human().surface.size();
  ASSERT_EQ(originals.size(), before / 4);
  ASSERT_EQ(model.surface.size(), before + before / 4);
  for (std::size_t i = 0; i < originals.size(); ++i)
    EXPECT_EQ(model.surface.points[before + i], human().surface.points[index(originals[i])]);
  EXPECT_GT(std::set<Index>(originals.begin(), originals.end()).size(), before / 5) << "drawn from all points";
  EXPECT_EQ(checkTruth(model), before / 4);
}

TEST(KeepVertices, RenumbersTrianglesAndPartners)
{
  Model model;
  model.surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}};
  model.surface.normals = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  model.surface.triangles = {{0, 1, 2}, {0, 2, 3}};
  model.partners = {0, 3, 2, 1};
  keepVertices(model, {1, 0, 1, 1});
  EXPECT_EQ(model.surface.points, (std::vector<Vector3>{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}));
  EXPECT_EQ(model.surface.normals, (std::vector<Vector3>{{0, 0, 1}, {1, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(model.surface.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_EQ(model.partners, (std::vector<Index>{0, 1, no_index}));
}

TEST(Disturb, SameSeedGivesTheSameBytes)
{
  const auto all = [](std::uint64_t seed) {
    Model model = human();
    cutHoles(model, 3, 0.1, seed);
    addNoise(model, 0.005, seed);
    bend(model, 0.5, seed);
    addOutliers(model, 0.02, seed);
    shuffleVertices(model, seed);
    return model;
  };
  expectSame(all(5), all(5));
  EXPECT_NE(all(5).surface.points, all(6).surface.points);
}

TEST(Disturb, RejectsWhatIsOutOfRange)
{
  Model model = human();
  EXPECT_THROW(addNoise(model, -0.1, 1), std::invalid_argument);
  EXPECT_THROW(addNoise(model, std::nan(""), 1), std::invalid_argument);
  EXPECT_THROW(cutHoles(model, 2, 0.95, 1), std::invalid_argument);
  EXPECT_THROW(thinOut(model, 0.5, 1), std::invalid_argument);
  EXPECT_THROW(dropPoints(model, 1.0, 1), std::invalid_argument);
  EXPECT_THROW(addOutliers(model, 1.5, 1), std::invalid_argument);
  EXPECT_THROW(quantise(model, 1.5), std::invalid_argument);
  EXPECT_THROW(bend(model, 4.0, 1), std::invalid_argument);
  EXPECT_THROW(bend(model, std::nan(""), 1), std::invalid_argument);
  EXPECT_THROW(repeatPoints(model, -0.5, 1), std::invalid_argument);
  EXPECT_THROW(keepVertices(model, {1, 0}), std::invalid_argument);
  expectSame(model, human());
}

} // namespace
