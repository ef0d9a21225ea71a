// Values of options: what is taken, what is refused, and how the help words them.
#include "cli/command_line.h"
#include "cli/option_group.h"
#include "cli/program.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <sstream>

using namespace pcl::symmetry;

namespace {

/** Reads a command line of these words. */
void
read(const OptionGroup& group, std::vector<const char*> words)
{
  words.insert(words.begin(), "program");
  CommandLine line("program", "program\n");
  line.add(group);
  ASSERT_TRUE(line.read(static_cast<int>(words.size()), words.data()));
}

/** What is said about a command line that is refused; empty where it is not. */
std::string
refusal(const OptionGroup& group, const std::vector<const char*>& words)
{
  try {
    read(group, words);
  }
  catch (const UsageError& error) {
    return error.what();
  }
  return {};
}

std::string
help(const OptionGroup& group)
{
  std::ostringstream text;
  text << group.description();
  return text.str();
}

TEST(ParseNumber, TakesWhatIsWhollyANumber)
{
  int whole = 0;
  EXPECT_TRUE(parseNumber("-12", whole));
  EXPECT_EQ(whole, -12);
  EXPECT_TRUE(parseNumber("+7", whole));
  EXPECT_EQ(whole, 7);
  double real = 0.0;
  EXPECT_TRUE(parseNumber("1e-3", real));
  EXPECT_EQ(real, 1e-3);
  EXPECT_TRUE(parseNumber("nan", real)) << "a range refuses it later";
  EXPECT_TRUE(real != real);
  std::uint64_t large = 0;
  EXPECT_TRUE(parseNumber("18446744073709551615", large));
  EXPECT_EQ(large, std::numeric_limits<std::uint64_t>::max());
}

TEST(ParseNumber, LeavesTheValueWhereTheWordIsNone)
{
  int whole = 5;
  for (const char* word : {"", "+", "-", "+-1", "1x", " 1", "1 ", "1.5", "2147483648", "one"})
    EXPECT_FALSE(parseNumber(word, whole)) << word;
  EXPECT_EQ(whole, 5);
  unsigned natural = 5;
  EXPECT_FALSE(parseNumber("-1", natural)) << "streams would read 4294967295";
  EXPECT_EQ(natural, 5U);
}

TEST(OptionGroup, WritesEachValueToItsVariable)
{
  bool quiet = false;
  bool loud = false;
  std::string name = "human";
  std::string file;
  std::vector<std::string> sets;
  float radius = 1.0F;
  std::optional<unsigned> threads;
  Method method = Method::Robust;
  OptionGroup group("Options");
  group.flag("quiet,q", quiet, "");
  group.flag("loud", loud, "");
  group.word("name", name, "NAME", "");
  group.file("file", file, "");
  group.words("set", sets, "NAME", "");
  group.number("radius", radius, "R", "");
  group.count("threads", threads, 8, "");
  group.choice("method", method, method_names, "");
  read(group, {});
  EXPECT_FALSE(quiet || threads || !file.empty()) << "nothing changes without an option";
  EXPECT_EQ(name, "human");
  read(group, {"-q", "--name", "bird", "--file=a b", "--set", "x", "--set", "y", "--radius", "-2.5", "--threads", "0",
               "--method", "staged"});
  EXPECT_TRUE(quiet && !loud);
  EXPECT_EQ(name, "bird");
  EXPECT_EQ(file, "a b");
  EXPECT_EQ(sets, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(radius, -2.5F);
  EXPECT_EQ(threads, 0U);
  EXPECT_EQ(method, Method::Staged);
}

TEST(OptionGroup, RefusesWrongValuesNamingTheOption)
{
  unsigned threads = 3;
  float radius = 1.0F;
  std::string file;
  Metric metric = Metric::Geodesic;
  bool quiet = false;
  OptionGroup group("Options");
  group.count("threads,t", threads, 8, "");
  group.number("radius", radius, "R", "");
  group.file("map", file, "");
  group.choice("metric", metric, metric_names, "");
  group.flag("quiet", quiet, "");
  EXPECT_EQ(refusal(group, {"--threads", "9"}), "--threads 9 is not in [0, 8]");
  EXPECT_EQ(refusal(group, {"-t", "-1"}), "--threads -1 is not in [0, 8]");
  EXPECT_EQ(refusal(group, {"--threads", "two"}), "the argument ('two') for option '--threads' is invalid");
  EXPECT_EQ(refusal(group, {"--radius", "1m"}), "the argument ('1m') for option '--radius' is invalid");
  EXPECT_EQ(refusal(group, {"--map", ""}), "--map needs the name of a file");
  EXPECT_EQ(refusal(group, {"--metric", "taxicab"}), "--metric is geodesic or euclidean, not 'taxicab'");
  EXPECT_EQ(refusal(group, {"--radius", "1", "--radius", "2"}), "option '--radius' cannot be specified more than once");
  EXPECT_NE(refusal(group, {"--radius"}), "");
  EXPECT_NE(refusal(group, {"--quiet=yes"}), "");
  EXPECT_EQ(threads, 3U);
  EXPECT_EQ(metric, Metric::Geodesic);
}

TEST(OptionGroup, NumberMayBeMissingBehindItsOption)
{
  double share = 0.3;
  bool quiet = false;
  OptionGroup group("Options");
  group.numberOrNothing("flip", share, "F", "");
  group.flag("quiet", quiet, "");
  read(group, {"--flip", "--quiet"});
  EXPECT_EQ(share, 0.3);
  read(group, {"--flip=0"});
  EXPECT_EQ(share, 0.0);
  EXPECT_NE(refusal(group, {"--flip=x"}), "");
}

TEST(OptionGroup, HelpTellsNamesAndDefaults)
{
  double share = 0.3;
  float radius = 0.0F;
  std::optional<unsigned> threads;
  PairingFeature pairing = PairingFeature::BySurfaceSize;
  std::string body = "human";
  OptionGroup group("Things");
  group.numberOrNothing("flip", share, "F", "flipped");
  group.number("radius,r", radius, "R", "longest", Default::Hidden);
  group.count("threads", threads, 8, "at once");
  group.choice("pairing", pairing, pairing_names, "pairs");
  group.word("body", body, "NAME", "grown");
  const std::string text = help(group);
  EXPECT_EQ(text.compare(0, 8, "Things:\n"), 0) << text;
  for (const char* part : {"--flip [=F(=0.3)] (=0.3)", "-r [ --radius ] R  ", "--threads N  ", "--pairing NAME (=size)",
                           "--body NAME (=human)"})
    EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
}

} // namespace
