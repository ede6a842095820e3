// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Scans of a plate and of things on it and beside it. Lengths in mm.
 */
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <cmath>
#include <random>

namespace pcl_spiral::test {

using ScanPtr = pcl::PointCloud<pcl::PointXYZ>::Ptr;

/** Adds points \p spacing apart, shaken a little, at \p place(u, v) for |u| < \p u_half and |v| < \p v_half, where that is finite. */
template <typename Place>
void
addSheet(double u_half, double v_half, double spacing, const Place& place, pcl::PointCloud<pcl::PointXYZ>& scan)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(-0.25 * spacing, 0.25 * spacing);
  for (double u = 0.5 * spacing - u_half; u < u_half; u += spacing)
    for (double v = 0.5 * spacing - v_half; v < v_half; v += spacing) {
      const Eigen::Vector3d p = place(u + jitter(random), v + jitter(random));
      if (p.allFinite())
        scan.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
    }
}

/** A square plate of half the side \p half that bulges a little, \p spacing between points; none where \p missing(x, y) holds. */
template <typename Missing>
ScanPtr
plateWithout(const Missing& missing, double half = 15.0, double spacing = 0.8)
{
  const ScanPtr scan(new pcl::PointCloud<pcl::PointXYZ>);
  addSheet(
      half, half, spacing,
      [&](double x, double y) { return missing(x, y) ? Eigen::Vector3d::Constant(NAN) : Eigen::Vector3d(x, y, -0.002 * (x * x + y * y)); },
      *scan);
  return scan;
}

inline ScanPtr
plate(double half = 15.0, double spacing = 0.8)
{
  return plateWithout([](double, double) { return false; }, half, spacing);
}

/** A round plate of radius 15. */
inline ScanPtr
disc()
{
  return plateWithout([](double x, double y) { return std::hypot(x, y) > 15.0; });
}

/** A round plate, or a square one, with a wall \p gap beyond its rim at +x. */
inline ScanPtr
besideWall(double gap, bool square = false)
{
  const ScanPtr scan = square ? plate() : disc();
  addSheet(
      10.0, 10.0, 0.8, [&](double u, double v) { return Eigen::Vector3d(15.0 + gap, u, v + 9.0); }, *scan);
  return scan;
}

/** A round plate with a hole of \p half its width about (x, 0). */
inline ScanPtr
withHole(double half, double x0 = 0.0, double spacing = 0.8)
{
  return plateWithout([&](double x, double y) { return std::hypot(x - x0, y) < half || std::hypot(x, y) > 15.0; }, 15.0, spacing);
}

} // namespace pcl_spiral::test
