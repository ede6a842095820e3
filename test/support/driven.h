// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Drive paths on clouds of known surfaces.
 */
#pragma once

#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/drive/drive_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace pcl_spiral::test {

using Drive = DrivePath<pcl::PointXYZ>;

/** The result of compute. */
struct Driven {
  DrivePasses passes;
  DriveReport report;
  Status status;
};

inline Driven
driven(const std::vector<Eigen::Vector3d>& points, const std::function<void(Drive&)>& set, bool ok = true)
{
  Drive drive;
  drive.setInputCloud(toCloud(points));
  set(drive);
  Driven run;
  drive.compute(run.passes);
  run.report = drive.getReport();
  run.status = drive.getStatus();
  EXPECT_EQ(run.status.ok(), ok) << run.status.message();
  return run;
}

/** Largest distance of consecutive points; for closed passes also from the last to the first. */
inline double
largestStep(const DrivePass& pass)
{
  double largest = 0.0;
  for (std::size_t i = pass.closed ? 0 : 1; i < pass.points.size(); ++i)
    largest = std::max(largest, (pass.points[i].position - pass.points[i > 0 ? i - 1 : pass.points.size() - 1].position).norm());
  return largest;
}

/** Largest difference between the points of two runs, infinite if they do not have the same passes. */
inline double
difference(const DrivePasses& a, const DrivePasses& b)
{
  if (a.size() != b.size())
    return INFINITY;
  double largest = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k].points.size() != b[k].points.size() || a[k].closed != b[k].closed)
      return INFINITY;
    for (std::size_t i = 0; i < a[k].points.size(); ++i)
      largest = std::max(
          {largest, (a[k].points[i].position - b[k].points[i].position).norm(), (a[k].points[i].axis - b[k].points[i].axis).norm()});
  }
  return largest;
}

/** Distance of \p x from the nearest segment of any pass, both as \p seen. */
inline double
distanceFrom(const DrivePasses& passes, const Eigen::Vector3d& x, const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& seen)
{
  double least = INFINITY;
  const Eigen::Vector3d p = seen(x);
  for (const DrivePass& pass : passes)
    for (std::size_t i = 0; i + (pass.closed ? 0 : 1) < pass.points.size(); ++i) {
      const Eigen::Vector3d a = seen(pass.points[i].position), d = seen(pass.points[(i + 1) % pass.points.size()].position) - a;
      const double t = d.squaredNorm() > 0.0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
      least = std::min(least, (p - a - t * d).norm());
    }
  return least;
}

} // namespace pcl_spiral::test
