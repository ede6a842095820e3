#include "section_passes.h"

#include "section_curve.h"
#include "section_lines.h"
#include "section_rows.h"

#include <pcl_spiral/common/available_memory.h>
#include <pcl_spiral/common/message.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

Status
bad(std::string message)
{
  return {StatusCode::InvalidArgument, std::move(message)};
}

/** Distances of the planes along their normal. */
Status
levelsOf(const SectionSettings& settings, double low, double high, std::vector<double>& levels)
{
  if (!settings.levels.empty()) {
    levels = settings.levels;
    return Status::success();
  }
  constexpr double most = 1e7;
  const double count = std::max(1.0, std::ceil((high - low) / settings.step_over - 1e-9));
  if (!(count <= most))
    return bad(textOf("a step-over of ", settings.step_over, " mm over ", high - low, " mm makes ", count, " rows, more than ", most,
                      ": is the mesh in another unit than mm? Otherwise raise the step-over (setStepOver)"));
  for (double k = 0.5; k < count; k += 1.0)
    levels.push_back(low + k * (high - low) / count);
  return Status::success();
}

/** Refused where the contacts, foretold by the area, take more memory than there is. */
Status
checkSize(const SurfaceMesh& mesh, const SectionSettings& settings, const std::vector<double>& levels, double extent)
{
  const double rows = static_cast<double>(levels.size());
  const double step = levels.size() > 1 ? (levels.back() - levels.front()) / (rows - 1.0) : extent;
  const double length = step > 0.0 ? mesh.area() / step : 0.0;
  const double edge = std::sqrt(mesh.area() / static_cast<double>(mesh.faceCount()));
  const double spacing = settings.point_spacing > 0.0 ? std::min(edge, settings.point_spacing) : edge;
  const double bytes = 3.0 * sizeof(DrivePoint) * length / spacing;
  const std::optional<double> memory = availableMemory();
  if (!memory || bytes <= *memory)
    return Status::success();
  return bad(textOf("the sections asked for are too large: about ", length / spacing, " contacts and ", bytes / 1e9,
                    " GB of memory, and ", *memory / 1e9, " GB are free: is the mesh in another unit than mm? Otherwise raise "
                    "the step-over (setStepOver), now ", settings.step_over, " mm"));
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


/** How far each vertex lies along the planes' normal, and from where to where they all do. */
struct Distances {
  std::vector<double> of;
  double low = INFINITY, high = -INFINITY;
};

Distances
distancesAlong(const SurfaceMesh& mesh, const Vector3d& normal)
{
  Distances distances;
  distances.of.resize(mesh.vertexCount());
  for (std::size_t v = 0; v < distances.of.size(); ++v) {
    distances.of[v] = normal.dot(mesh.position(v));
    distances.low = std::min(distances.low, distances.of[v]);
    distances.high = std::max(distances.high, distances.of[v]);
  }
  return distances;
}

/** Direction of the rows: across planes' normal and tool axis; where these are one, any across. */
Vector3d
alongRows(const Vector3d& normal, const Vector3d& axis)
{
  constexpr double most_parallel = 1e-4; // sine
  const Vector3d along = normal.cross(axis.normalized());
  return along.norm() > most_parallel ? Vector3d(along.normalized()) : normal.unitOrthogonal();
}

} // namespace

Status
checkSettings(const SectionSettings& s)
{
  constexpr double shortest = 1e-9;
  if (!s.plane_normal.allFinite() || !(s.plane_normal.norm() > shortest))
    return bad("the planes' normal is " + placeText(s.plane_normal) + ", which has no direction: set it along the step from plane to "
               "plane (setPlaneNormal)");
  if (!s.axis.allFinite() || !(s.axis.norm() > shortest))
    return bad("the tool axis is " + placeText(s.axis) + ", which has no direction: set it from the tip to the shank (setAxis)");
  if (s.levels.empty() && (!(s.step_over > 0.0) || !std::isfinite(s.step_over)))
    return bad(textOf("the step-over is ", s.step_over, " mm: set it above 0 (setStepOver)"));
  for (std::size_t k = 0; k < s.levels.size(); ++k)
    if (!std::isfinite(s.levels[k]) || (k > 0 && !(s.levels[k] > s.levels[k - 1])))
      return bad(textOf("level ", k, " of the planes is ", s.levels[k], " mm: set levels that ascend (setLevels)"));
  if (!(s.chord_error > 0.0) || !std::isfinite(s.chord_error))
    return bad(textOf("the chord error is ", s.chord_error, " mm: set it above 0 (setChordError)"));
  if (!(s.point_spacing >= 0.0) || !std::isfinite(s.point_spacing))
    return bad(textOf("the spacing of contacts is ", s.point_spacing, " mm: set it above 0, or to 0 for none (setPointSpacing)"));
  return Status::success();
}

Status
sectionPasses(const SurfaceMesh& mesh, const SectionSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
              SectionReport& report)
{
  const auto goesOn = [&](double share, const char* stage) { return !progress || progress(share, stage); };
  const Status cancelled(StatusCode::Cancelled, "cancelled");
  const Vector3d normal = settings.plane_normal.normalized();
  const Distances distances = distancesAlong(mesh, normal);
  std::vector<double> levels;
  if (const Status status = levelsOf(settings, distances.low, distances.high, levels); !status.ok())
    return status;
  if (const Status status = checkSize(mesh, settings, levels, distances.high - distances.low); !status.ok())
    return status;
  if (!goesOn(0.0, "sections"))
    return cancelled;
  const auto lines = sectionLines(mesh, normal, distances.of, levels, settings.search);
  if (!goesOn(0.3, "contacts"))
    return cancelled;
  const SectionCurve curve(mesh, settings, normal, distances.of);
  std::vector<DrivePasses> rows(levels.size());
  std::vector<std::size_t> inside(levels.size(), 0);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t k = 0; k < static_cast<std::int64_t>(levels.size()); ++k)
    for (const LevelLine& line : lines[k])
      if (DrivePass pass = curve.contacts(line, levels[k], inside[k]); pass.points.size() > 1)
        rows[k].push_back(std::move(pass));
  if (!goesOn(0.9, "order"))
    return cancelled;
  const Vector3d along = alongRows(normal, settings.axis);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (const LevelLine& line : lines[k])
      report.crossings += line.crossings.size();
    report.inside_points += inside[k];
    report.step_over = std::max(report.step_over, k > 0 ? levels[k] - levels[k - 1] : 0.0);
    if (rows[k].empty())
      continue;
    addRow(std::move(rows[k]), along, settings.zigzag && report.rows % 2 == 1, passes);
    ++report.rows;
  }
  if (passes.empty())
    return {StatusCode::InvalidInput, textOf("no plane crosses the mesh: the planes lie at ", levels.front(), " to ", levels.back(),
                                             " mm along their normal, the mesh from ", distances.low, " to ", distances.high,
                                             " mm; set levels between these (setLevels)")};
  measure(passes, report);
  return goesOn(1.0, "order") ? Status::success() : cancelled;
}

} // namespace pcl_spiral
