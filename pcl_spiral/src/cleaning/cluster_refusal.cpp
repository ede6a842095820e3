// SPDX-License-Identifier: BSD-3-Clause
#include "standing_clusters.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/search/impl/point_blocks.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double safe = 0.5; // of the ball's radius: 1 - sin(30 degrees)

/** Radius of the smallest ball that may ride over all \p clusters, see checkRideHeight, to a tenth of a mm; 0: any may. */
double
leastRidingRadius(const std::vector<StandingCluster>& clusters)
{
  double highest = 0.0;
  for (const StandingCluster& cluster : clusters)
    if (cluster.hides_surface)
      highest = std::max(highest, cluster.height);
  return 0.1 * std::ceil(10.0 * highest / safe);
}

} // namespace

Diagnostic
clustersText(const std::vector<StandingCluster>& clusters, double spacing)
{
  constexpr std::size_t most_named = 4;
  const Eigen::Vector3d aside(spacing, spacing, 0.0);
  const std::size_t count = clusters.size();
  Diagnostic list = Diagnostic(count, count == 1 ? " cluster of points stands" : " clusters of points stand", " off the surface: ");
  for (std::size_t i = 0; i < std::min(count, most_named); ++i) {
    const Eigen::AlignedBox3d box = boxOf(clusters[i]);
    list +=
        Diagnostic(i > 0 ? ", " : "", clusters[i].indices.size(), " points at ", Place(clusters[i].place), ", ", clusters[i].size,
                   " {mm} across and ", clusters[i].height, " {mm} high, ", Proposed("addKeepOut", box.min() - aside, box.max() + aside));
  }
  if (count > most_named)
    list += Diagnostic(" and ", count - most_named, " more");
  return list;
}

Status
refusalOf(const std::vector<StandingCluster>& clusters, double spacing)
{
  const bool line = std::all_of(clusters.begin(), clusters.end(), [&](const StandingCluster& cluster) { return isLine(cluster, spacing); });
  const double least = leastRidingRadius(clusters);
  return {
      StatusCode::InvalidInput,
      Diagnostic(
          clustersText(clusters, spacing), "; a path would go through what is there: ",
          line ? "points in one line are an edge of the part that has too few points, or a wire; scan an edge more densely, take off what "
                 "is no part and scan again"
               : "take it off and scan again",
          ", keep the cutter out of there ({addKeepOut}), ", line ? "or " : "",
          "ride over it ({setClusterHandling(ClusterHandling::Ride)})",
          least > 0.0 ? Diagnostic(" with a ball of radius ", least, " {mm} or more") : "",
          line ? "" : ", or leave the points out if they are false echoes ({setClusterHandling(ClusterHandling::LeaveOut)})",
          least > 0.0 ? "; if they stand on a table or on another part, give a place on the part to be machined ({setPartAt})" : "")};
}

bool
isLine(const StandingCluster& cluster, double spacing)
{
  constexpr std::size_t least = 8; // points
  constexpr double reach = 3.0;    // spacings, along the line
  constexpr double widest = 0.75;  // spacings, beside it: two rows are farther apart
  const PointBlocks blocks(cluster.positions);
  std::size_t wide = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    std::vector<Eigen::Vector3d> near;
    const auto keep = [&](const Box& box) { return box.squaredDistance(blocks.point(i).data()) <= reach * reach * spacing * spacing; };
    blocks.forBlocks(keep, [&](std::size_t b) {
      for (std::size_t k = blocks.blockBegin(b); k < blocks.blockEnd(b); ++k)
        if (const Eigen::Vector3d way = blocks.position(k) - blocks.position(i); way.norm() <= reach * spacing)
          near.push_back(way);
    });
    const Eigen::Vector3d along = std::max_element(near.begin(), near.end(), [](const auto& a, const auto& b) {
                                    return a.squaredNorm() < b.squaredNorm();
                                  })->normalized();
    wide += near.size() < 2 ||
            std::any_of(near.begin(), near.end(), [&](const Eigen::Vector3d& way) { return way.cross(along).norm() > widest * spacing; });
  }
  return blocks.size() >= least && 10 * wide <= blocks.size();
}

Status
checkRideHeight(const std::vector<StandingCluster>& clusters, double radius)
{
  for (const StandingCluster& cluster : clusters)
    if (cluster.hides_surface && cluster.height > safe * radius)
      return {
          StatusCode::InvalidInput,
          Diagnostic(
              "the cluster of points at ", Place(cluster.place), " is ", cluster.height,
              " {mm} high and hides the surface: only its top is seen, and its sides may lean into the way of the ball, which rides "
              "over such a thing up to half its radius, ",
              safe * radius,
              " {mm} high: take it off and scan again, keep the cutter out of there ({addKeepOut}), or leave the points out if they are "
              "false echoes ({setClusterHandling(ClusterHandling::LeaveOut)})")};
  return Status::success();
}

} // namespace pcl_spiral
