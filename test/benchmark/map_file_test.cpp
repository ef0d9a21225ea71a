#include "benchmark/map_file.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

namespace pcl {
namespace symmetry {
namespace {

using Partners = std::vector<Index>;

class MapFileTest : public test::TemporaryFolder {
protected:
  std::string
  error(const std::string& content) const
  {
    const std::string file = write("map.csv", content);
    return test::messageOf<pcl::IOException>([&] { readMap(file, 3); });
  }
};

TEST_F(MapFileTest, ReadsLinesInAnyOrderWithAndWithoutHeader)
{
  const std::string with_header = write("a.csv", "vertex,partner,confidence\n2,0,0.5\n0,2,0.25\n");
  EXPECT_EQ(readMap(with_header, 3), (Partners{2, no_index, 0}));
  const std::string without = write("b.csv", "# made by hand\n0;1\n1 ; -1\n\n#end");
  EXPECT_EQ(readMap(without, 3), (Partners{1, no_index, no_index}));
  EXPECT_EQ(readMap(write("c.csv", "0,1\n0,2\n"), 3)[0], 2) << "the last line counts";
}

TEST_F(MapFileTest, RejectsWhatIsNoMap)
{
  EXPECT_NE(error("0,1\nvertex,partner\n").find("map.csv:2: 'vertex' is no integer"), std::string::npos);
  EXPECT_NE(error("0\n").find("map.csv:1: a vertex and its partner"), std::string::npos);
  EXPECT_NE(error("3,0\n").find("map.csv:1: vertex 3 is not in [0, 3)"), std::string::npos);
  EXPECT_NE(error("-1,0\n").find("map.csv:1: vertex -1"), std::string::npos);
  EXPECT_NE(error("0,3\n").find("map.csv:1: partner 3 is not in [-1, 3)"), std::string::npos);
  EXPECT_NE(error("0,-2\n").find("map.csv:1: partner -2"), std::string::npos);
  EXPECT_NE(error("0,1.5\n").find("map.csv:1: '1.5'"), std::string::npos);
  EXPECT_NE(error("").find("map.csv: there is nothing in it"), std::string::npos);
  EXPECT_THROW(readMap(path("missing.csv"), 3), pcl::IOException);
}

} // namespace
} // namespace symmetry
} // namespace pcl
