// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/machine_reader.h>

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace pcl_spiral {
namespace {

/** A map of a machine file: every value is read once; names that were not read are not settings. */
class Settings {
public:
  Settings(std::string file, const YAML::Node& node, std::string what) : file_(std::move(file)), node_(node), what_(std::move(what))
  {
    if (!node_.IsMap())
      fail(node_, what_ + " needs lines such as 'name: value'");
  }

  [[noreturn]] void fail(const YAML::Node& node, const std::string& reason) const
  {
    throw FileError(file_, "line " + std::to_string(node.Mark().line + 1) + ": " + reason);
  }
  bool has(const std::string& name)
  {
    asked_.push_back(name);
    return static_cast<bool>(node_[name]);
  }
  /** \throw FileError if there is none */
  YAML::Node at(const std::string& name, const std::string& example)
  {
    if (!has(name))
      fail(node_, what_ + " has no " + name + "; give it, such as " + name + ": " + example);
    return node_[name];
  }
  template <typename Value>
  Value value(const std::string& name, const std::string& example)
  {
    const YAML::Node node = at(name, example);
    try {
      return node.as<Value>();
    }
    catch (const YAML::Exception&) {
      fail(node, name + " of " + what_ + " cannot be read; write it as " + name + ": " + example);
    }
  }
  double number(const std::string& name, const std::string& example)
  {
    const double number = value<double>(name, example);
    if (!std::isfinite(number))
      fail(node_[name], name + " of " + what_ + " is not finite; write it as " + name + ": " + example);
    return number;
  }
  Eigen::Vector3d vector(const std::string& name, const std::string& example)
  {
    const auto v = value<std::vector<double>>(name, example);
    if (v.size() != 3)
      fail(node_[name], name + " of " + what_ + " needs three numbers, such as " + name + ": " + example);
    return {v[0], v[1], v[2]};
  }
  /** Call this last. */
  void refuseOthers() const
  {
    for (const auto& entry : node_) {
      const std::string name = entry.first.as<std::string>();
      if (std::find(asked_.begin(), asked_.end(), name) == asked_.end())
        fail(entry.first, "'" + name + "' is not a setting of " + what_ + "; its settings are " + listed());
    }
  }

private:
  std::string listed() const
  {
    std::string list;
    for (const std::string& name : asked_)
      list += (list.empty() ? "" : ", ") + name;
    return list;
  }

  std::string file_;
  YAML::Node node_;
  std::string what_;
  std::vector<std::string> asked_;
};

void
readLimits(Settings& settings, double unit, AxisRange& range)
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

RotaryAxis
readRotary(const std::string& file, const YAML::Node& node)
{
  Settings settings(file, node, "a rotary axis");
  RotaryAxis axis;
  const auto letter = settings.value<std::string>("axis", "C");
  if (letter.size() != 1)
    settings.fail(node["axis"], "a rotary axis is called " + letter + "; it must be A, B or C");
  axis.letter = letter[0];
  const auto mount = settings.value<std::string>("mount", "table");
  if (mount != "table" && mount != "head")
    settings.fail(node["mount"], "mount of " + letter + " is " + mount + "; it must be table or head");
  axis.mount = mount == "table" ? RotaryMount::Table : RotaryMount::Head;
  axis.direction = settings.vector("direction", "[0, 0, 1]");
  if (settings.has("point"))
    axis.point = settings.vector("point", "[0, 0, 0]");
  readLimits(settings, degree, axis.range);
  axis.range.largest_rate = full_turn * settings.number("max_rpm", "20");
  if (settings.has("home"))
    axis.home = degree * settings.number("home", "0");
  settings.refuseOthers();
  return axis;
}

AxisRange
readLinear(const std::string& file, const YAML::Node& node, const std::string& name)
{
  Settings settings(file, node, name);
  AxisRange range;
  if (settings.has("limits"))
    readLimits(settings, 1.0, range);
  if (settings.has("max_feed"))
    range.largest_rate = settings.number("max_feed", "12000");
  settings.refuseOthers();
  return range;
}

void
readOptional(Settings& settings, Machine& machine)
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
}

Machine
machineFrom(const std::string& file, const YAML::Node& root)
{
  Settings settings(file, root, "a machine file");
  Machine machine;
  const YAML::Node rotary = settings.at("rotary", "[{axis: C, mount: table, ...}, {axis: A, mount: table, ...}]");
  if (!rotary.IsSequence() || rotary.size() != 2)
    settings.fail(rotary, "rotary must be a list of the two rotary axes, from the workpiece to the tool");
  for (std::size_t i = 0; i < 2; ++i)
    machine.rotary[i] = readRotary(file, rotary[i]);
  if (settings.has("linear")) {
    Settings linear(file, root["linear"], "linear");
    for (int i = 0; i < 3; ++i)
      if (const std::string name(1, "XYZ"[i]); linear.has(name))
        machine.linear[i] = readLinear(file, root["linear"][name], name);
    linear.refuseOthers();
  }
  readOptional(settings, machine);
  settings.refuseOthers();
  return machine;
}

} // namespace

Machine
readMachine(const std::string& file)
{
  if (std::filesystem::is_directory(file))
    throw FileError(file, "this is a folder, not a machine file");
  if (!std::filesystem::is_regular_file(file))
    throw FileError(file, "there is no such machine file; check the name and the folder");
  Machine machine;
  try {
    machine = machineFrom(file, YAML::LoadFile(file));
  }
  catch (const YAML::Exception& error) {
    throw FileError(file, error.what());
  }
  if (machine.name.empty())
    machine.name = std::filesystem::path(file).stem().string();
  if (const Status status = checkMachine(machine); !status.ok())
    throw FileError(file, status.message());
  return machine;
}

} // namespace pcl_spiral
