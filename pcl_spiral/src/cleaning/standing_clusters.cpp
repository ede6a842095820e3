// SPDX-License-Identifier: BSD-3-Clause
#include "standing_clusters.h"

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

/** Number of pairs of different groups whose points are nearest at 1 to 3 times \p reach, both ends counted once. */
std::size_t
pairsAround(const std::vector<StandingCluster>& groups, double reach)
{
  constexpr double farther = 3.0;
  std::vector<Eigen::Vector3f> middles;
  for (const StandingCluster& group : groups)
    middles.push_back(group.place.cast<float>());
  const PointBlocks blocks(middles);
  const auto squared = static_cast<float>(farther * farther * reach * reach);
  std::size_t pairs = 0;
  for (std::uint32_t i = 0; i < middles.size(); ++i) {
    Box place;
    place.extend(middles[i].data());
    blocks.forBlocksNear(place, squared, [&](std::size_t block) {
      for (std::size_t k = blocks.blockBegin(block); k < blocks.blockEnd(block); ++k)
        pairs += blocks.originalIndex(k) < i && (blocks.point(k) - middles[i]).squaredNorm() <= squared;
    });
  }
  return pairs;
}

/** Number of points from which on a group is larger than chance makes it; see standingPoints. */
std::size_t
leastCluster(const std::vector<StandingCluster>& groups, double reach)
{
  constexpr double shell = 8.0;      // times the area within reach
  constexpr double unlikely = 0.3;   // groups
  constexpr std::size_t most = 1000; // echoes as close as this are no single ones
  const double all = static_cast<double>(groups.size());
  const double another = 2.0 * static_cast<double>(pairsAround(groups, reach)) / shell / std::max(1.0, all); // within reach of an echo
  double expected = all * another;
  std::size_t least = 2;
  for (; expected >= unlikely && least < most; ++least)
    expected *= std::min(another, 1.0);
  return least;
}

/** The groups of \p points, which stand off the surface by \p heights; \p members are their indices among those given. */
std::vector<StandingCluster>
groupsOf(const std::vector<Eigen::Vector3f>& points, const std::vector<std::uint32_t>& members, const std::vector<double>& heights,
         double reach)
{
  std::vector<StandingCluster> groups;
  std::vector<Eigen::AlignedBox3d> boxes;
  const std::vector<std::uint32_t> group = pointGroups(points, reach);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (group[i] == groups.size()) {
      groups.emplace_back();
      boxes.emplace_back();
    }
    StandingCluster& own = groups[group[i]];
    own.indices.push_back(members[i]);
    own.positions.push_back(points[i]);
    own.place += points[i].cast<double>();
    own.height = std::max(own.height, heights[i]);
    boxes[group[i]].extend(points[i].cast<double>());
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups[g].place /= static_cast<double>(groups[g].indices.size());
    groups[g].size = boxes[g].diagonal().norm();
  }
  return groups;
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
  const double noise = usualNoise(sure);
  std::vector<Eigen::Vector3f> standing;
  std::vector<std::uint32_t> members;
  std::vector<double> standing_heights, sizes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Height& height = heights[i];
    sizes.push_back(std::abs(height.value));
    if (height.over && height.value > std::max(over_noise * std::max(height.noise, noise), over_spacing * graph.spacing())) {
      standing.push_back(points[i]);
      members.push_back(static_cast<std::uint32_t>(i));
      standing_heights.push_back(height.value);
    }
  }
  found.largest_height = *std::max_element(sizes.begin(), sizes.end());
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  found.median_height = *middle;
  const double reach = link * graph.spacing();
  std::vector<StandingCluster> groups = groupsOf(standing, members, standing_heights, reach);
  const std::size_t least = leastCluster(groups, reach);
  const auto isFar = [&](std::uint32_t i) { return heights[i].value > far_over_noise * std::max(heights[i].noise, noise); };
  for (const StandingCluster& group : groups)
    if (group.indices.size() >= least && std::count_if(group.indices.begin(), group.indices.end(), isFar) > 1)
      found.clusters.push_back(group);
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
