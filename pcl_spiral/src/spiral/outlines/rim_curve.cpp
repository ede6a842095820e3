// SPDX-License-Identifier: BSD-3-Clause
#include "rim_curve.h"

#include <algorithm>
#include <cstdint>

namespace pcl_spiral {

RimCurve::RimCurve(const BoundaryLoop& loop, const Eigen::Vector3d& start)
{
  startAt(loop, start);
  s_ = arcLengths(points_, true);
}

Eigen::Vector3d
RimCurve::at(double s) const
{
  const auto above = std::upper_bound(s_.begin() + 1, s_.end() - 1, s);
  const auto k = static_cast<std::size_t>(above - s_.begin()) - 1;
  const double f = (s - s_[k]) / (s_[k + 1] - s_[k]);
  return (1.0 - f) * points_[k] + f * points_[(k + 1) % points_.size()];
}

/** Reorder the loop to start at its place nearest to \p start: at a close corner, at another vertex moved there, or at a new
 *  vertex. */
void
RimCurve::startAt(const BoundaryLoop& loop, const Eigen::Vector3d& start)
{
  const Polyline& c = loop.curve;
  std::size_t segment = 0;
  double best = 1e300, best_f = 0.0;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const Eigen::Vector3d d = c[(k + 1) % c.size()] - c[k];
    const double f = std::clamp((start - c[k]).dot(d) / d.squaredNorm(), 0.0, 1.0);
    const double distance = (c[k] + f * d - start).norm();
    if (distance < best) {
      best = distance;
      segment = k;
      best_f = f;
    }
  }
  constexpr double close = 0.2; // of a segment
  const Eigen::Vector3d place = (1.0 - best_f) * c[segment] + best_f * c[(segment + 1) % c.size()];
  if (best_f > 1.0 - close) {
    segment = (segment + 1) % c.size();
    best_f = 0.0;
  }
  const bool new_vertex = best_f >= close;
  if (new_vertex)
    points_.push_back(place);
  const std::size_t first = new_vertex ? segment + 1 : segment;
  std::vector<std::uint8_t> corner(c.size(), 0);
  for (const std::size_t k : loop.corners)
    corner[k] = 1;
  for (std::size_t step = 0; step < c.size(); ++step) {
    const std::size_t k = (first + step) % c.size();
    if (corner[k])
      corners_.push_back(points_.size());
    points_.push_back(c[k]);
  }
  if (!new_vertex && !corner[first])
    points_.front() = place;
}

} // namespace pcl_spiral
