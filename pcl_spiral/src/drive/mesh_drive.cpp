// SPDX-License-Identifier: BSD-3-Clause
// Drive paths over a mesh: sections of it; helix, rings and curves as over a cloud of its points.
#include "drive_kinds.h"

#include "mesh/mesh_feet.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/drive/impl/drive_cylinder.h>
#include <pcl_spiral/drive/impl/drive_path_engine.h>
#include <pcl_spiral/mesh/mesh_sampling.h>
#include <pcl_spiral/mesh/mesh_sections.h>

#include <omp.h>

#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** The number of threads within the caller's limit. */
unsigned int
threadsInUse()
{
  return static_cast<unsigned int>(omp_get_max_threads());
}

/** A surface through points of the mesh, for code that works on clouds. */
Status
sampledSurface(const SurfaceMesh::ConstPtr& mesh, Surface::ConstPtr& surface)
{
  MeshSampling sampling;
  sampling.setInputMesh(mesh);
  sampling.setNumberOfThreads(threadsInUse());
  pcl::PointCloud<pcl::PointNormal> samples;
  sampling.compute(samples);
  if (!sampling.getStatus().ok())
    return sampling.getStatus();
  SurfacePoints points;
  for (const pcl::PointNormal& sample : samples) {
    points.positions.push_back(sample.getVector3fMap());
    points.normals.push_back(sample.getNormalVector3fMap());
  }
  Surface::Parts parts;
  parts.input_size = samples.size();
  SurfaceSettings settings;
  settings.strict = false;
  std::vector<std::int8_t> why;
  if (const Status status = makeSurface(std::move(points), settings, SurfaceReport(), parts, why); !status.ok())
    return status;
  surface = std::make_shared<Surface>(std::move(parts));
  return Status::success();
}

void
takeReport(const SectionReport& sections, DriveReport& report)
{
  report.rows = sections.rows;
  report.step_over = sections.step_over;
  report.smallest_step = sections.smallest_step;
  report.held_share = sections.held_share;
  report.links = sections.links;
  report.rows_apart = sections.rows_apart;
  report.facing_away = sections.facing_away;
  report.warnings.insert(report.warnings.end(), sections.warnings.begin(), sections.warnings.end());
}

Status
planMeshSections(const SurfaceMesh::ConstPtr& mesh, const DriveSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
                 DriveReport& report)
{
  MeshSections sections;
  sections.setInputMesh(mesh);
  sections.setPlaneNormal(acrossPlanes(settings));
  sections.setAxis(settings.axis);
  sections.setStepOver(settings.step_over);
  sections.setRows(settings.rows);
  sections.setToolRadius(settings.cutter ? settings.cutter->radius : 0.0);
  sections.setScallopHeight(settings.scallop_height);
  sections.setChordError(settings.chord_error);
  sections.setPointSpacing(settings.point_spacing);
  sections.setZigzag(settings.zigzag);
  sections.setLinkRows(settings.link_rows);
  sections.setFacing(settings.axisMode() == DriveAxisMode::Fixed);
  sections.setProgressCallback(progress);
  sections.setQuiet(true);
  sections.setNumberOfThreads(threadsInUse());
  sections.compute(passes);
  takeReport(sections.getReport(), report);
  if (report.facing_away > 0)
    report.warnings.push_back(Diagnostic(report.facing_away, " contacts face away from the tool axis ", Direction(settings.axis),
                                         ", and were left out; passes are interrupted there"));
  return sections.getStatus();
}

/** Axes of contacts that have normals. */
Status
setContactAxes(const SurfaceMesh::ConstPtr& mesh, const DriveSettings& settings, DrivePasses& passes, DriveReport& report)
{
  switch (settings.axisMode()) {
  case DriveAxisMode::Fixed:
    return Status::success();
  case DriveAxisMode::Surface:
    for (DrivePass& pass : passes)
      for (DrivePoint& p : pass.points)
        p.axis = p.normal;
    return Status::success();
  case DriveAxisMode::LocalPlane: {
    const MeshFeet feet(*mesh);
    for (DrivePass& pass : passes)
#pragma omp parallel for schedule(static)
      for (std::int64_t i = 0; i < static_cast<std::int64_t>(pass.points.size()); ++i)
        pass.points[i].axis = mesh->faceNormal(feet.of(pass.points[i].position).face);
    return Status::success();
  }
  case DriveAxisMode::Cylinder:
    break;
  }
  Surface::ConstPtr surface;
  if (const Status status = sampledSurface(mesh, surface); !status.ok())
    return status;
  report.column.emplace();
  if (const Status status = findColumn(surface->graph(), settings.cylinder, *report.column); !status.ok())
    return status;
  return setAxes(surface->graph(), settings, {}, passes, report);
}

} // namespace

Status
planMeshDrive(const SurfaceMesh::ConstPtr& mesh, const DriveSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
              DriveReport& report)
{
  if (settings.kind == DriveKind::BoundaryOffset)
    return {StatusCode::InvalidArgument,
            "offsets of the boundary run over the points of a scan, not over a mesh: choose planes ({setKind}), "
            "or give the mesh's vertices as a cloud ({setInputCloud})"};
  if (settings.rows == DriveRows::Kept && settings.cutter && !hasBallEnd(*settings.cutter))
    return {StatusCode::InvalidArgument, "on a mesh only a ball keeps rows to a scallop height: give the mesh's vertices as a cloud "
                                         "({setInputCloud}), or take even rows ({setRows}, {setStepOver})"};
  if (settings.kind != DriveKind::Planes) {
    Surface::ConstPtr surface;
    if (settings.needsSurface())
      if (const Status status = sampledSurface(mesh, surface); !status.ok())
        return status;
    return planDrive(surface, settings, progress, passes, report);
  }
  if (const Status status = planMeshSections(mesh, settings, partOf(progress, 0.0, 0.8), passes, report); !status.ok())
    return status;
  if (const Status status = setContactAxes(mesh, settings, passes, report); !status.ok())
    return status;
  measureDrive(passes, report);
  if (progress && !progress(1.0, "axes"))
    return {StatusCode::Cancelled, "cancelled"};
  return Status::success();
}

} // namespace pcl_spiral
