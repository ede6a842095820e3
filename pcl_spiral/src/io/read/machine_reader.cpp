// SPDX-License-Identifier: BSD-3-Clause
#include "shop_lines.h"
#include "yaml_settings.h"

#include "io/byte_file.h"
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/machine_reader.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace pcl_spiral {
namespace {

void
readLimits(YamlSettings& settings, double unit, AxisRange& range)
{
  const YAML::Node node = settings.at("limits", "[-100, 50]");
  if (node.IsScalar() && node.as<std::string>() == "unlimited")
    return;
  const auto limits = settings.value<std::vector<double>>("limits", "[-100, 50], or unlimited");
  if (limits.size() != 2 || !std::isfinite(limits[0]) || !std::isfinite(limits[1]))
    settings.fail(node, "limits are two numbers, such as limits: [-100, 50], or unlimited");
  range.lower = unit * limits[0];
  range.upper = unit * limits[1];
}

/** \p unit: of the axis, mm or radians. */
void
readDynamics(YamlSettings& settings, double unit, AxisRange& range)
{
  if (settings.has("max_acceleration"))
    range.largest_acceleration = unit * settings.number("max_acceleration", "1000");
  if (settings.has("max_jerk"))
    range.largest_jerk = unit * settings.number("max_jerk", "20000");
}

RotaryAxis
readRotary(const std::string& file, const YAML::Node& node)
{
  YamlSettings settings(file, node, "a rotary axis");
  RotaryAxis axis;
  const auto letter = settings.value<std::string>("axis", "C");
  if (letter.size() != 1)
    settings.fail(node["axis"], Diagnostic("a rotary axis is called ", letter, "; it must be A, B or C"));
  axis.letter = letter[0];
  const auto mount = settings.value<std::string>("mount", "table");
  if (mount != "table" && mount != "head")
    settings.fail(node["mount"], Diagnostic("mount of ", letter, " is ", mount, "; it must be table or head"));
  axis.mount = mount == "table" ? RotaryMount::Table : RotaryMount::Head;
  axis.direction = settings.vector("direction", "[0, 0, 1]");
  if (settings.has("point"))
    axis.point = settings.vector("point", "[0, 0, 0]");
  readLimits(settings, degree, axis.range);
  axis.range.largest_rate = full_turn * settings.number("max_rpm", "20");
  readDynamics(settings, degree, axis.range);
  if (settings.has("home"))
    axis.home = degree * settings.number("home", "0");
  settings.refuseOthers();
  return axis;
}

AxisRange
readLinear(const std::string& file, const YAML::Node& node, const std::string& name)
{
  YamlSettings settings(file, node, name);
  AxisRange range;
  if (settings.has("limits"))
    readLimits(settings, 1.0, range);
  if (settings.has("max_feed"))
    range.largest_rate = settings.number("max_feed", "12000");
  readDynamics(settings, 1.0, range);
  settings.refuseOthers();
  return range;
}

void
readControl(const std::string& file, const YAML::Node& node, Machine& machine)
{
  YamlSettings settings(file, node, "control");
  if (settings.has("look_ahead"))
    machine.control.look_ahead = settings.value<int>("look_ahead", "200");
  if (settings.has("rounds_rotary_corners"))
    machine.control.rounds_rotary_corners = settings.value<bool>("rounds_rotary_corners", "true");
  settings.refuseOthers();
}

void
readOptional(const std::string& file, YamlSettings& settings, Machine& machine)
{
  if (settings.has("name"))
    machine.name = settings.value<std::string>("name", "xyzac-trt");
  if (settings.has("work_zero"))
    machine.work_zero = settings.vector("work_zero", "[0, 0, 0]");
  if (settings.has("tool_length"))
    machine.tool_length = settings.number("tool_length", "120");
  if (settings.has("rtcp"))
    machine.rtcp = settings.value<bool>("rtcp", "true");
  if (settings.has("retract_z"))
    machine.retract_z = settings.number("retract_z", "300");
  if (settings.has("path_tolerance"))
    machine.path_tolerance = settings.number("path_tolerance", "0.01");
  if (settings.has("control"))
    readControl(file, settings.at("control", "{look_ahead: 200}"), machine);
  if (settings.has("program"))
    readProgramWords(file, settings.at("program", "{header: [G55]}"), machine);
}

/** With ISO 841 a positive angle counts the tool against the work: tables turn the other way. */
void
countToolAgainstWork(Machine& machine)
{
  for (RotaryAxis& axis : machine.rotary)
    if (axis.mount == RotaryMount::Table)
      axis.direction = -axis.direction;
}

void
readRotaryAxes(const std::string& file, YamlSettings& settings, Machine& machine)
{
  const YAML::Node rotary = settings.at("rotary", "[{axis: C, mount: table, ...}, {axis: A, mount: table, ...}]");
  if (!rotary.IsSequence() || (rotary.size() != 2 && rotary.size() != 0))
    settings.fail(rotary,
                  "rotary must be a list of the two rotary axes, from the workpiece to the tool, or [] for a machine with three axes");
  machine.three_axes = rotary.size() == 0;
  for (std::size_t i = 0; i < rotary.size(); ++i)
    machine.rotary[i] = readRotary(file, rotary[i]);
  if (settings.has("conventional_directions") && settings.value<bool>("conventional_directions", "true"))
    countToolAgainstWork(machine);
}

/** Without RTCP the program contains the places of the axes: what they depend on must be given. */
void
requirePlaces(YamlSettings& settings, const YAML::Node& rotary, const Machine& machine)
{
  if (machine.rtcp || machine.three_axes)
    return;
  const auto require = [&](bool needed, const YAML::Node& node, const std::string& name, const Diagnostic& what) {
    if (needed && !node[name])
      settings.fail(node, Diagnostic("rtcp: false, so the program depends on ", name,
                                     ", and none is given; measure it on the machine and give ", name, ": ", what));
  };
  bool table = false, head = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const RotaryAxis& axis = machine.rotary[i];
    (axis.mount == RotaryMount::Table ? table : head) = true;
    require(true, rotary[i], "point", Diagnostic("[x, y, z], a place on the axis ", axis.letter));
  }
  require(table, settings.node(), "work_zero", "[x, y, z], the zero of the program in machine coordinates");
  require(head, settings.node(), "tool_length", "the distance from the gauge point to the tip");
}

Machine
machineFrom(const std::string& file, const YAML::Node& root)
{
  YamlSettings settings(file, root, "a machine file");
  Machine machine;
  readRotaryAxes(file, settings, machine);
  if (settings.has("linear")) {
    YamlSettings linear(file, root["linear"], "linear");
    for (int i = 0; i < 3; ++i)
      if (const std::string name(1, "XYZ"[i]); linear.has(name))
        machine.linear[i] = readLinear(file, root["linear"][name], name);
    linear.refuseOthers();
  }
  readOptional(file, settings, machine);
  settings.refuseOthers();
  requirePlaces(settings, root["rotary"], machine);
  return machine;
}

} // namespace

Machine
readMachine(const std::string& file)
{
  if (std::filesystem::is_directory(file))
    throw FileError(file, "this is a folder, not a machine file");
  if (!std::filesystem::exists(file))
    throw FileError(file, "there is no such machine file; check the name and the folder");
  const std::string text = readBytes(file);
  Machine machine;
  try {
    machine = machineFrom(file, YAML::Load(text));
  }
  catch (const YAML::Exception& error) {
    throw FileError(file, Diagnostic(std::string(error.what())));
  }
  if (machine.name.empty())
    machine.name = std::filesystem::path(file).stem().string();
  if (const Status status = checkMachine(machine); !status.ok())
    throw FileError(file, status.diagnostic());
  return machine;
}

} // namespace pcl_spiral
