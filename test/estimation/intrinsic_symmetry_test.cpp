// The PCL class: what it takes, what it refuses, what its result refers to.
#include "support/known_body.h"
#include "support/pcl_input.h"

#include <pcl/symmetry/intrinsic_symmetry.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>
#include <pcl/search/brute_force.h>

#include <array>
#include <cstring>
#include <limits>
#include <string>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

const pcl::PolygonMesh::Ptr&
humanMesh()
{
  static const pcl::PolygonMesh::Ptr mesh = meshOf(bentHuman().surface);
  return mesh;
}

/** The staged method: a quarter of the robust one's time, and what is tested here is the class. */
SymmetryParameters
staged()
{
  SymmetryParameters parameters;
  parameters.method = Method::Staged;
  return parameters;
}

template <typename PointT = pcl::PointXYZ>
pcl::IntrinsicSymmetryResult
compute(const pcl::PolygonMesh::ConstPtr& mesh, const pcl::IndicesPtr& indices = {})
{
  pcl::IntrinsicSymmetryEstimation<PointT> estimation;
  estimation.setParameters(staged());
  estimation.setInputMesh(mesh);
  if (indices) {
    estimation.setIndices(indices);
  }
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  return result;
}

/** What a call says when it throws an Exception. */
template <typename Exception, typename Call>
std::string
messageOf(Call call)
{
  try {
    call();
  }
  catch (const Exception& error) {
    return error.what();
  }
  return "nothing was thrown";
}

void
expectInMessage(const std::string& message, const std::vector<std::string>& parts)
{
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << '"' << part << "\" is not in \"" << message << '"';
  }
}

void
expectNothingAbout(const SymmetryResult& result, std::size_t v)
{
  EXPECT_EQ(result.partners[v], no_index);
  EXPECT_EQ(result.confidences[v], 0.0F);
  EXPECT_EQ(result.sides[v], Side::None);
  EXPECT_EQ(result.regions[v], Region::None);
}

/** No number of the result refers to a point that is marked. */
void
expectNoReferenceTo(const SymmetryResult& result, const std::vector<char>& marked)
{
  const auto is_marked = [&](Index v) {
    return v != no_index && marked[v] != 0;
  };
  EXPECT_TRUE(std::none_of(result.partners.begin(), result.partners.end(), is_marked));
  EXPECT_TRUE(std::none_of(result.extremities.begin(), result.extremities.end(), is_marked));
  for (const SymmetricMatch& match : result.matches) {
    EXPECT_FALSE(is_marked(match.source) || is_marked(match.target) || is_marked(match.midpoint));
  }
  for (const Polyline& line : result.axis) {
    EXPECT_TRUE(std::none_of(line.points.begin(), line.points.end(), is_marked));
    EXPECT_TRUE(std::none_of(line.curve.begin(), line.curve.end(),
                             [&](const AxisPoint& place) { return is_marked(place.nearest); }));
  }
}

