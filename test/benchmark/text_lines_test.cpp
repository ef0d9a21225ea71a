#include "benchmark/text_lines.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <pcl/exceptions.h>

#include <cmath>
#include <fstream>

using namespace pcl::symmetry;

namespace {

class TextLinesTest : public testing::Test {
protected:
  std::string
  fileWith(const std::string& text) const
  {
    const std::string path = folder_.file("lines.txt");
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  test::ScratchFolder folder_;
};

using Words = std::vector<std::string_view>;

TEST_F(TextLinesTest, AreSplitIntoWordsAndBlankOnesPassedOver)
{
  TextLines lines(fileWith("one  two\t3\r\n\n \t\r\nlast"));
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.words(), (Words{"one", "two", "3"}));
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.words(), Words{"last"}); // no line break at the end
  EXPECT_FALSE(lines.next());
  EXPECT_FALSE(lines.next());
}

TEST_F(TextLinesTest, AreSplitAtOtherSeparatorsToo)
{
  TextLines lines(fileWith("a,b;;c d\n,;\n"), ",;");
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.words(), (Words{"a", "b", "c", "d"}));
  EXPECT_FALSE(lines.next());
}

TEST_F(TextLinesTest, AWordIsANumberAsAWholeOrNone)
{
  TextLines lines(fileWith("x\n"));
  EXPECT_EQ(lines.toInteger("-12"), -12);
  EXPECT_EQ(lines.toNumber("2.5e-3"), 2.5e-3);
  EXPECT_TRUE(std::isnan(lines.toNumber("NaN")));
  for (const char* word : {"", "1.0", "12a", "2147483648"}) {
    EXPECT_THROW(lines.toInteger(word), pcl::IOException) << word;
  }
  for (const char* word : {"", "1,5", "0.1x"}) {
    EXPECT_THROW(lines.toNumber(word), pcl::IOException) << word;
  }
}

TEST_F(TextLinesTest, AComplaintNamesFileAndLine)
{
  const std::string path = fileWith("first\n\nthird\n");
  TextLines lines(path);
  lines.next();
  lines.next();
  try {
    lines.fail("is wrong");
  }
  catch (const pcl::IOException& error) {
    EXPECT_NE(std::string(error.what()).find(path + ":3: is wrong"), std::string::npos) << error.what();
  }
}

TEST_F(TextLinesTest, WhatCannotBeReadIsRefused)
{
  EXPECT_THROW(TextLines(folder_.file("missing.txt")), pcl::IOException);
  EXPECT_THROW(TextLines(folder_.file("")).next(), pcl::IOException); // the folder itself
  TextLines empty(fileWith(""));
  EXPECT_FALSE(empty.next());
}

} // namespace
