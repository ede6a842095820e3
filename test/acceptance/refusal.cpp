// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"
#include "table.h"

#include <cmath>
#include <cstdlib>

namespace pcl_spiral::acceptance {

namespace {

/** All numbers in a message, in order. */
std::vector<double>
numbersIn(const std::string& message)
{
  std::vector<double> found;
  const char* at = message.c_str();
  while (*at != '\0') {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at)
      ++at;
    else {
      found.push_back(value);
      at = end;
    }
  }
  return found;
}

/** Whether three successive numbers are a point of the surface, to a millimetre. */
bool
namesAPlace(const std::string& message, const test::AnalyticSurface& surface)
{
  const std::vector<double> numbers = numbersIn(message);
  for (std::size_t i = 0; i + 2 < numbers.size(); ++i) {
    const Eigen::Vector3d p(numbers[i], numbers[i + 1], numbers[i + 2]);
    if (p.allFinite() && p.norm() > 1.0 && std::abs(surface.signedDistance(p)) < 1.0 && surface.contains(p))
      return true;
  }
  return false;
}

} // namespace

int
judgeRefusal(const Options& options)
{
  Job large = job("bowl");
  large.tool_radius = 200.0;
  Table table("bowl_refusal: a ball of radius 200 in a bowl of radius 130");
  const Run result = run(large, test::toCloud(sampled(large, options.seed).points), options.threads);
  table.note("time", result.seconds, "s");
  table.holds("refused", !result.status.ok(), result.status.message());
  table.holds("no path", result.path.empty());
  table.holds("the message names the place", namesAPlace(result.status.message(), *large.surface));
  table.holds("the message names the radius", result.status.message().find("200") != std::string::npos);
  return table.broken();
}

} // namespace pcl_spiral::acceptance
