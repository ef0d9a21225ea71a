/** \file
 * \brief Tables of command-line options that write to the variables of a program.
 */
#pragma once

#include "estimation/enum_names.h"
#include "io/write/record_writer.h"

#include <boost/program_options/options_description.hpp>

#include <charconv>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

namespace pcl {
namespace symmetry {

/** \brief A number that is all of \a word. Unlike streams, and thus Boost, it takes no "-1" for a large unsigned
 * number. \return false where it is none, or does not fit; \a value stays as it was then */
template <typename Number>
bool
parseNumber(std::string_view word, Number& value)
{
  if (word.size() > 1 && word[0] == '+' && word[1] != '-')
    word.remove_prefix(1);
  Number parsed{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), parsed);
  if (error != std::errc{} || end != word.data() + word.size())
    return false;
  value = parsed;
  return true;
}

/** \brief Whether the help tells the value that a variable has before the command line is read. */
enum class Default { Shown, Hidden };

/** \brief Options under one title in the help.
 *
 * The name of an option may be followed by a comma and a letter: "quiet,q". A variable keeps its value unless the
 * command line has the option, and must outlive the reading of the command line; where the program has to know whether
 * the option was there, it is a std::optional. A value that is refused throws UsageError, which names the option.
 */
class OptionGroup {
public:
  explicit OptionGroup(const std::string& title) : description_(title)
  {
  }

  /** \brief An option without a value. */
  void
  flag(const char* option, bool& target, const char* help);

  /** \brief An option that CommandLine answers itself. */
  void
  flag(const char* option, const char* help);

  /** \brief Any word. */
  void
  word(const char* option, std::string& target, const char* value_name, const char* help);

  /** \brief The name of a file; an empty one is refused: an unset variable of a script, most likely. */
  void
  file(const char* option, std::string& target, const char* help);

  /** \brief The name of a folder, not empty. */
  void
  folder(const char* option, std::string& target, const char* help);

  /** \brief Any word; the option may come several times. */
  void
  words(const char* option, std::vector<std::string>& target, const char* value_name, const char* help);

  /** \brief A number, with nothing behind it. */
  template <typename Number>
  void
  number(const char* option, Number& target, const char* value_name, const char* help, Default known = Default::Shown)
  {
    add(option, value_name + shown(target, known), Words::One, help, numberReader(option, target));
  }

  /** \brief A number that may be missing behind the option, which then changes nothing. */
  template <typename Number>
  void
  numberOrNothing(const char* option, Number& target, const char* value_name, const char* help)
  {
    const std::string value = shown(target, Default::Shown);
    add(option, "[=" + (value_name + value.substr(1)) + "]" + value, Words::OneOrNone, help,
        numberReader(option, target));
  }

  /** \brief A whole number in [0, \a most]. */
  template <typename Target>
  void
  count(const char* option, Target& target, unsigned most, const char* help, Default known = Default::Shown)
  {
    add(option, "N" + shown(target, known), Words::One, help,
        [=, &target](const std::string& word) { target = countUpTo(most, option, word); });
  }

  /** \brief One of the names of a table. */
  template <typename Target, typename Enum, std::size_t Size>
  void
  choice(const char* option, Target& target, const EnumName<Enum> (&table)[Size], const char* help)
  {
    std::string value_text = "NAME";
    if constexpr (std::is_same_v<Target, Enum>)
      value_text += shown(std::string(nameOf(table, target)), Default::Shown);
    add(option, value_text, Words::One, help, [=, &target, &table](const std::string& word) {
      const std::optional<Enum> value = valueOf(table, word);
      if (!value)
        refuse(option, "is " + allNames(table) + ", not '" + word + "'");
      target = *value;
    });
  }

  const boost::program_options::options_description&
  description() const
  {
    return description_;
  }

private:
  /** \brief How many words follow an option. */
  enum class Words { None, One, OneOrNone, OneEachTime };

  using Reader = std::function<void(const std::string& word)>;
  class Value;

  void
  named(const char* option, std::string& target, const char* value_name, const char* kind, const char* help);

  void
  add(const char* option, const std::string& value_text, Words words, const char* help, Reader read);

  /** \throws UsageError "--option reason", always */
  [[noreturn]] static void
  refuse(const char* option, const std::string& reason);

  /** \throws UsageError saying that \a word is not what \a option takes, always */
  [[noreturn]] static void
  refuseWord(const char* option, const std::string& word);

  /** \throws UsageError \a word is no whole number in [0, most] */
  static unsigned
  countUpTo(unsigned most, const char* option, const std::string& word);

  template <typename Number>
  static Reader
  numberReader(const char* option, Number& target)
  {
    return [option, &target](const std::string& word) {
      if (!parseNumber(word, target))
        refuseWord(option, word);
    };
  }

  /** \brief " (=value)"; empty where there is none, or it is not to be shown. */
  static std::string
  shown(const std::string& value, Default known)
  {
    return known == Default::Shown ? " (=" + value + ")" : "";
  }

  template <typename Number>
  static std::string
  shown(Number value, Default known)
  {
    std::string text;
    appendNumber(text, value);
    return shown(text, known);
  }

  template <typename Number>
  static std::string
  shown(const std::optional<Number>& /*value*/, Default /*known*/)
  {
    return "";
  }

  boost::program_options::options_description description_;
};

} // namespace symmetry
} // namespace pcl
