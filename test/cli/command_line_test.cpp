// Words beside the options, help and version, and what is no command line.
#include "cli/command_line.h"
#include "cli/program.h"

#include <gtest/gtest.h>

using namespace pcl::symmetry;

namespace {

class CommandLineTest : public ::testing::Test {
protected:
  CommandLineTest()
  {
    OptionGroup group("General");
    group.number("count,c", count_, "N", "how many");
    line_.addLast(group);
  }

  bool
  read(std::vector<const char*> words)
  {
    words.insert(words.begin(), "program");
    return line_.read(static_cast<int>(words.size()), words.data());
  }

  std::string
  onlyWordOf(const std::vector<const char*>& words)
  {
    try {
      EXPECT_TRUE(read(words));
      return line_.onlyWord("INPUT", "a file");
    }
    catch (const UsageError& error) {
      return std::string("refused: ") + error.what();
    }
  }

  int count_ = 3;
  CommandLine line_{"program", "program INPUT\n", "\nThat is all.\n"};
};

TEST_F(CommandLineTest, WordsMayStandAnywhere)
{
  EXPECT_TRUE(read({"a", "-c", "4", "b", "--", "--count"}));
  EXPECT_EQ(line_.words(), (std::vector<std::string>{"a", "b", "--count"}));
  EXPECT_EQ(count_, 4);
  EXPECT_TRUE(read({"-c5"}));
  EXPECT_TRUE(line_.words().empty()) << "each reading begins anew";
}

TEST_F(CommandLineTest, OnlyWordIsThereOnceAndNotEmpty)
{
  EXPECT_EQ(onlyWordOf({"-c", "1", "a.ply"}), "a.ply");
  EXPECT_EQ(onlyWordOf({}), "refused: INPUT, a file, is missing");
  EXPECT_EQ(onlyWordOf({"a", "b"}), "refused: more than one INPUT: 'b'");
  EXPECT_EQ(onlyWordOf({""}), "refused: INPUT has no name");
}

TEST_F(CommandLineTest, HelpIsAllThereIsToDo)
{
  ::testing::internal::CaptureStdout();
  const bool goes_on = read({"--help", "--count", "many", "a", "b"});
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_FALSE(goes_on) << "what else is wrong does not matter";
  EXPECT_EQ(text, "Usage: program INPUT\n\n"
                  "General:\n"
                  "  -c [ --count ] N (=3)  how many\n"
                  "  -h [ --help ]          print this text\n"
                  "  --version              print the version\n"
                  "\nThat is all.\n");
  EXPECT_EQ(count_, 3);
}

TEST_F(CommandLineTest, VersionIsOneLine)
{
  ::testing::internal::CaptureStdout();
  const bool goes_on = read({"--version"});
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "program " PCL_SYMMETRY_VERSION "\n");
  EXPECT_FALSE(goes_on);
}

TEST_F(CommandLineTest, RefusesWordsThatMessagesWouldNeverEndWith)
{
  for (const char* const word :
       {"--%canonical_option%", "--count=%value%", "-%prefix%", "--x%option%", "--x%original_token%=1"}) {
    EXPECT_THROW(read({word}), UsageError) << word;
  }
}

TEST_F(CommandLineTest, RefusesWhatIsNoOption)
{
  EXPECT_THROW(read({"--other"}), UsageError);
  EXPECT_THROW(read({"--coun", "4"}), UsageError) << "names are not guessed";
  EXPECT_THROW(read({"-x"}), UsageError);
  EXPECT_THROW(read({"--count"}), UsageError);
}

} // namespace
