// SPDX-License-Identifier: BSD-3-Clause
// Radial lines over a square patch of a sphere: geodesics from its centre to the rim, one on every corner.
#include <pcl_spiral/spiral/radial_lines.h>

#include <cmath>
#include <cstdio>
#include <random>

int
main()
{
  const double radius = 200.0, half = 60.0; // of the sphere, and half the square's side, mm
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-half, half);
  while (cloud->size() < 20000) {
    const double x = place(random), y = place(random), z = std::sqrt(radius * radius - x * x - y * y);
    cloud->emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  }

  pcl_spiral::RadialLines<pcl::PointXYZ> radial;
  radial.setInputCloud(cloud);
  radial.setTolerance(0.02);
  std::vector<pcl_spiral::RadialLine> lines;
  radial.compute(lines);
  if (!radial.getStatus().ok())
    return 1;

  const Eigen::Vector3d centre = radial.getCenter();
  std::printf("%zu lines from (%.2f %.2f %.2f), %s\n", lines.size(), centre.x(), centre.y(), centre.z(),
              radial.usedHarmonic() ? "harmonic" : "geodesic");
  for (const pcl_spiral::RadialLine& line : lines) {
    if (line.level > 0)
      continue; // only the coarse lines; finer lines are between them
    const Eigen::Vector3d end = line.curve.positionAt(line.length());
    std::printf("to (%7.2f %7.2f %7.2f): %7.3f mm, %2zu spans, off its points by %.5f mm%s\n", end.x(), end.y(), end.z(), line.length(),
                line.curve.spans(), line.deviation, line.corner ? ", a corner" : "");
  }
  return 0;
}
