#include "apps/hostile_inputs.h"
#include "apps/hostile_shapes.h"

#include <cmath>
#include <limits>
#include <utility>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

Vector3
at(double x, double y, double z)
{
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

Surface
scaledBody(double factor)
{
  return moved(body(3000), [factor](std::size_t, Vector3& p) { p = at(factor * p[0], factor * p[1], factor * p[2]); });
}

Surface
shiftedBody(double x)
{
  return moved(body(3000), [x](std::size_t, Vector3& p) { p = at(p[0] + x, p[1] - x, p[2] + x); });
}

/** \brief A body of which some points are no places. */
Surface
bodyWith(float value, std::size_t every)
{
  return moved(body(3000), [=](std::size_t i, Vector3& p) {
    if (i % every == 0)
      p[i % 3] = value;
  });
}

Surface
repeatedFaces()
{
  Surface surface = body(3000);
  const std::vector<Triangle> once = surface.triangles;
  for (const Triangle& t : once)
    surface.triangles.push_back({t[0], t[2], t[1]});
  surface.triangles.insert(surface.triangles.end(), once.begin(), once.end());
  return surface;
}

Surface
flipped(std::size_t every)
{
  Surface surface = body(3000);
  for (std::size_t i = 0; i < surface.triangles.size(); i += every)
    std::swap(surface.triangles[i][0], surface.triangles[i][1]);
  return surface;
}

Surface
flatGrid()
{
  return sheet(100, 60, [](double i, double j) { return at(0.01 * i, 0.01 * j, 0.0); });
}

Surface
randomCloud(std::size_t points, const std::function<Vector3(Dice&)>& place)
{
  Dice dice(11);
  return curve(points, [&](double) { return place(dice); });
}

/** \brief A torus, a Moebius strip or a Klein bottle by its two angles; seams stay open: their points come twice. */
Surface
tube(const std::function<Vector3(double u, double v)>& f)
{
  constexpr double turn = 6.283185307179586;
  return sheet(121, 61, [&](double i, double j) { return f(turn * i / 120.0, turn * j / 60.0); });
}

Surface
sphere(std::size_t points)
{
  return curve(points, [points](double i) {
    const double z = 1.0 - (2.0 * i + 1.0) / static_cast<double>(points);
    const double across = std::sqrt(1.0 - z * z);
    return at(across * std::cos(2.399963 * i), across * std::sin(2.399963 * i), z);
  });
}

} // namespace

