// SPDX-License-Identifier: BSD-3-Clause
// Tip, contact and normal of a location on a mesh fit together: the ball at the tip touches at the contact, along the normal.
#include <pcl_spiral/cutter/cutter_location.h>
#include <pcl_spiral/mesh/mesh_sections.h>

#include "support/meshes.h"
#include "support/solids.h"

#include <gtest/gtest.h>

#include <cmath>

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
  EXPECT_LT(farthestTip(gridMesh(*landform(), {100, 100}, 49), 5.0, 4.0), 1e-3); // by blended normals: 0.055
  EXPECT_LT(farthestTip(gridMesh(*landform(), {100, 100}, 20, 0.3), 8.0, 4.0), 1e-3);
  EXPECT_LT(farthestTip(cube(20.0), 3.0, 2.0), 1e-3);
}
