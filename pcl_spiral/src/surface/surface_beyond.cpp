// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/surface/impl/surface_beyond.h>

#include "search/pieces.h"
#include <pcl_spiral/surface/scanned_surface.h>

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <set>

namespace pcl_spiral {
namespace {

constexpr double patch_spacings = 0.75; // half the width of a patch, as those of BallReach
constexpr double support = 8.0;         // spacings: points about a foot that its fit uses, with the widest void between them
constexpr double deviations = 3.0;      // of the noise: a point farther out of the fit is no noise
constexpr double reached = 2.0;         // radii: no point of a ball is farther from its contact

/** Those of \p points that are within \p distance of \p part. */
std::vector<Eigen::Vector3f>
nearPart(const Surface& part, const std::vector<Eigen::Vector3f>& points, double distance)
{
  const PointBlocks& blocks = part.graph().blocks();
  return pointsWhere(points, [&](const Eigen::Vector3f& point) {
    const Eigen::Vector3d p = point.cast<double>();
    return blocks.box().squaredDistance(point.data()) <= static_cast<float>(distance * distance) &&
           (blocks.position(blocks.nearest(p)) - p).norm() <= distance;
  });
}

/** Whether a ball of \p radius on a point of \p part has one of \p points in it. */
bool
touches(const Surface& part, const std::vector<Eigen::Vector3f>& points, double radius)
{
  const PointBlocks blocks(points);
  bool any = false;
#pragma omp parallel for schedule(dynamic, 256) reduction(|| : any)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(part.size()); ++i) {
    const Eigen::Vector3d centre = part.position(i) + radius * part.normal(i);
    any = any || (blocks.box().squaredDistance(centre.cast<float>().eval().data()) < static_cast<float>(radius * radius) &&
                  (blocks.position(blocks.nearest(centre)) - centre).norm() < radius);
  }
  return any;
}

/** The surface of \p part with the points \p beside it, which follow those of the part; null if there is none. */
Surface::ConstPtr
continued(const Surface& part, const std::vector<Eigen::Vector3f>& beside)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (std::size_t i = 0; i < part.size(); ++i) {
    const Eigen::Vector3f p = part.position(i).cast<float>(), n = part.normal(i).cast<float>();
    cloud->emplace_back(p.x(), p.y(), p.z());
    normals->emplace_back(n.x(), n.y(), n.z());
  }
  for (const Eigen::Vector3f& p : beside)
    cloud->emplace_back(p.x(), p.y(), p.z());
  normals->resize(cloud->size(), pcl::Normal(0.0f, 0.0f, 0.0f));
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  scanned.setInputNormals(normals);
  scanned.setPartAt(part.position(part.size() / 2));
  scanned.setClusterHandling(ClusterHandling::Ride);
  scanned.setStrict(false);
  scanned.setQuiet(true);
  scanned.setNumberOfThreads(static_cast<unsigned int>(omp_get_max_threads()));
  Surface::ConstPtr surface;
  scanned.compute(surface);
  return surface;
}

/** Patches at the points of \p whole that are not among the first \p own of its cloud, nor in a cluster. */
std::vector<SurfacePatch>
patchesOf(const Surface& whole, std::size_t own)
{
  std::set<std::uint32_t> standing;
  for (const StandingCluster& cluster : whole.clusters())
    standing.insert(cluster.indices.begin(), cluster.indices.end());
  std::vector<std::size_t> points;
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < whole.size(); ++i)
    if (whole.sourceIndex(i) >= own && standing.count(whole.sourceIndex(i)) == 0) {
      points.push_back(i);
      places.push_back(whole.position(i));
    }
  std::vector<SurfaceFoot> feet;
  whole.fit().project(places, feet);
  std::vector<SurfacePatch> patches;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const bool fits = feet[k].valid;
    if (fits)
      patches.push_back({feet[k], patch_spacings * whole.graph().spacing(points[k])});
    if (fits && feet[k].normal.dot(places[k] - feet[k].position) <= deviations * whole.noise())
      continue;
    SurfacePatch point;
    point.foot.position = places[k];
    point.foot.normal = whole.normal(points[k]);
    point.foot.direction1 = point.foot.normal.unitOrthogonal();
    point.foot.curvature1 = point.foot.curvature2 = 0.0;
    patches.push_back(point);
  }
  return patches;
}

} // namespace

std::vector<SurfacePatch>
surfaceBeyond(const Surface& part, const std::vector<Eigen::Vector3f>& beside, double radius)
{
  const std::vector<Eigen::Vector3f> near = nearPart(part, beside, reached * radius + support * part.spacing());
  if (near.empty() || !touches(part, near, radius))
    return {};
  const Surface::ConstPtr whole = continued(part, near);
  return whole ? patchesOf(*whole, part.size()) : std::vector<SurfacePatch>();
}

} // namespace pcl_spiral
