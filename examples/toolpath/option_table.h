/** \file
 *  Every option of pcl_spiral_toolpath: its words, its help, and what it sets.
 */
#pragma once

#include "job.h"

#include <functional>
#include <string>
#include <vector>

/** One option, on the command line and in a job file alike. */
struct Option {
  std::string name;
  std::string argument; ///< its name in the help; empty: a switch without a value
  std::string help;
  std::function<void(Job&, const std::string& value)> set; ///< throws UsageError
};

/** Options that belong together in the help. */
struct OptionGroup {
  std::string title;
  std::vector<Option> options;
};

const std::vector<OptionGroup>& optionTable();

/** The option of that name; null where there is none. */
const Option* findOption(const std::string& name);

/** "; did you mean 'scallop'?" where an option's name is near; else empty. */
std::string suggestion(const std::string& name);
