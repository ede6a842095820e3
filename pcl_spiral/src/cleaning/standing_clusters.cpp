// SPDX-License-Identifier: BSD-3-Clause
#include "standing_clusters.h"

#include "cluster_chance.h"

#include "search/neighbour_search.h"
#include "surface/local_fit.h"

#include <pcl_spiral/cleaning/impl/point_groups.h>
#include <pcl_spiral/common/impl/message.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double link = 2.0;           // spacings
constexpr double loose_link = 6.0;     // spacings: of points that stand far apart for their cluster
constexpr std::size_t least_patch = 2; // points

/** Height of a point over the surface. */
struct Height {
  double value = 0.0; ///< mm, towards the outer side
  double noise = 0.0; ///< of the neighbours about the surface
  bool over = false;  ///< over the surface, not beside its rim
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
    std::vector<std::uint8_t> is_doubtful(graph.size(), 0);
    for (const std::uint32_t i : graph.doubtfulPoints())
      is_doubtful[i] = 1;
    std::vector<Eigen::Vector3f> points, unsorted;
    for (std::size_t i = 0; i < graph.size(); ++i)
      if (!is_doubtful[i]) {
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
    if (!foot.valid)
      return height;
    height.value = (point - foot.position).dot(n);
    height.noise = foot.residual;
    height.over = foot.overhang < sure_.spacing;
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
  std::vector<double> heights;

  void add(const Eigen::Vector3f& point, std::uint32_t member, double height)
  {
    points.push_back(point);
    members.push_back(member);
    heights.push_back(height);
  }
};

std::vector<StandingCluster>
groupsOf(const StandingSet& standing, double reach)
{
  std::vector<StandingCluster> groups;
  std::vector<Eigen::AlignedBox3d> boxes;
  const std::vector<std::uint32_t> group = pointGroups(standing.points, reach);
  for (std::size_t i = 0; i < standing.points.size(); ++i) {
    if (group[i] == groups.size()) {
      groups.emplace_back();
      boxes.emplace_back();
    }
    StandingCluster& own = groups[group[i]];
    own.indices.push_back(standing.members[i]);
    own.positions.push_back(standing.points[i]);
    own.place += standing.points[i].cast<double>();
    own.height = std::max(own.height, standing.heights[i]);
    boxes[group[i]].extend(standing.points[i].cast<double>());
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups[g].place /= static_cast<double>(groups[g].indices.size());
    groups[g].size = boxes[g].diagonal().norm();
  }
  return groups;
}

/** Groups larger than chance makes them: first of points that are near each other among all, then of the others, which stand farther
 *  apart but in one place of the \p area. \p is_far: of the indices among the points given. */
std::vector<StandingCluster>
clustersOf(const StandingSet& standing, const std::vector<std::uint8_t>& is_far, double spacing, double area)
{
  const auto isCluster = [&](const StandingCluster& group, std::size_t least) {
    return group.indices.size() >= least &&
           std::count_if(group.indices.begin(), group.indices.end(), [&](std::uint32_t i) { return is_far[i] != 0; }) > 1;
  };
  std::vector<StandingCluster> clusters;
  const std::vector<StandingCluster> groups = groupsOf(standing, link * spacing);
  const std::size_t least = leastCluster(groups, link * spacing);
  StandingSet others;
  for (const StandingCluster& group : groups) {
    if (isCluster(group, least))
      clusters.push_back(group);
    else
      for (std::size_t i = 0; i < group.indices.size(); ++i)
        others.add(group.positions[i], group.indices[i], group.height);
  }
  const std::size_t least_loose = leastSpread(others.points.size(), loose_link * spacing, area);
  for (const StandingCluster& group : groupsOf(others, loose_link * spacing))
    if (isCluster(group, least_loose))
      clusters.push_back(group);
  return clusters;
}

} // namespace

StandingPoints
standingPoints(const SurfaceGraph& graph, const std::vector<Eigen::Vector3f>& points)
{
  constexpr double over_noise = 8.0, far_over_noise = 12.0, over_spacing = 0.3;
  StandingPoints found;
  if (points.empty())
    return found;
  const SurePoints sure(graph);
  if (sure.blocks.size() == 0)
    return found;
  const std::vector<Height> heights = heightsOver(sure, points);
  const double spacing = graph.spacing(), usual = usualNoise(sure);
  StandingSet standing;
  std::vector<double> sizes;
  std::vector<std::uint8_t> is_far(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Height& height = heights[i];
    const double noise = std::max(height.noise, usual);
    sizes.push_back(std::abs(height.value));
    is_far[i] = height.value > far_over_noise * noise;
    if (height.over && height.value > std::max(over_noise * noise, over_spacing * spacing))
      standing.add(points[i], static_cast<std::uint32_t>(i), height.value);
  }
  found.largest_height = *std::max_element(sizes.begin(), sizes.end());
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  found.median_height = *middle;
  found.clusters = clustersOf(standing, is_far, spacing, static_cast<double>(sure.blocks.size()) * spacing * spacing);
  std::stable_sort(found.clusters.begin(), found.clusters.end(),
                   [](const StandingCluster& a, const StandingCluster& b) { return a.height > b.height; });
  return found;
}

std::string
clustersText(const std::vector<StandingCluster>& clusters)
{
  constexpr std::size_t most_named = 4;
  const std::size_t count = clusters.size();
  std::string list = textOf(count, count == 1 ? " cluster of points stands" : " clusters of points stand", " off the surface: ");
  for (std::size_t i = 0; i < std::min(count, most_named); ++i)
    list += textOf(i > 0 ? ", " : "", clusters[i].indices.size(), " points at ", placeText(clusters[i].place), ", ", clusters[i].size,
                   " mm across and ", clusters[i].height, " mm high");
  if (count > most_named)
    list += textOf(" and ", count - most_named, " more");
  return list;
}

Status
refusalOf(const std::vector<StandingCluster>& clusters)
{
  return {StatusCode::InvalidInput,
          clustersText(clusters) +
              "; a path would go through what is there: take it off and scan again, keep the cutter out of there (addKeepOut), ride over "
              "it (setClusterHandling with Ride), or leave the points out if they are false echoes (setClusterHandling)"};
}

} // namespace pcl_spiral
