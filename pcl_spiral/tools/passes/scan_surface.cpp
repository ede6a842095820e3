// SPDX-License-Identifier: BSD-3-Clause
#include "scan_surface.h"
#include "terminal/scan_places.h"

#include "cleaning/standing_clusters.h"
#include <pcl_spiral/cleaning/stray_removal.h>
#include <pcl_spiral/collision/impl/false_echoes.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <pcl/common/io.h>

#include <cstdint>
#include <vector>

using namespace pcl_spiral;

namespace {

/** Keeps the points of the scan with these \p indices. */
void
keepOnly(const pcl::Indices& indices, PassResult& result)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr kept(new pcl::PointCloud<pcl::PointXYZ>);
  pcl::copyPointCloud(*result.scan.cloud, indices, *kept);
  if (const auto normals = result.scan.normals) {
    result.scan.normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
    pcl::copyPointCloud(*normals, indices, *result.scan.normals);
  }
  result.scan.cloud = kept;
}

/** Removes the outliers from the scan, with a warning. */
void
leaveOutStrays(const PassJob& job, PassResult& result)
{
  StrayRemoval<pcl::PointXYZ> removal;
  removal.setNumberOfThreads(job.threads);
  removal.setInputCloud(result.scan.cloud);
  pcl::Indices indices;
  removal.filter(indices);
  require(job.scan, removal.getStatus());
  const StrayFigures& f = removal.getFigures();
  if (f.strays > 0)
    result.warnings.push_back(Diagnostic(f.strays, " of ", result.scan.cloud->size(),
                                         " points off the scanned surface were left out (--leave-out-strays); the largest "
                                         "group has ",
                                         f.largest_group, ", at ", Place(f.largest_group_place),
                                         f.largest_group > largest_echo ? ": such a group is not a false echo; check what is there" : ""));
  keepOnly(indices, result);
}

/** The surface of the scan; null if the points form none. */
Surface::ConstPtr
surfaceOf(const PassJob& job, ProgressBar& bar, const PassResult& result)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(result.scan.cloud);
  scanned.setStrict(false); // a rough surface is accepted, with a warning
  scanned.setQuiet(true);
  setSurface(job, scanned);
  scanned.setClusterHandling(job.choice.clusters);
  if (result.chosen.part_at)
    scanned.setPartAt(*result.chosen.part_at);
  setSide(result.asked_side, scanned);
  scanned.setFlipNormals(job.flip_scan);
  scanned.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(0.3 * share, stage); });
  Surface::ConstPtr surface;
  scanned.compute(surface);
  const StatusCode code = scanned.getStatus().code();
  if (code == StatusCode::Cancelled || code == StatusCode::InvalidArgument) // such as a place far from the scan
    require(job.scan, scanned.getStatus());
  return surface;
}

} // namespace

void
require(const std::string& file, const Status& status)
{
  if (status.code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (status.code() == StatusCode::InvalidArgument)
    throw UsageError(Diagnostic(file, ": ", status.diagnostic()));
  if (!status.ok())
    throw FileError(file, status.diagnostic());
}

Surface::ConstPtr
readScan(const PassJob& job, ProgressBar& bar, PassResult& result, StageClock& clock)
{
  bar.update(0.0, "reading " + job.scan);
  result.scan = readCloud(job.scan, job.read);
  setScanFrame(result.scan.shift, job.read);
  result.whole_scan = result.scan.cloud;
  clock.end("reading");
  if (cancelled())
    throw Cancelled();
  // With no radius: locations that enter a keep-out are left out later, so any cutter goes as near as it can.
  result.asked_side = sideOf(result.scan, fromScan(job.view_point));
  result.chosen = choosePart(job.choice, job.scan, job.read, {}, result.asked_side, job.flip_scan, job.threads, result.scan);
  if (job.leave_out_strays) {
    bar.update(0.0, "strays");
    leaveOutStrays(job, result);
    clock.end("strays");
  }
  result.asked_side = sideOf(result.scan, fromScan(job.view_point));
  const Surface::ConstPtr surface = surfaceOf(job, bar, result);
  if (surface)
    result.side = surface->side();
  clock.end("surface");
  return surface;
}

Surface::ConstPtr
heedClusters(const PassJob& job, ProgressBar& bar, const Surface::ConstPtr& surface, PassResult& result)
{
  if (!surface || surface->clusters().empty())
    return surface;
  if (job.choice.clusters == ClusterHandling::Refuse)
    require(job.scan, refusalOf(surface->clusters(), surface->spacing()));
  const bool rides = job.choice.clusters == ClusterHandling::Ride;
  result.warnings.push_back(
      Diagnostic(clustersText(surface->clusters(), surface->spacing()),
                 (rides ? "; the cutter rides over what is there" : "; they were left out, and the cutter goes through what is there")));
  if (rides) {
    require(job.scan, checkRideHeight(surface->clusters(), job.cutter.corner_radius));
    return surface; // locations stay clear of every point of the scan
  }
  std::vector<std::uint8_t> stands(result.scan.cloud->size(), 0);
  for (const StandingCluster& cluster : surface->clusters())
    for (const pcl::index_t i : cluster.indices)
      stands[i] = 1;
  pcl::Indices others;
  for (std::size_t i = 0; i < stands.size(); ++i)
    if (stands[i] == 0)
      others.push_back(static_cast<int>(i));
  keepOnly(others, result);
  return surfaceOf(job, bar, result);
}
