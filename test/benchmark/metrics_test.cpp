#include "benchmark/metrics.h"
#include "support/messages.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"
#include "support/with_threads.h"

#include <pcl/exceptions.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace pcl {
namespace symmetry {
namespace {

using Partners = std::vector<Index>;

constexpr double pi = 3.14159265358979323846;

double
edgeLength(const Vector3& a, const Vector3& b)
{
  return std::sqrt(std::pow(double(a[0]) - b[0], 2) + std::pow(double(a[1]) - b[1], 2) +
                   std::pow(double(a[2]) - b[2], 2));
}

/** All distances along edges (Floyd and Warshall): the oracle. */
std::vector<std::vector<double>>
allDistances(const Surface& mesh)
{
  const std::size_t n = mesh.size();
  std::vector<std::vector<double>> d(n, std::vector<double>(n, std::numeric_limits<double>::infinity()));
  for (std::size_t i = 0; i < n; ++i)
    d[i][i] = 0.0;
  for (const Triangle& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(t[k]);
      const auto b = static_cast<std::size_t>(t[(k + 1) % 3]);
      d[a][b] = d[b][a] = edgeLength(mesh.points[a], mesh.points[b]);
    }
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
  return d;
}

/** The published definitions once more, by brute force. */
struct BruteForceScore {
  double correspondence_rate = 0.0;
  double mean_error = 0.0;
};

BruteForceScore
bruteForceScore(const Surface& mesh, const GroundTruth& truth, const Partners& partners, double area)
{
  const std::vector<std::vector<double>> d = allDistances(mesh);
  const auto farthest = [&d](std::size_t i) {
    return static_cast<std::size_t>(std::max_element(d[i].begin(), d[i].end()) - d[i].begin());
  };
  std::size_t end = farthest(static_cast<std::size_t>(truth[0].vertex));
  double diameter = 0.0;
  for (int sweep = 0; sweep < 3; ++sweep) {
    diameter = d[end][farthest(end)];
    end = farthest(end);
  }
  const double radius = std::sqrt(area / (20.0 * pi));
  BruteForceScore score;
  for (const TruePartner& pair : truth) {
    const Index partner = partners[static_cast<std::size_t>(pair.vertex)];
    const double error =
        partner == no_index ? diameter : d[static_cast<std::size_t>(pair.partner)][static_cast<std::size_t>(partner)];
    score.correspondence_rate += error < radius ? 1.0 / static_cast<double>(truth.size()) : 0.0;
    score.mean_error += std::min(error, diameter) / diameter / static_cast<double>(truth.size());
  }
  return score;
}

/** The left-right mirror of a grid. */
Partners
gridMirror(int columns, int rows)
{
  Partners mirror;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      mirror.push_back(j * columns + columns - 1 - i);
  return mirror;
}

GroundTruth
denseTruth(const Partners& partners)
{
  GroundTruth truth;
  for (std::size_t i = 0; i < partners.size(); ++i)
    truth.push_back({static_cast<Index>(i), partners[i]});
  return truth;
}

TEST(MetricsTest, TheTruthItselfIsPerfect)
{
  const Partners mirror = gridMirror(6, 4);
  const MapAccuracy score = scoreMap(test::gridMesh(6, 4), denseTruth(mirror), mirror);
  EXPECT_EQ(score.correspondenceRate(), 1.0);
  EXPECT_EQ(score.meanGeodesicError(), 0.0);
  EXPECT_EQ(score.shareBelow(0.05), 1.0);
  EXPECT_TRUE(score.isRight());
  EXPECT_EQ(score.matched, 24U);
  EXPECT_EQ(score.map_size, 24U);
}

TEST(MetricsTest, RadiusAndDiameterOfASquareAreKnown)
{
  // 5 x 5 vertices one apart, one diagonal in each cell from (i, j) to (i + 1, j + 1): the other diagonal is all
  // zigzag.
  const Surface grid = test::gridMesh(5, 5);
  const MapAccuracy score = scoreMap(grid, {{4, 0}, {0, 4}}, gridMirror(5, 5));
  EXPECT_NEAR(score.area, 16.0, 1e-12);
  EXPECT_NEAR(score.radius, std::sqrt(16.0 / (20.0 * pi)), 1e-12);
  EXPECT_NEAR(score.diameter, 8.0, 1e-6) << "from (4, 0) to (0, 4) along the sides of the cells";
  EXPECT_NEAR(scoreMap(grid, {{0, 4}}, gridMirror(5, 5)).diameter, std::sqrt(32.0), 1e-6)
      << "sweeps that begin at (0, 0) never leave the diagonal to (4, 4)";
}

TEST(MetricsTest, ErrorIsTheDistanceAlongEdgesOverTheDiameter)
{
  const Surface grid = test::gridMesh(5, 5);
  const GroundTruth truth{{4, 0}, {0, 4}};
  Partners partners(25, no_index);
  partners[0] = 2;     // two steps from vertex 4
  partners[4] = 5 + 1; // one diagonal from vertex 0
  const MapAccuracy score = scoreMap(grid, truth, partners);
  ASSERT_EQ(score.errors.size(), 2U);
  EXPECT_NEAR(score.errors[0].geodesic, std::sqrt(2.0) / 8.0, 1e-6);
  EXPECT_NEAR(score.errors[1].geodesic, 2.0 / 8.0, 1e-6);
  EXPECT_NEAR(score.shareBelow(0.2), 0.5, 1e-12);
  EXPECT_EQ(score.shareBelow(0.1), 0.0);
  EXPECT_EQ(score.correspondenceRate(), 0.0) << "the radius is 0.505";
}

TEST(MetricsTest, AgreesWithBruteForce)
{
  const Surface sphere = test::scaled(test::sphereMesh(2), {1.0F, 2.0F, 3.0F});
  std::mt19937 random(7);
  Partners truth(sphere.size());
  std::iota(truth.begin(), truth.end(), 0);
  std::shuffle(truth.begin(), truth.end(), random);
  Partners partners = truth;
  for (Index& partner : partners)
    if (random() % 3 == 0)
      partner = random() % 4 == 0 ? no_index : static_cast<Index>(random() % sphere.size());
  const MapAccuracy score = scoreMap(sphere, denseTruth(truth), partners);
  const BruteForceScore expected = bruteForceScore(sphere, denseTruth(truth), partners, score.area);
  EXPECT_LT(expected.correspondence_rate, 0.95);
  EXPECT_NEAR(score.correspondenceRate(), expected.correspondence_rate, 1e-12);
  EXPECT_NEAR(score.meanGeodesicError(), expected.mean_error, 1e-6);
}

TEST(MetricsTest, AMissingPartnerAndAnUnreachableOneAreWrongByTheDiameter)
{
  Surface two = test::gridMesh(3, 3);
  const Surface other = test::gridMesh(3, 3);
  for (const Vector3& p : other.points)
    two.points.push_back({p[0] + 100.0F, p[1], p[2]});
  for (const Triangle& t : other.triangles)
    two.triangles.push_back({t[0] + 9, t[1] + 9, t[2] + 9});
  Partners partners(18, no_index);
  partners[2] = 10;
  const MapAccuracy score = scoreMap(two, {{0, 2}, {2, 0}}, partners);
  EXPECT_EQ(score.meanGeodesicError(), 1.0);
  EXPECT_EQ(score.correspondenceRate(), 0.0);
  EXPECT_EQ(score.matched, 1U);
  EXPECT_NEAR(score.diameter, std::sqrt(8.0), 1e-6) << "of the part that the truth is on";
  EXPECT_NEAR(score.area, 8.0, 1e-9) << "of everything";
}

TEST(MetricsTest, DoesNotDependOnScaleOrThreads)
{
  const Surface grid = test::gridMesh(9, 7);
  Partners partners = gridMirror(9, 7);
  const GroundTruth truth = denseTruth(partners);
  std::rotate(partners.begin(), partners.begin() + 1, partners.end());
  const MapAccuracy score = scoreMap(grid, truth, partners);
  const MapAccuracy large = test::withThreads(3, [&] {
    return scoreMap(test::scaled(grid, {1024.0F, 1024.0F, 1024.0F}), truth, partners);
  });
  EXPECT_EQ(large.correspondenceRate(), score.correspondenceRate());
  EXPECT_DOUBLE_EQ(large.meanGeodesicError(), score.meanGeodesicError());
  EXPECT_DOUBLE_EQ(large.diameter, 1024.0 * score.diameter);
}

TEST(MetricsTest, LongTruthsAreThinnedToAtMost200)
{
  const auto size = [](std::size_t n) {
    return subsampleTruth(GroundTruth(n)).size();
  };
  EXPECT_EQ(size(200), 200U);
  EXPECT_EQ(size(201), 101U) << "every second";
  EXPECT_EQ(size(399), 200U);
  EXPECT_EQ(size(400), 134U) << "every third";
  EXPECT_EQ(size(59727), 200U);
  const GroundTruth thinned = subsampleTruth(denseTruth(gridMirror(30, 20)));
  EXPECT_EQ(thinned[1].vertex, 4) << "600 / 200 + 1";
}

TEST(MetricsTest, RightMapsNeedMoreThanThreeQuarters)
{
  MapAccuracy score;
  score.errors = {{0, 0.0, true}, {1, 0.0, true}, {2, 0.0, true}, {3, 1.0, false}};
  EXPECT_FALSE(score.isRight());
  score.errors.push_back({4, 0.0, true});
  EXPECT_TRUE(score.isRight());
}

TEST(MetricsTest, RejectsWhatCannotBeScored)
{
  const Surface grid = test::gridMesh(3, 3);
  const GroundTruth truth{{0, 2}};
  const Partners none(9, no_index);
  const auto error = [](const Surface& mesh, const GroundTruth& given, const Partners& partners) {
    return test::messageOf<pcl::BadArgumentException>([&] { scoreMap(mesh, given, partners); });
  };
  Surface cloud = grid;
  cloud.triangles.clear();
  Surface broken = grid;
  broken.triangles[0][1] = 9;
  Partners outside = none;
  outside[8] = 9;
  EXPECT_NE(error(cloud, truth, none).find("no faces"), std::string::npos);
  EXPECT_NE(error(grid, {}, none).find("truth is empty"), std::string::npos);
  EXPECT_NE(error(grid, truth, Partners(8, 0)).find("8 partners for 9 points"), std::string::npos);
  EXPECT_NE(error(broken, truth, none).find("a face refers to vertex 9"), std::string::npos);
  EXPECT_NE(error(grid, {{0, 9}}, none).find("vertices 0 and 9"), std::string::npos);
  EXPECT_NE(error(grid, truth, outside).find("the map refers to vertex 9"), std::string::npos);
  EXPECT_NE(error(test::scaled(grid, {0, 0, 0}), truth, none).find("no extent"), std::string::npos);
}

} // namespace
} // namespace symmetry
} // namespace pcl
