// References for the names of sides: files that were labelled before; others are refused, with the reason.
#include "io/sample_result.h"
#include "support/known_body.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>
#include <pcl/symmetry/symmetry.h>

#include <pcl/exceptions.h>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

class NameReferenceFile : public TemporaryFolder {
protected:
  static std::string
  complaint(const std::string& file)
  {
    return messageOf<IOException>([&file] { readNameReference(file); });
  }
};

TEST_F(NameReferenceFile, IsWhatWasLabelledBefore)
{
  const Model model = body(Body::Human, 0.3);
  const SymmetryResult found = estimateIntrinsicSymmetry(model.surface);
  ASSERT_TRUE(hasMap(found.status));
  for (const std::string name : {"human.ply", "human.pcd"}) {
    SCOPED_TRACE(name);
    writeLabelledSurface(path(name), model.surface, found);
    SymmetryResult again = found;
    readNameReference(path(name)).nameSides(model.surface, again);
    EXPECT_FALSE(again.naming.exchanged);
    EXPECT_GT(again.naming.margin, 0.1F);
  }
}

TEST_F(NameReferenceFile, WithoutLabelsIsRefused)
{
  const std::string plain =
      write("plain.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                         "property float z\nend_header\n0 0 0\n1 0 0\n");
  EXPECT_NE(complaint(plain).find(plain + ": has no integers 'label'"), std::string::npos) << complaint(plain);
  const std::string off = write("plain.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_NE(complaint(off).find("has no integers 'label'"), std::string::npos);
}

TEST_F(NameReferenceFile, WithLabelsOutOfRangeIsRefused)
{
  const auto file = [this](const std::string& first) {
    return write("wild.ply",
                 "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float "
                 "z\nproperty int label\nproperty int partner\nend_header\n0 0 0 " +
                     first + "\n1 0 0 2 0\n");
  };
  EXPECT_NE(complaint(file("7 1")).find("label 7 of point 0 is out of range"), std::string::npos);
  EXPECT_NE(complaint(file("1 2")).find("partner 2 of point 0 is out of range"), std::string::npos);
  EXPECT_NE(complaint(file("2 1")).find("has no point on the source side"), std::string::npos);
  EXPECT_NE(complaint(file("1 1")).find("too few points"), std::string::npos);
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
