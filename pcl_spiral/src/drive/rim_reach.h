// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Section planes beyond a rim that falls away, so that the cutter reaches the rim. Private.
 */
#pragma once

#include "drive_lines.h"
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/surface/surface.h>

#include <vector>

namespace pcl_spiral {

/** Directions of the passes and of the steps between planes, and the origin of their distances. */
struct SectionFrame {
  Eigen::Vector3d along, across, origin;
};

/** Where a cutter that comes down along an axis stands as it touches the rims of a surface. On a slope its axis is beside the contact,
 *  a ball's by R sin(slope): the cutter reaches a rim that falls away from beyond it. Rims are the longest loop of each part: holes and
 *  gaps, where nothing is known, are not entered. */
class RimReach {
public:
  /** \p mesh: triangles of \p surface; \p axis is unit. */
  RimReach(const Surface& surface, const Triangulation& mesh, const CutterShape& cutter, const SectionFrame& frame);

  /** Widens an extent across the passes to the cutter's places. */
  void widen(double& low, double& high) const;

  /** The lines of the plane at \p level, mm across, that lie beyond the rim; \p lines are its sections with the surface. They run along
   *  the passes, and begin and end at sections that they continue. */
  std::vector<DriveLine> beyond(double level, const std::vector<DriveLine>& lines) const;

  /** Whether \p place is beyond the rim, along the tool axis, and the cutter there touches the surface inside. */
  bool contains(const Eigen::Vector3d& place) const;

private:
  /** A part of a plane. */
  struct Span {
    double from, to; ///< along the passes
    Eigen::Vector3d begin, end;
  };
  using Spans = std::vector<Span>;

  double along(const Eigen::Vector3d& x) const { return frame_.along.dot(x - frame_.origin); }
  double across(const Eigen::Vector3d& x) const { return frame_.across.dot(x - frame_.origin); }
  Spans inside(const std::vector<Polyline>& loops, double level) const;
  static Spans without(const Spans& spans, const Spans& covered);
  Spans outerSpans(double level) const { return without(inside(tips_, level), inside(rims_, level)); }

  SectionFrame frame_;
  double shortest_; ///< mm
  std::vector<Polyline> rims_, tips_;
};

} // namespace pcl_spiral
