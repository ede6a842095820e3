// SPDX-License-Identifier: BSD-3-Clause
#include "section_passes.h"

#include "section_curve.h"
#include "section_levels.h"
#include "section_lines.h"
#include "section_rows.h"

#include "mesh_feet.h"
#include "row_links.h"
#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

Status
bad(Diagnostic message)
{
  return {StatusCode::InvalidArgument, std::move(message)};
}

void
measure(const DrivePasses& passes, SectionReport& report)
{
  report.passes = passes.size();
  for (const DrivePass& pass : passes) {
    const std::size_t n = pass.points.size();
    report.points += n;
    for (std::size_t i = 0; i + (pass.closed ? 0 : 1) < n; ++i)
      report.length += (pass.points[(i + 1) % n].position - pass.points[i].position).norm();
  }
}

/** Direction of the rows: across the normal of the planes and the tool axis; if these coincide, any direction across. */
Vector3d
alongRows(const Vector3d& normal, const Vector3d& axis)
{
  constexpr double most_parallel = 1e-4; // sine
  const Vector3d along = normal.cross(axis.normalized());
  return along.norm() > most_parallel ? Vector3d(along.normalized()) : normal.unitOrthogonal();
}

/** The contacts of each plane's lines. */
std::vector<DrivePasses>
contactRows(const SurfaceMesh& mesh, const SectionSettings& settings, const MeshExtent& extent, const std::vector<double>& levels,
            const std::vector<std::vector<LevelLine>>& lines, SectionReport& report)
{
  const SectionCurve curve(mesh, settings, settings.plane_normal.normalized(), extent.of);
  std::vector<DrivePasses> rows(levels.size());
  std::vector<std::size_t> inside(levels.size(), 0);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t k = 0; k < static_cast<std::int64_t>(levels.size()); ++k)
    for (const LevelLine& line : lines[k])
      if (DrivePass pass = curve.contacts(line, levels[k], inside[k]); pass.points.size() > 1)
        rows[k].push_back(std::move(pass));
  for (std::size_t k = 0; k < levels.size(); ++k) {
    report.inside_points += inside[k];
    for (const LevelLine& line : lines[k])
      report.crossings += line.crossings.size();
  }
  return rows;
}

void
measureSteps(const std::vector<double>& levels, double extent, SectionReport& report)
{
  report.step_over = report.smallest_step = levels.size() > 1 ? levels[1] - levels[0] : extent;
  for (std::size_t k = 2; k < levels.size(); ++k) {
    report.step_over = std::max(report.step_over, levels[k] - levels[k - 1]);
    report.smallest_step = std::min(report.smallest_step, levels[k] - levels[k - 1]);
  }
}

/** Join rows on the surface; links are at most two step-overs long. */
void
link(const SurfaceMesh& mesh, const SectionSettings& settings, DrivePasses& passes, SectionReport& report)
{
  const MeshFeet feet(mesh);
  const double edge = std::sqrt(mesh.area() / static_cast<double>(mesh.faceCount()));
  const double spacing = settings.point_spacing > 0.0 ? settings.point_spacing : edge;
  const double beside = 0.02 * report.step_over; // the boundary, along which links may run; it bows, too
  const RowLinks links = linkRows(passes, {2.0 * report.step_over, 0.1 * report.step_over, std::min(spacing, 0.5 * report.step_over)},
                                  [&](const Vector3d& place) -> std::optional<DrivePoint> {
                                    const MeshFoot foot = feet.of(place);
                                    const Vector3d off = place - foot.position;
                                    const double across = (off - foot.normal * foot.normal.dot(off)).norm();
                                    if (foot.beyond && across > beside + mesh.sag(foot.face))
                                      return std::nullopt;
                                    return DrivePoint{foot.position, settings.axis.normalized(), foot.normal};
                                  });
  report.links = links.made;
  report.rows_apart = links.not_made;
}

} // namespace

