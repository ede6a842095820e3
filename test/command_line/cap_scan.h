// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A scan for runs of the programs.
 */
#pragma once

#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>
#include <string>

/** A cap of a sphere of radius 100 mm, with a rim of radius 40 mm, as the text of an .xyz file; uniform
 * over its disc, with noise of standard deviation \p noise along z. */
inline std::string
capScan(int count, double noise = 0.0)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> normal;
  std::ostringstream text;
  text << std::setprecision(9);
  for (int i = 0; i < count; ++i) {
    const double r = 40.0 * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
    const double off = noise > 0.0 ? noise * normal(random) : 0.0;
    text << r * std::cos(angle) << ' ' << r * std::sin(angle) << ' ' << std::sqrt(1e4 - r * r) - 100.0 + off << '\n';
  }
  return text.str();
}
