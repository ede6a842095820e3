// SPDX-License-Identifier: BSD-3-Clause
#include "kept_rows.h"

#include "core/profile_rows.h"
#include "drive_kinds.h"
#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double floor_share = 0.25, cell_share = 0.5; // of the step on a plane

/** The step of a ball with the radius of the cutter's corner on a plane: flat ends cut slopes with their corner. */
double
cornerStep(const DriveSettings& settings)
{
  const double h = settings.scallop_height, corner = std::max(settings.cutter->corner_radius, h);
  return 2.0 * std::sqrt((2.0 * corner - h) * h);
}

/** Curvature that the noise of the scan can show over the points that a normal is fitted to, or that a flat end levels within
 *  the scallop height. */
double
flattestOf(const Surface& surface, const DriveSettings& settings)
{
  constexpr double fitted = 5.0, noises = 4.0; // spacings; standard deviations
  const double span = fitted * surface.spacing(), radius = settings.cutter->radius;
  return std::max(settings.scallop_height / (radius * radius), noises * surface.noise() / (span * span));
}

/** The points of the graph; if they are closer than \p edge, the first of each cube of that size. */
std::vector<Vector3d>
placesOf(const SurfaceGraph& graph, double edge)
{
  std::vector<Vector3d> places;
  if (graph.spacing() >= edge) {
    for (std::size_t i = 0; i < graph.size(); ++i)
      places.push_back(graph.position(i));
    return places;
  }
  std::vector<std::pair<std::array<double, 3>, std::size_t>> cells;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const Vector3d cell = (graph.position(i) / edge).array().floor();
    cells.push_back({{cell.x(), cell.y(), cell.z()}, i});
  }
  std::sort(cells.begin(), cells.end());
  for (std::size_t k = 0; k < cells.size(); ++k)
    if (k == 0 || cells[k].first != cells[k - 1].first)
      places.push_back(graph.position(cells[k].second));
  return places;
}

void
warnOfFloor(const DriveSettings& settings, double floor, const Vector3d& narrowest, DriveReport& report)
{
  report.warnings.push_back(Diagnostic("on ", 100.0 * report.held_share, " % of the surface the scallop height of ",
                                       settings.scallop_height, " {mm} needs rows closer than ", floor,
                                       " {mm}, the least distance allowed; the closest at ", Place(narrowest),
                                       ": ridges there are higher; turn the planes across steep walls "
                                       "({setPlaneDirection}), or take a smaller cutter "
                                       "if a hollow is hardly wider than the cutter"));
}

} // namespace

RowLevels
keptRows(const Surface& surface, const DriveSettings& settings, const Vector3d& across, const Vector3d& origin, double low, double high,
         DriveReport& report)
{
  const double height = settings.scallop_height, step = cornerStep(settings), flattest = flattestOf(surface, settings);
  const CutterProfile profile(*settings.cutter);
  const bool fixed = settings.axisMode() == DriveAxisMode::Fixed, ball = hasBallEnd(*settings.cutter);
  const RowsThrough through = fixed ? RowsThrough::Centres : RowsThrough::Contacts;
  const double edge = cell_share * step;
  std::vector<SurfaceFoot> feet;
  surface.fit().project(placesOf(surface.graph(), edge), feet);
  feet.erase(std::remove_if(feet.begin(), feet.end(), [](const SurfaceFoot& foot) { return !foot.valid; }), feet.end());
  std::vector<RowPatch> patches(feet.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(feet.size()); ++i) {
    const SurfaceFoot& foot = feet[i];
    const Vector3d axis = fixed ? settings.axis.normalized() : foot.normal;
    const double width = std::max(edge, surface.graph().spacing(foot.nearest));
    const double at = across.dot((fixed ? profile.locate(foot.position, foot.normal, axis).tip : foot.position) - origin);
    const SurfaceBend bend{foot.normal, foot.direction1, foot.curvature1, foot.curvature2};
    const double most = ball ? rowDistance(bend, across, profile.radius(), height, through)
                             : profileRowDistance(bend, across, profile, axis, height, through, flattest);
    patches[i] = {at - 0.5 * width, at + 0.5 * width, most, width * width};
  }
  const RowLevels rows = rowLevels(patches, low, high, floor_share * step);
  report.held_share = rows.held_share;
  if (rows.narrowest != RowLevels::none)
    warnOfFloor(settings, floor_share * step, feet[rows.narrowest].position, report);
  return rows;
}

} // namespace pcl_spiral
