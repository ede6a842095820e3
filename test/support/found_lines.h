// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines of ridges found in scans, and their distance from the scanned die.
 */
#pragma once

#include <pcl_spiral/ridge/ridge_lines.h>

#include "support/ridge_scans.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral::test {

using Lines = RidgeLines<pcl::PointXYZ>;

inline Lines
linesOf(const std::vector<Eigen::Vector3d>& scan, const Polyline& rough, double half_width)
{
  Lines lines;
  lines.setInputCloud(toCloud(scan));
  lines.setRoughPoints(rough);
  lines.setHalfWidth(half_width);
  lines.setQuiet(true);
  return lines;
}

inline void
find(Lines& lines)
{
  pcl::PointCloud<pcl::PointXYZ> rail, generator;
  lines.compute(rail, generator);
  ASSERT_TRUE(lines.getStatus().ok()) << lines.getStatus().message();
  EXPECT_EQ(rail.size(), lines.getRail().size());
  EXPECT_EQ(generator.size(), lines.getGenerator().size());
}

/** A scan of the die with coarser points, for tests that do not need all points. */
inline std::vector<Eigen::Vector3d>
coarseDie()
{
  return scanOf(dieRidge(), 600, 26, 0.02, 5);
}

/** Distance of \p p from the die, with its place across it in \p w. */
inline double
offDie(const Eigen::Vector3d& p, double& w)
{
  static const ExactRidge die = dieRidge();
  double least = 1e30;
  for (const double guess : {0.1, 0.4, 0.8}) {
    double t = p.x() / 600.0, at = guess;
    if (const double off = die.distance(p, t, at); off < least) {
      least = off;
      w = at;
    }
  }
  return least;
}

} // namespace pcl_spiral::test
