#include "apps/hostile_shapes.h"

#include "model/articulated_body.h"

#include <cmath>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

Vector3
at(double x, double y, double z)
{
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

} // namespace

double
Dice::share()
{
  state_ = state_ * 6364136223846793005U + 1442695040888963407U; // Knuth, MMIX
  return static_cast<double>(state_ >> 11U) / 9007199254740992.0;
}

double
Dice::bell()
{
  double sum = -6.0;
  for (int i = 0; i < 12; ++i)
    sum += share();
  return sum;
}

Index
Dice::below(Index count)
{
  return static_cast<Index>(share() * static_cast<double>(count));
}

Vector3
Dice::inCube(double edge)
{
  const double x = share();
  const double y = share();
  return at(edge * x, edge * y, edge * share());
}

Surface
body(std::size_t vertices)
{
  ModelParameters parameters;
  parameters.vertices = vertices;
  return makeModel(parameters).surface;
}

Surface
withoutFaces(Surface surface)
{
  surface.triangles.clear();
  return surface;
}

Surface
moved(Surface surface, const std::function<void(std::size_t number, Vector3& point)>& move)
{
  for (std::size_t i = 0; i < surface.points.size(); ++i)
    move(i, surface.points[i]);
  return surface;
}

Surface
soupOf(const Surface& surface)
{
  Surface soup;
  for (const Triangle& t : surface.triangles) {
    const auto first = static_cast<Index>(soup.points.size());
    for (const Index corner : t)
      soup.points.push_back(surface.points[static_cast<std::size_t>(corner)]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

Surface
joined(Surface a, const Surface& b)
{
  const auto first = static_cast<Index>(a.points.size());
  a.points.insert(a.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles)
    a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return a;
}

Surface
curve(std::size_t count, const std::function<Vector3(double i)>& f)
{
  Surface surface;
  for (std::size_t i = 0; i < count; ++i)
    surface.points.push_back(f(static_cast<double>(i)));
  return surface;
}

Surface
sheet(int columns, int rows, const std::function<Vector3(double i, double j)>& f)
{
  Surface surface;
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j)
      surface.points.push_back(f(i, j));
  for (int i = 0; i + 1 < columns; ++i)
    for (int j = 0; j + 1 < rows; ++j) {
      const Index a = i * rows + j;
      surface.triangles.push_back({a, a + 1, a + rows});
      surface.triangles.push_back({a + 1, a + rows + 1, a + rows});
    }
  return surface;
}

Surface
randomFaces(Index points, std::size_t faces)
{
  Dice dice(1);
  Surface surface;
  for (Index i = 0; i < points; ++i)
    surface.points.push_back(dice.inCube());
  for (std::size_t i = 0; i < faces; ++i) {
    const Index a = dice.below(points);
    const Index b = dice.below(points);
    surface.triangles.push_back({a, b, dice.below(points)});
  }
  return surface;
}

Surface
allTriples(Index points)
{
  Surface surface = randomFaces(points, 0);
  for (Index i = 0; i < points; ++i)
    for (Index j = i + 1; j < points; ++j)
      for (Index k = j + 1; k < points; ++k)
        surface.triangles.push_back({i, j, k});
  return surface;
}

Surface
star(Index arms)
{
  Surface surface;
  surface.points.push_back({0.0F, 0.0F, 0.0F});
  for (Index i = 0; i < arms; ++i) {
    const double angle = 6.283185307179586 * i / arms;
    surface.points.push_back(at(std::cos(angle), std::sin(angle), 0.1 * std::sin(7.0 * angle)));
    surface.triangles.push_back({0, 1 + i, 1 + (i + 1) % arms});
  }
  return surface;
}

Surface
fanAboutAnEdge(Index faces)
{
  Surface surface;
  surface.points = {{0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 1.0F}};
  for (Index i = 0; i < faces; ++i) {
    const double angle = 6.2 * i / faces;
    surface.points.push_back(at(std::cos(angle), std::sin(angle), 0.5));
    surface.triangles.push_back({0, 1, 2 + i});
  }
  return surface;
}

Surface
clusters(Index count, int points, double size)
{
  Dice dice(7);
  Surface surface;
  for (Index i = 0; i < count; ++i) {
    const Vector3 centre = dice.inCube();
    for (int k = 0; k < points; ++k)
      surface.points.push_back(
          at(centre[0] + size * dice.bell(), centre[1] + size * dice.bell(), centre[2] + size * dice.bell()));
  }
  return surface;
}

Surface
copies(const Surface& surface, int count, double distance)
{
  Dice dice(2);
  Surface result;
  for (int k = 0; k < count; ++k)
    for (const Vector3& p : surface.points)
      result.points.push_back(
          at(p[0] + distance * dice.bell(), p[1] + distance * dice.bell(), p[2] + distance * dice.bell()));
  return result;
}

Surface
tetrahedra(int count)
{
  Dice dice(3);
  Surface surface;
  for (int i = 0; i < count; ++i) {
    const auto a = static_cast<Index>(surface.points.size());
    const Vector3 c = dice.inCube(10.0);
    surface.points.insert(surface.points.end(),
                          {c, at(c[0] + 0.01, c[1], c[2]), at(c[0], c[1] + 0.01, c[2]), at(c[0], c[1], c[2] + 0.01)});
    surface.triangles.insert(surface.triangles.end(),
                             {{a, a + 1, a + 2}, {a, a + 1, a + 3}, {a, a + 2, a + 3}, {a + 1, a + 2, a + 3}});
  }
  return surface;
}

Surface
comb(int fingers, int length)
{
  Surface surface;
  for (int t = 0; t < fingers; ++t) {
    const auto a = static_cast<Index>(surface.points.size());
    surface = joined(std::move(surface),
                     sheet(2, length, [t](double i, double j) { return at(0.01 * t + 0.004 * i, 0.005 * j, 0.0); }));
    if (t > 0)
      surface.triangles.push_back({a - length, a, a + 1});
  }
  return surface;
}

} // namespace test
} // namespace symmetry
} // namespace pcl
