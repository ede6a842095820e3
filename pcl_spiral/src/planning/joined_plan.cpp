// SPDX-License-Identifier: BSD-3-Clause
#include "planning/joined_plan.h"

#include "planning/joined_report.h"
#include "planning/plan_regions.h"
#include <pcl_spiral/core/impl/tolerances.h>

#include <pcl/common/point_tests.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace pcl_spiral {
namespace {

/** The points of a region: of its surface, if there is one. */
std::vector<std::array<float, 3>>
pointsOf(const SpiralPlan& region)
{
  std::vector<std::array<float, 3>> points;
  if (region.surface)
    for (std::size_t i = 0; i < region.surface->size(); ++i) {
      const pcl::PointXYZ& p = (*region.cloud)[region.surface->sourceIndex(i)];
      points.push_back({p.x, p.y, p.z});
    }
  else
    for (const pcl::PointXYZ& p : *region.cloud)
      if (pcl::isFinite(p))
        points.push_back({p.x, p.y, p.z});
  return points;
}

/** Adds the path of \p region; arc lengths and turns continue, and the arc length does not grow on the way to it. */
void
addPath(const SpiralPlan& region, pcl::PointCloud<ToolpathPoint>& path)
{
  const double length = path.empty() ? 0.0 : path.back().arc_length - region.path->front().arc_length;
  const float turns = path.empty() ? 0.0f : std::ceil(path.back().turn) + 1.0f;
  for (ToolpathPoint point : *region.path) {
    point.arc_length += length;
    point.turn += turns;
    path.push_back(point);
  }
}

} // namespace

Status
checkApart(const std::vector<RegionPoints>& regions)
{
  std::map<std::array<float, 3>, std::size_t> owners;
  for (std::size_t k = 0; k < regions.size(); ++k) {
    std::map<std::size_t, std::size_t> shared;
    std::array<float, 3> place{};
    for (const auto& point : regions[k].points) {
      const std::size_t owner = owners.emplace(point, k).first->second;
      if (owner != k && shared[owner]++ == 0)
        place = point;
    }
    for (const auto& [owner, count] : shared)
      return {StatusCode::InvalidInput, Diagnostic(regions[owner].name, " and ", regions[k].name, " have ", count,
                                                   " points in common, one at ", Place(Eigen::Vector3d(place[0], place[1], place[2])),
                                                   ": they would be cut twice; leave one of the two out, or make the polygons smaller")};
  }
  return Status::success();
}

void
addStage(const StageCost& stage, std::vector<StageCost>& stages)
{
  for (StageCost& present : stages)
    if (present.name == stage.name) {
      present.seconds += stage.seconds;
      return;
    }
  stages.insert(stages.begin(), stage);
}

Status
joinPlans(std::vector<SpiralPlan> regions, SpiralPlan& all)
{
  std::vector<RegionPoints> points;
  points.reserve(regions.size());
  for (const SpiralPlan& region : regions)
    points.push_back({region.region, pointsOf(region)});
  if (const Status status = checkApart(points); !status.ok())
    return status;
  all.path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  all.settings = regions.front().settings;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const RegionPoints& region : points)
    for (const auto& [x, y, z] : region.points)
      cloud->emplace_back(x, y, z);
  const auto shared = static_cast<std::ptrdiff_t>(all.part.warnings.size()); // of the mesh: each region has them, too
  for (const SpiralPlan& region : regions) {
    addPath(region, *all.path);
    all.echoes.insert(all.echoes.end(), region.echoes.begin(), region.echoes.end());
    const auto first = region.part.warnings.begin() + shared;
    for (const Diagnostic& warning : ofRegion(region.region, {first, region.part.warnings.end()}))
      all.part.warnings.push_back(warning);
  }
  all.cloud = cloud;
  all.report = joinedReport(regions, *all.path);
  all.tool = regions.front().tool;
  all.tool.tolerance = gougeTolerance(all.settings.chord_error, all.report.noise);
  all.regions = std::move(regions);
  return Status::success();
}

} // namespace pcl_spiral
