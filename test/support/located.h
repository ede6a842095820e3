// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Cutter locations on clouds of known surfaces.
 */
#pragma once

#include "support/cutters.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/cutter/cutter_location.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral::test {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Evaluation = LocationEvaluation;

/** A random axis at most \p lean degrees off the normal. */
inline Eigen::Vector3d
leaning(const Eigen::Vector3d& normal, double lean, Random& random)
{
  const double a = lean * M_PI / 180.0 * std::sqrt(random.uniform());
  const Eigen::Vector3d side = normal.cross(Eigen::Vector3d(random.normal(), random.normal(), random.normal())).normalized();
  return std::cos(a) * normal + std::sin(a) * side;
}

/** Places of a surface with the axis up to \p lean degrees off the normal, at least \p inside from the
 * outline. */
inline DrivePoints
drivePoints(const AnalyticSurface& surface, std::size_t count, double lean, double inside, bool contacts, std::uint64_t seed)
{
  Random random(seed);
  DrivePoints drive;
  while (drive.size() < count) {
    const Sampled places = sampleUniform(surface, count, random.below(1000000));
    for (std::size_t i = 0; i < count && drive.size() < count; ++i)
      if (surface.rimDistance(places.points[i]) > inside)
        drive.push_back({places.points[i], leaning(places.normals[i], lean, random),
                         contacts ? places.normals[i] : Eigen::Vector3d(Eigen::Vector3d::Zero())});
  }
  return drive;
}

/** The result of compute. */
struct Located {
  ToolLocations locations;
  LocationReport figures;
  Status status;
};

inline Located
located(const Cloud::ConstPtr& cloud, const CutterShape& cutter, const DrivePoints& drive,
        Evaluation evaluation = Evaluation::FittedSurface, int threads = 0)
{
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(cloud);
  location.setCutter(cutter);
  location.setDrivePoints(drive);
  location.setEvaluation(evaluation);
  location.setNumberOfThreads(threads);
  Located run;
  location.compute(run.locations);
  run.figures = location.getReport();
  run.status = location.getStatus();
  EXPECT_TRUE(run.status.ok()) << run.status.message();
  return run;
}

/** Depth of the deepest of \p points in the cutter, along its axis. */
inline double
deepest(const std::vector<Eigen::Vector3d>& points, const CutterProfile& cutter, const ToolLocation& location)
{
  double depth = -1e300;
  for (const Eigen::Vector3d& p : points) {
    const double h = (p - location.tip).dot(location.axis), l = (p - location.tip).cross(location.axis).norm();
    if (l <= cutter.radius())
      depth = std::max(depth, h - cutter.height(l));
  }
  return depth;
}

/** One cutter of each kind. */
const CutterShape all_kinds[] = {CutterShape::ball(4.0),
                                 CutterShape::bullNose(6.0, 1.5, 10.0),
                                 CutterShape::flatEnd(4.0, 10.0),
                                 CutterShape::taper(6.0, 12.0, 25.0),
                                 CutterShape::taperedBall(6.0, 20.0, 8.0),
                                 CutterShape::taperedBullNose(6.0, 1.2, 12.0, 15.0)};

} // namespace pcl_spiral::test
