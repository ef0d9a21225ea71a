#include "benchmark/ground_truth.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

namespace pcl {
namespace symmetry {

bool
operator==(const TruePartner& a, const TruePartner& b)
{
  return a.vertex == b.vertex && a.partner == b.partner;
}

std::ostream&
operator<<(std::ostream& out, const TruePartner& pair)
{
  return out << pair.vertex << "->" << pair.partner;
}

namespace {

class GroundTruthTest : public test::TemporaryFolder {
protected:
  /** What the reader of a dense file says about this content. */
  std::string
  denseError(const std::string& content) const
  {
    const std::string file = write("sym.txt", content);
    return test::messageOf<pcl::IOException>([&] { readDenseTruth(file); });
  }

  std::string
  landmarkError(const std::string& landmarks, const std::string& symmetry) const
  {
    const std::string points = write("a.pid", landmarks);
    write("a.sym.info", symmetry);
    return test::messageOf<pcl::IOException>([&] { readGroundTruth(points); });
  }
};

TEST_F(GroundTruthTest, LandmarksGiveBothDirectionsAndTheAxis)
{
  const std::string points = write("cat.pid", "  70 0 0 0\n  71 0 0 0\n  72 0 0 0\n");
  write("cat.sym.info", "2 0\n1\n");
  EXPECT_EQ(readGroundTruth(points), (GroundTruth{{72, 70}, {70, 72}, {71, 71}}));
}

TEST_F(GroundTruthTest, LandmarkFilesMayHoldBlanksAndOrbitsAndLackTheLastNewline)
{
  const std::string points = write("3.vts", " 5 0.1 0.2 0.3\n\n 6 0.1 -2e-3 0\n 7 0 0 0\n 8 0 0 0");
  const std::string symmetry = write("1.sym.info", "\n0 1 \r\n  \n0 1 2 3\n 0 1 2\n3");
  EXPECT_EQ(readGroundTruth(points + ":" + symmetry), (GroundTruth{{5, 6}, {6, 5}, {8, 8}}));
}

TEST_F(GroundTruthTest, DenseListIsOneBasedAndMayBeFloats)
{
  const GroundTruth expected{{0, 2}, {1, 1}, {2, 0}};
  EXPECT_EQ(readGroundTruth(write("line.txt", "   3.0000000e+00   2.0000000e+00   1.0000000e+00\n")), expected);
  EXPECT_EQ(readGroundTruth(write("column.txt", "3\n2\n1")), expected);
  EXPECT_EQ(readGroundTruth(write("pairs.txt", "     1      3 \n     2      2 \n 3 1\n")), expected);
  EXPECT_EQ(readGroundTruth(write("two.txt", "2 1\n")), (GroundTruth{{0, 1}, {1, 0}})) << "one line is a list";
}

TEST_F(GroundTruthTest, DenseListLeavesOutVerticesWithoutPartner)
{
  EXPECT_EQ(readDenseTruth(write("list.txt", "2 1 0 -1 NaN 6")), (GroundTruth{{0, 1}, {1, 0}, {5, 5}}));
  EXPECT_EQ(readDenseTruth(write("pairs.txt", "9 4\n4 9\n5 0\n")), (GroundTruth{{8, 3}, {3, 8}}));
}

TEST_F(GroundTruthTest, RejectsWhatIsNoDenseList)
{
  EXPECT_NE(denseError("1 2\n2 one\n").find("sym.txt:2: 'one' is no number"), std::string::npos);
  EXPECT_NE(denseError("1\n2.5\n").find("sym.txt:2: '2.5'"), std::string::npos);
  EXPECT_NE(denseError("1 2\n2 1\n3\n").find("sym.txt:3: 2 numbers expected"), std::string::npos);
  EXPECT_NE(denseError("1e10").find("sym.txt:1: '1e10'"), std::string::npos);
  EXPECT_NE(denseError("inf").find("sym.txt:1: 'inf'"), std::string::npos);
  EXPECT_NE(denseError("0 0 0").find("no vertex with a partner"), std::string::npos);
  EXPECT_NE(denseError("").find("no vertex with a partner"), std::string::npos);
}

TEST_F(GroundTruthTest, RejectsWhatAreNoLandmarks)
{
  EXPECT_NE(landmarkError("1 0 0 0\nx 0 0 0\n", "0 1\n").find("a.pid:2: 'x' is no integer"), std::string::npos);
  EXPECT_NE(landmarkError("1 0 0 0\n-2 0 0 0\n", "0 1\n").find("a.pid:2: vertex -2"), std::string::npos);
  EXPECT_NE(landmarkError("1\n2\n", "0\n0 2\n").find("a.sym.info:2: landmark 2 is not in [0, 2)"), std::string::npos);
  EXPECT_NE(landmarkError("1\n2\n", "0 1.5\n").find("a.sym.info:1: '1.5' is no integer"), std::string::npos);
  EXPECT_NE(landmarkError("1\n2\n", "\n").find("no vertex with a partner"), std::string::npos);
  EXPECT_NE(landmarkError("99999999999\n", "0\n").find("a.pid:1:"), std::string::npos);
}

TEST_F(GroundTruthTest, RejectsFilesThatCannotBeRead)
{
  EXPECT_THROW(readGroundTruth(path("missing.txt")), pcl::IOException);
  EXPECT_THROW(readGroundTruth(path("missing.pid")), pcl::IOException);
  EXPECT_THROW(readGroundTruth(path("missing.vts:1.sym.info")), pcl::IOException);
  write("folder/file", "");
  EXPECT_THROW(readDenseTruth(path("folder")), pcl::IOException);
}

TEST(CheckGroundTruthTest, RejectsVerticesThatTheModelDoesNotHave)
{
  const GroundTruth truth{{0, 3}, {3, 0}};
  EXPECT_NO_THROW(checkGroundTruth(truth, 4, "sym.txt"));
  const std::string message = test::messageOf<pcl::IOException>([&] { checkGroundTruth(truth, 3, "sym.txt"); });
  EXPECT_NE(message.find("sym.txt: vertex 3 (0-based) is not in [0, 3)"), std::string::npos) << message;
}

} // namespace
} // namespace symmetry
} // namespace pcl
