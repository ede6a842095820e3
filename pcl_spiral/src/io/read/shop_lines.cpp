// SPDX-License-Identifier: BSD-3-Clause
#include "shop_lines.h"

#include "yaml_settings.h"

#include "io/named_values.h"
#include <pcl_spiral/io/program_writer.h>

namespace pcl_spiral {
namespace {

/** One line, or a list of lines; each must be a line of a program. */
std::vector<std::string>
readLines(YamlSettings& settings, const std::string& name)
{
  std::vector<std::string> lines;
  if (!settings.has(name))
    return lines;
  const YAML::Node node = settings.at(name, "[M8]");
  if (node.IsScalar())
    lines.push_back(settings.value<std::string>(name, "[M8]"));
  else
    lines = settings.value<std::vector<std::string>>(name, "[M8]");
  for (const std::string& line : lines)
    if (const Diagnostic fault = faultOfShopLine(line); !fault.empty())
      settings.fail(node, Diagnostic("the line '", line, "' of ", name, " ", fault));
  return lines;
}

std::string
readWord(YamlSettings& settings, const std::string& name, const std::string& example)
{
  if (!settings.has(name))
    return {};
  const auto word = settings.value<std::string>(name, example);
  if (const Diagnostic fault = faultOfShopLine(word); !fault.empty())
    settings.fail(settings.at(name, example), Diagnostic("the word '", word, "' of ", name, " ", fault));
  return word;
}

} // namespace

void
readProgramWords(const std::string& file, const YAML::Node& node, Machine& machine)
{
  YamlSettings settings(file, node, "program");
  machine.lines.header = readLines(settings, "header");
  machine.lines.footer = readLines(settings, "footer");
  machine.lines.pass_begin = readLines(settings, "pass_begin");
  machine.lines.pass_end = readLines(settings, "pass_end");
  ControlWords& words = machine.words;
  if (settings.has("coolant")) {
    YamlSettings coolant(file, node["coolant"], "coolant");
    words.mist = readWord(coolant, "mist", "M7");
    words.flood = readWord(coolant, "flood", "M8");
    words.through = readWord(coolant, "through", "M88");
    words.coolant_off = readWord(coolant, "off", "M9");
    coolant.refuseOthers();
  }
  if (settings.has("kinematics")) {
    YamlSettings kinematics(file, node["kinematics"], "kinematics");
    words.tip_control_on = readWord(kinematics, "on", "M428");
    words.tip_control_off = readWord(kinematics, "off", "M429");
    kinematics.refuseOthers();
  }
  if (settings.has("smoothing")) {
    YamlSettings smoothing(file, node["smoothing"], "smoothing");
    words.smoothing_on = readLines(smoothing, "on");
    words.smoothing_off = readLines(smoothing, "off");
    smoothing.refuseOthers();
  }
  settings.refuseOthers();
  if (machine.lines.pass_begin.empty() != machine.lines.pass_end.empty())
    settings.fail(node, "of pass_begin and pass_end only one is given, and what is switched on must be switched off; give both");
}

} // namespace pcl_spiral
