#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/symmetry/surface_io.h>

#include <gtest/gtest.h>
#include <pcl/exceptions.h>

#include <cmath>
#include <cstring>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

class ReadXyz : public TemporaryFolder {
protected:
  Surface
  readText(const std::string& content)
  {
    return readSurface(write("a.xyz", content));
  }

  std::string
  complaint(const std::string& content)
  {
    return messageOf<IOException>([&] { readText(content); });
  }
};

const std::vector<Vector3> two_points = {{1.0F, 2.0F, 3.0F}, {-4.0F, 0.5F, 60.0F}};

/** Names of the fields, and their values in the second row. */
std::vector<std::pair<std::string, float>>
fieldsOf(const Surface& surface)
{
  std::vector<std::pair<std::string, float>> fields;
  if (surface.fields != nullptr)
    for (const PointField& field : surface.fields->fields) {
      float value = 0.0F;
      std::memcpy(&value, field.values.data() + sizeof value, sizeof value);
      fields.emplace_back(field.name, value);
    }
  return fields;
}

using Fields = std::vector<std::pair<std::string, float>>;

TEST_F(ReadXyz, BlanksCommasAndSemicolonsPartValues)
{
  for (const char* content :
       {"1 2 3\n-4 0.5 6e1\n", "1\t2  3\r\n -4 .5 60 \r\n\r\n", "1,2,3\n-4, 0.5 ,60\n", "1;2;3\n-4; 0.5;+60\n",
        "1 2 3\n-4 0.5 60", "# by hand\n1 2 3 # the first\n// and\n-4 0.5 60\n% the end\n"}) {
    SCOPED_TRACE(content);
    const Surface surface = readText(content);
    EXPECT_EQ(surface.points, two_points);
    EXPECT_TRUE(surface.normals.empty());
    EXPECT_EQ(surface.fields, nullptr);
    EXPECT_FALSE(surface.hasFaces());
  }
}

TEST_F(ReadXyz, EveryEndingOfTheFormat)
{
  for (const char* name : {"a.XYZ", "a.txt", "a.asc", "a.pts"})
    EXPECT_EQ(readSurface(write(name, "1 2 3\n-4 0.5 60\n")).points, two_points) << name;
  EXPECT_EQ(readSurface(write("a.dat", "1 2 3\n-4 0.5 60\n"), "xyz").points, two_points);
}

TEST_F(ReadXyz, AFirstLineOfOneIntegerIsTheNumberOfPoints)
{
  EXPECT_EQ(readText("2\n1 2 3\n-4 0.5 60\n").points, two_points);
  EXPECT_EQ(readText("2\n# now they come\n1;2;3\n-4;0.5;60\n").points, two_points);
  expectInMessage(complaint("3\n1 2 3\n-4 0.5 60\n"), {"announces 3 points", "there are 2"});
}

TEST_F(ReadXyz, NamesOfTheColumns)
{
  for (const char* content :
       {"x y z Nx NY nz r g b\n", "//X Y Z Nx Ny Nz R G B\n", "# x y z nx ny nz red green blue\n"}) {
    SCOPED_TRACE(content);
    const Surface surface = readText(content + std::string("1 2 3 0 0 1 9 8 7\n-4 0.5 60 0 1 0 300 0.25 1\n"));
    EXPECT_EQ(surface.points, two_points);
    EXPECT_EQ(surface.normals, (std::vector<Vector3>{{0, 0, 1}, {0, 1, 0}}));
    EXPECT_EQ(fieldsOf(surface), (Fields{{"red", 300.0F}, {"green", 0.25F}, {"blue", 1.0F}}));
  }
  const Surface other = readText("\"Scan Angle\", Z ,X,Y\n7,3,1,2\n8,60,-4,0.5\n");
  EXPECT_EQ(other.points, two_points);
  EXPECT_EQ(fieldsOf(other), (Fields{{"Scan_Angle", 8.0F}}));
}

TEST_F(ReadXyz, ACommentThatNamesNoColumnsIsAComment)
{
  EXPECT_EQ(fieldsOf(readText("# x y z of a scan in the garden\n1 2 3 4.5\n-4 0.5 60 5.5\n")),
            (Fields{{"column_4", 5.5F}}));
  EXPECT_EQ(readText("# x y\n1 2 3\n-4 0.5 60\n").points, two_points);
}