TEST(IntrinsicSymmetryEstimation, AgreesWithTheFunctionWithoutPclTypes)
{
  const pcl::IntrinsicSymmetryResult result = compute(humanMesh());
  const SymmetryResult expected = estimateIntrinsicSymmetry(bentHuman().surface, staged());
  EXPECT_EQ(result.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(result.partners, expected.partners);
  EXPECT_EQ(result.confidences, expected.confidences);
  EXPECT_EQ(result.sides, expected.sides);
}

TEST(IntrinsicSymmetryEstimation, TheAxisNeedNotBeLabelled)
{
  SymmetryParameters parameters = staged();
  const SymmetryResult labelled = estimateIntrinsicSymmetry(bentHuman().surface, parameters);
  parameters.label_axis = false;
  const SymmetryResult result = estimateIntrinsicSymmetry(bentHuman().surface, parameters);
  EXPECT_GT(labelled.map.axis, 0U);
  EXPECT_EQ(result.map.axis, 0U);
  EXPECT_EQ(result.axis.size(), labelled.axis.size());
  for (std::size_t v = 0; v < result.sides.size(); ++v) {
    EXPECT_TRUE(result.sides[v] == Side::Source || result.sides[v] == Side::Target);
    EXPECT_TRUE(labelled.sides[v] == Side::Axis || labelled.sides[v] == result.sides[v]);
  }
}

TEST(IntrinsicSymmetryEstimation, CorrespondencesAreTheMatches)
{
  const pcl::IntrinsicSymmetryResult result = compute(humanMesh());
  ASSERT_FALSE(result.matches.empty());
  ASSERT_EQ(result.correspondences.size(), result.matches.size());
  for (std::size_t i = 0; i < result.matches.size(); ++i) {
    EXPECT_EQ(result.correspondences[i].index_query, result.matches[i].source);
    EXPECT_EQ(result.correspondences[i].index_match, result.matches[i].target);
    EXPECT_EQ(result.correspondences[i].distance, result.matches[i].cost);
  }
}

TEST(IntrinsicSymmetryEstimation, AResultIsReplacedAsAWhole)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setParameters(staged());
  estimation.setInputMesh(humanMesh());
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  const pcl::IntrinsicSymmetryResult first = result;
  estimation.compute(result);
  EXPECT_EQ(result.partners, first.partners);
  EXPECT_EQ(result.matches.size(), first.matches.size());
  EXPECT_EQ(result.correspondences.size(), first.correspondences.size());
  EXPECT_EQ(result.axis.size(), first.axis.size());
  EXPECT_EQ(result.seconds.size(), first.seconds.size());
}

TEST(IntrinsicSymmetryEstimation, NonFinitePointsTakeNoPart)
{
  // Unused points among the others: the mesh stays as it is, but for the numbers.
  Surface surface;
  std::vector<char> marked;
  std::vector<Index> new_number;
  for (const Vector3& p : bentHuman().surface.points) {
    if (surface.size() % 100 == 7) {
      surface.points.push_back({p[0], surface.size() % 200 == 7 ? not_a_number : INFINITY, p[2]});
      marked.push_back(1);
    }
    new_number.push_back(static_cast<Index>(surface.size()));
    surface.points.push_back(p);
    marked.push_back(0);
  }
  for (const Triangle& t : bentHuman().surface.triangles) {
    surface.triangles.push_back({new_number[t[0]], new_number[t[1]], new_number[t[2]]});
  }
  const pcl::IntrinsicSymmetryResult result = compute(meshOf(surface));
  const SymmetryResult expected = estimateIntrinsicSymmetry(bentHuman().surface, staged());
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric);
  ASSERT_EQ(result.partners.size(), surface.size());
  for (std::size_t v = 0; v < new_number.size(); ++v) {
    EXPECT_EQ(result.partners[new_number[v]], new_number[expected.partners[v]]);
  }
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (marked[v] != 0) {
      expectNothingAbout(result, v);
    }
  }
  expectNoReferenceTo(result, marked);
  EXPECT_EQ(result.input.non_finite, surface.size() - new_number.size());
  EXPECT_EQ(result.input.used, new_number.size());
}

TEST(IntrinsicSymmetryEstimation, PointsOutsideTheIndicesTakeNoPart)
{
  // Two bodies side by side, of which the indices choose the second; its points come in falling order.
  Surface surface = bentHuman().surface;
  const auto n = static_cast<Index>(surface.size());
  for (const Vector3& p : bentHuman().surface.points) {
    surface.points.push_back(p + Vector3{10.0F, 0.0F, 0.0F});
  }
  for (const Triangle& t : bentHuman().surface.triangles) {
    surface.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  const auto indices = pcl::make_shared<pcl::Indices>();
  for (Index v = 2 * n; v-- > n;) {
    indices->push_back(v);
  }
  const pcl::IntrinsicSymmetryResult result = compute(meshOf(surface), indices);
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric);
  ASSERT_EQ(result.partners.size(), surface.size());
  std::vector<char> marked(surface.size(), 0);
  for (Index v = 0; v < n; ++v) {
    marked[v] = 1;
    expectNothingAbout(result, static_cast<std::size_t>(v));
  }
  expectNoReferenceTo(result, marked);
  const std::vector<Index> partners(result.partners.begin() + n, result.partners.end());
  std::vector<Index> of_one_body;
  for (const Index partner : partners) {
    of_one_body.push_back(partner - n);
  }
  EXPECT_GE(correspondenceRate(mapErrors(bentHuman(), of_one_body)), 0.95);
  EXPECT_EQ(result.input.points, surface.size());
  EXPECT_EQ(result.input.outside_indices, static_cast<std::size_t>(n));
  EXPECT_EQ(result.input.used, static_cast<std::size_t>(n));
}

