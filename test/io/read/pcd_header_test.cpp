// What a PCD header says, and headers whose lines do not agree. Damaged ones at random: broken_files_test.cpp.
#include "io/read/pcd_header.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

#include <map>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

using Lines = std::map<std::string, std::string>;

class PcdHeaderTest : public TemporaryFolder {
protected:
  /** \brief A header of two floats and three bytes, with some lines changed; an empty one is left out. */
  static std::string
  text(const Lines& changes = {})
  {
    const std::pair<const char*, const char*> lines[] = {
        {"VERSION", "0.7"}, {"FIELDS", "x y rgb"}, {"SIZE", "4 4 1"}, {"TYPE", "F F U"},
        {"COUNT", "1 1 3"}, {"WIDTH", "4"},        {"HEIGHT", "3"},   {"VIEWPOINT", "0 0 0 1 0 0 0"},
        {"POINTS", "12"},   {"DATA", "binary"}};
    std::string header = "# a comment\n";
    for (const auto& [keyword, words] : lines) {
      const auto change = changes.find(keyword);
      const std::string value = change == changes.end() ? words : change->second;
      if (!value.empty())
        header += std::string(keyword) + " " + value + "\n";
    }
    return header;
  }

  PcdHeader
  header(const std::string& content) const
  {
    return readPcdHeader(FileContent(write("a.pcd", content)));
  }

  std::string
  complaint(const Lines& changes) const
  {
    const std::string message = messageOf<IOException>([&] { header(text(changes)); });
    const std::size_t place = (path("a.pcd") + ": ").size();
    return message.size() > place ? message.substr(place) : message;
  }
};

TEST_F(PcdHeaderTest, HoldsFieldsAndPoints)
{
  const PcdHeader read = header(text() + "\n");
  EXPECT_EQ(read.format, PcdFormat::Binary);
  EXPECT_EQ(read.points, 12U);
  EXPECT_EQ(read.end_byte, text().size());
  EXPECT_EQ(read.end_line, 12U);
  ASSERT_EQ(read.fields.size(), 3U);
  EXPECT_EQ(read.fields[1].name, "y");
  EXPECT_TRUE(read.fields[1].is_number);
  EXPECT_EQ(read.fields[1].type, ScalarType::Float32);
  EXPECT_EQ(read.fields[2].count, 3U);
  EXPECT_EQ(read.fields[2].bytes(), 3U);
  EXPECT_EQ(read.pointBytes(), 11U);
}

TEST_F(PcdHeaderTest, SomeLinesMayBeMissing)
{
  const PcdHeader read =
      header(text({{"VERSION", ""}, {"COUNT", ""}, {"HEIGHT", ""}, {"POINTS", ""}, {"VIEWPOINT", ""}}));
  EXPECT_EQ(read.points, 4U) << "one row";
  EXPECT_EQ(read.fields[2].count, 1U);
}

TEST_F(PcdHeaderTest, TypesGoByLetterAndSize)
{
  const std::pair<const char*, ScalarType> types[] = {{"I 1", ScalarType::Int8},    {"I 2", ScalarType::Int16},
                                                      {"I 4", ScalarType::Int32},   {"I 8", ScalarType::Int64},
                                                      {"U 1", ScalarType::UInt8},   {"U 2", ScalarType::UInt16},
                                                      {"U 4", ScalarType::UInt32},  {"U 8", ScalarType::UInt64},
                                                      {"F 4", ScalarType::Float32}, {"F 8", ScalarType::Float64}};
  for (const auto& [name, type] : types) {
    const std::string word = name;
    const PcdHeader read =
        header(text({{"FIELDS", "x"}, {"TYPE", word.substr(0, 1)}, {"SIZE", word.substr(2)}, {"COUNT", ""}}));
    EXPECT_TRUE(read.fields.at(0).is_number) << name;
    EXPECT_EQ(read.fields[0].type, type) << name;
    EXPECT_EQ(read.fields[0].bytes(), sizeOf(type)) << name;
  }
  const PcdHeader padding = header(text({{"TYPE", "F F X"}, {"SIZE", "4 4 17"}}));
  EXPECT_FALSE(padding.fields[2].is_number) << "is passed over";
  EXPECT_EQ(padding.pointBytes(), 8U + 3U * 17U);
}

TEST_F(PcdHeaderTest, AFieldOfNoValuesTakesNoRoom)
{
  const PcdHeader read = header(text({{"COUNT", "1 1 0"}}));
  EXPECT_EQ(read.fields.at(2).bytes(), 0U);
  EXPECT_EQ(read.pointBytes(), 8U);
}

TEST_F(PcdHeaderTest, LettersOfTypesMayBeSmall)
{
  const PcdHeader read = header(text({{"TYPE", "f F u"}, {"DATA", "Binary"}}));
  EXPECT_EQ(read.fields.at(0).type, ScalarType::Float32);
  EXPECT_EQ(read.fields.at(2).type, ScalarType::UInt8);
  EXPECT_EQ(read.format, PcdFormat::Binary);
}

TEST_F(PcdHeaderTest, RefusesLinesThatDoNotAgree)
{
  EXPECT_EQ(complaint({{"SIZE", "4 4"}}), "line 4: 'SIZE' has 2 values instead of 3");
  EXPECT_EQ(complaint({{"TYPE", ""}}), "the header has no line 'TYPE'");
  EXPECT_EQ(complaint({{"FIELDS", ""}}), "the header has no line 'FIELDS'");
  EXPECT_EQ(complaint({{"POINTS", "11"}}), "line 10: POINTS is not WIDTH times HEIGHT");
  EXPECT_EQ(complaint({{"WIDTH", "-4"}}), "line 7: '-4' is no possible value of 'WIDTH'");
  EXPECT_EQ(complaint({{"WIDTH", "2147483647"}}), "line 7: more points than can be numbered");
  EXPECT_EQ(complaint({{"COUNT", "1 -1 3"}}), "line 6: '-1' is no possible value of 'COUNT'");
  EXPECT_EQ(complaint({{"SIZE", "4 4 1000000"}}), "line 4: the fields of one point take more than 1048576 bytes");
  EXPECT_EQ(complaint({{"DATA", "zip"}}), "line 11: 'zip' is not a kind of data: ascii, binary or binary_compressed");
  EXPECT_EQ(complaint({{"DATA", ""}}), "line 11: the file ends where a line of the header, up to 'DATA', is expected");
  EXPECT_EQ(complaint({{"WIDTH", "4\nWIDTH 4"}}), "line 8: a second line 'WIDTH'");
  EXPECT_EQ(complaint({{"WIDTH", "4\nCOLOUR 4"}}), "line 8: unexpected 'COLOUR' in the header: not a PCD file?");
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
