// SPDX-License-Identifier: BSD-3-Clause
// Tip, contact and normal of a location on a mesh fit together: the ball at the tip touches at the contact, along the normal.
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/mesh/mesh_sections.h>

#include "support/filleted_parts.h"
#include "support/meshes.h"
#include "support/sampling.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mesh_contacts_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

/** Largest distance of the tip from contact + R (normal - axis), over all locations of rows and those added between them. */
double
farthestTip(const TriangleMesh& mesh, double radius, double step)
{
  MeshSections sections;
  sections.setInputMesh(mesh.polygons());
  sections.setStepOver(step);
  sections.setFacing(true);
  sections.setPointSpacing(2.0);
  DrivePasses passes;
  sections.compute(passes);
  CutterLocation<pcl::PointXYZ> location;
  location.setInputMesh(sections.getSurfaceMesh());
  location.setCutter(CutterShape::ball(radius));
  location.setDrivePasses(passes);
  location.setPathTolerance(0.01);
  ToolLocations locations;
  location.compute(locations);
  EXPECT_GT(locations.size(), 100u);
  double most = 0.0;
  for (const ToolLocation& l : locations)
    if (l.state != LocationState::NoCloud)
      most = std::max(most, (l.contact + radius * (l.normal - l.axis) - l.tip).norm());
  return most;
}

} // namespace

TEST(MeshContacts, BelongToTheirTips)
{
  EXPECT_LT(farthestTip(gridMesh(*landform(), {100, 100}, 49), 5.0, 4.0), 1e-6); // by blended normals: 0.055
  EXPECT_LT(farthestTip(gridMesh(*landform(), {100, 100}, 20, 0.3), 8.0, 4.0), 1e-6);
  EXPECT_LT(farthestTip(cube(20.0), 3.0, 2.0), 1e-6);
}

TEST(MeshContacts, BelongToTheirTipsAtWallsAndEdges)
{
  using Eigen::Vector2d;
  SweepGuide line;
  line.half = {0.0, 20.0};
  for (const double wall : {3.0, 3.5}) { // straight down, and steep
    const RoundedProfile groove(
        {{Vector2d(-12, 0)}, {Vector2d(-wall, 0)}, {Vector2d(-3, -4)}, {Vector2d(3, -4)}, {Vector2d(wall, 0)}, {Vector2d(12, 0)}}, 10.0);
    for (const double radius : {1.0, 2.5, 6.0})
      EXPECT_LT(farthestTip(sweptPart(groove, line).mesh, radius, 0.37), 1e-6) << radius;
  }
}

TEST(MeshContacts, OfAScanWithAStepBelongToTheirTips)
{
  Random random(5);
  pcl::PointCloud<pcl::PointXYZ>::Ptr scan(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i < 12000; ++i) {
    const double x = random.uniform(-20.0, 20.0), y = random.uniform(-15.0, 15.0);
    scan->emplace_back(static_cast<float>(x), static_cast<float>(y), x < 0.0 ? 0.0F : 3.0F);
  }
  DrivePoints drive;
  for (int i = 0; i < 2000; ++i)
    drive.push_back({{random.uniform(-19.0, 19.0), random.uniform(-14.0, 14.0), 0.0}});
  for (const LocationEvaluation evaluation :
       {LocationEvaluation::FittedSurface, LocationEvaluation::PointsAndBound, LocationEvaluation::Points}) {
    CutterLocation<pcl::PointXYZ> location;
    location.setInputCloud(scan);
    location.setCutter(CutterShape::ball(4.0));
    location.setEvaluation(evaluation);
    location.setDrivePoints(drive);
    ToolLocations locations;
    location.compute(locations);
    ASSERT_TRUE(location.getStatus().ok()) << location.getStatus().message();
    for (const ToolLocation& l : locations)
      ASSERT_LT((l.contact + 4.0 * (l.normal - l.axis) - l.tip).norm(), 1e-6) << l.tip.transpose();
  }
}

} // namespace mesh_contacts_test