TEST(IntrinsicSymmetryEstimation, OnlyTheLargestObjectTakesPart)
{
  Surface surface = scaled(sphereMesh(3), {0.1F, 0.1F, 0.1F});
  for (Vector3& p : surface.points) {
    p[0] += 5.0F; // farther away than either is large
  }
  const auto sphere = static_cast<Index>(surface.size());
  surface.points.insert(surface.points.end(), bentHuman().surface.points.begin(), bentHuman().surface.points.end());
  for (const Triangle& t : bentHuman().surface.triangles) {
    surface.triangles.push_back({t[0] + sphere, t[1] + sphere, t[2] + sphere});
  }
  surface.points.push_back({50.0F, 0.0F, 0.0F}); // on no face
  const pcl::IntrinsicSymmetryResult result = compute(meshOf(surface));
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric);
  std::vector<char> marked(surface.size(), 0);
  std::fill_n(marked.begin(), sphere, char{1});
  marked.back() = 1;
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (marked[v] != 0) {
      expectNothingAbout(result, v);
    }
    else {
      EXPECT_NE(result.partners[v], no_index);
    }
  }
  expectNoReferenceTo(result, marked);
  EXPECT_EQ(result.input.components, 2U);
  EXPECT_EQ(result.input.unused, 1U);
  EXPECT_EQ(result.input.linked_parts, 0U);
  EXPECT_EQ(result.input.other_components, static_cast<std::size_t>(sphere));
  EXPECT_EQ(result.input.used, bentHuman().surface.size());
}

TEST(IntrinsicSymmetryEstimation, RefusesToComputeWithoutInput)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  pcl::IntrinsicSymmetryResult result;
  EXPECT_THROW(estimation.compute(result), pcl::InitFailedException);
}

TEST(IntrinsicSymmetryEstimation, RefusesIndicesOutOfRangeAndRepeated)
{
  const auto n = static_cast<Index>(bentHuman().surface.size());
  expectInMessage(messageOf<pcl::BadArgumentException>([n] {
                    compute(humanMesh(), pcl::make_shared<pcl::Indices>(pcl::Indices{0, n}));
                  }),
                  {std::to_string(n), "range"});
  expectInMessage(messageOf<pcl::BadArgumentException>([] {
                    compute(humanMesh(), pcl::make_shared<pcl::Indices>(pcl::Indices{0, -1}));
                  }),
                  {"-1", "range"});
  expectInMessage(messageOf<pcl::BadArgumentException>([] {
                    compute(humanMesh(), pcl::make_shared<pcl::Indices>(pcl::Indices{4, 17, 4}));
                  }),
                  {"4", "twice"});
}

TEST(IntrinsicSymmetryEstimation, RefusesAPolygonWithAPointThatIsNotThere)
{
  for (const int corner : {-1, static_cast<int>(bentHuman().surface.size())}) {
    const auto mesh = pcl::make_shared<pcl::PolygonMesh>(*humanMesh());
    mesh->polygons[5].vertices[1] = static_cast<pcl::index_t>(corner);
    pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
    expectInMessage(messageOf<pcl::BadArgumentException>([&] { estimation.setInputMesh(mesh); }),
                    {"polygon 5", std::to_string(bentHuman().surface.size())});
  }
}

TEST(IntrinsicSymmetryEstimation, RefusesAMeshWithoutFloatCoordinates)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  EXPECT_THROW(estimation.setInputMesh(pcl::PolygonMesh::ConstPtr()), pcl::BadArgumentException);
  EXPECT_THROW(estimation.setInputMesh(pcl::make_shared<pcl::PolygonMesh>()), pcl::BadArgumentException);
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(*humanMesh());
  mesh->cloud.fields[1].datatype = pcl::PCLPointField::FLOAT64;
  expectInMessage(messageOf<pcl::BadArgumentException>([&] { estimation.setInputMesh(mesh); }), {"float", "y"});
}

