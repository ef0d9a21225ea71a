/** \file
 * \brief Surfaces that nobody measured: made to be degenerate, huge, tangled or endless.
 */
#pragma once

#include <pcl/symmetry/surface.h>

#include <cstdint>
#include <functional>

namespace pcl {
namespace symmetry {
namespace test {

/** \brief The same numbers with any standard library. */
class Dice {
public:
  explicit Dice(std::uint64_t seed) : state_(seed)
  {
  }

  /** \brief Evenly spread in [0, 1). */
  double
  share();

  /** \brief Of standard deviation 1, nearly normally distributed. */
  double
  bell();

  Index
  below(Index count);

  Vector3
  inCube(double edge = 1.0);

private:
  std::uint64_t state_;
};

/** \brief A body of the generator. */
Surface
body(std::size_t vertices);

Surface
withoutFaces(Surface surface);

/** \brief Every point changed. */
Surface
moved(Surface surface, const std::function<void(std::size_t number, Vector3& point)>& move);

/** \brief The corners of each triangle as points of their own. */
Surface
soupOf(const Surface& surface);

Surface
joined(Surface a, const Surface& b);

/** \brief Points at f (i) for i in [0, count). */
Surface
curve(std::size_t count, const std::function<Vector3(double i)>& f);

/** \brief A rectangle of columns x rows points at f (i, j). */
Surface
sheet(int columns, int rows, const std::function<Vector3(double i, double j)>& f);

/** \brief Triangles with corners at random among random points. */
Surface
randomFaces(Index points, std::size_t faces);

/** \brief All triangles among random points. */
Surface
allTriples(Index points);

/** \brief A point joined to \a arms others around it. */
Surface
star(Index arms);

/** \brief Triangles that all share one edge. */
Surface
fanAboutAnEdge(Index faces);

/** \brief \a count places at random, with \a points points around each. */
Surface
clusters(Index count, int points, double size);

/** \brief Copies of the points of a surface, each moved at random. */
Surface
copies(const Surface& surface, int count, double distance);

Surface
tetrahedra(int count);

/** \brief Fingers side by side, joined at their ends. */
Surface
comb(int fingers, int length);

} // namespace test
} // namespace symmetry
} // namespace pcl
