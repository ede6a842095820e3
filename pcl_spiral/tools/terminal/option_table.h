// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Options of a program: their names, their help, and what they set.
 */
#pragma once

#include "option_values.h"

#include <pcl_spiral/core/setting.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

/** Options by name with their values, as on the command line; "output" once for each file. */
using NamedValues = std::vector<std::pair<std::string, std::string>>;

/** One option, on the command line and in a job file alike. */
struct Option {
  std::string name;
  std::string argument; ///< name of the value in the help; empty: a switch without a value
  std::string help;
  std::function<void(const std::string& value)> set; ///< throws UsageError
  bool repeats = false;                              ///< may be given several times
};

/** Options that belong together in the help. */
struct OptionGroup {
  std::string title;
  std::vector<Option> options;
};

/** All options of a program. The variables they set must outlive them. */
using OptionTable = std::vector<OptionGroup>;

/** An option for each of \p settings that programs have and that \p group does not have yet: its help has the default, and an example. */
void addSettings(OptionGroup& group, const std::vector<pcl_spiral::Setting>& settings);

/** \throw UsageError if one of \p settings does not take its value */
void requireInRange(const std::vector<pcl_spiral::Setting>& settings);

/** Adds \p more after the options of \p group. */
void addOptions(OptionGroup& group, const std::vector<Option>& more);

/** The option of that name; null if there is none. */
const Option* findOption(const OptionTable& table, const std::string& name);

/** Whether the option of that name may be given several times. */
bool mayRepeat(const OptionTable& table, const std::string& name);

/** The names of all options. */
std::vector<std::string> namesOf(const OptionTable& table);

/** "; did you mean 'scallop'?" if an option's name is similar; otherwise empty. */
std::string suggestion(const OptionTable& table, const std::string& name);

/** An option for a number. */
Option numberOption(const std::string& name, const std::string& argument, const std::string& help, double& target);

/** An option for text, taken unchanged. */
Option textOption(const std::string& name, const std::string& argument, const std::string& help, std::string& target);

/** An option for a place or a direction, X,Y,Z; \p target is a vector or an optional one. */
template <typename Place>
Option
placeOption(const std::string& name, const std::string& help, Place& target)
{
  return {name, "X,Y,Z", help, [name, &target](const std::string& value) { target = placeValue(name, value); }};
}

/** An option for a choice, by its name. */
template <typename Enum>
Option
choiceOption(const std::string& name, const std::string& help, Enum& target)
{
  return {name, pcl_spiral::choiceList<Enum>(), help,
          [name, &target](const std::string& value) { target = choiceValue<Enum>(name, value); }};
}

/** A switch. */
Option switchOption(const std::string& name, const std::string& help, bool& target);
