// SPDX-License-Identifier: BSD-3-Clause
#include "standing_clusters.h"

#include "cluster_chance.h"

#include "core/median.h"
#include "fit/local_fit.h"
#include "search/mean_distances.h"
#include "search/neighbour_search.h"

#include <pcl_spiral/cleaning/impl/point_groups.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double link = 2.0;           // spacings
constexpr double loose_link = 6.0;     // spacings: of points that stand far apart for their cluster
constexpr std::size_t least_patch = 2; // points
/** In mean distances of the points of a cluster from their nearest one. Of points spread evenly at random, one in a thousand has no other
 *  within 2.1 of these inside a volume, 2.7 at its side, 3.0 in a plane. (On a line 6.9: wires are linked by their spacing.) */
constexpr double widest_gap = 3.0;
constexpr std::size_t enough = 12; // points, for a mean distance to about a sixth

/** Height of a point over the surface. */
struct Height {
  double value = 0.0; ///< mm, towards the outer side
  double noise = 0.0; ///< of the neighbours about the surface
  bool over = false;  ///< over the surface, not beyond its rim or over a wide hole in it
  bool hides = false; ///< nothing of the surface is seen below
};

/** Leave out points with fewer than \p least of them in their group: single ones of a cluster that stands off the surface. */
void
dropSmallGroups(std::vector<Eigen::Vector3f>& points, std::vector<Eigen::Vector3f>& normals, double reach, std::size_t least)
{
  const std::vector<std::uint32_t> group = pointGroups(points, reach);
  std::vector<std::size_t> sizes(points.size(), 0);
  for (const std::uint32_t g : group)
    ++sizes[g];
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (sizes[group[i]] >= least) {
      points[kept] = points[i];
      normals[kept++] = normals[i];
    }
  points.resize(kept);
  normals.resize(kept);
}

/** The points of a graph that are surely on its surface. */
struct SurePoints {
  PointBlocks blocks;
  std::vector<Eigen::Vector3f> normals; ///< in the order of the blocks
  double spacing = 0.0;

  explicit SurePoints(const SurfaceGraph& graph) : spacing(graph.spacing())
  {
    std::vector<std::uint8_t> is_candidate(graph.size(), 0);
    for (const std::uint32_t i : graph.spikeCandidates())
      is_candidate[i] = 1;
    std::vector<Eigen::Vector3f> points, unsorted;
    for (std::size_t i = 0; i < graph.size(); ++i)
      if (!is_candidate[i]) {
        points.push_back(graph.blocks().point(i));
        unsorted.push_back(graph.normals()[i]);
      }
    dropSmallGroups(points, unsorted, link * spacing, least_patch);
    blocks = PointBlocks(std::move(points));
    normals.resize(unsorted.size());
    for (std::size_t i = 0; i < unsorted.size(); ++i)
      normals[i] = unsorted[blocks.originalIndex(i)];
  }
};

/** Heights over the surface fitted to sure points. One object per thread. */
class HeightOver {
public:
  explicit HeightOver(const SurePoints& sure)
  : sure_(sure), search_(sure.blocks, std::min<int>(fit_neighbours, static_cast<int>(sure.blocks.size())))
  {}

  Height operator()(const Eigen::Vector3d& point)
  {
    const std::uint32_t nearest = sure_.blocks.nearest(point);
    const Eigen::Vector3d n = sure_.normals[nearest].cast<double>();
    const Eigen::Vector3d base = point - n.dot(point - sure_.blocks.position(nearest)) * n;
    Box place;
    place.extend(base.cast<float>().eval().data());
    search_.setRun(place);
    const Neighbourhood& near = search_.find(base);
    const Eigen::Vector3d up = meanNormal(near.index, std::min(near.size, nearest_for_normal), sure_.normals);
    const SurfaceFoot foot = robustQuarticFoot(base, near, up);
    Height height;
    height.over = foot.valid && foot.overhang < sure_.spacing;
    height.value = n.dot(point - (height.over ? foot.position : sure_.blocks.position(nearest))); // no fit reaches far over a hole
    height.noise = foot.residual;
    height.hides = (base - sure_.blocks.position(nearest)).norm() > unseen * sure_.spacing;
    return height;
  }

private:
  static constexpr int fit_neighbours = 48, nearest_for_normal = 12;

  const SurePoints& sure_;
  NeighbourSearch search_;
};

std::vector<Height>
heightsOver(const SurePoints& sure, const std::vector<Eigen::Vector3f>& points)
{
  std::vector<Height> heights(points.size());
#pragma omp parallel
  {
    HeightOver height(sure);
#pragma omp for schedule(dynamic, 64)
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(points.size()); ++i)
      heights[i] = height(points[i].cast<double>());
  }
  return heights;
}

