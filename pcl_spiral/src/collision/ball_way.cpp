// SPDX-License-Identifier: BSD-3-Clause
#include "ball_way.h"

#include <pcl_spiral/search/impl/point_blocks.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl_spiral {
namespace {

/** Call \p visit(point, begin, end) for the straight ways of the ball's centre, with the point where each begins. */
template <typename Visit>
void
forWays(const pcl::PointCloud<ToolpathPoint>& path, const std::vector<Eigen::Vector3d>& centres, Visit visit)
{
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const std::size_t next = std::min(i + 1, centres.size() - 1);
    const double distance = (path[next].getVector3fMap() - path[i].getVector3fMap()).norm();
    visit(i, centres[i], isLift(distance, path[next].arc_length - path[i].arc_length) ? centres[i] : centres[next]);
  }
}

/** Short straight pieces of the ways of the ball and of the axes of its shank. */
class WayPieces {
public:
  WayPieces(const pcl::PointCloud<ToolpathPoint>& path, double radius) : radius_(radius)
  {
    forWays(path, ballCentres(path, radius), [&](std::size_t i, const Eigen::Vector3d& begin, const Eigen::Vector3d& end) {
      add(begin, end);
      addShanks(path[i], path[std::min(i + 1, path.size() - 1)], begin, end);
    });
    if (!middles_.empty())
      blocks_ = PointBlocks(std::move(middles_));
  }

  /** How deep \p p is in the ball or its shank, mm; 0 outside. */
  double depth(const Eigen::Vector3f& p) const
  {
    const double reach = (1.0 + 0.5 * longest) * radius_;
    const auto squared = static_cast<float>(reach * reach);
    if (blocks_.size() == 0 || blocks_.box().squaredDistance(p.data()) > squared)
      return 0.0;
    Box place;
    place.extend(p.data());
    double least = radius_ * radius_;
    blocks_.forBlocksNear(place, squared, [&](std::size_t block) {
      for (std::size_t k = blocks_.blockBegin(block); k < blocks_.blockEnd(block); ++k)
        if ((blocks_.point(k) - p).squaredNorm() <= squared)
          least = std::min(least, squaredDistance(k, p.cast<double>()));
    });
    return radius_ - std::sqrt(least);
  }

private:
  static constexpr double longest = 0.5; // of the radius: a piece
  static constexpr double apart = 0.1;   // of the radius: axes looked at; between them a point is at most 0.00125 radii deeper

  void add(const Eigen::Vector3d& begin, const Eigen::Vector3d& end)
  {
    const int pieces = std::max(1, static_cast<int>(std::ceil((end - begin).norm() / (longest * radius_))));
    const Eigen::Vector3d half = (end - begin) / (2.0 * pieces);
    for (int k = 0; k < pieces; ++k) {
      middles_.push_back((begin + (2.0 * k + 1.0) * half).cast<float>());
      halves_.push_back(half.cast<float>());
    }
  }

  /** Axes of the shank on the way from \p begin to \p end, from one point to the next. */
  void addShanks(const ToolpathPoint& point, const ToolpathPoint& next, const Eigen::Vector3d& begin, const Eigen::Vector3d& end)
  {
    const double length = shank_radii * radius_;
    const Eigen::Vector3d from = begin + length * point.getAxisVector3fMap().cast<double>();
    const Eigen::Vector3d to = begin == end ? from : end + length * next.getAxisVector3fMap().cast<double>();
    const double way = std::max((end - begin).norm(), (to - from).norm());
    const int pieces = std::max(1, static_cast<int>(std::ceil(way / (apart * radius_))));
    for (int k = 0; k < pieces; ++k) {
      const Eigen::Vector3d low = begin + (end - begin) * k / pieces, high = from + (to - from) * k / pieces;
      if (std::max((low - low_).norm(), (high - high_).norm()) < 0.5 * apart * radius_)
        continue;
      low_ = low;
      high_ = high;
      add(low, high);
    }
  }

  /** From piece \p k of the blocks to \p p. */
  double squaredDistance(std::size_t k, const Eigen::Vector3d& p) const
  {
    const Eigen::Vector3d half = halves_[blocks_.originalIndex(k)].cast<double>(), offset = p - blocks_.position(k);
    const double share = std::clamp(offset.dot(half) / std::max(half.squaredNorm(), 1e-30), -1.0, 1.0);
    return (offset - share * half).squaredNorm();
  }

  double radius_;
  Eigen::Vector3d low_ = Eigen::Vector3d::Constant(1e30), high_ = low_; ///< ends of the last axis of the shank
  std::vector<Eigen::Vector3f> middles_, halves_;                       ///< of the pieces: from the middle to the end
  PointBlocks blocks_;                                                  ///< of the middles
};

/** A box that ball and shank do not leave: no place of them is farther from a contact. */
Eigen::AlignedBox3f
reachOf(const pcl::PointCloud<ToolpathPoint>& path, double radius)
{
  Eigen::AlignedBox3f box;
  for (const ToolpathPoint& p : path)
    box.extend(p.getVector3fMap());
  const Eigen::Vector3f reach = Eigen::Vector3f::Constant(static_cast<float>(reach_radii * radius));
  return {box.min() - reach, box.max() + reach};
}

} // namespace

std::vector<Eigen::Vector3d>
ballCentres(const pcl::PointCloud<ToolpathPoint>& path, double radius)
{
  std::vector<Eigen::Vector3d> centres;
  for (const ToolpathPoint& p : path)
    centres.push_back(p.getVector3fMap().cast<double>() + radius * p.getNormalVector3fMap().cast<double>());
  return centres;
}

std::optional<BallEntry>
deepestEntry(const pcl::PointCloud<ToolpathPoint>& path, const std::vector<Eigen::Vector3d>& centres, double radius,
             const std::vector<Prism>& prisms)
{
  BallEntry deepest;
  forWays(path, centres, [&](std::size_t i, const Eigen::Vector3d& begin, const Eigen::Vector3d& end) {
    for (const Prism& prism : prisms)
      if (const double depth = radius - prism.distance(begin, end); depth > deepest.depth)
        deepest = {depth, path[i].getVector3fMap().cast<double>()};
  });
  return deepest.depth > 0.0 ? std::optional(deepest) : std::nullopt;
}

std::vector<double>
depthsInWay(const pcl::PointCloud<ToolpathPoint>& path, double radius, const std::vector<Eigen::Vector3f>& points)
{
  std::vector<double> depths(points.size(), 0.0);
  const Eigen::AlignedBox3f box = reachOf(path, radius);
  if (std::none_of(points.begin(), points.end(), [&box](const Eigen::Vector3f& p) { return box.contains(p); }))
    return depths;
  const WayPieces pieces(path, radius);
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(points.size()); ++i)
    depths[i] = pieces.depth(points[i]);
  return depths;
}

std::optional<BallEntry>
deepestPoint(const pcl::PointCloud<ToolpathPoint>& path, double radius, const std::vector<Eigen::Vector3f>& points)
{
  return deepestOf(points, depthsInWay(path, radius, points));
}

std::optional<BallEntry>
deepestOf(const std::vector<Eigen::Vector3f>& points, const std::vector<double>& depths)
{
  const auto most = std::max_element(depths.begin(), depths.end());
  if (most == depths.end() || !(*most > 0.0))
    return std::nullopt;
  return BallEntry{*most, points[static_cast<std::size_t>(most - depths.begin())].cast<double>()};
}

} // namespace pcl_spiral
