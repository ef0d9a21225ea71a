// Files that a program is asked to write, checked before it begins.
#include "cli/output_names.h"
#include "cli/program.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using OutputNames = TemporaryFolder;

template <typename Check>
std::string
refusal(Check check)
{
  return messageOf<UsageError>(check);
}

TEST_F(OutputNames, EndingIsOneOfThoseThatAreWritten)
{
  EXPECT_EQ(refusal([] { checkEnding("axis", "", {".ply"}); }), "") << "not wanted";
  EXPECT_EQ(refusal([] { checkEnding("axis", "a.b/c.PCD", {".ply", ".pcd"}); }), "");
  EXPECT_EQ(refusal([] {
              checkEnding("axis", "a.ply/c", {".ply", ".pcd"});
            }),
            "--axis writes .ply or .pcd, not 'a.ply/c'");
}

TEST_F(OutputNames, NoFileOverwritesAnother)
{
  const std::string input = write("input.ply", "points");
  std::filesystem::create_hard_link(input, path("link.ply"));
  EXPECT_EQ(refusal([&] { checkDistinct({path("a"), "", path("b"), ""}, {input, ""}); }), "");
  EXPECT_EQ(refusal([&] {
              checkDistinct({path("a"), path("./a")}, {});
            }),
            "'" + path("./a") + "' would be overwritten: each file needs a name of its own");
  EXPECT_NE(refusal([&] { checkDistinct({input}, {input}); }), "");
  EXPECT_NE(refusal([&] { checkDistinct({path("link.ply")}, {input}); }), "") << "another name of the input";
}

TEST_F(OutputNames, FilesThatCannotBeWrittenAreFoundOutEarly)
{
  EXPECT_NO_THROW(checkWritableFiles({path("a"), ""}));
  EXPECT_EQ(countFiles(), 0U) << "nothing is left behind";
  EXPECT_THROW(checkWritableFiles({path("a"), path("missing/b")}), pcl::IOException);
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
