// SPDX-License-Identifier: BSD-3-Clause
#include "scene_stock.h"

#include "planning/playback.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {

void
takeStock(const Heights& judged, ScenePart& part)
{
  const auto samples = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::vector<float> stock;
  for (std::size_t i = 0; i < judged.stock.size(); ++i)
    if (!std::isnan(judged.stock[i])) {
      samples->push_back((*judged.points)[i]);
      stock.push_back(judged.stock[i]);
    }
  constexpr float no_stock = std::numeric_limits<float>::quiet_NaN();
  part.stock.resize(part.places.size(), no_stock);
  if (samples->empty())
    return;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree(false);
  tree.setInputCloud(samples);
  pcl::Indices found(2);
  std::vector<float> squared(2);
  tree.nearestKSearch(samples->front(), 2, found, squared);
  const float reach = 4.0f * std::sqrt(squared.back());
  for (std::size_t i = 0; i < part.places.size(); ++i) {
    const Eigen::Vector3f& p = part.places[i];
    tree.nearestKSearch(pcl::PointXYZ(p.x(), p.y(), p.z()), 1, found, squared);
    part.stock[i] = squared[0] <= reach * reach ? stock[static_cast<std::size_t>(found[0])] : no_stock;
  }
}

void
findFalls(const pcl::PointCloud<ToolpathPoint>::ConstPtr& path, const Polyline& tips, const CutterShape& cutter,
          const RemovalReport& judged, const std::vector<double>& reached, ScenePart& part)
{
  if (part.stock.empty() || part.cut_at.empty() || reached.empty())
    return;
  PlaybackInput input;
  input.path = path;
  input.tips = tips;
  input.cutter = cutter;
  StockMesh mesh;
  mesh.normals = part.normals;
  for (std::size_t i = 0; i < part.places.size(); ++i) {
    mesh.stock.push_back(std::isnan(part.stock[i]) ? 0.0f : part.stock[i]);
    mesh.places.push_back(part.places[i] + mesh.stock[i] * part.normals[i]);
  }
  StockFalls falls;
  if (!playbackStock(input, mesh, judged, falls).ok())
    return;
  const auto timeOf = [&](const StockFall& fall) {
    return static_cast<float>(reached[std::min<std::size_t>(fall.move + 1, reached.size() - 1)]);
  };
  constexpr float never = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < part.places.size(); ++i) {
    const std::uint32_t begin = falls.begins[i], end = falls.begins[i + 1];
    part.first_at.push_back(begin < end ? timeOf(falls.falls[begin]) : never);
    part.first_stock.push_back(begin < end ? falls.falls[begin].height : 0.0f);
    part.cut_at[i] = begin < end ? timeOf(falls.falls[end - 1]) : never;
  }
}

} // namespace pcl_spiral
