// SPDX-License-Identifier: BSD-3-Clause
#include "verify/move_order.h"

#include <algorithm>

namespace pcl_spiral {

MoveOrder::MoveOrder(const Polyline& line) : moves_(line.size() < 2 ? 0 : line.size() - 1), runs_((moves_ + run - 1) / run)
{
  if (runs_ == 0)
    return;
  boxes_.resize(2 * runs_ - 1);
  build(line, 0, 0, runs_);
  slack_ = 1e-6 * (boxes_[0].min().cwiseAbs().maxCoeff() + boxes_[0].max().cwiseAbs().maxCoeff());
}

void
MoveOrder::build(const Polyline& line, std::size_t node, std::size_t first, std::size_t count)
{
  Eigen::AlignedBox3f& box = boxes_[node];
  if (count == 1) {
    for (std::size_t i = first * run; i <= std::min(moves_, (first + 1) * run); ++i)
      box.extend(line[i].cast<float>());
    return;
  }
  const std::size_t half = count / 2;
  build(line, node + 1, first, half);
  build(line, node + 2 * half, first + half, count - half);
  box = boxes_[node + 1].merged(boxes_[node + 2 * half]);
}

} // namespace pcl_spiral
