// SPDX-License-Identifier: BSD-3-Clause
#include "section_levels.h"

#include "mesh_bends.h"

#include "common/available_memory.h"
#include "core/row_levels.h"
#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double most_rows = 1e7;
constexpr double floor_share = 0.25; // of the step on a plane: rows are never nearer

/** Equation (4) of Sun, Li, Li, Liu, 2010: the step on a plane. */
double
planeStep(const SectionSettings& settings)
{
  return 2.0 * std::sqrt((2.0 * settings.tool_radius - settings.scallop_height) * settings.scallop_height);
}

Status
checkRows(double rows, double extent, double step)
{
  if (rows <= most_rows)
    return Status::success();
  return {StatusCode::InvalidArgument,
          Diagnostic("a step-over of ", step, " {mm} over ", extent, " {mm} makes ", rows, " rows, more than ", most_rows,
                     ": is the mesh in another unit than {mm} ({ReadOptions::unit})? Otherwise raise the step-over ({setStepOver})")};
}

/** Refused if the predicted contacts are too many, or if they and what is made from them need more memory than is free. */
Status
checkSize(const SurfaceMesh& mesh, const SectionSettings& settings, double step)
{
  constexpr double crossings_an_edge = 2.5;                      // edges crossed on the length of one
  constexpr double most_contacts = 1e8, bytes_a_contact = 600.0; // of contact, location and pose
  const double edge = std::sqrt(mesh.area() / static_cast<double>(mesh.faceCount()));
  const double rate = std::max(crossings_an_edge / edge, settings.point_spacing > 0.0 ? 1.0 / settings.point_spacing : 0.0);
  const double contacts = mesh.area() / step * rate, bytes = bytes_a_contact * contacts;
  const std::optional<double> memory = availableMemory();
  if (contacts <= most_contacts && (!memory || bytes <= *memory))
    return Status::success();
  return {StatusCode::InvalidArgument,
          Diagnostic("the sections asked for are too large: about ", contacts, " contacts and ", bytes / 1e9, " GB of memory; at most ",
                     most_contacts, " contacts are allowed", (memory ? Diagnostic(" and ", *memory / 1e9, " GB are free") : Diagnostic()),
                     ": is the mesh in another unit than {mm} ({ReadOptions::unit})? Otherwise put rows farther apart, now ", step,
                     " {mm} ({setStepOver}, {setScallopHeight}), or contacts ({setPointSpacing})")};
}

/** What each face allows for the rows across it: the least of its corners. */
std::vector<RowPatch>
facePatches(const SurfaceMesh& mesh, const SectionSettings& settings, const Vector3d& normal, const MeshExtent& extent)
{
  const std::vector<SurfaceBend> bends = meshBends(mesh);
  std::vector<RowPatch> patches(mesh.faceCount());
#pragma omp parallel for schedule(static)
  for (std::int64_t t = 0; t < static_cast<std::int64_t>(patches.size()); ++t) {
    RowPatch& patch = patches[t];
    patch = {INFINITY, -INFINITY, INFINITY, mesh.faceArea(t)};
    for (auto h = static_cast<std::uint32_t>(3 * t); h < 3 * t + 3; ++h) {
      const double at = extent.of[mesh.triangles().origin(h)];
      patch.low = std::min(patch.low, at);
      patch.high = std::max(patch.high, at);
      patch.most = std::min(
          patch.most, rowDistance(bends[mesh.sector(h)], normal, settings.tool_radius, settings.scallop_height, RowsThrough::Contacts));
    }
  }
  return patches;
}

std::vector<double>
keptLevels(const SurfaceMesh& mesh, const SectionSettings& settings, const Vector3d& normal, const MeshExtent& extent,
           SectionReport& report)
{
  const double floor = floor_share * planeStep(settings);
  RowLevels rows = rowLevels(facePatches(mesh, settings, normal, extent), extent.low, extent.high, floor);
  report.held_share = rows.held_share;
  if (rows.narrowest != RowLevels::none) {
    const MeshPatch patch = mesh.patch(rows.narrowest);
    report.warnings.push_back(Diagnostic(
        "on ", 100.0 * rows.held_share, " % of the surface the scallop height of ", settings.scallop_height,
        " {mm} needs rows closer than ", floor, " {mm}, the least distance allowed; the closest at ", Place(patch.corners.rowwise().mean()),
        ": ridges there are higher; turn the planes across "
        "steep walls ({setPlaneNormal}), or take a smaller ball if a hollow is hardly wider than the ball"));
  }
  return std::move(rows.levels);
}

} // namespace

MeshExtent
extentAlong(const SurfaceMesh& mesh, const Vector3d& normal)
{
  MeshExtent extent{std::vector<double>(mesh.vertexCount()), INFINITY, -INFINITY};
  for (std::size_t v = 0; v < extent.of.size(); ++v) {
    extent.of[v] = normal.dot(mesh.position(v));
    extent.low = std::min(extent.low, extent.of[v]);
    extent.high = std::max(extent.high, extent.of[v]);
  }
  return extent;
}

Status
sectionLevels(const SurfaceMesh& mesh, const SectionSettings& settings, const MeshExtent& extent, std::vector<double>& levels,
              SectionReport& report)
{
  const Vector3d normal = settings.plane_normal.normalized();
  const double width = extent.high - extent.low;
  if (!(width > 0.0))
    return {StatusCode::InvalidInput,
            Diagnostic("the mesh has no extent along the planes' normal ", Direction(normal), ": turn the planes ({setPlaneNormal})")};
  if (!settings.levels.empty()) {
    levels = settings.levels;
    const double step = levels.size() > 1 ? (levels.back() - levels.front()) / static_cast<double>(levels.size() - 1) : width;
    return checkSize(mesh, settings, step);
  }
  const bool kept = settings.rows == DriveRows::Kept;
  const double step = kept ? planeStep(settings) : settings.step_over, count = std::max(1.0, std::ceil(width / step - 1e-9));
  if (const Status status = checkRows(kept ? count / floor_share : count, width, step); !status.ok())
    return status;
  if (kept)
    levels = keptLevels(mesh, settings, normal, extent, report);
  else
    for (double k = 0.5; k < count; k += 1.0)
      levels.push_back(extent.low + k * width / count);
  return checkSize(mesh, settings, width / static_cast<double>(levels.size()));
}

} // namespace pcl_spiral
