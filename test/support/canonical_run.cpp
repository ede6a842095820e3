// SPDX-License-Identifier: BSD-3-Clause
#include "support/canonical_run.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

namespace pcl_spiral::test {

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
interpret(const std::string& program, const ScratchFolder& folder)
{
  if (std::system("command -v rs274 >/dev/null") != 0)
    return {-1, "LinuxCNC's rs274 is missing; run cmake/install_dependencies.sh test", {}, {}};
  const std::string out = folder.path("canon.txt"), err = folder.path("messages.txt");
  CanonicalRun run;
  run.code = std::system(("rs274 -g '" + program + "' '" + out + "' 2>'" + err + "'").c_str());
  std::istringstream messages(readText(err));
  for (std::string line; std::getline(messages, line);)
    if (line.find("executing") == std::string::npos)
      run.messages += line + '\n';
  std::istringstream lines(readText(out));
  double feed = 0.0;
  for (std::string line; std::getline(lines, line);) {
    const auto numbers = [&line](const std::string& name, int count) {
      std::vector<double> values;
      const std::size_t at = line.find(name + "(");
      if (at == std::string::npos)
        return values;
      std::istringstream words(line.substr(at + name.size() + 1));
      for (double value; static_cast<int>(values.size()) < count && words >> value; words.ignore(1))
        values.push_back(value);
      return values;
    };
    if (const auto rate = numbers("SET_FEED_RATE", 1); !rate.empty())
      feed = rate[0];
    for (const bool on : {true, false})
      if (const auto bit = numbers(on ? "SET_MOTION_OUTPUT_BIT" : "CLEAR_MOTION_OUTPUT_BIT", 1); !bit.empty())
        run.outputs.push_back({on, static_cast<int>(bit[0]), run.motions.size()});
    for (const bool rapid : {true, false})
      if (const auto v = numbers(rapid ? "STRAIGHT_TRAVERSE" : "STRAIGHT_FEED", 6); v.size() == 6)
        run.motions.push_back({rapid, {v[0], v[1], v[2], v[3], v[4], v[5]}, feed});
  }
  return run;
}

} // namespace pcl_spiral::test
