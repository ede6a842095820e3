// SPDX-License-Identifier: BSD-3-Clause
#include "option_table.h"

#include "core/nearest_name.h"

#include <algorithm>
#include <cctype>

using namespace pcl_spiral;

namespace {

/** What stands for the value in the help: "MM", "DEGREES", "X,Y,Z", "cw|ccw". */
std::string
argumentOf(const Setting& setting)
{
  if (std::holds_alternative<bool*>(setting.target))
    return {};
  if (const auto* choice = std::get_if<ChoiceTarget>(&setting.target))
    return choice->words;
  if (!numberOf(setting) && !std::holds_alternative<std::optional<double>*>(setting.target))
    return "X,Y,Z";
  std::string argument = setting.unit.empty() ? "N" : setting.unit;
  for (char& letter : argument)
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return argument;
}

/** "radius of the ball cutter; required: --tool-radius 10" */
std::string
helpOf(const Setting& setting)
{
  const std::optional<double> number = numberOf(setting);
  const std::string value = textOf(setting);
  std::string help = setting.help;
  const bool is_zero = value.empty() || value == "0";
  if (number && !setting.range.takes(*number))
    help += "; required";
  else if (!setting.zero.empty() && is_zero)
    help += "; default " + setting.zero;
  else if (!value.empty() && !std::holds_alternative<bool*>(setting.target))
    help += "; default " + value;
  if (!setting.zero.empty() && !is_zero)
    help += ", 0 for " + setting.zero;
  return setting.example.empty() ? help : help + ": --" + setting.option + " " + setting.example;
}

/** Sets the variable of a setting from the text of its option. \throw UsageError */
struct TakeText {
  const Setting& setting;
  const std::string& name;
  const std::string& text;
  void operator()(bool* target) const { switchOption(name, "", *target).set(text); }
  void operator()(int* target) const { *target = wholeNumber(); }
  void operator()(unsigned int* target) const
  {
    const int number = wholeNumber();
    requireOption(number >= 0, name, number, ruleOf(setting));
    *target = static_cast<unsigned int>(number);
  }
  void operator()(double* target) const { *target = numberValue(name, text); }
  void operator()(std::optional<double>* target) const { *target = numberValue(name, text); }
  void operator()(Eigen::Vector3d* target) const { *target = placeValue(name, text); }
  void operator()(std::optional<Eigen::Vector3d>* target) const { *target = placeValue(name, text); }
  void operator()(const ChoiceTarget& target) const
  {
    if (!target.take(text))
      throw UsageError(Diagnostic("--", name, " ", text, ": must be one of ", target.words));
  }

private:
  /** In the range of the setting, also where that is too large for a whole number. */
  int wholeNumber() const
  {
    const double number = numberValue(name, text);
    requireOption(setting.range.takes(number), name, number, ruleOf(setting));
    return wholeNumberValue(name, text);
  }
};

} // namespace

void
addSettings(OptionGroup& group, const std::vector<Setting>& settings)
{
  for (const Setting& setting : settings) {
    const std::string name = setting.option;
    const auto has_name = [&name](const Option& option) { return option.name == name; };
    if (!setting.by_table || std::any_of(group.options.begin(), group.options.end(), has_name))
      continue;
    group.options.push_back({name, argumentOf(setting), helpOf(setting), [setting, name](const std::string& text) {
                               std::visit(TakeText{setting, name, text}, setting.target);
                               requireInRange({setting});
                             }});
  }
}

void
requireInRange(const std::vector<Setting>& settings)
{
  for (const Setting& setting : settings)
    if (const std::optional<double> number = numberOf(setting))
      requireOption(setting.range.takes(*number), setting.option, *number, ruleOf(setting));
}

void
addOptions(OptionGroup& group, const std::vector<Option>& more)
{
  group.options.insert(group.options.end(), more.begin(), more.end());
}

const Option*
findOption(const OptionTable& table, const std::string& name)
{
  for (const OptionGroup& group : table)
    for (const Option& option : group.options)
      if (option.name == name)
        return &option;
  return nullptr;
}

std::vector<std::string>
namesOf(const OptionTable& table)
{
  std::vector<std::string> names;
  for (const OptionGroup& group : table)
    for (const Option& option : group.options)
      names.push_back(option.name);
  return names;
}

std::string
suggestion(const OptionTable& table, const std::string& name)
{
  const std::string nearest = nearestName(name, namesOf(table));
  return nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?";
}

bool
mayRepeat(const OptionTable& table, const std::string& name)
{
  const Option* const option = findOption(table, name);
  return option && option->repeats;
}

Option
numberOption(const std::string& name, const std::string& argument, const std::string& help, double& target)
{
  return {name, argument, help, [name, &target](const std::string& value) { target = numberValue(name, value); }};
}

Option
textOption(const std::string& name, const std::string& argument, const std::string& help, std::string& target)
{
  return {name, argument, help, [&target](const std::string& value) { target = value; }};
}

Option
switchOption(const std::string& name, const std::string& help, bool& target)
{
  return {name, "", help, [name, &target](const std::string& value) {
            if (value != "true" && value != "false")
              throw UsageError(pcl_spiral::Diagnostic(name, ": ", value, ": must be true or false"));
            target = value == "true";
          }};
}
