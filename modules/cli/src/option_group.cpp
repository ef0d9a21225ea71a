#include "cli/option_group.h"

#include "cli/program.h"

#include <boost/program_options/errors.hpp>
#include <boost/program_options/value_semantic.hpp>

#include <utility>

namespace po = boost::program_options;

namespace pcl {
namespace symmetry {
namespace {

/** \brief "--quiet" of "quiet,q". */
std::string
longName(const std::string& option)
{
  return "--" + option.substr(0, option.find(','));
}

} // namespace

/** \brief What Boost asks about the value of an option; hands each word to a function. */
class OptionGroup::Value : public po::value_semantic {
public:
  Value(std::string text, Words words, Reader read) : text_(std::move(text)), words_(words), read_(std::move(read))
  {
  }

  std::string
  name() const override
  {
    return text_;
  }

  unsigned
  min_tokens() const override
  {
    return words_ == Words::One || words_ == Words::OneEachTime ? 1 : 0;
  }

  unsigned
  max_tokens() const override
  {
    return words_ == Words::None ? 0 : 1;
  }

  bool
  is_composing() const override
  {
    return words_ == Words::OneEachTime;
  }

  bool
  is_required() const override
  {
    return false;
  }

  void
  parse(boost::any& seen, const std::vector<std::string>& words, bool /*utf8*/) const override
  {
    if (!seen.empty() && words_ != Words::OneEachTime)
      throw po::multiple_occurrences();
    seen = true;
    if (words_ == Words::None)
      read_("");
    else if (!words.empty())
      read_(words.front());
  }

  bool
  apply_default(boost::any& /*seen*/) const override
  {
    return false;
  }

  void
  notify(const boost::any& /*seen*/) const override
  {
  }

private:
  std::string text_;
  Words words_;
  Reader read_;
};

void
OptionGroup::add(const char* option, const std::string& value_text, Words words, const char* help, Reader read)
{
  description_.add_options()(option, new Value(value_text, words, std::move(read)), help); // Boost deletes it
}

void
OptionGroup::refuse(const char* option, const std::string& reason)
{
  throw UsageError(longName(option) + " " + reason);
}

void
OptionGroup::refuseWord(const char* option, const std::string& word)
{
  throw UsageError("the argument ('" + word + "') for option '" + longName(option) + "' is invalid");
}

unsigned
OptionGroup::countUpTo(unsigned most, const char* option, const std::string& word)
{
  long long value = 0;
  if (!parseNumber(word, value))
    refuseWord(option, word);
  if (value < 0 || value > static_cast<long long>(most))
    refuse(option, std::to_string(value) + " is not in [0, " + std::to_string(most) + "]");
  return static_cast<unsigned>(value);
}

void
OptionGroup::flag(const char* option, bool& target, const char* help)
{
  add(option, "", Words::None, help, [&target](const std::string& /*word*/) { target = true; });
}

void
OptionGroup::flag(const char* option, const char* help)
{
  add(option, "", Words::None, help, [](const std::string& /*word*/) {});
}

void
OptionGroup::word(const char* option, std::string& target, const char* value_name, const char* help)
{
  const std::string text = target.empty() ? value_name : value_name + shown(target, Default::Shown);
  add(option, text, Words::One, help, [&target](const std::string& word) { target = word; });
}

void
OptionGroup::file(const char* option, std::string& target, const char* help)
{
  named(option, target, "FILE", "file", help);
}

void
OptionGroup::folder(const char* option, std::string& target, const char* help)
{
  named(option, target, "FOLDER", "folder", help);
}

void
OptionGroup::named(const char* option, std::string& target, const char* value_name, const char* kind, const char* help)
{
  add(option, value_name, Words::One, help, [=, &target](const std::string& word) {
    if (word.empty())
      refuse(option, std::string("needs the name of a ") + kind);
    target = word;
  });
}

void
OptionGroup::words(const char* option, std::vector<std::string>& target, const char* value_name, const char* help)
{
  add(option, value_name, Words::OneEachTime, help, [&target](const std::string& word) { target.push_back(word); });
}

} // namespace symmetry
} // namespace pcl
