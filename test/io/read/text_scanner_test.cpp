// Lines and words of a text, whatever ends a line, and numbers exactly as the standard library rounds them.
#include "io/read/text_scanner.h"
#include "support/messages.h"
#include "support/temporary_folder.h"

#include <pcl/exceptions.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

namespace pcl {
namespace symmetry {
namespace test {
namespace {

class TextScannerTest : public TemporaryFolder {
protected:
  FileContent
  text(const std::string& content) const
  {
    return FileContent(write("text", content));
  }

  /** \brief The words of all lines. */
  std::vector<std::vector<std::string>>
  wordsOf(const std::string& content, TextSyntax syntax = {}) const
  {
    const FileContent file = text(content);
    TextScanner scanner(file, syntax);
    std::vector<std::vector<std::string>> lines;
    while (scanner.nextLine()) {
      lines.emplace_back();
      for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
        lines.back().emplace_back(word);
    }
    return lines;
  }

  float
  numberOf(const std::string& content) const
  {
    const FileContent file = text(content);
    TextScanner scanner(file);
    EXPECT_TRUE(scanner.nextLine());
    return scanner.number();
  }

  using Lines = std::vector<std::vector<std::string>>;
};

TEST_F(TextScannerTest, AnyLineEndAndAnyBlank)
{
  const Lines expected = {{"a", "b"}, {"c"}};
  for (const char* content : {"a b\nc", "a b\r\nc\r\n", "a\tb\rc\r", "\n\n  a \v\f b \n \r\n\r c\n\n",
                              "\xEF\xBB\xBF"
                              "a b\nc"})
    EXPECT_EQ(wordsOf(content), expected) << content;
  EXPECT_TRUE(wordsOf(" \n\t\r\n").empty());
}

TEST_F(TextScannerTest, CommentsAndContinuedLinesWhereTheFormatHasThem)
{
  const std::string content = "a#b c\n#d\ne\\\nf \\\r\n g\n";
  EXPECT_EQ(wordsOf(content, {true, false}), (Lines{{"a"}, {"e\\"}, {"f", "\\"}, {"g"}}));
  EXPECT_EQ(wordsOf(content, {false, true}), (Lines{{"a#b", "c"}, {"#d"}, {"e", "f", "g"}}));
  EXPECT_EQ(wordsOf(content), (Lines{{"a#b", "c"}, {"#d"}, {"e\\"}, {"f", "\\"}, {"g"}}));
}

TEST_F(TextScannerTest, EmptyLinesWhereTheyCount)
{
  const FileContent file = text("a b\r\n\n c\n\n\nd");
  TextScanner scanner(file);
  std::vector<std::string> words;
  while (scanner.nextLineOrEmpty())
    words.emplace_back(scanner.word()); // what is left of the first line stays unread
  EXPECT_EQ(words, (std::vector<std::string>{"a", "", "c", "", "", "d"}));
  EXPECT_EQ(scanner.line(), 6U);
}

TEST_F(TextScannerTest, LinesAreCountedFromOne)
{
  const FileContent file = text("a\r\n\r\nb c\rd");
  TextScanner scanner(file);
  for (const std::size_t line : {1U, 3U, 4U}) {
    ASSERT_TRUE(scanner.nextLine());
    EXPECT_EQ(scanner.line(), line); // what is left of line 3 stays unread
  }
  EXPECT_EQ(scanner.word(), "d");
  EXPECT_EQ(scanner.remaining(), 0U);
  EXPECT_FALSE(scanner.nextLine());
}

TEST_F(TextScannerTest, MayBeginInTheMiddleAndEndBeforeData)
{
  const FileContent file = text("skipped\nend_header\r\n\nbytes");
  TextScanner scanner(file, {}, 8, 2);
  scanner.needLine("a line");
  EXPECT_EQ(scanner.word(), "end_header");
  scanner.finishLine();
  EXPECT_EQ(scanner.position(), 20U) << "the empty line behind belongs to the data";
  EXPECT_EQ(scanner.line(), 3U);
  EXPECT_EQ(scanner.remaining(), 6U);
}

TEST_F(TextScannerTest, NumbersAreThoseOfTheStandardLibrary)
{
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    char digits[64];
    const double value = std::ldexp(static_cast<double>(random()) - 2e9, static_cast<int>(random() % 200U) - 130);
    std::snprintf(digits, sizeof(digits), i % 2 == 0 ? "%.17g" : "%.6f", value);
    EXPECT_EQ(numberOf(digits), std::strtof(digits, nullptr)) << digits;
  }
  EXPECT_EQ(numberOf("+.5"), 0.5F);
  EXPECT_EQ(numberOf("5."), 5.0F);
  EXPECT_TRUE(std::isnan(numberOf("NaN")));
  EXPECT_EQ(numberOf("-Inf"), -std::numeric_limits<float>::infinity());
  EXPECT_EQ(numberOf("1e999999"), std::numeric_limits<float>::infinity());
  EXPECT_EQ(numberOf("-1e-999999"), 0.0F);
}

TEST_F(TextScannerTest, AnOriginIsSubtractedBeforeRounding)
{
  const FileContent file = text("5400000.125 5400000.125 1e999 0.1");
  TextScanner scanner(file);
  scanner.nextLine();
  EXPECT_EQ(scanner.numberFrom(5400000.0), 0.125F);
  EXPECT_EQ(scanner.numberFrom(0.0), 5400000.0F);
  EXPECT_EQ(scanner.preciseNumber(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(scanner.preciseNumber(), 0.1);
}

TEST_F(TextScannerTest, ComplaintsNameLineAndWord)
{
  const auto complaint = [this](const std::string& line, auto read) {
    const FileContent file = text("\n" + line);
    TextScanner scanner(file);
    scanner.nextLine();
    return messageOf<IOException>([&] { read(scanner); });
  };
  const auto number = [](TextScanner& s) {
    s.number();
  };
  const auto integer = [](TextScanner& s) {
    s.integer();
  };
  const std::string place = path("text") + ": line 2: ";
  EXPECT_EQ(complaint("1x", number), place + "'1x' is not a number");
  EXPECT_EQ(complaint("+-1", number), place + "'+-1' is not a number");
  EXPECT_EQ(complaint("1.5", integer), place + "'1.5' is not an integer");
  EXPECT_EQ(complaint("9223372036854775808", integer), place + "'9223372036854775808' is not an integer");
  EXPECT_EQ(complaint("1", [&](TextScanner& s) { s.word(), s.integer(); }),
            place + "the line ends where an integer is expected");
  EXPECT_EQ(complaint("1 2", [&](TextScanner& s) { s.number(), s.needLineEnd(); }),
            place + "unexpected '2' behind the last value of the line");
  EXPECT_EQ(complaint("1", [&](TextScanner& s) { s.needLine("a face"); }),
            place + "the file ends where a face is expected");
}

TEST(Words, AreQuotedReadably)
{
  EXPECT_EQ(quoted("a\tb\x80"), "'a?b?'");
  EXPECT_EQ(pcl::symmetry::quoted(std::string(40, 'x')), "'" + std::string(40, 'x') + "'");
  EXPECT_EQ(pcl::symmetry::quoted(std::string(41, 'x')), "'" + std::string(40, 'x') + "...'");
}

TEST(Words, LowerOnlyLatinLetters)
{
  EXPECT_EQ(toLower("AbZ@[09\xC4"), "abz@[09\xC4");
}

TEST(Words, IntegersAreWholeWords)
{
  std::int64_t value = 7;
  for (const char* word : {"", "+", "-", "1 ", " 1", "0x1", "1.0", "+-1", "9223372036854775808"})
    EXPECT_FALSE(parseInteger(word, value)) << word;
  EXPECT_TRUE(parseInteger("+12", value));
  EXPECT_EQ(value, 12);
  EXPECT_TRUE(parseInteger("-9223372036854775808", value));
  EXPECT_EQ(value, std::numeric_limits<std::int64_t>::min());
}

} // namespace
} // namespace test
} // namespace symmetry
} // namespace pcl
