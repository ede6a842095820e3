// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/geodesic/impl/geodesic_path_engine.h>

#include "dijkstra_tree.h"
#include "distance_field.h"

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>

namespace pcl_spiral {
namespace {

template <typename Make>
void
fill(const Polyline& targets, std::vector<GeodesicLine>& lines, Make make)
{
  const auto count = static_cast<std::int64_t>(targets.size());
#pragma omp parallel for schedule(dynamic, 4)
  for (std::int64_t i = 0; i < count; ++i)
    lines[i].points = make(targets[i]);
}

/** Start lines; false when the source is not on the cloud. */
bool
startLines(const SurfaceGraph& graph, const Eigen::Vector3d& source, const Polyline& targets, GeodesicStart start,
           std::vector<GeodesicLine>& lines)
{
  if (start == GeodesicStart::Field) {
    DistanceField field;
    if (!field.compute(graph, source))
      return false;
    fill(targets, lines, [&](const Eigen::Vector3d& to) { return field.trace(to); });
    return true;
  }
  DijkstraTree tree;
  if (!tree.compute(graph, source))
    return false;
  fill(targets, lines, [&](const Eigen::Vector3d& to) { return tree.path(to); });
  return true;
}

Status
judge(const Polyline& targets, const std::vector<GeodesicLine>& lines, const RefinementOptions& options)
{
  std::size_t missing = 0, unsettled = 0;
  double largest = 0.0;
  Diagnostic first;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const GeodesicLine& line = lines[i];
    const bool empty = line.points.empty();
    if ((empty || line.left_surface) && missing++ == 0) {
      first = Diagnostic("target ", i, " at ", Place(targets[i]));
      if (empty)
        first += " is not on the cloud, or is on a part that no path from the source reaches: project it first, or scan "
                 "the surface between";
      else
        first += Diagnostic(": the shortest path leaves the surface at ", Place(line.left_at),
                            " (a re-entrant outline or a gap in the scan): choose targets with a straight way over the surface from the "
                            "source, or scan the gap");
    }
    else if (!empty && !line.left_surface && !line.converged) {
      ++unsettled;
      largest = std::max(largest, line.largest_move);
    }
  }
  if (missing > 0)
    return {StatusCode::Failed, Diagnostic(missing, " of ", lines.size(), " paths were not found; first ", first)};
  if (unsettled > 0)
    return {StatusCode::Ok, Diagnostic("done; ", unsettled, " of ", lines.size(), " paths still moved sideways by up to ", largest,
                                       " {mm} (tolerance ", options.tolerance, "): allow more iterations, or a tolerance of that size")};
  return Status::success();
}

} // namespace

Status
checkRefinement(const RefinementOptions& options)
{
  Diagnostic fault;
  if (options.levels.empty())
    fault = "there are no levels; give at least one number of segments";
  for (std::size_t i = 0; i < options.levels.size(); ++i)
    if (options.levels[i] < 2 || options.levels[i] > 100000 || (i > 0 && options.levels[i] < options.levels[i - 1])) {
      fault = Diagnostic("level ", i, " has ", options.levels[i], " segments; levels must not fall, and have 2 to 100000 segments");
      break;
    }
  if (fault.empty() && options.max_iterations < 1)
    fault = Diagnostic("the number of iterations is ", options.max_iterations, "; set it to 1 or more");
  if (fault.empty() && !(options.tolerance > 0.0))
    fault = Diagnostic("the tolerance is ", options.tolerance, " {mm}; set it above 0");
  return fault.empty() ? Status::success() : Status(StatusCode::InvalidArgument, fault);
}

Status
shortestPaths(const MlsSurface& surface, const Eigen::Vector3d& source, const Polyline& targets, GeodesicStart start,
              const RefinementOptions& options, std::vector<GeodesicLine>& lines)
{
  lines.assign(targets.size(), GeodesicLine());
  const Status checked = checkRefinement(options);
  if (!checked.ok())
    return checked;
  if (!startLines(surface.graph(), source, targets, start, lines))
    return {StatusCode::InvalidArgument, Diagnostic("the source ", Place(source),
                                                    " is farther than three point spacings from the cloud: project it onto "
                                                    "the surface first")};
  refineGeodesics(surface, options, lines);
  return judge(targets, lines, options);
}

} // namespace pcl_spiral
