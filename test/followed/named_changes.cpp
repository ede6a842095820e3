// SPDX-License-Identifier: BSD-3-Clause
#include "named_changes.h"

#include "support/typed_words.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <optional>
#include <regex>
#include <sstream>

namespace pcl_spiral::followed {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

const std::string number = "(-?[0-9.]+(?:e[-+]?[0-9]+)?)";
const std::string place = "\\(" + number + ", " + number + ", " + number + "\\)";
const std::string tried_words = "one gives a path of ", two_words = "two together give a path of ";
const std::string more_tries = "The search ended after ", no_change = "There is no single change of the settings to try";

/** The option with another value, or added. */
Command
with(Command command, const std::string& option, const std::string& value = "")
{
  const auto at = std::find(command.begin(), command.end(), option);
  if (at == command.end()) {
    command.push_back(option);
    if (!value.empty())
      command.push_back(value);
  }
  else if (!value.empty())
    *(at + 1) = value;
  return command;
}

/** The value of \p option. */
std::optional<double>
valueOf(const Command& command, const std::string& option)
{
  const auto at = std::find(command.begin(), command.end(), option);
  return at == command.end() ? std::nullopt : std::optional<double>(std::stod(*(at + 1)));
}

std::string
text(double value)
{
  std::ostringstream out;
  out.precision(9);
  out << value;
  return out.str();
}

/** A rectangle as a further keep-out. */
Command
withKeepOut(Command command, const Vector2d& low, const Vector2d& high, const ScratchFolder& folder)
{
  std::ostringstream polygon;
  polygon.precision(12);
  for (const Vector2d& p : {low, Vector2d(high.x(), low.y()), high, Vector2d(low.x(), high.y())})
    polygon << p.transpose() << '\n';
  const std::string file = "keep_" + text(low.x()) + "_" + text(low.y()) + "_" + text(high.x()) + "_" + text(high.y()) + ".txt";
  writeText(folder.path(file), polygon.str());
  command.insert(command.end(), {"--keep-out", file});
  return command;
}

/** One reading of a message. */
class Reading {
public:
  Reading(const RefusedInput& input, const Command& command, const std::string& said, const ScratchFolder& folder)
  : input_(input), command_(command), said_(said), folder_(folder)
  {}

  /** The command that the words at \p at, an option, name. */
  std::optional<Command> changeAt(std::size_t at, const std::string& option) const
  {
    const std::string rest = said_.substr(at), before = said_.substr(at < 90 ? 0 : at - 90, std::min<std::size_t>(at, 90));
    std::smatch value;
    const std::string head = rest.substr(0, 120);
    const auto has = [](const std::string& where, const char* words) { return where.find(words) != std::string::npos; };
    // a word or number behind the option, which is what the planner tried, or an example for it
    if (option != "--keep-out" && option != "--crop" && option != "--region" &&
        std::regex_search(head, value, std::regex("^" + option + " ([a-z][a-z-]*|-?[0-9][0-9.e,+-]*[0-9]|[0-9])(?=[\\s,.;:)])")) &&
        !has("and or with to alone gives the in", value[1].str().c_str()))
      return option == "--clusters" && value[1] == "leave-out" ? std::nullopt : std::optional<Command>(with(command_, option, value[1]));
    if (option == "--method")
      return with(command_, option,
                  before.rfind("radial") != std::string::npos && !has(before.substr(before.rfind("radial")), "onstant scallop")
                      ? "radial"
                      : "constant-scallop");
    if (option == "--tool-radius")
      return toolRadius(head, before);
    if (option == "--scallop")
      return with(command_, option,
                  std::regex_search(before, value, std::regex("above " + number + " mm \\($")) ? text(1.05 * std::stod(value[1]))
                                                                                               : text(0.7 * input_.scallop));
    if (option == "--sense")
      return with(command_, option, "cw");
    if (option == "--tilt")
      return with(command_, option, "0");
    if (option == "--tight")
      return with(command_, option, "ride");
    if (option == "--holes")
      return with(command_, option, "over");
    if (option == "--gaps")
      return with(command_, option, "bridge");
    if (option == "--hole-margin")
      return with(command_, option, "0");
    if (option == "--rim")
      return with(command_, option, "on");
    if (option == "--boundaries")
      return with(command_, option, "one");
    if (option == "--largest" || option == "--ball-closing")
      return with(command_, option);
    if (option == "--part-at")
      return partAt(head);
    if (option == "--crop")
      return middleCrop();
    if (option == "--keep-out")
      return keepOut(before);
    if (option == "--thin" && std::regex_search(before, value, std::regex("thin to " + number + " mm or less \\($")))
      return with(command_, option, value[1]);
    return std::nullopt;
  }

private:
  Command toolRadius(const std::string& head, const std::string& before) const
  {
    std::smatch value;
    if (std::regex_search(head, value, std::regex("a radius of " + number + " mm")))
      return with(command_, "--tool-radius", value[1]);
    const double now = valueOf(command_, "--tool-radius").value_or(input_.radius);
    return with(command_, "--tool-radius", text((before.find("larger ball") != std::string::npos ? 1.4 : 0.7) * now));
  }

