// SPDX-License-Identifier: BSD-3-Clause
#include "joined_regions.h"

#include "joined_report.h"
#include "program/program_check.h"
#include "region_links.h"
#include "terminal/region_overlap.h"

#include <array>
#include <cmath>

using namespace pcl_spiral;

namespace {

/** The points of a region: of its surface, if there is one. */
std::vector<std::array<float, 3>>
pointsOf(const Result& region)
{
  std::vector<std::array<float, 3>> points;
  if (region.surface)
    for (std::size_t i = 0; i < region.surface->size(); ++i) {
      const pcl::PointXYZ& p = (*region.scan.cloud)[region.surface->sourceIndex(i)];
      points.push_back({p.x, p.y, p.z});
    }
  else
    for (const pcl::PointXYZ& p : *region.scan.cloud)
      if (pcl::isFinite(p))
        points.push_back({p.x, p.y, p.z});
  return points;
}

/** Adds the path of \p region; arc lengths and turns continue, and the arc length does not grow on the way to it. */
void
addPath(const Result& region, pcl::PointCloud<ToolpathPoint>& path)
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

Result
joined(const Job& job, const Result& input, std::vector<Result> regions)
{
  std::vector<RegionPoints> points;
  for (const Result& region : regions)
    points.push_back({region.region, pointsOf(region)});
  requireApart(job.scan, points);
  Result all = input;
  all.path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  all.settings = regions.front().settings;
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const RegionPoints& region : points)
    for (const auto& [x, y, z] : region.points)
      cloud->emplace_back(x, y, z);
  for (const Result& region : regions) {
    addPath(region, *all.path);
    all.echoes.insert(all.echoes.end(), region.echoes.begin(), region.echoes.end());
    const auto first = region.scan.warnings.begin() + static_cast<std::ptrdiff_t>(input.scan.warnings.size());
    for (const Diagnostic& warning : ofRegion(region.region, {first, region.scan.warnings.end()}))
      all.scan.warnings.push_back(warning);
  }
  all.scan.cloud = cloud;
  all.report = joinedReport(regions, *all.path);
  all.regions = std::move(regions);
  if (!hasProgram(job.program, job.outputs)) // the leads of a program are checked when it is there
    all.links = checkedLinks(job, all);
  return all;
}
