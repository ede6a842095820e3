// SPDX-License-Identifier: BSD-3-Clause
// A column with a waist, along one helix round its axis; a wavy plate, along planes. Both with a ball.
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/drive/drive_path.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace pcl_spiral;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

static void
machine(const char* name, DrivePath<pcl::PointXYZ>& drive, const Cloud::Ptr& cloud)
{
  const CutterShape cutter = CutterShape::ball(4.0);
  drive.setInputCloud(cloud);
  drive.setStepOver(*stepForScallop(CutterProfile(cutter), 0.05));
  drive.setPointSpacing(0.8);
  DrivePasses passes;
  drive.compute(passes);
  DrivePoints points; // empty on failure: both classes report the error
  for (const DrivePass& pass : passes)
    points.insert(points.end(), pass.points.begin(), pass.points.end());
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(cloud);
  location.setCutter(cutter);
  location.setDrivePoints(points);
  ToolLocations locations;
  location.compute(locations);
  const DriveReport& r = drive.getReport();
  std::printf("%s: %zu passes %.3f mm apart, %zu points over %.1f m, of which %zu touch\n", name, passes.size(), r.step_over, r.points,
              0.001 * r.length, location.getReport().count(LocationState::Touching));
  if (r.column && !passes.empty())
    std::printf("  the column's axis runs along (%.4f, %.4f, %.4f), its mean radius is %.3f mm\n", r.column->cylinder.direction.x(),
                r.column->cylinder.direction.y(), r.column->cylinder.direction.z(), r.column->radius);
}

int
main()
{
  std::mt19937 random(1); // 0 to 4294967295
  Cloud::Ptr column(new Cloud), plate(new Cloud);
  for (int i = 0; i < 40000; ++i) {
    const double a = random() / 683565275.6, z = random() / 71582788.3 - 30.0, r = 18.0 + 0.008 * z * z;
    column->emplace_back(r * std::cos(a), 0.8 * r * std::sin(a) - 0.6 * z, 0.6 * r * std::sin(a) + 0.8 * z); // leaning
    const double x = 1.5 * z, y = random() / 47721858.8 - 45.0;
    plate->emplace_back(x, y, 4.0 * std::sin(0.08 * x) * std::cos(0.06 * y));
  }
  DrivePath<pcl::PointXYZ> drive;
  drive.setKind(DriveKind::Helix);
  machine("column, helix", drive, column);
  drive.setKind(DriveKind::Planes);
  drive.setPlaneDirection(30.0);
  machine("plate, section planes", drive, plate);
  return 0;
}
