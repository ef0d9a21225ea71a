// Which side is called the source side.
#include "support/known_body.h"

#include <pcl/symmetry/symmetry.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Share of the points with a side that are on the source side where x is positive in the rest pose, and on the target
 * side elsewhere. Models of one body have the same vertices whatever the pose. */
double
shareOfSourceLeft(const Surface& at_rest, const std::vector<Side>& sides)
{
  double agree = 0.0;
  double all = 0.0;
  for (std::size_t v = 0; v < sides.size(); ++v) {
    if (sides[v] == Side::Source || sides[v] == Side::Target) {
      all += 1.0;
      agree += (at_rest.points[v][0] > 0.0F) == (sides[v] == Side::Source) ? 1.0 : 0.0;
    }
  }
  return agree / all;
}

std::vector<Side>
sidesOf(const Surface& surface)
{
  const SymmetryResult result = estimateIntrinsicSymmetry(surface);
  EXPECT_EQ(result.status, SymmetryStatus::Symmetric);
  return result.sides;
}

Surface
mirrored(Surface surface)
{
  for (Vector3& p : surface.points) {
    p[0] = -p[0];
  }
  for (Triangle& t : surface.triangles) {
    std::swap(t[1], t[2]);
  }
  return surface;
}

TEST(SideNames, DoNotChangeWithThePose)
{
  const Surface at_rest = body(Body::Human, 0.0).surface;
  const bool is_source_left = shareOfSourceLeft(at_rest, sidesOf(at_rest)) > 0.5;
  for (const std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const double share = shareOfSourceLeft(at_rest, sidesOf(body(Body::Human, 1.0, seed).surface));
    EXPECT_GT(is_source_left ? share : 1.0 - share, 0.95);
  }
}

TEST(SideNames, AreExchangedInTheMirrorImage)
{
  const Surface at_rest = body(Body::Human, 0.0).surface;
  const Surface posed = body(Body::Human, 1.0, 2).surface;
  const double share = shareOfSourceLeft(at_rest, sidesOf(posed));
  EXPECT_NEAR(shareOfSourceLeft(at_rest, sidesOf(mirrored(posed))), 1.0 - share, 0.05);
}

TEST(SideNames, DoNotDependOnTheFacesBeingTurnedInwards)
{
  const Surface posed = body(Body::Human, 1.0, 2).surface;
  Surface inwards = posed;
  for (Triangle& t : inwards.triangles) {
    std::swap(t[1], t[2]);
  }
  EXPECT_NEAR(shareOfSourceLeft(posed, sidesOf(inwards)), shareOfSourceLeft(posed, sidesOf(posed)), 0.05);
}

} // namespace
