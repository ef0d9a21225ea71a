/** \file
 * \brief Reads the command line of a program; answers --help and --version.
 */
#pragma once

#include "cli/option_group.h"
#include "cli/program.h"

#include <string>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief The options of a program and the words beside them.
 *
 * Options are written in full, "--name value" or "--name=value", or as "-n value".
 */
class CommandLine {
public:
  /** \param[in] program its name
   * \param[in] usage what --help says before the options, behind "Usage: "
   * \param[in] after_options what it says behind them */
  CommandLine(std::string program, std::string usage, std::string after_options = "");

  /** \brief Adds options, in the order of the help. */
  void
  add(const OptionGroup& group);

  /** \brief Adds a last group, with --help and --version behind its options. */
  void
  addLast(OptionGroup group);

  /** \brief Reads the command line and writes to the variables of the options.
   * \return false where help or version was asked for, and printed: there is nothing left to do
   * \throws UsageError unknown or incomplete option, refused value
   */
  bool
  read(int argc, const char* const* argv);

  /** \brief The words that are no options. */
  const std::vector<std::string>&
  words() const
  {
    return words_;
  }

  /** \brief The only word that is no option.
   * \param[in] name as in the usage, INPUT
   * \param[in] kind what it is, for messages: "a file"
   * \throws UsageError there is none, an empty or a second one */
  const std::string&
  onlyWord(const std::string& name, const std::string& kind) const;

private:
  std::string program_;
  std::string usage_;
  std::string after_options_;
  boost::program_options::options_description options_;
  std::vector<std::string> words_;
};

/** \brief A whole program, which is what remains of main: describes the options, reads them, and runs.
 * \param[in] describe makes the command line, whose options write to the options given
 * \param[in] run returns the exit status
 * \return the exit status, see runProgram () */
template <typename Options>
int
runCommand(const char* program,
           int argc,
           const char* const* argv,
           CommandLine (*describe)(Options& options),
           int (*run)(Options& options, const CommandLine& line))
{
  const auto whole = [=] {
    Options options;
    CommandLine line = describe(options);
    return line.read(argc, argv) ? run(options, line) : exit_done;
  };
  return runProgram(program, std::cref(whole)); // a copy would need memory, outside of what catches that there is none
}

} // namespace symmetry
} // namespace pcl
