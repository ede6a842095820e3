// SPDX-License-Identifier: BSD-3-Clause
// Lines of equal distance along the surface from its boundary.
#include "drive_kinds.h"
#include "drive_lines.h"
#include "level_islands.h"

#include "geodesic/distance_field.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/features/impl/boundary_loops_engine.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** A level, and its island; LevelIslands::none: the whole surface. */
struct OffsetLevel {
  double distance;
  std::uint32_t island;
};

/** Equal steps, and one more line for each island with its peak more than half a step inside the last of
 *  these. */
std::vector<OffsetLevel>
levelsOf(const EqualSteps& steps, const LevelIslands& islands)
{
  constexpr double rounding = 1e-6;
  std::vector<OffsetLevel> levels;
  for (const double middle : steps.middles)
    levels.push_back({middle, LevelIslands::none});
  for (std::uint32_t i = 0; i < islands.islands.size(); ++i) {
    const LevelIslands::Island& island = islands.islands[i];
    if (island.peak - steps.middles[island.level] > (0.5 + rounding) * steps.step)
      levels.push_back({island.peak - 0.5 * steps.step, i});
  }
  std::sort(levels.begin(), levels.end(), [](const OffsetLevel& a, const OffsetLevel& b) {
    return a.distance < b.distance || (a.distance == b.distance && a.island < b.island);
  });
  return levels;
}

/** Let a closed line begin next to \p place. */
void
beginNextTo(const Eigen::Vector3d& place, Polyline& line)
{
  std::rotate(line.begin(),
              std::min_element(line.begin(), line.end(),
                               [&](const auto& a, const auto& b) { return (a - place).squaredNorm() < (b - place).squaredNorm(); }),
              line.end());
}

} // namespace

Status
planOffsets(const SurfaceGraph& graph, const DriveSettings& settings, const ProgressCallback& progress, DrivePasses& passes,
            DriveReport& report)
{
  std::vector<BoundaryLoop> loops;
  BoundaryOptions options;
  options.progress = [&](double share) { return !progress || progress(0.3 * share, "boundary"); };
  if (const Status status = findBoundaryLoops(graph, options, loops); !status.ok())
    return status;
  DistanceField field;
  if (!field.compute(graph, loops.front().curve))
    return {StatusCode::Failed, "the distance from the outer boundary cannot be computed: its outline runs farther than "
                                "three spacings from the points; remove points away from the surface, or scan more densely"};
  double deepest = 0.0;
  for (const double distance : field.distances())
    if (std::isfinite(distance))
      deepest = std::max(deepest, distance);
  const double rows = surfaceArea(graph) / settings.step_over;
  if (const Status status =
          checkDriveSize(rows / settings.point_spacing + deepest / settings.step_over, 2.0 * rows / graph.spacing(), settings);
      !status.ok())
    return status;
  const Triangulation mesh = withoutFlaws(graph);
  const EqualSteps steps = equalSteps(0.0, deepest, settings.step_over);
  report.step_over = steps.step;
  const LevelIslands islands = levelIslands(mesh, field.distances(), steps.middles);
  const std::vector<OffsetLevel> levels = levelsOf(steps, islands);
  std::vector<double> distances;
  distances.reserve(levels.size());
  for (const OffsetLevel& level : levels)
    distances.push_back(level.distance);
  const auto lines = levelLines(mesh, field.distances(), distances);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::vector<LevelLine> wanted;
    for (const LevelLine& line : lines[k])
      if (levels[k].island == LevelIslands::none || islands.of_point[line.crossings.front().above] == levels[k].island)
        wanted.push_back(line);
    std::vector<DriveLine> pieces = joined(driveLines(wanted, graph), widest_gap * graph.spacing());
    report.short_pieces += dropShort(pieces, graph.spacing());
    for (DriveLine& piece : pieces) {
      if (piece.closed && !passes.empty())
        beginNextTo(passes.back().points.front().position, piece.points);
      passes.push_back(passAlong(piece.points, piece.closed, settings.point_spacing));
    }
  }
  const auto open =
      static_cast<std::size_t>(std::count_if(passes.begin(), passes.end(), [](const DrivePass& pass) { return !pass.closed; }));
  if (open > 0)
    report.warnings.push_back(Diagnostic(open, " of ", passes.size(),
                                         " lines are interrupted: by holes in the scan, or by its rim "
                                         "if that is more ragged than half a step-over, ",
                                         0.5 * steps.step, " {mm}"));
  return Status::success();
}

} // namespace pcl_spiral
