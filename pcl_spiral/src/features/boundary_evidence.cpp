// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/features/impl/boundary_evidence.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

BoundaryEvidence
boundaryEvidence(const std::vector<Eigen::Vector2d>& offsets, double radius, std::vector<double>& angles)
{
  angles.clear();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& d : offsets)
    if (d.squaredNorm() > 0.0) {
      sum += d;
      angles.push_back(std::atan2(d.y(), d.x()));
    }
  if (angles.empty())
    return {0.0, full_turn};
  std::sort(angles.begin(), angles.end());
  double gap = full_turn - angles.back() + angles.front();
  for (std::size_t i = 1; i < angles.size(); ++i)
    gap = std::max(gap, angles[i] - angles[i - 1]);
  return {sum.norm() / (static_cast<double>(angles.size()) * radius), gap};
}

bool
isBoundary(const BoundaryEvidence& evidence, BoundaryCriterion criterion, double offset_threshold, double gap_threshold)
{
  const double offset = evidence.offset / offset_threshold, gap = evidence.gap / gap_threshold;
  switch (criterion) {
  case BoundaryCriterion::Centroid:
    return offset > 1.0;
  case BoundaryCriterion::LargestGap:
    return gap > 1.0;
  case BoundaryCriterion::Combined:
    break;
  }
  return offset + gap > 1.7 || gap > 0.9; // the second one is for re-entrant corners, whose offset is small
}

} // namespace pcl_spiral