Status
checkSettings(const SectionSettings& s)
{
  constexpr double shortest = 1e-9;
  if (!s.plane_normal.allFinite() || !(s.plane_normal.norm() > shortest))
    return bad(Diagnostic("the planes' normal is ", Direction(s.plane_normal),
                          ", which has no direction: set it along the step from plane to "
                          "plane ({setPlaneNormal})"));
  if (!s.axis.allFinite() || !(s.axis.norm() > shortest))
    return bad(
        Diagnostic("the tool axis is ", Direction(s.axis), ", which has no direction: set it from the tip to the shank ({setAxis})"));
  const bool kept = s.rows == DriveRows::Kept;
  if (kept && !s.levels.empty())
    return bad("{setRows} asks for a constant scallop height, but levels are given: leave one of them out ({setRows}, {setLevels})");
  if (kept && (!(s.tool_radius > 0.0) || !std::isfinite(s.tool_radius) || !(s.scallop_height > 0.0) || !(s.scallop_height < s.tool_radius)))
    return bad(
        Diagnostic("rows are kept for a ball of radius ", s.tool_radius, " {mm} and a scallop height of ", s.scallop_height,
                   " {mm}: set the radius above 0 ({setToolRadius}), and the height above 0 and below the radius ({setScallopHeight})"));
  if (s.link_rows && !s.zigzag)
    return bad("rows that all run one way cannot be joined: each begins far from the end of the one before; call {setZigzag}(true), or "
               "{setLinkRows}(false)");
  if (!kept && s.levels.empty() && (!(s.step_over > 0.0) || !std::isfinite(s.step_over)))
    return bad(Diagnostic("the step-over is ", s.step_over, " {mm}: set it above 0 ({setStepOver})"));
  for (std::size_t k = 0; k < s.levels.size(); ++k)
    if (!std::isfinite(s.levels[k]) || (k > 0 && !(s.levels[k] > s.levels[k - 1])))
      return bad(Diagnostic("level ", k, " of the planes is ", s.levels[k], " {mm}: set levels that ascend ({setLevels})"));
  constexpr double least_error = 1e-6; // mm: the single precision of a mesh resolves no less
  if (!(s.chord_error >= least_error) || !std::isfinite(s.chord_error))
    return bad(Diagnostic("the chord error is ", s.chord_error, " {mm}: set it to ", least_error, " or more ({setChordError})"));
  if (!(s.point_spacing >= 0.0) || !std::isfinite(s.point_spacing))
    return bad(Diagnostic("the spacing of contacts is ", s.point_spacing, " {mm}: set it above 0, or to 0 for none ({setPointSpacing})"));
  return Status::success();
}

Status
sectionPasses(const SurfaceMesh& mesh, const SectionSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
              SectionReport& report)
{
  const auto goesOn = [&](double share, const char* stage) { return !progress || progress(share, stage); };
  const Status cancelled(StatusCode::Cancelled, "cancelled");
  const Vector3d normal = settings.plane_normal.normalized();
  const MeshExtent extent = extentAlong(mesh, normal);
  std::vector<double> levels;
  if (const Status status = sectionLevels(mesh, settings, extent, levels, report); !status.ok())
    return status;
  if (!goesOn(0.0, "sections"))
    return cancelled;
  const auto lines = sectionLines(mesh, normal, extent.of, levels, settings.search);
  if (!goesOn(0.3, "contacts"))
    return cancelled;
  std::vector<DrivePasses> rows = contactRows(mesh, settings, extent, levels, lines, report);
  if (!goesOn(0.8, "order"))
    return cancelled;
  const Vector3d along = alongRows(normal, settings.axis);
  for (DrivePasses& row : rows) {
    if (settings.facing)
      row = facingParts(row, settings.axis.normalized(), report.facing_away);
    if (!row.empty()) {
      addRow(std::move(row), along, settings.zigzag && report.rows % 2 == 1, passes);
      ++report.rows;
    }
  }
  if (passes.empty() && report.facing_away > 0)
    return {StatusCode::InvalidInput,
            Diagnostic("the whole mesh faces away from the tool axis ", Direction(settings.axis),
                       ", set from the tip "
                       "to the shank: turn the axis round ({setAxis}), or flip the faces of the mesh ({setFlipNormals})")};
  if (passes.empty())
    return {StatusCode::InvalidInput, Diagnostic("no plane crosses the mesh: the planes lie at ", levels.front(), " to ", levels.back(),
                                                 " {mm} along their normal, the mesh from ", extent.low, " to ", extent.high,
                                                 " {mm}; set levels between these ({setLevels})")};
  measureSteps(levels, extent.high - extent.low, report);
  if (settings.link_rows)
    link(mesh, settings, passes, report);
  measure(passes, report);
  return goesOn(1.0, "order") ? Status::success() : cancelled;
}

} // namespace pcl_spiral