/** The mesh with double positions, all of them moved; x y z in another order, behind a field of another type. */
pcl::PolygonMesh::Ptr
inDoubles(const pcl::PolygonMesh& mesh, const std::array<double, 3>& place)
{
  const auto moved = pcl::make_shared<pcl::PolygonMesh>();
  moved->polygons = mesh.polygons;
  moved->cloud.width = mesh.cloud.width;
  moved->cloud.height = mesh.cloud.height;
  moved->cloud.point_step = 28;
  moved->cloud.row_step = 28 * mesh.cloud.width;
  moved->cloud.data.resize(std::size_t{moved->cloud.row_step} * moved->cloud.height);
  const char* names[] = {"intensity", "z", "x", "y"};
  const std::size_t axes[] = {0, 2, 0, 1};
  for (std::size_t f = 0; f < 4; ++f) {
    pcl::PCLPointField field;
    field.name = names[f];
    field.offset = f == 0 ? 0 : static_cast<pcl::uindex_t>(8 * f - 4);
    field.datatype = f == 0 ? pcl::PCLPointField::FLOAT32 : pcl::PCLPointField::FLOAT64;
    field.count = 1;
    moved->cloud.fields.push_back(field);
    for (std::size_t v = 0; f > 0 && v < mesh.cloud.width; ++v) {
      float from = 0.0F;
      std::memcpy(&from, mesh.cloud.data.data() + v * mesh.cloud.point_step + 4 * axes[f], sizeof from);
      const double to = double{from} + place[axes[f]];
      std::memcpy(moved->cloud.data.data() + v * 28 + field.offset, &to, sizeof to);
    }
  }
  return moved;
}

TEST(IntrinsicSymmetryEstimation, TakesDoublePositionsAtMapCoordinates)
{
  const std::array<double, 3> place{326499.0, 5822000.0, 34.0}; // floats there are half a metre apart
  pcl::IntrinsicSymmetryResult at_origin;
  pcl::IntrinsicSymmetryResult on_the_map;
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setParameters(staged());
  estimation.setInputMesh(humanMesh());
  estimation.compute(at_origin);
  EXPECT_EQ(estimation.getInputOffset(), (std::array<double, 3>{}));
  estimation.setInputMesh(inDoubles(*humanMesh(), place));
  estimation.compute(on_the_map);
  EXPECT_NEAR(estimation.getInputOffset()[0], place[0], 2.0);
  EXPECT_NEAR(estimation.getInputOffset()[1], place[1], 2.0);
  std::size_t same = 0;
  for (std::size_t v = 0; v < at_origin.partners.size(); ++v) {
    same += at_origin.partners[v] == on_the_map.partners[v] ? 1U : 0U;
  }
  EXPECT_GT(same, at_origin.partners.size() * 9 / 10); // rounding moves a few to a neighbour
  double moved_offset = at_origin.plane.offset;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(on_the_map.plane.normal[k], at_origin.plane.normal[k], 1e-2);
    moved_offset += on_the_map.plane.normal[k] * place[k];
  }
  EXPECT_NEAR(on_the_map.plane.offset, moved_offset, 0.02);
  estimation.setInputCloud(pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>());
  EXPECT_EQ(estimation.getInputOffset(), (std::array<double, 3>{}));
}

TEST(IntrinsicSymmetryEstimation, AMeshThatIsRefusedLeavesTheEarlierInput)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setParameters(staged());
  estimation.setInputMesh(humanMesh());
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(*humanMesh());
  mesh->polygons[5].vertices[1] = 100000;
  EXPECT_THROW(estimation.setInputMesh(mesh), pcl::BadArgumentException);
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  EXPECT_EQ(result.partners, compute(humanMesh()).partners);
}

