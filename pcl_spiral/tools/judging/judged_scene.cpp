// SPDX-License-Identifier: BSD-3-Clause
#include "judged_scene.h"

#include "terminal/scan_places.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace pcl_spiral;

namespace {

/** The values of a planner's report that the pictures need, from the path and the surface of the scan. */
SpiralReport
reportOf(const pcl::PointCloud<ToolpathPoint>& path, const JudgeSettings& settings, const ReferenceSurface& surface,
         const RemovalReport& removal)
{
  SpiralReport report;
  report.used_points = surface.graph().size();
  report.spacing = surface.graph().spacing();
  report.noise = surface.noise();
  report.loops = surface.loops();
  for (BoundaryLoop& loop : report.loops)
    loop.indices.clear(); // of the surface's points, not of the scan's
  report.turns = static_cast<std::size_t>(std::max(1L, std::lround(path.back().turn)));
  const double on_plane = std::sqrt(8.0 * settings.cutter.radius * settings.scallop_height);
  const double mean = removal.area > 0.0 ? removal.area / removal.path_length : on_plane;
  report.path_length = removal.path_length;
  report.smallest_step_over = report.largest_step_over = mean;
  return report;
}

} // namespace

VerificationScene
judgedScene(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const pcl::PointCloud<ToolpathPoint>::ConstPtr& path,
            const JudgeSettings& settings, const ReferenceSurface& surface, const Verification& verification, const Heights& heights)
{
  VerificationScene scene;
  scene.part.title = titleWithShift(std::filesystem::path(verification.path).filename().string());
  scene.part.cloud = surface.mesh() ? heights.points : scan;
  scene.part.mesh = settings.mesh;
  scene.part.path = path;
  scene.part.settings.tool_radius = settings.cutter.radius;
  scene.part.settings.scallop_height = settings.scallop_height;
  scene.part.settings.chord_error = settings.chord_error;
  scene.part.settings.view_point = settings.view_point;
  scene.part.settings.flip_normals = settings.flip_normals;
  scene.part.report = reportOf(*path, settings, surface, verification.removal);
  scene.deviation = heights.deviation;
  scene.stock = heights.stock;
  scene.ridges = heights.ridges;
  scene.deviation_figures = verification.deviation;
  scene.removal_figures = verification.removal;
  return scene;
}