TEST_F(ReadXyz, WithoutNamesNormalsAreOfLengthOne)
{
  const Surface surface = readText("1 2 3 0.6 0.8 0\n-4 0.5 60 0 0 -1\n5 5 5 0 0 0\n6 6 6 nan nan nan\n");
  ASSERT_EQ(surface.normals.size(), 4U);
  EXPECT_EQ(surface.normals[1], (Vector3{0, 0, -1}));
  EXPECT_EQ(surface.fields, nullptr);
}

TEST_F(ReadXyz, WithoutNamesColoursAreWholeNumbersUpTo255)
{
  EXPECT_EQ(fieldsOf(readText("1 2 3 255 0 17\n-4 0.5 60 1 2 3\n")),
            (Fields{{"red", 1.0F}, {"green", 2.0F}, {"blue", 3.0F}}));
  EXPECT_EQ(fieldsOf(readText("1 2 3 256 0 17\n-4 0.5 60 1 2 3\n")).front().first, "column_4");
}

/** Some write colours first, others normals; a value of its own may come before them. */
TEST_F(ReadXyz, WithoutNamesInAnyOrder)
{
  const Surface colours_first = readText("1 2 3 255 0 17 0 0 1\n-4 0.5 60 1 2 3 0.6 0.8 0\n");
  EXPECT_EQ(colours_first.normals[1], (Vector3{0.6F, 0.8F, 0.0F}));
  EXPECT_EQ(fieldsOf(colours_first), (Fields{{"red", 1.0F}, {"green", 2.0F}, {"blue", 3.0F}}));
  const Surface value_first = readText("2\n1 2 3 -1200 255 0 17\n-4 0.5 60 -800.5 1 2 3\n");
  EXPECT_EQ(fieldsOf(value_first), (Fields{{"column_4", -800.5F}, {"red", 1.0F}, {"green", 2.0F}, {"blue", 3.0F}}));
}

TEST_F(ReadXyz, NumbersThatAreNoneAreData)
{
  const Surface surface = readText("NaN nan NAN\n1 2 3\n-inf 1e99 0\n");
  ASSERT_EQ(surface.size(), 3U);
  EXPECT_TRUE(std::isnan(surface.points[0][2]));
  EXPECT_EQ(surface.points[2][1], INFINITY);
}

TEST_F(ReadXyz, MapCoordinatesAreReadInDoublePrecision)
{
  std::string text;
  for (int i = 0; i < 20; ++i)
    text += "5400000.0" + std::to_string(i + 10) + " 326000.5 " + std::to_string(i % 7) + "\n";
  const Surface surface = readText(text);
  EXPECT_GT(surface.offset[0], 5e6);
  EXPECT_NEAR(surface.points[5][0] - surface.points[4][0], 0.001F, 1e-6F);
}

TEST_F(ReadXyz, RefusesWhatIsNoTable)
{
  const std::vector<std::pair<std::string, std::vector<std::string>>> broken = {
      {"1 2 3\n1 2\n", {"line 2", "2 values", "has 3"}},
      {"1 2 3\n1 2 3 4\n", {"line 2", "unexpected '4'"}},
      {"1 2 3\n\n# and\n1 a 3\n", {"line 4", "'a'", "not a number"}},
      {"1 2\n3 4\n", {"line 1", "2 values", "no position"}},
      {"5\n", {"line 1", "the file ends"}},
      {"1,5;2,5;3,5\n", {"line 1", "'1,5'", "not a number"}},
      {"1,5 2,5 3,5\n1 2 3\n", {"line 2", "3 values", "has 6"}},
      {"x y w\n1 2 3\n", {"line 2", "names no columns x, y and z", "'x y w'"}},
      {"x y z i\n1 2 3\n", {"line 2", "names no columns", "'x y z i'"}},
      {"hello\nworld\n", {"line 2", "neither names of columns nor numbers"}},
      {"x y z\n", {"line 1", "no row of numbers"}},
      {"# nothing\n", {"no row of numbers"}},
      {"2\nwater\nO 0 0 0\nH 1 0 0\n", {"line 2", "1 values", "no position"}}, // molecules have this ending, too
      {std::string("\0\1\2 3", 5), {"line 1"}}};
  for (const auto& [content, words] : broken) {
    SCOPED_TRACE(content);
    expectInMessage(complaint(content), words);
  }
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
