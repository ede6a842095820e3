// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"
#include "table.h"

#include "support/geodesic_oracle.h"

#include <pcl_spiral/geodesic/geodesic_path.h>

#include <pcl/kdtree/kdtree_flann.h>

#include <cmath>
#include <limits>
#include <queue>

namespace pcl_spiral::acceptance {

namespace {

constexpr double axis_a = 1650.0, axis_b = 860.0;

/** Longitudes of the rim points in degrees, and their distances from latitude 60, longitude 0 by
 * GeographicLib. */
const std::vector<std::pair<double, double>>&
published()
{
  static const std::vector<std::pair<double, double>> values{{0.0, 749.802870802},   {30.0, 1072.315413128},  {60.0, 1683.675783644},
                                                             {90.0, 2306.561014625}, {120.0, 2827.778170366}, {150.0, 3171.441917434},
                                                             {180.0, 3291.158860704}};
  return values;
}

/** Lengths of the shortest paths from the first point along the edges to the 16 nearest neighbours. */
std::vector<double>
graphLengths(const Cloud::ConstPtr& cloud)
{
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  std::vector<std::vector<std::pair<int, double>>> edges(cloud->size());
  pcl::Indices indices;
  std::vector<float> squares;
  for (std::size_t i = 0; i < cloud->size(); ++i) {
    tree.nearestKSearch((*cloud)[i], 17, indices, squares);
    for (std::size_t k = 0; k < indices.size(); ++k) {
      const double length = std::sqrt(static_cast<double>(squares[k]));
      edges[i].emplace_back(indices[k], length);
      edges[static_cast<std::size_t>(indices[k])].emplace_back(static_cast<int>(i), length);
    }
  }
  std::vector<double> lengths(cloud->size(), std::numeric_limits<double>::max());
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  queue.emplace(lengths[0] = 0.0, 0);
  while (!queue.empty()) {
    const auto [length, at] = queue.top();
    queue.pop();
    if (length > lengths[static_cast<std::size_t>(at)])
      continue;
    for (const auto& [to, edge] : edges[static_cast<std::size_t>(at)])
      if (length + edge < lengths[static_cast<std::size_t>(to)])
        queue.emplace(lengths[static_cast<std::size_t>(to)] = length + edge, to);
  }
  return lengths;
}

} // namespace

int
judgeGeodesics(const Options& options)
{
  Table table("geodesics: 200,000 points of the spheroid, from latitude 60 to the rim");
  const test::SurfacePtr surface = test::spheroidCap(axis_a, axis_b);
  const Eigen::Vector3d source = test::onSpheroid(axis_a, axis_b, 60.0, 0.0);
  Polyline targets;
  std::vector<Eigen::Vector3d> points{source};
  for (const auto& [longitude, length] : published()) {
    targets.push_back(test::onSpheroid(axis_a, axis_b, 0.0, longitude));
    points.push_back(targets.back());
  }
  const std::vector<Eigen::Vector3d> samples = test::sampleUniform(*surface, 200000, options.seed).points;
  const std::vector<double> graph = [&] {
    points.insert(points.end(), samples.begin(), samples.end());
    return graphLengths(test::toCloud(points));
  }();

  GeodesicPath<pcl::PointXYZ> geodesics;
  geodesics.setInputCloud(test::toCloud(samples));
  geodesics.setSourcePoint(source);
  geodesics.setTargetPoints(targets);
  geodesics.setNumberOfThreads(options.threads);
  std::vector<Polyline> paths;
  geodesics.compute(paths);
  table.holds("paths are found", geodesics.getStatus().ok(), geodesics.getStatus().message());
  for (std::size_t i = 0; i < targets.size() && i < paths.size(); ++i) {
    const auto [longitude, length] = published()[i];
    const std::string name = "to longitude " + std::to_string(static_cast<int>(longitude));
    table.note(name + ": length", geodesics.getLengths()[i]);
    table.atMost(name + ": off the published", std::abs(geodesics.getLengths()[i] - length), 0.0005);
    table.atMost(name + ": longer than by graph", geodesics.getLengths()[i] - graph[i + 1], 0.0);
    if (paths[i].size() < 2)
      continue;
    const Eigen::Vector3d towards = paths[i][1] - paths[i][0];
    const test::ExactGeodesic exact = test::exactGeodesic(*surface, source, targets[i], towards, length);
    table.atMost(name + ": exact one off published", std::abs(exact.length - length), 1e-4);
    table.atMost(name + ": sideways", test::sidewaysDistance(*surface, paths[i], exact.points), 0.02);
  }
  return table.broken();
}

} // namespace pcl_spiral::acceptance
