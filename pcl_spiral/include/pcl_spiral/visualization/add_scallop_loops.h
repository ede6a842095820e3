// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The parts of a path of constant scallop height, in your own
 *  pcl::visualization::PCLVisualizer: the field, the loops, the tree that links them.
 *
 *  Header only, like add_toolpath.h: the program that includes it links pcl_visualization.
 */
#pragma once

#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/visualization/add_toolpath.h>

#include <pcl/kdtree/kdtree_flann.h>

#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkMapper.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_spiral {

/** Nearly black: ridges. */
constexpr Color ridge_color{0.10, 0.10, 0.15};
/** Red: the middles of fingers, and bridges. */
constexpr Color finger_color{0.80, 0.11, 0.13};

/** The colour of a branch of the tree: blue for the spiral itself (0), other colours for the other branches. */
inline Color
branchColor(std::size_t branch)
{
  constexpr Color beside[] = {{0.95, 0.55, 0.10}, {0.10, 0.65, 0.35}, {0.60, 0.25, 0.75}, {0.10, 0.70, 0.75}, {0.75, 0.60, 0.10}};
  return branch == 0 ? Color{0.20, 0.40, 0.90} : beside[(branch - 1) % 5];
}

/** The branch of each of \p count loops linked by \p joints: 0 for the loops of the spiral, 1, 2 ... for the
 *  others. All loops that are attached to the spiral at one place, or cut by one pass, are one branch. */
inline std::vector<std::size_t>
branchesOf(const std::vector<LoopJoint>& joints, std::size_t count)
{
  std::vector<std::size_t> branch(count, 0);
  std::size_t branches = 0;
  const auto follow = [&](bool fingers) { // fingers come before the loops to which they are attached
    for (const LoopJoint& joint : joints) {
      if (fingers != (joint.kind == LoopJointKind::Finger))
        continue;
      const bool begins = joint.kind == LoopJointKind::Lift || (joint.kind == LoopJointKind::Bridge && branch[joint.parent] == 0);
      branch[joint.loop] = begins ? ++branches : branch[joint.parent];
    }
  };
  follow(false);
  follow(true);
  return branch;
}

namespace detail {

/** Triangles of a field with its distances, in step-overs, at their corners. */
inline vtkSmartPointer<vtkPolyData>
fieldMesh(const StepOverDistance& field)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  auto distances = vtkSmartPointer<vtkFloatArray>::New();
  for (std::size_t v = 0; v < field.mesh.size(); ++v) {
    points->InsertNextPoint(field.mesh.positions[v].data());
    distances->InsertNextValue(static_cast<float>(field.distance[v]));
  }
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  for (std::size_t t = 0; t < field.mesh.triangles.triangleCount(); ++t) {
    const auto& c = field.mesh.triangles.triangle(t);
    const vtkIdType corners[3] = {c[0], c[1], c[2]};
    triangles->InsertNextCell(3, corners);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(triangles);
  data->GetPointData()->SetScalars(distances);
  return data;
}

/** One colour per step-over, light and dark in turn. */
inline vtkSmartPointer<vtkLookupTable>
stepOverColors(int bands)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(bands);
  table->SetTableRange(0.0, bands);
  for (int k = 0; k < bands; ++k) {
    Color color = turnColor(static_cast<double>(k) / std::max(bands - 1, 1));
    for (double& share : color)
      share = 1.0 - (1.0 - share) * (k % 2 == 0 ? 0.55 : 0.8);
    table->SetTableValue(k, color[0], color[1], color[2]);
  }
  return table;
}

} // namespace detail

/** Shows \p field: its triangles in bands of one step-over from the rims inward as shape ID_field,
 *  and the nodes on its ridges as cloud ID_ridges. What was shown under the id before is replaced. */