  std::optional<Command> partAt(const std::string& head) const
  {
    std::smatch at;
    if (!std::regex_search(head, at, std::regex("^--part-at " + place)) && !std::regex_search(said_, at, std::regex("mm2 at " + place)))
      return std::nullopt;
    return with(command_, "--part-at", at[1].str() + "," + at[2].str() + "," + at[3].str());
  }

  /** The middle half of the scan. */
  Command middleCrop() const
  {
    Eigen::AlignedBox3d box;
    for (const Vector3d& p : input_.points)
      box.extend(p);
    const Vector3d low = box.center() - 0.25 * box.sizes(), high = box.center() + 0.25 * box.sizes();
    return with(command_, "--crop", text(low.x()) + "," + text(high.x()) + "," + text(low.y()) + "," + text(high.y()));
  }

  /** About all that the message gives the extents of; about its first place if it gives none. */
  std::optional<Command> keepOut(const std::string& before) const
  {
    std::smatch value;
    if (before.find("enlarge the polygon") != std::string::npos)
      return larger();
    const std::regex extents("from " + place + " to " + place);
    const auto add = [&](const std::string& where) {
      Command command = command_;
      for (auto at = std::sregex_iterator(where.begin(), where.end(), extents); at != std::sregex_iterator(); ++at)
        command = withKeepOut(command, {std::stod((*at)[1]), std::stod((*at)[2])}, {std::stod((*at)[4]), std::stod((*at)[5])}, folder_);
      return command;
    };
    if (Command command = add(said_); command != command_)
      return command;
    if (!std::regex_search(said_, value, std::regex(place)))
      return std::nullopt;
    const Vector2d at(std::stod(value[1]), std::stod(value[2]));
    const Vector2d half = Vector2d::Constant(2.0 * input_.radius);
    return withKeepOut(command_, at - half, at + half, folder_);
  }

  /** The keep-outs again, larger by as much as the message says: boxes about them. */
  std::optional<Command> larger() const
  {
    std::smatch by;
    if (!std::regex_search(said_, by, std::regex("(?:by|cut) " + number + " mm")))
      return std::nullopt;
    const Vector2d more = Vector2d::Constant(std::stod(by[1]) + 0.01);
    Command command;
    std::vector<Eigen::AlignedBox2d> boxes;
    for (std::size_t i = 0; i < command_.size(); ++i) {
      if (command_[i] != "--keep-out") {
        command.push_back(command_[i]);
        continue;
      }
      std::istringstream corners(readText(folder_.path(command_[++i])));
      boxes.emplace_back();
      for (Vector2d p; corners >> p.x() >> p.y();)
        boxes.back().extend(p);
    }
    for (const Eigen::AlignedBox2d& box : boxes)
      command = withKeepOut(command, box.min() - more, box.max() + more, folder_);
    return command;
  }

  const RefusedInput& input_;
  const Command& command_;
  const std::string& said_;
  const ScratchFolder& folder_;
};

/** The change that the planner tried, which is at the end of its line, behind what the path is like. */
std::optional<std::string>
triedChange(const std::string& said)
{
  for (const std::string& words : {tried_words, two_words})
    if (const std::size_t at = said.find(words); at != std::string::npos) {
      const std::string line = said.substr(at, said.find('\n', at) - at);
      return line.substr(line.rfind(": ") + 2);
    }
  return std::nullopt;
}

const std::regex option("--[a-z][a-z-]*");

} // namespace

bool
plannerTried(const std::string& said)
{
  return triedChange(said).has_value();
}

bool
onlyAnotherScan(const std::string& said)
{
  if (said.find(more_tries) != std::string::npos)
    return false;
  if (said.find("none gives a path: ") != std::string::npos || said.find("What the scan lacks") != std::string::npos ||
      (said.find(no_change) != std::string::npos && !std::regex_search(said, option)))
    return true;
  const bool scan = said.find("scan it again") != std::string::npos || said.find("more densely") != std::string::npos;
  return scan && !std::regex_search(said, option);
}

std::vector<Command>
namedChanges(const RefusedInput& input, const Command& command, const std::string& said, const ScratchFolder& folder)
{
  if (const std::optional<std::string> change = triedChange(said))
    return {test::typedChange(command, *change)};
  std::smatch tries;
  if (std::regex_search(said, tries, std::regex(more_tries + "--remedy-tries " + number + "; --remedy-tries " + number + " tries more")))
    return {with(command, "--remedy-tries", tries[2])};
  std::vector<Command> changes;
  const Reading reading(input, command, said, folder);
  for (auto at = std::sregex_iterator(said.begin(), said.end(), option); at != std::sregex_iterator(); ++at)
    if (const auto change = reading.changeAt(static_cast<std::size_t>(at->position()), at->str()))
      changes.push_back(*change);
  return changes;
}

} // namespace pcl_spiral::followed
