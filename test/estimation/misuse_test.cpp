// Misuse of the class ends in an exception of pcl/exceptions.h that says what is wrong.
#include "support/known_body.h"
#include "support/messages.h"
#include "support/pcl_input.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/intrinsic_symmetry.h>

#include <gtest/gtest.h>
#include <pcl/conversions.h>
#include <pcl/exceptions.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

using namespace pcl::symmetry;
using namespace pcl::symmetry::test;

namespace {

using Estimation = pcl::IntrinsicSymmetryEstimation<pcl::PointXYZ>;

/** A kd-tree whose answers are changed. */
class ChangedSearch : public pcl::search::KdTree<pcl::PointXYZ> {
public:
  using Change = std::function<int(int count, pcl::Indices& found, std::vector<float>& squared_distances)>;

  explicit ChangedSearch(Change change) : change_(std::move(change))
  {
  }

  using pcl::search::KdTree<pcl::PointXYZ>::nearestKSearch;

  int
  nearestKSearch(const pcl::PointXYZ& point,
                 int k,
                 pcl::Indices& found,
                 std::vector<float>& squared_distances) const override
  {
    const int count = pcl::search::KdTree<pcl::PointXYZ>::nearestKSearch(point, k, found, squared_distances);
    return change_(count, found, squared_distances);
  }

private:
  Change change_;
};

pcl::IntrinsicSymmetryResult
computeWith(ChangedSearch::Change change)
{
  SymmetryParameters parameters;
  parameters.method = Method::Staged; // a quarter of the time
  Estimation estimation;
  estimation.setParameters(parameters);
  estimation.setInputCloud(cloudOf(bentHuman().surface.points));
  estimation.setSearchMethod(pcl::make_shared<ChangedSearch>(std::move(change)));
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  return result;
}

std::string
complaintAbout(ChangedSearch::Change change)
{
  return messageOf<pcl::BadArgumentException>([&] { computeWith(std::move(change)); });
}

TEST(SearchMethod, MayNotReturnMoreThanIsAskedFor)
{
  const std::string complaint = complaintAbout([](int, pcl::Indices& found, std::vector<float>& squared_distances) {
    found.resize(500, 0);
    squared_distances.resize(500, 1.0F);
    return 500;
  });
  EXPECT_NE(complaint.find("returned 500 neighbours"), std::string::npos) << complaint;
}

TEST(SearchMethod, MayNotClaimMoreThanItsListHolds)
{
  EXPECT_NE(complaintAbout([](int count, pcl::Indices& found, std::vector<float>&) {
              found.clear();
              return count;
            }),
            "");
  EXPECT_NE(complaintAbout([](int, pcl::Indices&, std::vector<float>&) { return -3; }), "");
}

TEST(SearchMethod, MayNotReturnWhatIsNoPoint)
{
  for (const int index : {-1, -1000, std::numeric_limits<int>::max(), std::numeric_limits<int>::min(), 100000}) {
    const std::string complaint = complaintAbout([index](int count, pcl::Indices& found, std::vector<float>&) {
      found[2] = index;
      return count;
    });
    EXPECT_NE(complaint.find("neighbour " + std::to_string(index)), std::string::npos) << complaint;
  }
}

TEST(SearchMethod, MayAnswerInAnyOrder)
{
  const auto as_is = [](int count, pcl::Indices&, std::vector<float>&) {
    return count;
  };
  const auto reversed = [](int count, pcl::Indices& found, std::vector<float>& squared_distances) {
    std::reverse(found.begin(), found.end());
    std::reverse(squared_distances.begin(), squared_distances.end());
    return count;
  };
  const auto without_distances = [](int count, pcl::Indices&, std::vector<float>& squared_distances) {
    squared_distances.clear();
    return count;
  };
  const std::vector<Index> partners = computeWith(as_is).partners;
  EXPECT_EQ(computeWith(reversed).partners, partners);
  EXPECT_EQ(computeWith(without_distances).partners, partners);
}

TEST(SearchMethod, MayFindNothing)
{
  const pcl::IntrinsicSymmetryResult result = computeWith([](int, pcl::Indices& found, std::vector<float>&) {
    found.clear();
    return 0;
  });
  EXPECT_EQ(result.status, SymmetryStatus::TooFewPoints);
}

TEST(SearchMethod, MayThrow)
{
  struct Lost {};
  EXPECT_THROW(computeWith([](int, pcl::Indices&, std::vector<float>&) -> int { throw Lost(); }), Lost);
}

/** What is said about a mesh whose cloud was changed; empty where it is taken. */
template <typename Change>
std::string
complaintAboutMesh(Change change)
{
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>(*meshOf(bentHuman().surface));
  change(mesh->cloud);
  return messageOf<pcl::BadArgumentException>([&] { Estimation().setInputMesh(mesh); });
}

TEST(MeshCloud, MustHoldItsPoints)
{
  using Cloud = pcl::PCLPointCloud2;
  EXPECT_EQ(complaintAboutMesh([](Cloud&) {}), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.data.resize(100); }), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.data.clear(); }), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.data.resize(2 * cloud.data.size()); }), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.width *= 2; }), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.height = 3; }), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.row_step = 0; }), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.row_step *= 2; }), "");
}

