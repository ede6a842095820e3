// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/geodesic/impl/geodesic_refinement.h>

#include "line_refiner.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** Project what all active lines ask for, in one call, until no line is active. */
void
runLevel(const MlsSurface& surface, std::vector<LineRefiner>& refiners)
{
  std::vector<std::size_t> active, begin;
  std::vector<Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (;;) {
    active.clear();
    begin.clear();
    queries.clear();
    for (std::size_t k = 0; k < refiners.size(); ++k)
      if (refiners[k].active()) {
        active.push_back(k);
        begin.push_back(queries.size());
        refiners[k].appendQueries(queries);
      }
    if (active.empty())
      return;
    surface.project(queries, feet);
    const auto count = static_cast<std::int64_t>(active.size());
#pragma omp parallel for schedule(dynamic, 4)
    for (std::int64_t a = 0; a < count; ++a)
      refiners[active[a]].take(feet.data() + begin[a]);
  }
}

bool
isFinite(const Polyline& line)
{
  return std::all_of(line.begin(), line.end(), [](const Vector3d& p) { return p.allFinite(); });
}

/** A line from a point to itself is a geodesic already. */
void
finishPoint(const MlsSurface& surface, GeodesicLine& line)
{
  line.points.resize(2);
  line.feet.assign(2, surface.project(line.points[0]));
  line.feet[0].position = line.feet[1].position = line.points[0];
  line.largest_move = 0.0;
  line.converged = true;
}

} // namespace

void
refineGeodesics(const MlsSurface& surface, const RefinementOptions& options, std::vector<GeodesicLine>& lines)
{
  std::vector<Vector3d> ends;
  std::vector<LineRefiner> refiners;
  refiners.reserve(lines.size());
  for (GeodesicLine& line : lines) {
    Polyline start;
    start.swap(line.points);
    line = GeodesicLine();
    line.points.swap(start);
    if (line.points.size() < 2 || !isFinite(line.points))
      continue;
    if (!(length(line.points) > 0.0)) {
      finishPoint(surface, line);
      continue;
    }
    ends.push_back(line.points.front());
    ends.push_back(line.points.back());
    refiners.emplace_back(line, options, surface.graph().spacing());
  }
  std::vector<SurfaceFoot> feet;
  surface.project(ends, feet);
  for (std::size_t k = 0; k < refiners.size(); ++k)
    refiners[k].begin(feet[2 * k], feet[2 * k + 1]);
  for (std::size_t level = 0; level < options.levels.size(); ++level) {
    for (LineRefiner& refiner : refiners)
      refiner.startLevel(std::max(2, options.levels[level]), level + 1 == options.levels.size());
    runLevel(surface, refiners);
  }
}

} // namespace pcl_spiral
