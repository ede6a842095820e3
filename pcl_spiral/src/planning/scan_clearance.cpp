// SPDX-License-Identifier: BSD-3-Clause
#include "planning/scan_clearance.h"

#include <pcl_spiral/search/impl/point_blocks.h>

#include <pcl/common/point_tests.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr double step = 0.02;        // of the radius, between the places that are looked at on a move
constexpr double kept = step * step; // of the radius: between two of these places the ball bends by an eighth of this; the rest is rounding

} // namespace

Status
ScanClearance::modify(const Surface& /*surface*/, const SpiralSettings& settings, SpiralPath& path) const
{
  const double radius = settings.tool_radius, allowed = std::max(0.0, settings.chord_error - kept * radius);
  const std::size_t count = path.contacts.size();
  std::vector<std::uint8_t> begins(count + 1, 0);
  for (const std::size_t pass : path.passes)
    begins[pass] = 1;
  const auto centre = [&](std::size_t i) { return frame_.inside(path.contacts[i] + radius * path.normals[i]); };
  std::vector<double> lift(count, 0.0), on_move(count, 0.0); // mm; a move has the number of the point it begins at
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i) {
    const Eigen::Vector3d from = centre(i);
    lift[i] = std::max(0.0, ball_->height(from.x(), from.y(), allowed) - from.z());
    if (static_cast<std::size_t>(i) + 1 == count || begins[i + 1] != 0)
      continue;
    const Eigen::Vector3d way = centre(i + 1) - from;
    const auto parts = static_cast<int>(std::ceil(way.norm() / (step * radius)));
    for (int k = 1; k < parts; ++k) {
      const Eigen::Vector3d at = from + way * (static_cast<double>(k) / parts);
      on_move[i] = std::max(on_move[i], ball_->height(at.x(), at.y(), allowed) - at.z());
    }
  }
  for (std::size_t i = 0; i < count; ++i)
    if (on_move[i] > 0.0) {
      lift[i] = std::max(lift[i], on_move[i]);
      lift[i + 1] = std::max(lift[i + 1], on_move[i]);
    }
  if (std::none_of(lift.begin(), lift.end(), [](double l) { return l > 0.0; }))
    return Status::success();
  if (path.feet.empty()) {
    path.feet = path.contacts;
    path.lifts.assign(count, 0.0f);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!(lift[i] > 0.0))
      continue;
    path.contacts[i] += lift[i] * frame_.along();
    path.lifts[i] = static_cast<float>((path.contacts[i] - path.feet[i]).norm());
  }
  return Status::success();
}

DeepestPoint
deepestPoint(const pcl::PointCloud<ToolpathPoint>& path, const std::vector<std::size_t>& pass_begins, double radius,
             const pcl::PointCloud<pcl::PointXYZ>& scan)
{
  std::vector<Eigen::Vector3f> points;
  for (const pcl::PointXYZ& p : scan)
    if (pcl::isFinite(p))
      points.push_back(p.getVector3fMap());
  if (points.empty() || path.empty())
    return {};
  const PointBlocks blocks(std::move(points));
  const auto centre = [&](std::size_t i) -> Eigen::Vector3d {
    return path[i].getVector3fMap().cast<double>() + radius * path[i].getNormalVector3fMap().cast<double>();
  };
  std::vector<double> depth(path.size());
#pragma omp parallel for schedule(dynamic, 1024)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(path.size()); ++i) {
    const auto depthAt = [&](const Eigen::Vector3d& at) { return radius - (blocks.position(blocks.nearest(at)) - at).norm(); };
    const Eigen::Vector3d from = centre(i);
    depth[i] = depthAt(from);
    const std::size_t next = static_cast<std::size_t>(i) + 1;
    if (next < path.size() && !std::binary_search(pass_begins.begin(), pass_begins.end(), next))
      depth[i] = std::max(depth[i], depthAt(0.5 * (from + centre(next))));
  }
  const auto deepest = std::max_element(depth.begin(), depth.end());
  return {*deepest, path[static_cast<std::size_t>(deepest - depth.begin())].getVector3fMap().cast<double>()};
}

} // namespace pcl_spiral