inline void
addStepOverField(pcl::visualization::PCLVisualizer& viewer, const StepOverDistance& field, const std::string& id = "field",
                 int viewport = 0)
{
  viewer.removeShape(id + "_field");
  viewer.removePointCloud(id + "_ridges");
  if (field.mesh.size() == 0 || !viewer.addModelFromPolyData(detail::fieldMesh(field), id + "_field", viewport))
    return;
  if (auto* const actor = vtkActor::SafeDownCast(viewer.getShapeActorMap()->at(id + "_field"))) {
    const int bands = static_cast<int>(field.largest) + 1;
    actor->GetProperty()->LightingOff();
    actor->GetMapper()->SetLookupTable(detail::stepOverColors(bands));
    actor->GetMapper()->SetScalarRange(0.0, bands);
    actor->GetMapper()->InterpolateScalarsBeforeMappingOn();
  }
  pcl::PointCloud<pcl::PointXYZ>::Ptr ridges(new pcl::PointCloud<pcl::PointXYZ>);
  for (const std::uint32_t v : ridgeNodes(field)) {
    const Eigen::Vector3f p = field.mesh.positions[v].cast<float>() + 0.05f * field.mesh.normals[v];
    ridges->emplace_back(p.x(), p.y(), p.z());
  }
  using Dark = pcl::visualization::PointCloudColorHandlerCustom<pcl::PointXYZ>;
  if (!ridges->empty())
    viewer.addPointCloud<pcl::PointXYZ>(ridges, Dark(ridges, 255 * ridge_color[0], 255 * ridge_color[1], 255 * ridge_color[2]),
                                        id + "_ridges", viewport);
}

/** Shows \p set: its loops from blue at the rims to yellow in the middle as shape ID_loops, the
 *  centre lines of their fingers in red as ID_axes. What was shown under the id before is replaced. */
inline void
addScallopLoops(pcl::visualization::PCLVisualizer& viewer, const ScallopLoopSet& set, const std::string& id = "scallop", int viewport = 0)
{
  ColoredLines loops, axes;
  const int deepest = set.loops.empty() ? 0 : set.loops.back().level;
  for (const ScallopLoop& loop : set.loops) {
    for (const Eigen::Vector3d& p : loop.points)
      loops.add(p, turnColor(static_cast<double>(loop.level) / std::max(deepest, 1)));
    loops.end(true);
  }
  for (const Polyline& axis : set.axes) {
    for (const Eigen::Vector3d& p : axis)
      axes.add(p, finger_color);
    axes.end(false);
  }
  viewer.removeShape(id + "_loops");
  viewer.removeShape(id + "_axes");
  detail::showLines(viewer, loops, 1.5, id + "_loops", viewport);
  detail::showLines(viewer, axes, 2.5, id + "_axes", viewport);
}

/** Shows the tree that links \p loops to \p path: each loop in the colour of its branch as shape ID_branches; ramps
 *  of the spiral, bridges, lifts and fingers as strokes, ID_joints. What was shown under the id before is replaced. */
inline void
addLoopTree(pcl::visualization::PCLVisualizer& viewer, const std::vector<ScallopLoop>& loops, const LinkedPath& path,
            const std::string& id = "tree", int viewport = 0)
{
  ColoredLines branches, joints;
  const std::vector<std::size_t> branch = branchesOf(path.joints, loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (const Eigen::Vector3d& p : loops[i].points)
      branches.add(p, branchColor(branch[i]));
    branches.end(true);
  }
  for (const LoopJoint& joint : path.joints) {
    const Color color = joint.kind == LoopJointKind::Ramp ? ridge_color : finger_color;
    joints.add(joint.parent_place, color);
    joints.add(joint.place, color);
    joints.end(false);
  }
  viewer.removeShape(id + "_branches");
  viewer.removeShape(id + "_joints");
  detail::showLines(viewer, branches, 1.5, id + "_branches", viewport);
  detail::showLines(viewer, joints, 5.0, id + "_joints", viewport);
}

/** Shows \p path as one line per pass, shape ID_linked. Each place has the colour of the branch of the
 *  nearest of the \p loops from which it was linked. What was shown under the id before is replaced. */
inline void
addLinkedPath(pcl::visualization::PCLVisualizer& viewer, const LinkedPath& path, const std::vector<ScallopLoop>& loops,
              const std::string& id = "linked", int viewport = 0)
{
  viewer.removeShape(id + "_linked");
  pcl::PointCloud<pcl::PointXYZ>::Ptr places(new pcl::PointCloud<pcl::PointXYZ>);
  std::vector<std::size_t> owner;
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (const Eigen::Vector3d& p : loops[i].points) {
      places->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
      owner.push_back(i);
    }
  if (places->empty())
    return;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(places);
  const std::vector<std::size_t> branch = branchesOf(path.joints, loops.size());
  ColoredLines line;
  pcl::Indices nearest(1);
  std::vector<float> squared(1);
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const Eigen::Vector3d& p = path.points[i];
    if (beginsPass(path.passes, i))
      line.end(false);
    tree.nearestKSearch(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())), 1, nearest,
                        squared);
    line.add(p, branchColor(branch[owner[nearest[0]]]));
  }
  line.end(false);
  detail::showLines(viewer, line, 1.5, id + "_linked", viewport);
}

} // namespace pcl_spiral
