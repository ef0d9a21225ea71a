#include "support/prepared.h"
#include "symmetry/mirror/plane_alignment.h"
#include "symmetry/samples/coarse_surface.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr int rounds = 12;

/** The plane x = 0 turned by an angle about the axis y = 0 towards another. */
PlaneReflection
turnedPlane(float angle, std::size_t towards)
{
  PlaneReflection plane;
  plane.normal = {std::cos(angle), 0.0F, 0.0F};
  plane.normal[towards] = std::sin(angle);
  return plane;
}

struct Sampled {
  explicit Sampled(const Surface& mesh) : surface(preparedMesh(mesh))
  {
    const CoarseSurface coarse = coarsenSurface(surface, 500);
    samples = {coarse.points, coarse.normals, coarse.areas};
  }

  PreparedSurface surface;
  AreaSamples samples;
};

TEST(PointAlignment, TurnsAPlaneBackThatIsSixDegreesOff)
{
  const Sampled body(scaled(sphereMesh(4), {1.0F, 0.7F, 0.4F}));
  const PointAlignment alignment(body.samples, {body.surface.points, body.surface.normals}, onto_samples, 1.4F);
  for (const std::size_t towards : {1U, 2U}) {
    const PlaneReflection aligned = alignment.run(turnedPlane(0.1F, towards), rounds);
    EXPECT_GT(std::abs(aligned.normal[0]), 0.9995F);
    EXPECT_NEAR(aligned.offset, 0.0F, 0.01F);
  }
}

TEST(PointAlignment, LeavesAnExactMirrorPlaneAsItIs)
{
  const Sampled body(scaled(sphereMesh(4), {1.0F, 0.7F, 0.4F}));
  const PointAlignment alignment(body.samples, {body.surface.points, body.surface.normals}, onto_points, 1.4F);
  const PlaneReflection aligned = alignment.run(PlaneReflection{}, rounds);
  EXPECT_NEAR(aligned.normal[0], 1.0F, 1e-5F);
  EXPECT_NEAR(aligned.offset, 0.0F, 1e-5F);
}

/** Its inner points are on it whatever the plane is: the border alone tells. */
TEST(SurfaceAlignment, TurnsAPlaneAcrossASheetUntilItsBorderFits)
{
  const Sampled sheet(scaled(gridMesh(40, 26), {1.0F, 1.0F, 1.0F}));
  const SurfaceAlignment alignment(sheet.samples, sheet.surface, onto_surface, 1.2F);
  const PlaneReflection aligned = alignment.run(turnedPlane(0.05F, 1), rounds);
  EXPECT_GT(std::abs(aligned.normal[0]), 0.99999F);
  EXPECT_NEAR(aligned.offset, 0.0F, 0.002F);
}

} // namespace