/** Root mean square of the noise about the surface, at some hundreds of its points. */
double
usualNoise(const SurePoints& sure)
{
  constexpr std::size_t samples = 500;
  std::vector<Eigen::Vector3f> places;
  for (std::size_t i = 0; i < sure.blocks.size(); i += 1 + sure.blocks.size() / samples)
    places.push_back(sure.blocks.point(i));
  double sum = 0.0;
  for (const Height& height : heightsOver(sure, places))
    sum += height.noise * height.noise;
  return std::sqrt(sum / static_cast<double>(places.size()));
}

/** Points off the surface. */
struct StandingSet {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint32_t> members; ///< their indices among those given
  std::vector<double> heights;        ///< 0 of points that are not over the surface

  void add(const Eigen::Vector3f& point, std::uint32_t member, double height)
  {
    points.push_back(point);
    members.push_back(member);
    heights.push_back(height);
  }
};

/** Sets place and size of \p cluster. */
void
measure(StandingCluster& cluster)
{
  cluster.place.setZero();
  for (const Eigen::Vector3f& point : cluster.positions)
    cluster.place += point.cast<double>() / static_cast<double>(cluster.positions.size());
  cluster.size = boxOf(cluster).diagonal().norm();
}

std::vector<StandingCluster>
groupsOf(const StandingSet& standing, double reach)
{
  std::vector<StandingCluster> groups;
  const std::vector<std::uint32_t> group = pointGroups(standing.points, reach);
  for (std::size_t i = 0; i < standing.points.size(); ++i) {
    if (group[i] == groups.size())
      groups.emplace_back();
    StandingCluster& own = groups[group[i]];
    own.indices.push_back(static_cast<pcl::index_t>(standing.members[i]));
    own.positions.push_back(standing.points[i]);
    own.height = std::max(own.height, standing.heights[i]);
  }
  for (StandingCluster& own : groups)
    measure(own);
  return groups;
}

/** True if \p group has \p least points, and some of them are far from the surface. \p is_far: of the indices among the points given. */
bool
isCluster(const StandingCluster& group, std::size_t least, const std::vector<std::uint8_t>& is_far)
{
  return group.indices.size() >= least && std::count_if(group.indices.begin(), group.indices.end(),
                                                        [&](pcl::index_t i) { return is_far[static_cast<std::size_t>(i)] != 0; }) > 1;
}

/** Groups larger than chance makes them: first of points that are near each other among all, then of the others, which stand farther
 *  apart but in one place of the \p area. */
std::vector<StandingCluster>
clustersOf(const StandingSet& standing, const std::vector<std::uint8_t>& is_far, double spacing, double area)
{
  std::vector<StandingCluster> clusters;
  const std::vector<StandingCluster> groups = groupsOf(standing, link * spacing);
  const std::size_t least = leastCluster(groups, link * spacing);
  StandingSet others;
  for (const StandingCluster& group : groups) {
    if (isCluster(group, least, is_far))
      clusters.push_back(group);
    else
      for (std::size_t i = 0; i < group.indices.size(); ++i)
        others.add(group.positions[i], static_cast<std::uint32_t>(group.indices[i]), group.height);
  }
  const std::size_t least_loose = leastSpread(others.points.size(), loose_link * spacing, area);
  for (const StandingCluster& group : groupsOf(others, loose_link * spacing))
    if (isCluster(group, least_loose, is_far))
      clusters.push_back(group);
  return clusters;
}

/** How far a point may lie from those of \p cluster and be of the same thing, as the leaf of a tree is; at least \p reach. */
double
reachOf(const StandingCluster& cluster, double reach)
{
  if (cluster.positions.size() < enough)
    return reach;
  const std::vector<float> gaps = meanDistances(cluster.positions, 1);
  return std::max(reach, widest_gap * std::accumulate(gaps.begin(), gaps.end(), 0.0) / static_cast<double>(gaps.size()));
}

/** Index of the cluster to which \p group is nearest, of those within whose reach it is; the number of clusters if there is none.
 *  \p fronts: the points of each cluster that are looked at. */
std::size_t
nearestTo(const StandingCluster& group, const std::vector<PointBlocks>& fronts, const std::vector<double>& reaches)
{
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = fronts.size();
  for (std::size_t c = 0; c < fronts.size(); ++c)
    for (const Eigen::Vector3f& point : group.positions) {
      if (fronts[c].size() == 0 || fronts[c].box().squaredDistance(point.data()) > static_cast<float>(reaches[c] * reaches[c]))
        continue;
      const double distance = (fronts[c].point(fronts[c].nearest(point.cast<double>())) - point).norm();
      if (distance <= reaches[c] && distance < least) {
        least = distance;
        nearest = c;
      }
    }
  return nearest;
}

