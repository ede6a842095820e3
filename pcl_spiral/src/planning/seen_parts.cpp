// SPDX-License-Identifier: BSD-3-Clause
#include "planning/seen_parts.h"

#include <pcl_spiral/graph/impl/surface_parts.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <pcl/common/io.h>

#include <vector>

namespace pcl_spiral {
namespace {

/** Whether one of several parts is to be cut. */
bool
isChosen(const PlanInput& input)
{
  return input.choice.part_at || input.settings.largest_part;
}

/** The points of \p surface if others of \p scan are of another part, else none. */
pcl::PointCloud<pcl::PointXYZ>::ConstPtr
chosenOf(const Surface& surface, const pcl::PointCloud<pcl::PointXYZ>& scan)
{
  if (surface.report().other_part == 0)
    return nullptr;
  const auto chosen = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  chosen->sensor_origin_ = scan.sensor_origin_;
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (!surface.isGuessed(i))
      chosen->push_back(scan[surface.sourceIndex(i)]);
  return chosen;
}

} // namespace

Status
findSeenParts(const PlanInput& input, SeenParts& seen)
{
  seen = SeenParts();
  if (input.indices) {
    const auto chosen = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
    pcl::copyPointCloud(*input.cloud, *input.indices, *chosen);
    chosen->sensor_origin_ = input.cloud->sensor_origin_;
    seen.chosen = chosen;
    return Status::success();
  }
  const bool divided = input.choice.cuts() || input.regions.size() > 1; // then the points are chosen by their place
  if (divided && !isChosen(input))
    return Status::success();
  SurfaceSettings settings = input.settings;
  settings.part_at = input.choice.part_at;
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(input.cloud);
  scanned.setSettings(settings);
  scanned.setStrict(false); // what is wrong with it is what the ball closes
  scanned.setQuiet(true);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  if (!surface)
    return isChosen(input) ? scanned.getStatus() : Status::success();
  if (isChosen(input)) {
    seen.chosen = chosenOf(*surface, *input.cloud);
    return Status::success();
  }
  const std::vector<SurfacePart> parts = surfaceParts(surface->graph()).parts;
  if (otherParts(parts, largest_cluster) == OtherParts::TooLarge)
    seen.joined =
        Diagnostic("the {scan} has ", parts.size(), " separate parts, and closed by the ball ({setBallClosing}) those beside each ",
                   "other are one: ", partsText(parts), "; to cut only one of them, give a place on it ({setPartAt})");
  return Status::success();
}

} // namespace pcl_spiral
