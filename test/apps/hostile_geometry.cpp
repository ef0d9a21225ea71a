#include "apps/hostile_inputs.h"
#include "apps/hostile_shapes.h"
#include "support/boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

constexpr double turn = 6.283185307179586;

Vector3
at(double x, double y, double z)
{
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

Vector3
onSphere(Dice& dice)
{
  const double z = 2.0 * dice.share() - 1.0;
  const double angle = turn * dice.share();
  const double across = std::sqrt(1.0 - z * z);
  return at(across * std::cos(angle), across * std::sin(angle), z);
}

/** \brief Points at the same place made one. */
Surface
welded(const Surface& surface)
{
  std::map<Vector3, Index> numbers;
  std::vector<Index> number;
  Surface result;
  for (const Vector3& p : surface.points) {
    const auto [entry, is_new] = numbers.emplace(p, static_cast<Index>(result.points.size()));
    if (is_new)
      result.points.push_back(p);
    number.push_back(entry->second);
  }
  for (const Triangle& t : surface.triangles)
    result.triangles.push_back({number[static_cast<std::size_t>(t[0])], number[static_cast<std::size_t>(t[1])],
                                number[static_cast<std::size_t>(t[2])]});
  return result;
}

/** \brief Cubes of a lattice, with all of their faces. */
Surface
voxels(int side, const std::function<bool(int, int, int)>& is_full)
{
  Surface surface;
  for (int n = 0; n < side * side * side; ++n) {
    const int i = n % side;
    const int j = n / side % side;
    const int k = n / side / side;
    if (!is_full(i, j, k))
      continue;
    addBox(surface, at(i, j, k), at(i + 1, j + 1, k + 1));
  }
  return welded(surface);
}

bool
isInMengerSponge(int i, int j, int k)
{
  for (; i > 0 || j > 0 || k > 0; i /= 3, j /= 3, k /= 3)
    if ((i % 3 == 1 ? 1 : 0) + (j % 3 == 1 ? 1 : 0) + (k % 3 == 1 ? 1 : 0) >= 2)
      return false;
  return true;
}

/** \brief A tube or strip by two angles; around it closes on itself, turned over if wanted. */
Surface
closedBand(int around, int across, bool is_tube, const std::function<Vector3(double u, double v)>& f)
{
  Surface surface;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j)
      surface.points.push_back(f(turn * i / around, turn * j / (is_tube ? across : across - 1)));
  const auto number = [=](int i, int j) {
    j %= across;
    if (i < around)
      return static_cast<Index>(i * across + j);
    return static_cast<Index>(is_tube ? (across - j) % across : across - 1 - j);
  };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < (is_tube ? across : across - 1); ++j) {
      surface.triangles.push_back({number(i, j), number(i + 1, j), number(i, j + 1)});
      surface.triangles.push_back({number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return surface;
}

/** \brief Pages that share their spine. */
Surface
book(int pages, int rows, int columns)
{
  Surface all;
  for (int page = 0; page < pages; ++page) {
    const double angle = turn * page / pages;
    all = joined(std::move(all), sheet(columns, rows, [angle](double i, double j) {
                   return at(0.03 * i * std::cos(angle), 0.03 * i * std::sin(angle), 0.03 * j);
                 }));
  }
  return welded(all);
}

/** \brief A globe: long triangles at its poles. */
Surface
globe(int columns, int rows)
{
  return sheet(columns, rows, [=](double i, double j) {
    const double u = turn * i / (columns - 1);
    const double v = 0.5 * turn * (j + 0.5) / rows;
    return at(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v));
  });
}

/** \brief Of some faces one corner is any point. */
Surface
scrambled(Surface surface, double share)
{
  Dice dice(4);
  for (Triangle& t : surface.triangles)
    if (dice.share() < share)
      t[0] = dice.below(static_cast<Index>(surface.points.size()));
  return surface;
}

/** \brief Triangles without a common corner. */
Surface
looseTriangles(Index count, double size)
{
  Dice dice(4);
  Surface surface;
  for (Index i = 0; i < 3 * count; i += 3) {
    const Vector3 p = dice.inCube();
    for (int k = 0; k < 3; ++k)
      surface.points.push_back(at(p[0] + size * dice.bell(), p[1] + size * dice.bell(), p[2] + size * dice.bell()));
    surface.triangles.push_back({i, i + 1, i + 2});
  }
  return surface;
}

Surface
spiky()
{
  Dice dice(4);
  return moved(globe(100, 60), [&dice](std::size_t, Vector3& p) {
    const double r = 1.0 + 0.3 * dice.bell();
    p = at(r * p[0], r * p[1], r * p[2]);
  });
}

Surface
bipyramid(Index sides)
{
  Surface surface;
  surface.points = {at(0, 0, 1), at(0, 0, -1)};
  for (Index i = 0; i < sides; ++i) {
    surface.points.push_back(at(std::cos(turn * i / sides), std::sin(turn * i / sides), 0));
    surface.triangles.push_back({0, 2 + i, 2 + (i + 1) % sides});
    surface.triangles.push_back({1, 2 + (i + 1) % sides, 2 + i});
  }
  return surface;
}

Surface
randomStrip(Index points)
{
  Dice dice(2);
  Surface surface = curve(static_cast<std::size_t>(points), [&dice](double) { return dice.inCube(); });
  for (Index i = 0; i + 2 < points; ++i)
    surface.triangles.push_back({i, i + 1, i + 2});
  return surface;
}

/** \brief A globe, and triangles between any of its points. */
Surface
globeWithChords(int columns, int rows, int chords)
{
  Dice dice(4);
  Surface surface = globe(columns, rows);
  const auto points = static_cast<Index>(surface.size());
  for (int i = 0; i < chords; ++i) {
    const Index a = dice.below(points);
    const Index b = dice.below(points);
    surface.triangles.push_back({a, b, dice.below(points)});
  }
  return surface;
}

/** \brief Points of which no two thirds of any size are joined. */
Surface
cantorDust(std::size_t points)
{
  Dice dice(11);
  return curve(points, [&dice](double) {
    std::array<double, 3> place{};
    for (double& x : place) {
      for (double step = 2.0 / 3.0; step > 1e-6; step /= 3.0)
        x += step * dice.below(2);
    }
    return at(place[0], place[1], place[2]);
  });
}

Surface
solidBall(std::size_t points)
{
  Dice dice(11);
  return curve(points, [&dice](double) {
    const Vector3 p = onSphere(dice);
    const double r = std::cbrt(dice.share());
    return at(r * p[0], r * p[1], r * p[2]);
  });
}

/** \brief Points at random on a sphere, at distances of many sizes from its centre. */
Surface
logarithmicBall(std::size_t points, double decades)
{
  Dice dice(11);
  return curve(points, [&dice, decades](double) {
    const Vector3 p = onSphere(dice);
    const double r = std::pow(10.0, -decades * dice.share());
    return at(r * p[0], r * p[1], r * p[2]);
  });
}

/** \brief Every other point of a body is huge, the others are next to nothing. */
Surface
bodyOfTwoSizes()
{
  return moved(body(3000), [](std::size_t i, Vector3& p) {
    const double factor = i % 2 == 0 ? 1e30 : 1e-30;
    p = at(factor * p[0], factor * p[1], factor * p[2]);
  });
}

/** \brief Two clusters whose sizes are nothing next to the way between them. */
Surface
twoFarClusters(int points)
{
  return moved(clusters(2, points, 0.01),
               [points](std::size_t i, Vector3& p) { p[0] += i < static_cast<std::size_t>(points) ? 0.0F : 1e6F; });
}

} // namespace

