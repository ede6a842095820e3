// SPDX-License-Identifier: BSD-3-Clause
#include "support/canonical_run.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace pcl_spiral::test {
namespace {

/** The \p count numbers of the call \p name in \p line; fewer if it is another call. */
std::vector<double>
numbersOf(const std::string& line, const std::string& name, int count)
{
  std::vector<double> values;
  const std::size_t at = line.find(" " + name + "(");
  if (at == std::string::npos)
    return values;
  std::istringstream words(line.substr(at + name.size() + 2));
  for (double value; static_cast<int>(values.size()) < count && words >> value; words.ignore(1))
    values.push_back(value);
  return values;
}

void
readCanon(const std::string& text, CanonicalRun& run)
{
  std::istringstream lines(text);
  CanonicalMotion now{};
  double speed = 0.0;
  for (std::string line; std::getline(lines, line);) {
    const auto has = [&line](const char* call) { return line.find(call) != std::string::npos; };
    if (const auto rate = numbersOf(line, "SET_FEED_RATE", 1); !rate.empty())
      now.feed = rate[0];
    if (const auto set = numbersOf(line, "SET_SPINDLE_SPEED", 2); set.size() == 2)
      speed = set[1];
    if (const auto output = numbersOf(line, "SET_AUX_OUTPUT_VALUE", 2); output.size() == 2 && output[0] == 3.0)
      now.tool_tip = output[1] == 1.0;
    now.spindle = has(" START_SPINDLE_CLOCKWISE(") ? speed : has(" START_SPINDLE_COUNTERCLOCKWISE(") ? -speed : now.spindle;
    if (has(" STOP_SPINDLE_TURNING("))
      now.spindle = 0.0;
    now.flood = (now.flood || has(" FLOOD_ON(")) && !has(" FLOOD_OFF(");
    for (const bool on : {true, false})
      if (const auto bit = numbersOf(line, on ? "SET_MOTION_OUTPUT_BIT" : "CLEAR_MOTION_OUTPUT_BIT", 1); !bit.empty())
        run.outputs.push_back({on, static_cast<int>(bit[0]), run.motions.size()});
    for (const bool rapid : {true, false})
      if (const auto v = numbersOf(line, rapid ? "STRAIGHT_TRAVERSE" : "STRAIGHT_FEED", 6); v.size() == 6) {
        now.rapid = rapid;
        std::copy(v.begin(), v.end(), now.xyzabc.begin());
        run.motions.push_back(now);
      }
  }
}

} // namespace

double
minutesOf(const CanonicalMotion& from, const CanonicalMotion& to)
{
  const auto way = [&](std::size_t i) { return std::abs(to.xyzabc[i] - from.xyzabc[i]); };
  const auto length = [&](std::size_t i) { return std::hypot(way(i), way(i + 1), way(i + 2)); };
  constexpr double tiny = 1e-7;
  const bool moves = way(0) > tiny || way(1) > tiny || way(2) > tiny;
  return (moves ? length(0) : length(3)) / to.feed;
}

CanonicalRun
interpret(const std::string& program, const ScratchFolder& folder, const std::string& settings, double length)
{
  if (std::system("command -v rs274 >/dev/null") != 0)
    return {-1, "LinuxCNC's rs274 is missing; run cmake/install_dependencies.sh test", {}, {}};
  const std::string out = folder.path("canon.txt"), err = folder.path("messages.txt"), tools = folder.path("tool.tbl");
  writeText(tools, "T3 P3 Z" + std::to_string(length / 25.4) + "\n"); // rs274 alone reads inches
  const std::string options = settings.empty() ? "" : "cd '" + settings + "' && rs274 -i rs274.ini -t '" + tools + "'";
  CanonicalRun run;
  // Its tool table is a mapped file at home: runs at the same time would share it.
  run.code = std::system(("export HOME='" + folder.root().string() + "'; " + (settings.empty() ? "rs274" : options) + " -g '" + program +
                          "' '" + out + "' 2>'" + err + "'")
                             .c_str());
  std::istringstream messages(readText(err));
  for (std::string line; std::getline(messages, line);)
    if (line.find("executing") == std::string::npos)
      run.messages += line + '\n';
  readCanon(readText(out), run);
  return run;
}

} // namespace pcl_spiral::test
