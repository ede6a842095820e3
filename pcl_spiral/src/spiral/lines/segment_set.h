// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far points are from a set of lines, in step-overs.
 */
#pragma once

#include <pcl_spiral/core/impl/step_over_metric.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/search/impl/move_index.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace pcl_spiral {

/** Where a point's nearest segment is. */
struct NearestSegment {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  double distance = 0.0;      ///< step-overs, in the metric at the point
  std::size_t segment = none; ///< from point(segment) to point(segment + 1)
  double share = 0.0;         ///< along it
};

/** Distance in \p metric of \p p from the segment between \p a and \p b; \p share: where along it. */
inline double
distanceFromSegment(const Eigen::Vector3d& p, const StepOverMetric& metric, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                    double& share)
{
  const Eigen::Vector3d d = b - a, gd = metric.matrix() * d;
  share = std::clamp((p - a).dot(gd) / std::max(d.dot(gd), 1e-300), 0.0, 1.0);
  return metric.length(p - a - share * d);
}

/** Runs of points that are searched together. */
class SegmentSet {
public:
  /** Add a run with a label that the caller chooses. A run may be a single point. */
  void add(const Polyline& run, bool closed, std::size_t label = 0);
  /** Call this after the last add. */
  void build();

  bool empty() const { return points_.empty(); }
  const Eigen::Vector3d& point(std::size_t i) const { return points_[i]; }
  /** Label of the run that a segment belongs to. */
  std::size_t label(std::size_t segment) const { return runs_[run_of_[segment]].label; }
  /** Index, in its run, of the point at which a segment begins. */
  std::size_t place(std::size_t segment) const { return segment - runs_[run_of_[segment]].first; }

  /** The segment nearest to \p p when it is nearer than \p within step-overs; else the distance is \p within. Runs with the
   *  label \p but do not count. One that is nearer than \p enough ends the search. */
  NearestSegment nearest(const Eigen::Vector3d& p, const StepOverMetric& metric, double within, std::size_t but = NearestSegment::none,
                         double enough = 0.0) const;
  /** An upper limit of the distance of \p p, found along a run from \p segment while that gets nearer; no segment, and \p within, if
   *  nothing there is nearer. */
  NearestSegment along(const Eigen::Vector3d& p, const StepOverMetric& metric, std::size_t segment, double within) const;
  /** The same distance as by nearest, looked for first along the run from \p from, where the last point was near. One that is nearer
   *  than \p enough ends the search. */
  NearestSegment nearestFrom(std::size_t from, const Eigen::Vector3d& p, const StepOverMetric& metric, double within,
                             double enough = 0.0) const;
  /** Call \p visit(segment) for all segments within \p within step-overs of \p p; a segment may come twice. */
  template <typename Visit>
  void forSegmentsNear(const Eigen::Vector3d& p, const StepOverMetric& metric, double within, Visit visit) const
  {
    const double reach = within * longestStepOver(metric);
    double share = 0.0;
    index_->search(
        p, [reach] { return reach; },
        [&](std::size_t s) {
          if (!is_joint_[s] && distanceFromSegment(p, metric, points_[s], points_[s + 1], share) <= within)
            visit(s);
        });
  }

private:
  struct Run {
    std::size_t first, label;
  };

  Polyline points_;
  std::vector<std::uint8_t> is_joint_; ///< of the segment that begins here: it joins two runs and is no real segment
  std::vector<std::uint32_t> run_of_;
  std::vector<Run> runs_;
  std::unique_ptr<MoveIndex> index_;
};

} // namespace pcl_spiral
