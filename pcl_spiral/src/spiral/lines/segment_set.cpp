// SPDX-License-Identifier: BSD-3-Clause
#include "segment_set.h"

namespace pcl_spiral {

void
SegmentSet::add(const Polyline& run, bool closed, std::size_t label)
{
  if (run.empty())
    return;
  const std::size_t first = points_.size();
  points_.insert(points_.end(), run.begin(), run.end());
  if (closed || run.size() == 1)
    points_.push_back(run.front());
  is_joint_.resize(points_.size(), 0);
  is_joint_.back() = 1;
  run_of_.resize(points_.size(), static_cast<std::uint32_t>(runs_.size()));
  runs_.push_back({first, label});
}

void
SegmentSet::build()
{
  index_ = std::make_unique<MoveIndex>(points_);
}

NearestSegment
SegmentSet::nearest(const Eigen::Vector3d& p, const StepOverMetric& metric, double within, std::size_t but, double enough) const
{
  NearestSegment best;
  best.distance = within;
  if (points_.empty())
    return best;
  const double widest = longestStepOverBound(metric);
  index_->search(
      p, [&] { return best.segment == NearestSegment::none || best.distance > enough ? best.distance * widest : 0.0; },
      [&](std::size_t s) {
        if (is_joint_[s] || label(s) == but)
          return;
        double t = 0.0;
        const double distance = distanceFromSegment(p, metric, points_[s], points_[s + 1], t);
        if (distance < best.distance || (distance == best.distance && s < best.segment))
          best = {distance, s, t};
      });
  return best;
}

NearestSegment
SegmentSet::along(const Eigen::Vector3d& p, const StepOverMetric& metric, std::size_t segment, double within) const
{
  NearestSegment best;
  best.distance = within;
  const auto isNearer = [&](std::size_t s) {
    if (s + 1 >= points_.size() || is_joint_[s])
      return false;
    double t = 0.0;
    const double distance = distanceFromSegment(p, metric, points_[s], points_[s + 1], t);
    if (!(distance < best.distance))
      return false;
    best = {distance, s, t};
    return true;
  };
  isNearer(segment);
  const NearestSegment here = best;
  for (std::size_t s = segment + 1; isNearer(s); ++s)
    ;
  if (best.segment == here.segment)
    for (std::size_t s = segment; s > 0 && isNearer(s - 1); --s)
      ;
  return best;
}

NearestSegment
SegmentSet::nearestFrom(std::size_t from, const Eigen::Vector3d& p, const StepOverMetric& metric, double within, double enough) const
{
  NearestSegment best;
  best.distance = within;
  if (from != NearestSegment::none)
    best = along(p, metric, from, within);
  if (best.segment != NearestSegment::none && best.distance < enough)
    return best;
  const NearestSegment nearer = nearest(p, metric, best.distance, NearestSegment::none, enough);
  return nearer.segment != NearestSegment::none ? nearer : best;
}

} // namespace pcl_spiral
