// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Moves in time: runs between stops, and how they overlap.
 */
#pragma once

#include "core/move_corners.h"
#include "core/speed_profile.h"

#include <vector>

namespace pcl_spiral {

/** Elements between two stops or overlaps. */
struct MotionRun {
  std::vector<MotionElement> elements;
  std::vector<ElementTime> times;
  double seconds = 0.0;
  MoveCorner after;
};

/** Finds the end of each move. */
class MotionTimer {
public:
  MotionTimer(const ControlModel& control, const AxisDynamics& axes, double tolerance)
  : control_(control), axes_(axes), tolerance_(tolerance)
  {}

  /** The end of each of \p moves, s. */
  std::vector<double> ends(const std::vector<ControlMove>& moves) const;

private:
  MotionRun takeRun(const std::vector<ControlMove>& moves, const MoveCorner& entry, std::size_t& i) const;
  MoveCorner cornerAfter(const std::vector<ControlMove>& moves, std::size_t i) const;
  void addMove(const ControlMove& move, std::size_t i, const MoveCorner& before, const MoveCorner& after, double share,
               MotionRun& run) const;
  void keepToCycles(MotionElement& element) const;
  void roundUp(MotionRun& run) const;
  double begin(const MotionRun& before, double begun, const MotionRun& next) const;

  ControlModel control_;
  AxisDynamics axes_;
  double tolerance_;
};

} // namespace pcl_spiral