/** The spacing of the points of \p cluster: the median of the mean distance of the three nearest is that of a square grid, at its edges,
 *  too, and for points at random 0.73 of that of a grid as dense. */
double
spacingOf(const StandingCluster& cluster)
{
  constexpr int nearest = 3;
  return medianOf(meanDistances(cluster.positions, nearest));
}

/** Adds each of \p groups that is within the reach of one of \p clusters, at least \p reach, to the nearest one; then those within the
 *  reach of these, and so on, if the groups that are left are so few on the \p area that chance alone would not go on. */
void
joinToClusters(std::vector<StandingCluster> groups, double reach, double area, std::vector<StandingCluster>& clusters)
{
  std::vector<double> reaches;
  std::vector<PointBlocks> fronts;
  for (const StandingCluster& cluster : clusters) {
    reaches.push_back(reachOf(cluster, reach));
    fronts.emplace_back(cluster.positions);
  }
  const double widest = reaches.empty() ? 0.0 : *std::max_element(reaches.begin(), reaches.end());
  for (bool goes_on = !clusters.empty(); goes_on;) {
    std::vector<std::vector<Eigen::Vector3f>> joined(clusters.size());
    std::vector<StandingCluster> left;
    for (StandingCluster& group : groups) {
      const std::size_t nearest = nearestTo(group, fronts, reaches);
      if (nearest == clusters.size()) {
        left.push_back(std::move(group));
        continue;
      }
      StandingCluster& own = clusters[nearest];
      own.indices.insert(own.indices.end(), group.indices.begin(), group.indices.end());
      own.positions.insert(own.positions.end(), group.positions.begin(), group.positions.end());
      own.height = std::max(own.height, group.height);
      joined[nearest].insert(joined[nearest].end(), group.positions.begin(), group.positions.end());
    }
    goes_on = left.size() < groups.size() && isRare(left.size(), widest, area);
    groups = std::move(left);
    for (std::size_t c = 0; c < clusters.size(); ++c)
      fronts[c] = PointBlocks(std::move(joined[c]));
  }
  for (StandingCluster& cluster : clusters) {
    measure(cluster);
    cluster.spacing = spacingOf(cluster);
  }
}

} // namespace

Eigen::AlignedBox3d
boxOf(const StandingCluster& cluster)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& point : cluster.positions)
    box.extend(point.cast<double>());
  return box;
}

StandingPoints
standingPoints(const SurfaceGraph& graph, const std::vector<Eigen::Vector3f>& points)
{
  constexpr double over_noise = 8.0, over_spacing = 0.3;
  StandingPoints found;
  if (points.empty())
    return found;
  const SurePoints sure(graph);
  if (sure.blocks.size() == 0)
    return found;
  const std::vector<Height> heights = heightsOver(sure, points);
  const double spacing = graph.spacing(), usual = usualNoise(sure);
  StandingSet standing, others;
  std::vector<double> sizes;
  std::vector<std::uint8_t> is_far(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Height& height = heights[i];
    const double noise = std::max(height.noise, usual);
    sizes.push_back(std::abs(height.value));
    is_far[i] = height.value > far_over_noise * noise;
    if (!(height.value > std::max(over_noise * noise, over_spacing * spacing)))
      continue;
    if (height.over)
      standing.add(points[i], static_cast<std::uint32_t>(i), height.value);
    else
      others.add(points[i], static_cast<std::uint32_t>(i), 0.0);
  }
  found.largest_height = *std::max_element(sizes.begin(), sizes.end());
  found.median_height = medianOf(std::move(sizes));
  const double area = static_cast<double>(sure.blocks.size()) * spacing * spacing;
  found.clusters = clustersOf(standing, is_far, spacing, area);
  std::vector<std::uint8_t> is_in_cluster(points.size(), 0);
  for (const StandingCluster& cluster : found.clusters)
    for (const pcl::index_t i : cluster.indices)
      is_in_cluster[static_cast<std::size_t>(i)] = 1;
  for (std::size_t k = 0; k < standing.points.size(); ++k)
    if (is_in_cluster[standing.members[k]] == 0)
      others.add(standing.points[k], standing.members[k], standing.heights[k]);
  joinToClusters(groupsOf(others, link * spacing), loose_link * spacing, area, found.clusters);
  for (StandingCluster& cluster : found.clusters)
    cluster.hides_surface = std::any_of(cluster.indices.begin(), cluster.indices.end(),
                                        [&heights](pcl::index_t i) { return heights[static_cast<std::size_t>(i)].hides; });
  std::stable_sort(found.clusters.begin(), found.clusters.end(),
                   [](const StandingCluster& a, const StandingCluster& b) { return a.height > b.height; });
  return found;
}

} // namespace pcl_spiral