TEST(MeshCloud, MustNotOverflow)
{
  EXPECT_NE(complaintAboutMesh([](pcl::PCLPointCloud2& cloud) {
              cloud.width = 65536;
              cloud.height = 65536; // 0 in 32 bits
              cloud.row_step = 0;
              cloud.data.clear();
            }),
            "");
  EXPECT_NE(complaintAboutMesh([](pcl::PCLPointCloud2& cloud) {
              cloud.width = 1U << 31U;
              cloud.point_step = 0;
              cloud.row_step = 0;
              cloud.data.clear();
            }),
            "");
}

TEST(MeshCloud, MustHaveItsFieldsWithinThePoints)
{
  using Cloud = pcl::PCLPointCloud2;
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.fields[2].offset = cloud.point_step; }), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.fields[0].offset = 0xFFFFFFFEU; }), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.fields[1].count = 1000; }), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.point_step = 4; }), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.fields[1].datatype = 77; }), "");
  EXPECT_NE(complaintAboutMesh([](Cloud& cloud) { cloud.is_bigendian = 1; }), "");
}

TEST(MeshCloud, MayBeEmpty)
{
  pcl::PointCloud<pcl::PointXYZ> none;
  const auto mesh = pcl::make_shared<pcl::PolygonMesh>();
  pcl::toPCLPointCloud2(none, mesh->cloud);
  Estimation estimation;
  estimation.setInputMesh(mesh);
  pcl::IntrinsicSymmetryResult result;
  estimation.compute(result);
  EXPECT_EQ(result.status, SymmetryStatus::TooFewPoints);
}

TEST(Enumerations, AreAmongTheirValues)
{
  Estimation estimation;
  EXPECT_THROW(estimation.setMethod(static_cast<Method>(7)), pcl::BadArgumentException);
  EXPECT_EQ(estimation.getMethod(), Method::Robust);
  const auto refuses = [&estimation](auto change) {
    SymmetryParameters parameters;
    change(parameters);
    EXPECT_THROW(estimation.setParameters(parameters), pcl::BadArgumentException);
    EXPECT_THROW(estimateIntrinsicSymmetry(bentHuman().surface, parameters), pcl::BadArgumentException);
  };
  refuses([](SymmetryParameters& p) { p.method = static_cast<Method>(-1); });
  refuses([](SymmetryParameters& p) { p.metric = static_cast<Metric>(2); });
  refuses([](SymmetryParameters& p) { p.normals = static_cast<NormalSource>(1000); });
  refuses([](SymmetryParameters& p) { p.components = static_cast<ComponentUse>(2); });
  refuses([](SymmetryParameters& p) { p.staged.extremities = static_cast<ExtremePoints>(2); });
  refuses([](SymmetryParameters& p) { p.staged.pairing = static_cast<PairingFeature>(3); });
}

TEST(Callback, ThatThrowsLeavesTheResultAsItWas)
{
  struct Enough {};
  Estimation estimation;
  estimation.setInputMesh(meshOf(bentHuman().surface));
  pcl::IntrinsicSymmetryResult result;
  result.message = "earlier";
  estimation.setProgressCallback([](const char*, double fraction) -> bool {
    if (fraction > 0.2)
      throw Enough();
    return true;
  });
  EXPECT_THROW(estimation.compute(result), Enough);
  EXPECT_EQ(result.message, "earlier");
}

} // namespace
