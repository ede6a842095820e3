// SPDX-License-Identifier: BSD-3-Clause
#include "planning/part_surface.h"

#include "cleaning/standing_clusters.h"
#include <pcl_spiral/cleaning/outlier_removal.h>
#include <pcl_spiral/collision/impl/false_echoes.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <pcl/common/io.h>

#include <cstdint>

namespace pcl_spiral {
namespace {

/** Keeps the points with these \p indices. */
void
keepOnly(const pcl::Indices& indices, PassPlan& plan)
{
  const auto kept = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::copyPointCloud(*plan.cloud, indices, *kept);
  plan.cloud = kept;
  if (!plan.normals)
    return;
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::copyPointCloud(*plan.normals, indices, *normals);
  plan.normals = normals;
}

} // namespace

Status
leaveOutStrays(unsigned int threads, PassPlan& plan)
{
  OutlierRemoval<pcl::PointXYZ> removal;
  removal.setNumberOfThreads(threads);
  removal.setQuiet(true);
  removal.setInputCloud(plan.cloud);
  pcl::Indices indices;
  removal.filter(indices);
  if (!removal.getStatus().ok())
    return removal.getStatus();
  const OutlierReport& f = removal.getReport();
  if (f.outliers > 0)
    plan.warnings.push_back(Diagnostic(f.outliers, " of ", plan.cloud->size(),
                                       " points off the scanned surface were left out ({setLeaveOutStrays}); the largest group has ",
                                       f.largest_group, ", at ", Place(f.largest_group_place),
                                       f.largest_group > largest_echo ? ": such a group is not a false echo; check what is there" : ""));
  keepOnly(indices, plan);
  return Status::success();
}

Status
makePartSurface(const SurfaceSettings& settings, const ProgressCallback& progress, PassPlan& plan)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(plan.cloud);
  scanned.setInputNormals(plan.normals);
  scanned.setSettings(settings);
  scanned.setLargestPart(settings.largest_part && !settings.part_at);
  scanned.setStrict(false); // a rough surface is accepted, with a warning
  scanned.setQuiet(true);
  scanned.setProgressCallback(progress);
  plan.surface.reset();
  scanned.compute(plan.surface);
  if (plan.surface)
    plan.side = plan.surface->side();
  const StatusCode code = scanned.getStatus().code();
  const bool fails = code == StatusCode::Cancelled || code == StatusCode::InvalidArgument; // such as a place far from the scan
  return fails ? scanned.getStatus() : Status::success();
}

Status
applyClusterHandling(const SurfaceSettings& settings, double corner_radius, const ProgressCallback& progress, PassPlan& plan)
{
  if (!plan.surface || plan.surface->clusters().empty())
    return Status::success();
  const std::vector<StandingCluster>& clusters = plan.surface->clusters();
  if (settings.clusters == ClusterHandling::Refuse)
    return refusalOf(clusters, plan.surface->spacing());
  const bool rides = settings.clusters == ClusterHandling::Ride;
  plan.warnings.push_back(
      Diagnostic(clustersText(clusters, plan.surface->spacing()),
                 rides ? "; the cutter rides over what is there" : "; they were left out, and the cutter goes through what is there"));
  if (rides)
    return checkRideHeight(clusters, corner_radius); // locations stay clear of every point of the scan
  std::vector<std::uint8_t> stands(plan.cloud->size(), 0);
  for (const StandingCluster& cluster : clusters)
    for (const pcl::index_t i : cluster.indices)
      stands[i] = 1;
  pcl::Indices others;
  for (std::size_t i = 0; i < stands.size(); ++i)
    if (stands[i] == 0)
      others.push_back(static_cast<int>(i));
  keepOnly(others, plan);
  return makePartSurface(settings, progress, plan);
}

} // namespace pcl_spiral
