// SPDX-License-Identifier: BSD-3-Clause
// Fields, closed loops and their tree in a user's PCLVisualizer: shapes counted, branches distinguished.
#include <pcl_spiral/visualization/add_scallop_loops.h>
#include <pcl_spiral/visualization/pictures.h>

#include "support/sampling.h"
#include "support/surfaces.h"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkMapper.h>

#include <algorithm>
#include <set>

namespace add_scallop_loops_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using pcl::visualization::PCLVisualizer;

namespace {

/** The field of a plate with two holes. */
struct Made {
  StepOverDistance::ConstPtr field;
  ScallopLoopSet set;
  LinkedPath path;
};

Made
made()
{
  Made result;
  const SurfacePtr part = flat(Region({rectangle(90.0, 60.0), circle({-20.0, 4.0}, 9.0), circle({21.0, -5.0}, 11.0)}));
  StepOverField<pcl::PointXYZ> distances;
  distances.setInputCloud(toCloud(sampleUniform(*part, 5000, 5).points));
  distances.setToolRadius(5.0);
  distances.setScallopHeight(0.1);
  distances.compute(result.field);
  ScallopLoops<pcl::PointXYZ> loops;
  loops.setInputField(result.field);
  loops.compute(result.set);
  LoopLinking<pcl::PointXYZ> linking;
  linking.setInputField(result.field);
  linking.setInputLoops(result.set.loops);
  linking.compute(result.path);
  return result;
}

vtkIdType
cellsOf(PCLVisualizer& viewer, const std::string& id)
{
  const auto found = viewer.getShapeActorMap()->find(id);
  if (found == viewer.getShapeActorMap()->end())
    return 0;
  return vtkPolyData::SafeDownCast(vtkActor::SafeDownCast(found->second)->GetMapper()->GetInput())->GetNumberOfCells();
}

} // namespace

TEST(AddScallopLoops, RidgesLieWhereBothSidesAreAsFar)
{
  StepOverField<pcl::PointXYZ> distances; // a strip along x
  distances.setInputCloud(toCloud(sampleUniform(*flat(Region({rectangle(100.0, 40.0)})), 5000, 2).points));
  distances.setToolRadius(5.0);
  distances.setScallopHeight(0.1);
  StepOverDistance::ConstPtr field;
  distances.compute(field);
  ASSERT_TRUE(field);
  std::size_t middle = 0;
  for (const std::uint32_t v : ridgeNodes(*field)) {
    const Eigen::Vector3d& p = field->mesh.positions[v];
    const double off = std::max(std::abs(p.y()) - std::max(0.0, std::abs(p.x()) - 30.0), 0.0); // from the roof over the strip
    EXPECT_LT(off, 1.2) << p.transpose(); // 0.6 step-overs: a front is late by up to a quarter, and the mesh has edges of that length
    middle += std::abs(p.x()) < 25.0;
  }
  EXPECT_GT(middle, 100u);
}

TEST(AddScallopLoops, EveryLoopBelongsToABranch)
{
  const std::vector<LoopJoint> joints{{5, 4, LoopJointKind::Finger},
                                      {1, 0, LoopJointKind::Ramp},
                                      {2, 1, LoopJointKind::Bridge},
                                      {3, 2, LoopJointKind::Bridge},
                                      {4, 0, LoopJointKind::Bridge}};
  EXPECT_EQ(branchesOf(joints, 6), (std::vector<std::size_t>{0, 0, 1, 1, 2, 2}));
  EXPECT_TRUE(branchesOf({}, 0).empty());
}

TEST(AddScallopLoops, ShapesHoldWhatTheyShow)
{
  if (!displayFault().empty())
    GTEST_SKIP() << "no display here, and PCLVisualizer would end the program";
  const Made of = made();
  ASSERT_FALSE(of.path.points.empty());
  PCLVisualizer viewer("scallop");
  for (int twice = 0; twice < 2; ++twice) { // the second time replaces the first
    addStepOverField(viewer, *of.field);
    addScallopLoops(viewer, of.set);
    addLoopTree(viewer, of.set.loops, of.path);
    addLinkedPath(viewer, of.path, of.set.loops);
    EXPECT_EQ(viewer.getShapeActorMap()->size(), 6u);
    EXPECT_EQ(viewer.getCloudActorMap()->size(), 1u);
  }
  EXPECT_EQ(cellsOf(viewer, "field_field"), static_cast<vtkIdType>(of.field->mesh.triangles.triangleCount()));
  EXPECT_EQ(cellsOf(viewer, "scallop_loops"), static_cast<vtkIdType>(of.set.loops.size()));
  EXPECT_GT(cellsOf(viewer, "scallop_axes"), 0);
  EXPECT_EQ(cellsOf(viewer, "tree_branches"), static_cast<vtkIdType>(of.set.loops.size()));
  EXPECT_EQ(cellsOf(viewer, "tree_joints"), static_cast<vtkIdType>(of.path.joints.size()));
  EXPECT_EQ(cellsOf(viewer, "linked_linked"), 1);
  const std::vector<std::size_t> branch = branchesOf(of.path.joints, of.set.loops.size());
  EXPECT_GE(std::set<std::size_t>(branch.begin(), branch.end()).size(), 3u); // round two holes, in addition to the spiral
}

TEST(AddScallopLoops, NothingIsShownOfNothing)
{
  if (!displayFault().empty())
    GTEST_SKIP() << "no display here, and PCLVisualizer would end the program";
  PCLVisualizer viewer("empty");
  addStepOverField(viewer, StepOverDistance());
  addScallopLoops(viewer, ScallopLoopSet());
  addLoopTree(viewer, {}, LinkedPath());
  addLinkedPath(viewer, LinkedPath(), {});
  EXPECT_TRUE(viewer.getShapeActorMap()->empty());
  EXPECT_TRUE(viewer.getCloudActorMap()->empty());
}

} // namespace add_scallop_loops_test
