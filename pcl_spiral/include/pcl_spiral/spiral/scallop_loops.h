/** \file
 *  Closed loops one step-over apart that cover a surface.
 */
#pragma once

#include <pcl_spiral/common/progress.h>
#include <pcl_spiral/spiral/scallop_loop.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <vector>

namespace pcl_spiral {

/** Loops at constant scallop height, and what lies in the middle of their fingers. */
struct ScallopLoopSet {
  std::vector<ScallopLoop> loops; ///< by level, the rims first
  std::vector<Polyline> axes;     ///< of fingers
};

/** Loops D = 0, 1, 2 ... of \p field. Where they alone would leave a ridge higher than asked for (at corners, over saddles, in
 *  cores that no further loop fits into) the upper one reaches out in a finger, two of whose sides lie 0.6 step-overs apart, or
 *  a loop is put in. False when cancelled. */
bool
makeScallopLoops(const StepOverDistance& field, const ProgressCallback& progress, ScallopLoopSet& set);

} // namespace pcl_spiral
