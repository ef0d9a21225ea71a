// Any words as a command line: options of every kind either take them or say what is wrong.
#include "cli/command_line.h"
#include "cli/option_group.h"
#include "cli/parameter_options.h"
#include "cli/program.h"
#include "estimation/enum_names.h"

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

using namespace pcl::symmetry;

namespace {

/** The words of a text that is parted by zeros or line ends. */
std::vector<std::string>
wordsOf(const std::uint8_t* data, std::size_t size)
{
  std::vector<std::string> words(1);
  for (std::size_t i = 0; i < size; ++i) {
    if (data[i] == 0 || data[i] == '\n')
      words.emplace_back();
    else
      words.back() += static_cast<char>(data[i]);
  }
  return words;
}

void
readOptions(const std::vector<const char*>& argv)
{
  SymmetryParameters parameters;
  bool quiet = false;
  std::string name;
  std::string file;
  std::vector<std::string> sets;
  OptionGroup group("Options");
  group.flag("quiet,q", quiet, "");
  group.word("name", name, "NAME", "");
  group.file("output,o", file, "");
  group.words("set", sets, "NAME", "");
  group.number("neighbours,k", parameters.k_search, "N", "");
  group.number("radius", parameters.radius, "R", "");
  group.count("threads", parameters.threads, thread_limit, "");
  group.choice("method", parameters.method, method_names, "");
  CommandLine line("program", "program INPUT\n");
  line.addLast(std::move(group));
  if (line.read(static_cast<int>(argv.size()), argv.data())) {
    checkParameterOptions(parameters);
    (void)line.onlyWord("INPUT", "a file");
  }
}

} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const bool is_silent = (std::cout.setstate(std::ios::failbit), true); // --help is long
  (void)is_silent;
  const std::vector<std::string> words = wordsOf(data, size);
  std::vector<const char*> argv{"program"};
  for (const std::string& word : words)
    argv.push_back(word.c_str());
  try {
    readOptions(argv);
  }
  catch (const UsageError& /*refused*/) {
  }
  return 0;
}
