// SPDX-License-Identifier: BSD-3-Clause
#include "job_file.h"

#include "io/byte_file.h"
#include <pcl_spiral/io/file_error.h>

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>

using pcl_spiral::FileError;

namespace {

std::string
line(const YAML::Node& node)
{
  return "line " + std::to_string(node.Mark().line + 1) + ": ";
}

std::string
scalar(const std::string& file, const YAML::Node& node)
{
  if (!node.IsScalar())
    throw FileError(file, pcl_spiral::Diagnostic(line(node), "a value or a list of values is needed after the name"));
  return node.as<std::string>();
}

YAML::Node
load(const std::string& file)
{
  if (!std::filesystem::exists(file) || std::filesystem::is_directory(file))
    throw FileError(file, "there is no such job file; check the name and the folder");
  const std::string text = pcl_spiral::readStream(file);
  try {
    return YAML::Load(text);
  }
  catch (const YAML::Exception& error) {
    throw FileError(file, pcl_spiral::Diagnostic(std::string(error.what())));
  }
}

/** The map of options: a job file itself, or a part of a report. */
YAML::Node
jobOf(const std::string& file, const YAML::Node& root)
{
  const YAML::Node options = root["options"];
  if (options && options.IsMap())
    return options;
  if (const YAML::Node settings = root["settings"]; settings && settings.IsMap())
    throw FileError(file, "this report does not have the options of its run, as those of pcl_spiral_verify and of earlier versions; write "
                          "them into a job file");
  return root;
}

/** Whether \p list is one value, such as a place: [120, 80, 15]. */
bool
isOneValue(const YAML::Node& list)
{
  double number = 0.0;
  return std::all_of(list.begin(), list.end(), [&](const YAML::Node& item) { return YAML::convert<double>::decode(item, number); });
}

/** Whether \p output is \p file: a report is not an output of the run that it describes again. */
bool
isSame(const std::string& output, const std::string& file)
{
  std::error_code none;
  return std::filesystem::equivalent(output, file, none);
}

} // namespace

NamedValues
readJobFile(const std::string& file, const OptionTable& table)
{
  const YAML::Node root = load(file);
  if (!root.IsMap())
    throw FileError(file, "this is not a job file; write lines such as 'tool-radius: 10'");
  NamedValues values;
  const YAML::Node job = jobOf(file, root);
  const bool report = !job.is(root);
  for (const auto& entry : job) {
    const std::string name = scalar(file, entry.first);
    if (!findOption(table, name) || name == "config" || name == "help" || name == "version")
      throw UsageError(pcl_spiral::Diagnostic(file, ": ", line(entry.first), "'", name, "' is not a setting", suggestion(table, name)));
    if (!entry.second.IsSequence()) {
      values.emplace_back(name, scalar(file, entry.second));
      continue;
    }
    const bool one = !mayRepeat(table, name) || isOneValue(entry.second);
    std::string list;
    for (const YAML::Node& item : entry.second) {
      if (!one && !(name == "output" && report && isSame(scalar(file, item), file)))
        values.emplace_back(name, scalar(file, item));
      list += (list.empty() ? "" : ",") + scalar(file, item);
    }
    if (one)
      values.emplace_back(name, list);
  }
  return values;
}
