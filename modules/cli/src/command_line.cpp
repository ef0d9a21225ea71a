#include "cli/command_line.h"

#include "cli/program.h"

#include <boost/program_options/parsers.hpp>
#include <boost/program_options/variables_map.hpp>

#include <algorithm>
#include <iostream>
#include <utility>

namespace po = boost::program_options;

namespace pcl {
namespace symmetry {
namespace {

bool
has(const po::parsed_options& parsed, const char* name)
{
  return std::any_of(parsed.options.begin(), parsed.options.end(),
                     [name](const po::option& option) { return option.string_key == name; });
}

/** Boost.Program_options puts a wrong word into its message in place of %canonical_option% and the like, again and again
 * where the word holds one itself: it would never end. No name of an option or a file needs one. */
void
refusePlaceholders(int argc, const char* const* argv)
{
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    for (const char* const placeholder :
         {"%canonical_option%", "%option%", "%original_token%", "%prefix%", "%value%"}) {
      if (word.find(placeholder) != std::string::npos) {
        throw UsageError("'" + word + "' holds " + placeholder + ", which no option and no name may");
      }
    }
  }
}

} // namespace

CommandLine::CommandLine(std::string program, std::string usage, std::string after_options)
    : program_(std::move(program)), usage_(std::move(usage)), after_options_(std::move(after_options))
{
}

void
CommandLine::add(const OptionGroup& group)
{
  options_.add(group.description());
}

void
CommandLine::addLast(OptionGroup group)
{
  group.flag("help,h", "print this text");
  group.flag("version", "print the version");
  add(group);
}

bool
CommandLine::read(int argc, const char* const* argv)
try {
  refusePlaceholders(argc, argv);
  const auto style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  const po::parsed_options parsed = po::command_line_parser(argc, argv).options(options_).style(style).run();
  if (has(parsed, "help")) {
    std::cout << "Usage: " << usage_ << options_ << after_options_;
    return false;
  }
  if (has(parsed, "version")) {
    std::cout << program_ << " " PCL_SYMMETRY_VERSION "\n";
    return false;
  }
  po::variables_map seen;
  po::store(parsed, seen);
  words_ = po::collect_unrecognized(parsed.options, po::include_positional);
  return true;
}
catch (const po::error& error) {
  throw UsageError(error.what());
}

const std::string&
CommandLine::onlyWord(const std::string& name, const std::string& kind) const
{
  if (words_.empty())
    throw UsageError(name + ", " + kind + ", is missing");
  if (words_.size() > 1)
    throw UsageError("more than one " + name + ": '" + words_[1] + "'");
  if (words_.front().empty())
    throw UsageError(name + " has no name");
  return words_.front();
}

} // namespace symmetry
} // namespace pcl