TEST(IntrinsicSymmetryEstimation, SettersRefuseWhatIsOutOfRangeAndKeepWhatTheyHad)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  EXPECT_EQ(estimation.getKSearch(), 10);
  for (const int k : {-1, 0, 2, 257}) {
    expectInMessage(messageOf<pcl::BadArgumentException>([&] { estimation.setKSearch(k); }),
                    {"k_search is " + std::to_string(k), "3", "256"});
  }
  EXPECT_EQ(estimation.getKSearch(), 10);
  estimation.setKSearch(3);
  EXPECT_EQ(estimation.getKSearch(), 3);
  estimation.setKSearch(256);
  EXPECT_EQ(estimation.getParameters().k_search, 256);
  SymmetryParameters parameters;
  parameters.staged.landmarks = 9;
  EXPECT_THROW(estimation.setParameters(parameters), pcl::BadArgumentException);
  EXPECT_EQ(estimation.getParameters().staged.landmarks, 100);
}

TEST(IntrinsicSymmetryEstimation, GettersMirrorSetters)
{
  pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ> estimation;
  estimation.setNumberOfThreads(3);
  EXPECT_EQ(estimation.getNumberOfThreads(), 3U);
  EXPECT_EQ(estimation.getParameters().threads, 3U);
  estimation.setMethod(Method::Staged);
  EXPECT_EQ(estimation.getMethod(), Method::Staged);
  const auto search = pcl::make_shared<pcl::search::BruteForce<pcl::PointXYZ>>();
  estimation.setSearchMethod(search);
  EXPECT_EQ(estimation.getSearchMethod(), search);
}

TEST(IntrinsicSymmetryEstimation, PolygonsAreTriangulatedAsFans)
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(*humanMesh());
  mesh->polygons.clear();
  // Triangles in pairs that share an edge become quads, whose fan is either that pair or the other diagonal's.
  const std::vector<Triangle>& triangles = bentHuman().surface.triangles;
  std::vector<char> used(triangles.size(), 0);
  std::size_t quads = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = i + 1; used[i] == 0 && j < std::min(i + 40, triangles.size()); ++j) {
      for (std::size_t a = 0; a < 3 && used[i] == 0; ++a) {
        for (std::size_t b = 0; b < 3 && used[i] == 0 && used[j] == 0; ++b) {
          const Triangle& s = triangles[i];
          const Triangle& t = triangles[j];
          if (s[a] == t[(b + 1) % 3] && s[(a + 1) % 3] == t[b]) {
            mesh->polygons.push_back(polygon({s[(a + 1) % 3], s[(a + 2) % 3], s[a], t[(b + 2) % 3]}));
            used[i] = used[j] = 1;
            ++quads;
          }
        }
      }
    }
    if (used[i] == 0) {
      mesh->polygons.push_back(polygon({triangles[i][0], triangles[i][1], triangles[i][2]}));
    }
  }
  ASSERT_GT(quads, triangles.size() / 8);
  mesh->polygons.push_back(polygon({0, 1})); // encloses nothing
  const pcl::IntrinsicSymmetryResult result = compute(mesh);
  ASSERT_EQ(result.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(result.input.faces, triangles.size());
  EXPECT_GE(correspondenceRate(mapErrors(bentHuman(), result.partners)), 0.95);
}

template <typename PointT>
class PointTypeTest : public testing::Test {
};

using PointTypes = testing::Types<pcl::PointXYZ,
                                  pcl::PointXYZI,
                                  pcl::PointXYZL,
                                  pcl::PointXYZRGB,
                                  pcl::PointXYZRGBA,
                                  pcl::PointXYZRGBL,
                                  pcl::PointNormal,
                                  pcl::PointXYZINormal,
                                  pcl::PointXYZRGBNormal>;
TYPED_TEST_SUITE(PointTypeTest, PointTypes);

TYPED_TEST(PointTypeTest, GivesTheSameMap)
{
  const pcl::IntrinsicSymmetryResult result = compute<TypeParam>(humanMesh());
  EXPECT_EQ(result.status, SymmetryStatus::Symmetric);
  EXPECT_EQ(result.partners, compute<pcl::PointXYZ>(humanMesh()).partners);
}

} // namespace
