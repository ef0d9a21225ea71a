// Sides named as those of a labelled reference.
#include "support/known_body.h"
#include "support/pcl_input.h"

#include <pcl/symmetry/intrinsic_symmetry.h>
#include <pcl/symmetry/name_reference.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

/** Labels of a human in its rest pose. \param[in] left what its left is called */
NameReference
referenceWith(Side left)
{
  const Model model = body(Body::Human, 0.0);
  const Side right = left == Side::Source ? Side::Target : Side::Source;
  std::vector<Side> sides;
  for (const Vector3& p : model.surface.points) {
    sides.push_back(p[0] > 0.01F ? left : p[0] < -0.01F ? right : Side::Axis);
  }
  return {model.surface, sides, model.partners};
}

/** Share of the points with a side whose side is the source side where x is positive in the rest pose. */
double
shareOfSourceLeft(const SymmetryResult& result)
{
  const Model at_rest = body(Body::Human, 0.0);
  double agree = 0.0;
  double all = 0.0;
  for (std::size_t v = 0; v < result.sides.size(); ++v) {
    if (result.sides[v] == Side::Source || result.sides[v] == Side::Target) {
      all += 1.0;
      agree += (at_rest.surface.points[v][0] > 0.0F) == (result.sides[v] == Side::Source) ? 1.0 : 0.0;
    }
  }
  return agree / all;
}

TEST(NameReference, NamesTheSidesOfAnotherPose)
{
  const Surface posed = body(Body::Human, 1.0, 2).surface;
  const SymmetryResult by_shape = estimateIntrinsicSymmetry(posed);
  for (const Side left : {Side::Source, Side::Target}) {
    SymmetryResult result = by_shape;
    referenceWith(left).nameSides(posed, result);
    EXPECT_TRUE(result.naming.by_reference);
    EXPECT_GT(result.naming.margin, 0.1F);
    EXPECT_EQ(result.naming.exchanged, result.sides != by_shape.sides);
    const double share = shareOfSourceLeft(result);
    EXPECT_GT(left == Side::Source ? share : 1.0 - share, 0.95);
    EXPECT_EQ(result.partners, by_shape.partners);
  }
}

TEST(NameReference, NamesTheSidesOfACloud)
{
  Surface posed = body(Body::Human, 0.5, 2).surface;
  posed.triangles.clear();
  SymmetryResult result = estimateIntrinsicSymmetry(posed);
  ASSERT_TRUE(hasMap(result.status));
  referenceWith(Side::Target).nameSides(posed, result);
  EXPECT_LT(shareOfSourceLeft(result), 0.05);
}

TEST(NameReference, IsTakenByTheClass)
{
  const Model posed = body(Body::Human, 1.0, 3);
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setInputMesh(meshOf(posed.surface));
  const auto reference = std::make_shared<const NameReference>(referenceWith(Side::Target));
  estimation.setNameReference(reference);
  EXPECT_EQ(estimation.getNameReference(), reference);
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  EXPECT_TRUE(result.naming.by_reference);
  EXPECT_LT(shareOfSourceLeft(result), 0.05);
  ASSERT_FALSE(result.correspondences.empty());
  EXPECT_EQ(result.sides[static_cast<std::size_t>(result.correspondences[0].index_query)], Side::Source);

  SymmetryParameters sparse;
  sparse.sparse_only = true;
  estimation.setParameters(sparse);
  EXPECT_THROW(estimation.compute(result), pcl::BadArgumentException);
  EXPECT_TRUE(result.naming.by_reference) << "the result is as it was";
}

TEST(NameReference, RefusesWhatNamesNothing)
{
  const Model model = body(Body::Human, 0.0);
  const std::size_t size = model.surface.size();
  const std::vector<Side> one_side(size, Side::Source);
  EXPECT_THROW(NameReference(model.surface, one_side, model.partners), pcl::BadArgumentException);
  std::vector<Side> sides = one_side;
  sides[0] = Side::Target;
  EXPECT_THROW(NameReference(model.surface, sides, std::vector<Index>(size, no_index)), pcl::BadArgumentException);
  EXPECT_THROW(NameReference(model.surface, sides, {0}), pcl::BadArgumentException);
  std::vector<Index> wild = model.partners;
  wild[5] = static_cast<Index>(size);
  EXPECT_THROW(NameReference(model.surface, sides, wild), pcl::BadArgumentException);
}

TEST(NameReference, LeavesAResultWithoutMapAlone)
{
  SymmetryResult result;
  result.status = SymmetryStatus::NoSymmetry;
  referenceWith(Side::Source).nameSides(body(Body::Human, 0.0).surface, result);
  EXPECT_FALSE(result.naming.by_reference);
}

} // namespace
