// SPDX-License-Identifier: BSD-3-Clause
#include "outline_side.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl_spiral {

OutlineSide::OutlineSide(const std::vector<BoundaryLoop>& outlines)
{
  for (std::size_t o = 0; o < outlines.size(); ++o) {
    const Polyline& curve = outlines[o].curve;
    const std::vector<double> arcs = arcLengths(curve, true);
    begin_.push_back(line_.size());
    line_.insert(line_.end(), curve.begin(), curve.end());
    line_.push_back(curve.front());
    arcs_.insert(arcs_.end(), arcs.begin(), arcs.end());
    outline_of_.resize(line_.size(), static_cast<std::uint32_t>(o));
  }
  begin_.push_back(line_.size());
  index_ = std::make_unique<MoveIndex>(line_);
}

Eigen::Vector3d
OutlineSide::tangentBefore(std::size_t vertex) const
{
  const std::size_t o = outline_of_[vertex];
  const std::size_t at = vertex == begin_[o] ? begin_[o + 1] - 1 : vertex;
  return (line_[at] - line_[at - 1]).normalized();
}

Eigen::Vector3d
OutlineSide::tangentAfter(std::size_t vertex) const
{
  const std::size_t o = outline_of_[vertex];
  const std::size_t at = vertex + 1 == begin_[o + 1] ? begin_[o] : vertex;
  return (line_[at + 1] - line_[at]).normalized();
}

bool
OutlineSide::find(const Eigen::Vector3d& p, const Eigen::Vector3d& normal, double within, OutlinePlace& place) const
{
  double best = within;
  std::size_t segment = line_.size();
  double share = 0.0;
  index_->search(
      p, [&best] { return best; },
      [&](std::size_t s) {
        if (outline_of_[s] != outline_of_[s + 1])
          return;
        const Eigen::Vector3d d = line_[s + 1] - line_[s];
        const double t = std::clamp((p - line_[s]).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
        const double distance = (p - line_[s] - t * d).norm();
        if (distance < best || (distance == best && s < segment)) {
          best = distance;
          segment = s;
          share = t;
        }
      });
  if (segment == line_.size())
    return false;
  const Eigen::Vector3d foot = line_[segment] + share * (line_[segment + 1] - line_[segment]);
  Eigen::Vector3d along = tangentAfter(segment);
  if (share <= 0.0)
    along += tangentBefore(segment);
  else if (share >= 1.0)
    along += tangentAfter(segment + 1);
  place.distance = best;
  place.inside = (p - foot).dot(normal.cross(along)) >= 0.0;
  place.outline = outline_of_[segment];
  place.arc = arcs_[segment] + share * (arcs_[segment + 1] - arcs_[segment]);
  return true;
}

} // namespace pcl_spiral