const std::vector<Hostile>&
hostileSurfaces()
{
  static const std::vector<Hostile> surfaces = {
      // Next to nothing.
      {"OnePoint", "1", [] { return curve(1, [](double) { return at(1, 2, 3); }); }, {}},
      {"TwoPoints", "1", [] { return curve(2, [](double i) { return at(i, 2, 3); }); }, {}},
      {"OneTriangle", "1", [] { return sheet(2, 2, [](double i, double j) { return at(i, j, 0); }); }, {}},
      {"FiveThousandTimesOnePoint", "1", [] { return curve(5000, [](double) { return at(1, 1, 1); }); }, {}},
      {"OnePointInManyPlacesOfAMillionth", "1", [] { return clusters(1, 5000, 1e-9); }, {}},
      {"FewerPointsThanNeighbours", "013", [] { return withoutFaces(body(1000)); }, {"-k", "256"}},
      // Lines and planes.
      {"Collinear", "013", [] { return curve(5000, [](double i) { return at(0.01 * i, 0.02 * i, 0.0); }); }, {}},
      {"CollinearAtRandom",
       "013",
       [] {
         return randomCloud(5000, [](Dice& d) {
           const double t = d.share();
           return at(t, 2 * t, 3 * t);
         });
       },
       {}},
      {"FlatMesh", "03", flatGrid, {}},
      {"FlatCloud", "03", [] { return withoutFaces(flatGrid()); }, {}},
      {"FlatAtRandom",
       "03",
       [] {
         return randomCloud(6000, [](Dice& d) {
           const double x = d.share();
           return at(x, d.share(), 0);
         });
       },
       {}},
      {"LongStrip",
       "013",
       [] { return sheet(40000, 2, [](double i, double j) { return at(0.001 * i, 0.001 * j, 0); }); },
       {}},
      {"LongPath", "013", [] { return curve(60000, [](double i) { return at(0.001 * i, 0, 0); }); }, {}},
      {"LongSpiral",
       "013",
       [] {
         return curve(60000, [](double i) {
           const double t = 0.005 * i;
           return at(t * std::cos(t), t * std::sin(t), 0.1 * t);
         });
       },
       {}},
      {"LineThatGrows", "013", [] { return curve(60000, [](double i) { return at(std::pow(1.0005, i), 0, 0); }); }, {}},
      {"SpiralThatGrows",
       "013",
       [] {
         return curve(20000, [](double i) {
           const double r = std::pow(1.001, i);
           return at(r * std::cos(0.1 * i), r * std::sin(0.1 * i), 0);
         });
       },
       {}},
      {"LineWithJitter",
       "013",
       [] {
         Dice d(5);
         return curve(50000, [&d](double i) { return at(0.002 * i, 1e-4 * d.share(), 1e-4 * d.share()); });
       },
       {}},
      // Not numbers.
      {"NoPlaceAtAll", "1", [] { return bodyWith(nan, 1); }, {}},
      {"InfiniteAll", "1", [] { return bodyWith(infinity, 1); }, {}},
      {"SomePointsAreNoPlaces", "03", [] { return bodyWith(nan, 100); }, {}},
      {"SomePointsAreInfinite", "03", [] { return bodyWith(-infinity, 100); }, {}},
      {"SomePointsOfACloudAreNoPlaces", "03", [] { return withoutFaces(bodyWith(nan, 10)); }, {}},
      {"SomePointsOfACloudAreInfinite", "03", [] { return withoutFaces(bodyWith(infinity, 10)); }, {}},
      // Scale and place.
      {"TinyBody", "0", [] { return scaledBody(1e-30); }, {}},
      {"BodyOfDenormals", "013", [] { return scaledBody(1e-42); }, {}},
      {"HugeBody", "0", [] { return scaledBody(1e30); }, {}},
      {"BodyAtTheEndOfFloats", "013", [] { return scaledBody(1e37); }, {}},
      {"BodyBeyondTheEndOfFloats", "013", [] { return scaledBody(1e39); }, {}},
      {"TinyCloud", "0", [] { return withoutFaces(scaledBody(1e-30)); }, {}},
      {"HugeCloud", "0", [] { return withoutFaces(scaledBody(1e30)); }, {}},
      {"BodyAThousandLengthsAway", "013", [] { return shiftedBody(1e3); }, {}},
      {"BodyAMillionLengthsAway", "13", [] { return shiftedBody(1e6); }, {}},
      {"CloudTenThousandLengthsAway", "013", [] { return withoutFaces(shiftedBody(1e4)); }, {}},
      // Repetition.
      {"EachPointThreeTimes", "0", [] { return copies(body(3000), 3, 0.0); }, {}},
      {"EachFaceThreeTimes", "0", repeatedFaces, {}},
      {"TriangleSoup", "0", [] { return soupOf(body(3000)); }, {}},
      {"EdgesOfLengthZero",
       "03",
       [] {
         Surface s = body(3000);
         for (std::size_t i = 0; i < 1000; ++i)
           s.points[static_cast<std::size_t>(s.triangles[5 * i][0])] =
               s.points[static_cast<std::size_t>(s.triangles[5 * i][1])];
         return s;
       },
       {}},
      {"FacesWithTwoCornersAlike",
       "0",
       [] {
         Surface s = body(3000);
         for (Index i = 0; i < 1000; ++i)
           s.triangles.push_back({i, i, i + 1});
         return s;
       },
       {}},
      {"CopiesMuchCloserThanTheSpacing", "013", [] { return copies(body(1000), 9, 1e-6); }, {}},
      {"CopiesAsCloseAsFloatsAllow", "013", [] { return copies(body(1000), 20, 1e-8); }, {}},
      {"AllButFiftyAreOne",
       "13",
       [] { return joined(curve(100000, [](double) { return at(1, 1, 1); }), clusters(50, 1, 0.1)); },
       {}},
      {"ThreeMillionPointsAThousandPlaces", "03", [] { return copies(withoutFaces(body(1000)), 300, 0.0); }, {}},
      // Faces.
      {"HalfOfTheFacesTurned", "03", [] { return flipped(2); }, {}},
      {"AllFacesTurned", "0", [] { return flipped(1); }, {}},
      {"EdgeOfTenThousandFaces", "03", [] { return fanAboutAnEdge(10000); }, {}},
      {"EdgeOfFiftyThousandFaces", "03", [] { return fanAboutAnEdge(50000); }, {}},
      {"PointOfAHundredThousandFaces", "03", [] { return star(100000); }, {}},
      {"AllTriplesOfSixtyPoints", "03", [] { return allTriples(60); }, {}},
      {"RandomFacesOnFewPoints", "03", [] { return randomFaces(1500, 40000); }, {}},
      {"RandomFacesOnManyPoints", "03", [] { return randomFaces(20000, 40000); }, {}},
      {"RandomFacesOnAsManyPoints", "03", [] { return randomFaces(2000, 4000); }, {}},
      {"LargeFacesInAPicture", "03", [] { return fanAboutAnEdge(6000); }, {"--picture", "PICTURE"}},
      {"TangledFacesInAPicture", "03", [] { return randomFaces(1000, 20000); }, {"--picture", "PICTURE"}},
      // Parts.
      {"PointsBesideTheMesh", "03", [] { return joined(body(3000), withoutFaces(clusters(1000, 1, 0.0))); }, {}},
      {"PointsFarFromTheMesh",
       "03",
       [] { return joined(body(3000), randomCloud(1000, [](Dice& d) { return d.inCube(1e6); })); },
       {}},
      {"TwoBodies",
       "03",
       [] { return joined(body(3000), moved(body(3000), [](std::size_t, Vector3& p) { p[0] += 5.0F; })); },
       {}},
      {"TwoBodiesAsCloud",
       "03",
       [] {
         return withoutFaces(joined(body(3000), moved(body(3000), [](std::size_t, Vector3& p) { p[0] += 5.0F; })));
       },
       {}},
      {"ThousandsOfTetrahedra", "1", [] { return tetrahedra(5000); }, {}},
      {"FarTetrahedraAsCloud", "013", [] { return withoutFaces(tetrahedra(2000)); }, {}},
      {"Comb", "03", [] { return comb(200, 100); }, {}},
      {"BodyThatSharesAPointWithAnother",
       "03",
       [] {
         Surface s = joined(body(3000), moved(body(3000), [](std::size_t, Vector3& p) { p[1] += 3.0F; }));
         s.triangles[0][0] = static_cast<Index>(s.points.size()) - 1;
         return s;
       },
       {}},
      // Topology.
      {"Torus",
       "03",
       [] {
         return tube([](double u, double v) {
           return at((2 + 0.7 * std::cos(v)) * std::cos(u), (2 + 0.7 * std::cos(v)) * std::sin(u), 0.7 * std::sin(v));
         });
       },
       {}},
      {"MoebiusStrip",
       "03",
       [] {
         return tube([](double u, double v) {
           const double w = v / 8.0 - 0.4;
           return at((1 + w * std::cos(u / 2)) * std::cos(u), (1 + w * std::cos(u / 2)) * std::sin(u),
                     w * std::sin(u / 2));
         });
       },
       {}},
      {"KleinBottle",
       "03",
       [] {
         return tube([](double u, double v) {
           const double r = 2 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v);
           return at(r * std::cos(u), r * std::sin(u),
                     std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v));
         });
       },
       {}},
      {"Cylinder", "03", [] { return tube([](double u, double v) { return at(std::cos(u), std::sin(u), v); }); }, {}},
      {"CylinderLikeALine",
       "013",
       [] {
         return sheet(9, 3000, [](double i, double j) {
           return at(0.001 * std::cos(0.785398 * i), 0.001 * std::sin(0.785398 * i), 0.002 * j);
         });
       },
       {}},
      {"Sphere", "03", [] { return sphere(10000); }, {}},
      {"SphereAndABallOfAsManyPoints", "03", [] { return joined(sphere(15000), clusters(1, 14000, 1e-4)); }, {}},
      // Clouds that are no surface.
      {"PointsInACube", "03", [] { return clusters(6000, 1, 0.0); }, {}},
      {"PointsAroundACentre", "03", [] { return clusters(1, 6000, 1.0); }, {}},
      {"Lattice",
       "03",
       [] {
         return curve(8000, [](double i) {
           const auto n = static_cast<int>(i);
           return at(n % 20, n / 20 % 20, n / 400);
         });
       },
       {}},
      {"ManySmallClusters", "013", [] { return clusters(3000, 20, 1e-5); }, {}},
      {"FewLargeClusters", "013", [] { return clusters(200, 300, 1e-6); }, {}},
      {"NeedlesAsThinAsNothing",
       "013",
       [] {
         Dice d(5);
         return curve(10000, [&d](double i) { return at(std::fmod(i, 2.0), 1e-25 * d.share(), 1e-25 * d.share()); });
       },
       {}},
      {"Needles",
       "013",
       [] {
         Dice d(5);
         return curve(10000, [&d](double i) { return at(std::fmod(i, 2.0), 1e-12 * d.share(), 1e-12 * d.share()); });
       },
       {}},
      // Options at the end of their ranges.
      {"ManyNeighbours", "0", [] { return withoutFaces(body(12000)); }, {"-k", "256"}},
      {"ManySamples", "03", [] { return body(3000); }, {"--samples", "20000"}},
      {"ManyLandmarks", "03", [] { return body(3000); }, {"--method", "staged", "--landmarks", "1000"}},
      {"TinyRadius", "13", [] { return withoutFaces(body(3000)); }, {"--radius", "1e-20"}},
      {"HugeRadius", "0", [] { return withoutFaces(body(3000)); }, {"--radius", "1e20"}},
      {"StarByStages", "03", [] { return star(20000); }, {"--method", "staged"}},
      {"RandomFacesByStages", "03", [] { return randomFaces(1500, 40000); }, {"--method", "staged"}},
      {"ClustersByStages", "013", [] { return clusters(3000, 20, 1e-5); }, {"--method", "staged"}},
      {"AllAlternatives", "03", [] { return sphere(3000); }, {"--alternatives", "100"}},
  };
  return surfaces;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
