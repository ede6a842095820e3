// SPDX-License-Identifier: BSD-3-Clause
#include "support/move_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl_spiral::test {

namespace {

constexpr std::uint32_t leaf_size = 4;

double
segmentDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d d = b - a;
  const double length2 = d.squaredNorm();
  const double t = length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

} // namespace

bool
capsuleInterval(const Eigen::Vector3d& x, const Eigen::Vector3d& n, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius,
                double& enter, double& leave)
{
  enter = std::numeric_limits<double>::max();
  leave = -enter;
  const auto include = [&](double t) {
    enter = std::min(enter, t);
    leave = std::max(leave, t);
  };
  for (const Eigen::Vector3d* centre : {&a, &b}) { // the ends: balls
    const Eigen::Vector3d m = x - *centre;
    const double half = m.dot(n), inside = half * half - m.squaredNorm() + radius * radius;
    if (inside >= 0.0) {
      include(-half - std::sqrt(inside));
      include(-half + std::sqrt(inside));
    }
  }
  const double length = (b - a).norm();
  if (length > 0.0) { // the side: points of the cylinder between the ends
    const Eigen::Vector3d d = (b - a) / length, m = x - a;
    const double md = m.dot(d), nd = n.dot(d);
    const Eigen::Vector3d mp = m - md * d, np = n - nd * d;
    const double q = np.squaredNorm(), half = mp.dot(np), c = mp.squaredNorm() - radius * radius;
    const double inside = half * half - q * c;
    if (q > 1e-18 && inside >= 0.0)
      for (const double sign : {-1.0, 1.0}) {
        const double t = (-half + sign * std::sqrt(inside)) / q;
        const double along = md + t * nd;
        if (along >= 0.0 && along <= length)
          include(t);
      }
  }
  return enter <= leave;
}

MoveTree::MoveTree(std::vector<Eigen::Vector3d> points) : points_(std::move(points))
{
  if (points_.size() < 2)
    points_.resize(2, points_.empty() ? Eigen::Vector3d::Zero() : points_.front());
  order_.resize(moves());
  std::iota(order_.begin(), order_.end(), 0u);
  nodes_.reserve(2 * moves() / leaf_size + 8);
  build(0, static_cast<std::uint32_t>(order_.size()));
}

Eigen::AlignedBox3d
MoveTree::boxOf(std::size_t move) const
{
  Eigen::AlignedBox3d box(points_[move]);
  box.extend(points_[move + 1]);
  return box;
}

std::uint32_t
MoveTree::build(std::uint32_t first, std::uint32_t last)
{
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Eigen::AlignedBox3d box, middles;
  for (std::uint32_t i = first; i < last; ++i) {
    box.extend(boxOf(order_[i]));
    middles.extend(0.5 * (points_[order_[i]] + points_[order_[i] + 1]));
  }
  nodes_[id].box = box;
  if (last - first <= leaf_size) {
    nodes_[id].first = first;
    nodes_[id].count = last - first;
    return id;
  }
  Eigen::Index axis = 0;
  middles.sizes().maxCoeff(&axis);
  const std::uint32_t half = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last, [&](std::uint32_t i, std::uint32_t j) {
    return points_[i][axis] + points_[i + 1][axis] < points_[j][axis] + points_[j + 1][axis];
  });
  build(first, half);
  const std::uint32_t right = build(half, last);
  nodes_[id].right = right;
  return id;
}

MoveTree::Entry
MoveTree::entry(const Eigen::Vector3d& x, const Eigen::Vector3d& n, double radius, double start, double reach) const
{
  Entry best;
  best.t = reach;
  std::array<std::uint32_t, 64> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  const Eigen::Vector3d ideal = x + radius * n;
  while (depth > 0) {
    const std::uint32_t id = stack[--depth];
    const Node& node = nodes_[id];
    // Centres farther than this from the middle of the rest of the ray cannot touch it.
    const double half = 0.5 * (best.t + start), limit = radius + half;
    if (node.box.squaredExteriorDistance(Eigen::Vector3d(x + (half - start) * n)) > limit * limit)
      continue;
    if (node.count == 0) {
      const std::uint32_t left = id + 1;
      const bool left_first = nodes_[left].box.squaredExteriorDistance(ideal) < nodes_[node.right].box.squaredExteriorDistance(ideal);
      stack[depth++] = left_first ? node.right : left;
      stack[depth++] = left_first ? left : node.right;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::size_t move = order_[i];
      const double middle = 0.5 * (best.t - start), far = radius + 0.5 * (best.t + start);
      double enter = 0.0, leave = 0.0;
      if (segmentDistance(x + middle * n, points_[move], points_[move + 1]) > far ||
          !capsuleInterval(x, n, points_[move], points_[move + 1], radius, enter, leave) || leave < -start)
        continue;
      enter = std::max(enter, -start);
      if (enter < best.t)
        best = {enter, move, true};
    }
  }
  return best;
}

std::pair<double, std::size_t>
MoveTree::nearest(const Eigen::Vector3d& p) const
{
  double best = std::numeric_limits<double>::max();
  std::size_t found = 0;
  std::array<std::uint32_t, 64> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t id = stack[--depth];
    const Node& node = nodes_[id];
    if (node.box.squaredExteriorDistance(p) >= best * best)
      continue;
    if (node.count == 0) {
      const std::uint32_t left = id + 1;
      const bool left_first = nodes_[left].box.squaredExteriorDistance(p) < nodes_[node.right].box.squaredExteriorDistance(p);
      stack[depth++] = left_first ? node.right : left;
      stack[depth++] = left_first ? left : node.right;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const double d = segmentDistance(p, points_[order_[i]], points_[order_[i] + 1]);
      if (d < best) {
        best = d;
        found = order_[i];
      }
    }
  }
  return {best, found};
}

void
MoveTree::laterOverlaps(std::size_t move, const std::function<void(std::size_t)>& f) const
{
  const Eigen::AlignedBox3d box = boxOf(move);
  std::array<std::uint32_t, 64> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t id = stack[--depth];
    const Node& node = nodes_[id];
    if (!node.box.intersects(box))
      continue;
    if (node.count == 0) {
      stack[depth++] = node.right;
      stack[depth++] = id + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      if (order_[i] > move && boxOf(order_[i]).intersects(box))
        f(order_[i]);
  }
}

} // namespace pcl_spiral::test
