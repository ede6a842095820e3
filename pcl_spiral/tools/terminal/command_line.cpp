// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "job_file.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <map>

namespace po = boost::program_options;

namespace {

po::options_description
description(const OptionGroup& group)
{
  constexpr unsigned int width = 110;
  po::options_description result(group.title, width, width / 2);
  for (const Option& option : group.options) {
    const std::string letters = option.name == "output" ? ",o" : option.name == "help" ? ",h" : "";
    const std::string names = option.name + letters;
    if (option.argument.empty())
      result.add_options()(names.c_str(), option.help.c_str());
    else
      result.add_options()(names.c_str(), po::value<std::string>()->value_name(option.argument), option.help.c_str());
  }
  return result;
}

po::options_description
allOptions(const OptionTable& table)
{
  po::options_description all;
  for (const OptionGroup& group : table)
    all.add(description(group));
  return all;
}

/** Names and values in the order given; a switch's value is "true". */
NamedValues
splitArguments(const OptionTable& table, const std::vector<std::string>& files, int argc, const char* const* argv)
{
  namespace style = po::command_line_style;
  const po::options_description options = allOptions(table);
  po::positional_options_description positional;
  for (const std::string& name : files)
    positional.add(name.c_str(), name == files.back() ? -1 : 1);
  try {
    const po::parsed_options parsed = po::command_line_parser(argc, argv)
                                          .options(options)
                                          .positional(positional)
                                          .style(style::unix_style & ~style::allow_guessing & ~style::allow_sticky)
                                          .run();
    NamedValues values;
    for (const auto& option : parsed.options)
      values.emplace_back(option.string_key, option.value.empty() ? "true" : option.value[0]);
    return values;
  }
  catch (const po::unknown_option& error) {
    const std::string name = error.get_option_name();
    throw UsageError(pcl_spiral::Diagnostic(name, " is not an option",
                                            suggestion(table, name.substr(std::min(name.find_first_not_of('-'), name.size())))));
  }
  catch (const po::error& error) {
    throw UsageError(pcl_spiral::Diagnostic(std::string(error.what())));
  }
}

void
setValues(const OptionTable& table, const std::vector<std::string>& files, const NamedValues& values)
{
  std::map<std::string, std::string> seen;
  for (const auto& [name, value] : values) {
    const bool again = !mayRepeat(table, name) && !seen.emplace(name, value).second;
    if (again && std::find(files.begin(), files.end(), name) != files.end())
      throw UsageError(pcl_spiral::Diagnostic(value, " is a second ", name, ", after ", seen[name], "; give one ", name,
                                              ", and write -o before every output"));
    if (again)
      throw UsageError(pcl_spiral::Diagnostic("--", name, " is given twice"));
    findOption(table, name)->set(value);
  }
}

bool
holds(const NamedValues& values, const std::string& name)
{
  return std::any_of(values.begin(), values.end(), [&name](const auto& value) { return value.first == name; });
}

} // namespace

NamedValues
setOptions(const OptionTable& table, int argc, const char* const* argv, const std::vector<std::string>& files)
{
  const NamedValues given = splitArguments(table, files, argc, argv);
  NamedValues filed;
  const auto config = std::find_if(given.begin(), given.end(), [](const auto& v) { return v.first == "config"; });
  if (config != given.end()) {
    filed = readJobFile(config->second, table);
    filed.erase(std::remove_if(filed.begin(), filed.end(), [&given](const auto& v) { return holds(given, v.first); }), filed.end());
  }
  setValues(table, files, filed);
  setValues(table, files, given);
  for (const auto& value : given)
    if (value.first != "config")
      filed.push_back(value);
  return filed;
}

void
printOptions(std::ostream& out, const OptionTable& table)
{
  out << allOptions(table);
}
