// SPDX-License-Identifier: BSD-3-Clause
// Ridges between rows of sections on a mesh, by a ball swept over the exact surface: rows at the step of a plane, and kept rows.
#include "cases.h"
#include "table.h"

#include "support/meshes.h"
#include "support/removed_material.h"

#include <pcl_spiral/mesh/mesh_sections.h>

#include <cmath>
#include <cstdio>

namespace pcl_spiral::acceptance {
namespace {

using namespace pcl_spiral::test;

CheckedPath
pathOf(const DrivePasses& passes)
{
  CheckedPath path;
  for (const DrivePass& pass : passes)
    for (const DrivePoint& p : pass.points) {
      path.contacts.push_back(p.position);
      path.normals.push_back(p.normal);
    }
  return path;
}

} // namespace

int
judgeMeshRows(const Options& options)
{
  constexpr double radius = 5.0, height = 0.01, chord_error = 0.001; // mm
  const SurfacePtr surface = landform();
  MeshSections sections;
  sections.setInputMesh(gridMesh(*surface, {100, 100}, 49).polygons());
  sections.setChordError(chord_error);
  sections.setToolRadius(radius);
  sections.setScallopHeight(height);
  sections.setStepOver(2.0 * std::sqrt((2.0 * radius - height) * height)); // equation (4)
  sections.setLinkRows(true);
  Table table("ridges between rows of sections on the landform, ball 5 mm, scallop 0.01 mm");
  std::size_t even = 0;
  for (const Eigen::Vector3d& normal : {Eigen::Vector3d(0.0, 1.0, 0.0), Eigen::Vector3d(1.0, 0.0, 0.0), Eigen::Vector3d(1.0, 1.0, 0.0)})
    for (const DriveRows rows : {DriveRows::Even, DriveRows::Kept}) {
      sections.setPlaneNormal(normal);
      sections.setRows(rows);
      DrivePasses passes;
      sections.compute(passes);
      RemovalSettings settings;
      settings.tool_radius = radius;
      settings.scallop_height = height;
      settings.seed = options.seed;
      settings.threads = options.threads;
      const RemovalReport figures = removedMaterial(*surface, pathOf(passes), settings);
      const SectionReport& report = sections.getReport();
      const bool kept = rows == DriveRows::Kept;
      const std::string name = std::string(kept ? "kept" : "even") + (normal.x() == 0.0   ? ", along x"
                                                                      : normal.y() == 0.0 ? ", along y"
                                                                                          : ", across");
      std::printf("  %s: %zu rows, %.4f to %.4f mm apart, %zu links, %zu passes\n", name.c_str(), report.rows, report.smallest_step,
                  report.step_over, report.links, report.passes);
      table.note(name + ": p99 of ridges", figures.ridge.p99 / height, "h");
      if (!kept) {
        even = report.rows;
        continue;
      }
      table.atMost(name + ": p99.9 of ridges", figures.ridge.p999, 1.02 * height + chord_error);
      table.note(name + ": gouge, with the error of the mesh", figures.gouge.value);
      table.holds(name + ": all rows joined", report.passes == 1);
      table.atMost(name + ": rows, of even ones", static_cast<double>(report.rows) / static_cast<double>(even), 1.12, "");
    }
  return table.broken();
}

} // namespace pcl_spiral::acceptance