const std::vector<Hostile>&
hostileGeometry()
{
  static const std::vector<Hostile> meshes = {
      // Not orientable, not manifold.
      {"MoebiusStripWithoutASeam",
       "03",
       [] {
         return closedBand(200, 30, false, [](double u, double v) {
           const double w = v / 8.0 - 0.4;
           return at((1 + w * std::cos(u / 2)) * std::cos(u), (1 + w * std::cos(u / 2)) * std::sin(u),
                     w * std::sin(u / 2));
         });
       },
       {}},
      {"KleinBottleWithoutASeam",
       "03",
       [] {
         return closedBand(150, 40, true, [](double u, double v) {
           const double r = 2 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
           return at(r * std::cos(u), r * std::sin(u),
                     std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v));
         });
       },
       {}},
      {"BookOfTwentyPages", "03", [] { return book(20, 15, 20); }, {}},
      {"BookOfAThousandPages", "03", [] { return book(1000, 3, 3); }, {}},
      {"CubesThatShareEdges",
       "03",
       [] { return voxels(12, [](int i, int j, int k) { return (i + j + k) % 2 == 0; }); },
       {}},
      {"CubesWithAllInnerFaces", "03", [] { return voxels(10, [](int, int, int) { return true; }); }, {}},
      {"MengerSponge", "03", [] { return voxels(9, isInMengerSponge); }, {}},
      {"Bipyramid", "03", [] { return bipyramid(8000); }, {}},
      // Faces that join what is far apart, or nothing.
      {"StripOverRandomPoints", "03", [] { return randomStrip(4000); }, {}},
      {"GlobeWithScrambledFaces", "03", [] { return scrambled(globe(90, 60), 0.05); }, {}},
      {"BodyWithFewScrambledFaces", "03", [] { return scrambled(body(6000), 0.003); }, {}},
      {"LooseTriangles", "013", [] { return looseTriangles(3000, 0.01); }, {}},
      {"LooseTrianglesThatCross", "013", [] { return looseTriangles(1500, 0.3); }, {}},
      {"ManyLooseTrianglesThatCross", "013", [] { return looseTriangles(20000, 0.3); }, {}},
      {"GlobeWithChords", "03", [] { return globeWithChords(160, 160, 3000); }, {}},
      // Shapes of which a spacing or a size tells nothing.
      {"SpikyGlobe", "03", spiky, {}},
      {"GlobeOfNeedles", "03", [] { return globe(1000, 10); }, {}},
      {"Accordion",
       "03",
       [] { return sheet(400, 15, [](double i, double j) { return at(0.001 * i, 0.04 * j, std::fmod(i, 2.0)); }); },
       {}},
      {"Labyrinth",
       "03",
       [] {
         return sheet(5000, 2, [](double i, double j) {
           return at(0.002 * i * std::cos(0.02 * i), 0.002 * i * std::sin(0.02 * i), j);
         });
       },
       {}},
      {"BodyAMillionTimesAsLong",
       "03",
       [] { return moved(body(3000), [](std::size_t, Vector3& p) { p[2] *= 1e6F; }); },
       {}},
      {"BodyOfTwoSizes", "013", bodyOfTwoSizes, {}},
      {"BodyWithAFarSpike",
       "03",
       [] { return moved(body(3000), [](std::size_t i, Vector3& p) { p[0] += i == 100 ? 1e6F : 0.0F; }); },
       {}},
      // Clouds.
      {"BallOfManySizes", "013", [] { return logarithmicBall(6000, 26.0); }, {}},
      {"BallOfAThousandSizes", "013", [] { return logarithmicBall(6000, 3.0); }, {}},
      {"LargeBallOfAHundredThousandSizes", "013", [] { return logarithmicBall(83000, 5.0); }, {}},
      {"LargeBallOfAMillionMillionSizes", "013", [] { return logarithmicBall(83000, 12.0); }, {}},
      {"TwoClustersAMillionSizesApart", "013", [] { return twoFarClusters(20000); }, {}},
      {"SolidBall", "03", [] { return solidBall(83000); }, {}},
      {"CantorDust", "03", [] { return cantorDust(30000); }, {}},
      {"TwoClustersFiftySizesApart", "03", [] { return clusters(2, 40000, 0.003); }, {}},
      {"ManySpheresInARow",
       "03",
       [] {
         Dice dice(5);
         return curve(12000, [&dice](double i) {
           const Vector3 p = onSphere(dice);
           return at(p[0] + 2.0 * std::fmod(i, 50.0), p[1], p[2]);
         });
       },
       {}},
      {"TorusKnot",
       "03",
       [] {
         return curve(12000, [](double i) {
           const double t = turn * i / 12000.0;
           return at((2 + std::cos(7 * t)) * std::cos(5 * t), (2 + std::cos(7 * t)) * std::sin(5 * t), std::sin(7 * t));
         });
       },
       {}},
  };
  return meshes;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
