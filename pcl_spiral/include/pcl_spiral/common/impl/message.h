// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Builds a message from words, numbers and places.
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

/** Joins the parts. Real numbers have four digits. Integers, and numbers of 10,000 or more, are written to the last digit before
 *  the decimal point. */
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

/** "(12.5, -3, 0.125)": a place to 0.001, without trailing zeros. */
inline std::string
placeText(const Eigen::Vector3d& p)
{
  std::string all = "(";
  for (int axis = 0; axis < 3; ++axis) {
    char number[400]; // the largest double has 309 digits before the decimal point
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
