// Shapes with several reflections that fit equally well, in any position and with their points in any order.
#include "base/vector_math.h"
#include "support/boxes.h"
#include "support/shapes.h"
#include "symmetry/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

using Rows = std::array<Vector3, 3>;

/** A rotation by a random unit quaternion. */
Rows
randomRotation(std::mt19937& random)
{
  std::normal_distribution<float> normal;
  std::array<float, 4> q{normal(random), normal(random), normal(random), normal(random)};
  const float length = std::sqrt(std::inner_product(q.begin(), q.end(), q.begin(), 0.0F));
  for (float& x : q) {
    x /= length;
  }
  const auto [w, x, y, z] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
           {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
           {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
}

Surface
rotatedAndShuffled(const Surface& mesh, const Rows& rotation, std::mt19937& random)
{
  std::vector<Index> order(mesh.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  Surface moved = mesh;
  for (std::size_t v = 0; v < mesh.size(); ++v) {
    const Vector3& p = mesh.points[v];
    moved.points[order[v]] = {dot(rotation[0], p), dot(rotation[1], p), dot(rotation[2], p)};
  }
  for (Triangle& t : moved.triangles) {
    t = {order[t[0]], order[t[1]], order[t[2]]};
  }
  std::shuffle(moved.triangles.begin(), moved.triangles.end(), random);
  return moved;
}

SymmetryResult
estimate(const Surface& surface)
{
  SymmetryParameters parameters;
  parameters.alternatives = 8;
  StepTimer timer;
  return runPipeline(surface, parameters, NeighbourSearch{}, timer);
}

Surface
boxMesh(const Vector3& sides)
{
  Surface box;
  addBox(box, {0, 0, 0}, sides);
  return finer(finer(finer(box)));
}

struct Shape {
  const char* name;
  Surface surface;
  std::size_t reflections; ///< that fit equally well; 0: without end
  Vector3 normal;          ///< of the plane that follows from the shape; zero where several are alike
};

class EqualReflections : public testing::TestWithParam<Shape> {};

INSTANTIATE_TEST_SUITE_P(Shapes,
                         EqualReflections,
                         testing::Values(Shape{"Sphere", sphereMesh(4), 0, {}},
                                         Shape{"Torus", torusMesh(30, 12, 1.0F, 0.35F), 0, {}},
                                         Shape{"Square", gridMesh(25, 25), 4, {}},
                                         Shape{"Rectangle", gridMesh(30, 20), 2, {1, 0, 0}},
                                         Shape{"Box", boxMesh({0.5F, 1.0F, 0.8F}), 3, {0, 1, 0}}),
                         [](const testing::TestParamInfo<Shape>& tested) { return tested.param.name; });

TEST_P(EqualReflections, AreAllListedAndTheOneTakenFollowsFromTheShape)
{
  const Shape& shape = GetParam();
  std::mt19937 random(11);
  for (int variant = 0; variant < 3; ++variant) {
    const Rows rotation = randomRotation(random);
    const Surface moved = rotatedAndShuffled(shape.surface, rotation, random);
    const SymmetryResult result = estimate(moved);
    ASSERT_EQ(result.status, SymmetryStatus::Symmetric);
    EXPECT_GT(result.confidence, 0.95F);
    EXPECT_EQ(result.message, std::to_string(result.equal_reflections) + " reflections fit equally well");
    if (shape.reflections > 0) {
      EXPECT_EQ(result.equal_reflections, shape.reflections);
      EXPECT_EQ(result.alternatives.size(), shape.reflections);
      EXPECT_EQ(result.rotations.size(), shape.reflections - 1);
    }
    else {
      EXPECT_GE(result.alternatives.size(), 2U);
    }
    EXPECT_EQ(result.map.matched, moved.size());
    EXPECT_FALSE(result.axis.empty()); // a point reflection has none
    if (shape.normal != Vector3{}) {
      float along = 0.0F;
      for (std::size_t k = 0; k < 3; ++k) {
        along += static_cast<float>(result.plane.normal[k]) * dot(rotation[k], shape.normal);
      }
      EXPECT_GT(std::abs(along), 0.99F);
    }
  }
}

} // namespace
