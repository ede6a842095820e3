// SPDX-License-Identifier: BSD-3-Clause
#include "outline_distance.h"

#include "support/move_tree.h"

namespace pcl_spiral::acceptance {

namespace {

/** Points along the closed line, at most \p step apart. */
Polyline
dense(const Polyline& line, double step)
{
  Polyline result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector3d edge = line[(i + 1) % line.size()] - line[i];
    const int pieces = 1 + static_cast<int>(edge.norm() / step);
    for (int k = 0; k < pieces; ++k)
      result.push_back(line[i] + edge * (static_cast<double>(k) / pieces));
  }
  return result;
}

/** Farthest point of the closed line \p a from the closed line \p b. */
test::Place
farthest(const Polyline& a, const Polyline& b, double step)
{
  Polyline closed = b;
  closed.push_back(b.front());
  const test::MoveTree tree(closed);
  test::Place place;
  for (const Eigen::Vector3d& p : dense(a, step)) {
    const double d = tree.nearest(p).first;
    if (d > place.value) {
      place.value = d;
      place.at = p;
    }
  }
  return place;
}

} // namespace

test::Place
hausdorff(const Polyline& a, const Polyline& b, double step)
{
  const test::Place there = farthest(a, b, step), back = farthest(b, a, step);
  return there.value > back.value ? there : back;
}

} // namespace pcl_spiral::acceptance
