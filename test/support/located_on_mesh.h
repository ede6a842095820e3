// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Cutter locations on meshes of known surfaces.
 */
#pragma once

#include "support/located.h"
#include "support/plain_mesh.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral::test {

using Location = CutterLocation<pcl::PointXYZ>;
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ(), none = Eigen::Vector3d::Zero();

template <typename Mesh, typename Change>
Located
onMesh(const Mesh& mesh, const CutterShape& cutter, const DrivePoints& drive, const Change& change)
{
  Location location;
  location.setInputMesh(mesh);
  location.setCutter(cutter);
  location.setDrivePoints(drive);
  change(location);
  Located run;
  location.compute(run.locations);
  run.figures = location.getReport();
  run.status = location.getStatus();
  EXPECT_TRUE(run.status.ok()) << run.status.message();
  return run;
}

template <typename Mesh>
Located
onMesh(const Mesh& mesh, const CutterShape& cutter, const DrivePoints& drive, Evaluation evaluation = Evaluation::FittedSurface)
{
  return onMesh(mesh, cutter, drive, [&](Location& l) { l.setEvaluation(evaluation); });
}

/** z = a cos(k x); its valleys have the radius 1 / (a k^2). */
struct Waves {
  double a, k;

  double height(double x) const { return a * std::cos(k * x); }
  Eigen::Vector3d at(double x, double y) const { return {x, y, height(x)}; }
  Eigen::Vector3d normal(double x) const { return Eigen::Vector3d(a * k * std::sin(k * x), 0.0, 1.0).normalized(); }
  double curvature(double x) const // positive in valleys
  {
    const double slope = a * k * std::sin(k * x);
    return -a * k * k * std::cos(k * x) / std::pow(1.0 + slope * slope, 1.5);
  }
  double distance(const Eigen::Vector3d& p) const
  {
    double best = 1e300;
    for (double x = p.x() - 8.0; x < p.x() + 8.0; x += 0.001)
      best = std::min(best, std::hypot(x - p.x(), height(x) - p.z()));
    return best;
  }
  PlainMesh mesh(double step) const
  {
    return graphMesh([this](double x, double) { return height(x); }, 15.0, step);
  }
};

/** Contacts along x with axes tilted by up to half the cutter's reach. */
inline DrivePoints
contactsOn(const Waves& waves, double from, double to, std::uint64_t seed)
{
  Random random(seed);
  DrivePoints drive;
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform(from, to), y = random.uniform(-6, 6);
    drive.push_back({waves.at(x, y), leaning(waves.normal(x), 15.0, random), waves.normal(x)});
  }
  return drive;
}

/** A pocket: floor 20 by 20 at z = 0, walls to z = 20. */
inline PlainMesh
pocket()
{
  PlainMesh m;
  m.addQuad({-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0});
  m.addQuad({10, -10, 0}, {10, -10, 20}, {10, 10, 20}, {10, 10, 0});
  m.addQuad({-10, 10, 0}, {-10, 10, 20}, {-10, -10, 20}, {-10, -10, 0});
  m.addQuad({-10, -10, 0}, {-10, -10, 20}, {10, -10, 20}, {10, -10, 0});
  m.addQuad({10, 10, 0}, {10, 10, 20}, {-10, 10, 20}, {-10, 10, 0});
  return m;
}

} // namespace pcl_spiral::test
