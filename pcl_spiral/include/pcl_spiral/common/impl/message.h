/** \file
 *  Words, numbers and places put together to a message.
 */
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>
#include <string>
#include <type_traits>

namespace pcl_spiral {

/** The parts one after the other, real numbers to four digits, whole ones and those beyond 10,000 to the last before the
 *  point. */
template <typename... Parts>
std::string
textOf(const Parts&... parts)
{
  std::ostringstream stream;
  const auto put = [&stream](const auto& part) {
    if constexpr (std::is_floating_point_v<std::decay_t<decltype(part)>>)
      stream << std::setprecision(std::abs(part) < 1e4 ? 4 : 9) << (std::abs(part) < 1e4 ? part : std::round(part));
    else
      stream << part;
  };
  (put(parts), ...);
  return stream.str();
}

/** "(12.5, -3, 0.125)": a place to the thousandth, without noughts at the end. */
inline std::string
placeText(const Eigen::Vector3d& p)
{
  std::string all = "(";
  for (int axis = 0; axis < 3; ++axis) {
    char number[400]; // the largest double has 309 digits before the point
    std::snprintf(number, sizeof number, "%.3f", p[axis]);
    std::string one = number;
    one.erase(one.find_last_not_of('0') + 1);
    if (!one.empty() && one.back() == '.')
      one.pop_back();
    all += (axis > 0 ? ", " : "") + (one == "-0" ? "0" : one);
  }
  return all + ")";
}

} // namespace pcl_spiral
