// SPDX-License-Identifier: BSD-3-Clause
// Cutters on a wavy part of 200 x 200 mm that is known only at points, the tool tilted by 15 degrees: contacts reached and
// lifted (hollows narrower than a flat or a large ball), the possible depth between points, the collisions of a chuck.
#include <pcl_spiral/cutter/cutter_location.h>

#include <cmath>
#include <cstdio>
#include <random>

static double
height(double x, double y)
{
  return 8.0 * std::sin(0.05 * x) * std::cos(0.04 * y);
}

static void
locate(const char* name, const pcl_spiral::CutterShape& cutter, pcl_spiral::CutterLocation<pcl::PointXYZ>& location)
{
  location.setCutter(cutter);
  pcl_spiral::ToolLocations locations;
  location.compute(locations);
  if (!location.getStatus().ok())
    return; // the class has reported the error
  const pcl_spiral::LocationReport& f = location.getReport();
  std::printf("%s: %zu of %zu contacts reached, %zu lifted by up to %.3f mm; %.3f mm sinking between points prevented\n", name,
              f.count(pcl_spiral::LocationState::Reached), locations.size(), f.count(pcl_spiral::LocationState::Lifted), f.largest_lift,
              f.largest_gap);
  for (const pcl_spiral::Diagnostic& warning : f.warnings)
    std::printf("  warning: %s\n", warning.text().c_str());
  location.setLocationSurface(location.getLocationSurface()); // the next cutter can use the same one
}

int
main()
{
  std::mt19937 random(1); // 0 to 4294967295
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i < 40000; ++i) {
    const double x = random() / 21474836.48 - 100.0, y = random() / 21474836.48 - 100.0;
    cloud->emplace_back(x, y, height(x, y));
  }
  pcl_spiral::DrivePoints drive; // contacts along lines, with their normals
  for (double y = -80.0; y <= 80.0; y += 4.0)
    for (double x = -80.0; x <= 80.0; x += 0.5) {
      const Eigen::Vector3d normal(-0.4 * std::cos(0.05 * x) * std::cos(0.04 * y), 0.32 * std::sin(0.05 * x) * std::sin(0.04 * y), 1.0);
      drive.push_back({{x, y, height(x, y)}, {0.0, std::sin(0.26), std::cos(0.26)}, normal});
    }

  pcl_spiral::CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(cloud);
  location.setDrivePoints(drive);
  locate("bull-nose 8 / 2", pcl_spiral::CutterShape::bullNose(8.0, 2.0, 10.0), location);
  locate("ball 60", pcl_spiral::CutterShape::ball(60.0), location);
  location.setHolder({pcl_spiral::ToolSegment::cylinder(40.0, 50.0, "chuck")});
  locate("ball 3, chuck 10 mm above its tip", pcl_spiral::CutterShape::ball(3.0, 7.0), location);
  return 0;
}
