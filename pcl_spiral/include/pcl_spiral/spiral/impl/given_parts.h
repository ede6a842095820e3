// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Parts of a path that the user gives in place of those that SpiralToolpathGenerator makes.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/spiral/path_planner.h>

#include <memory>
#include <optional>
#include <vector>

namespace pcl_spiral {

struct StepOverDistance;

/** One of them makes the path; a field may come with loops. */
struct GivenParts {
  std::shared_ptr<const StepOverDistance> field; ///< of setStepOverField
  std::optional<std::vector<ScallopLoop>> loops; ///< of setScallopLoops
  std::optional<LinkedPath> linked;              ///< of setLinkedPath
  std::optional<std::vector<SpiralPoint>> curve; ///< of setCurve
  std::shared_ptr<const PathPlanner> planner;    ///< of setPlanner

  /** Whether there is none. */
  bool empty() const { return !field && !loops && !linked && !ofUser(); }
  /** Whether the curve is the user's own, of which no stage knows anything. */
  bool ofUser() const { return curve || planner; }
};

/** Ok, or an error: more than one part, with \p lines_given for radial lines; a setting for a path that is made otherwise; another tool
 *  radius or scallop height than that of \p settings; arrays that do not fit together. */
Status checkGivenParts(const GivenParts& given, const SpiralSettings& settings, bool lines_given);

/** The curve of \p given over \p surface between \p boundaries, and its points for linear moves (samplePath). Fails if the rims of a
 *  field or of loops are not \p boundaries, and if a path runs into a hole among these. */
Status planGiven(const GivenParts& given, const Surface& surface, const std::vector<BoundaryLoop>& boundaries,
                 const SpiralSettings& settings, const ProgressCallback& progress, StageClock& clock, SpiralTurns& turns,
                 ScallopReport& figures);

/** Runs \p modifiers on \p path, which has its axes, and measures it again. Fails if one fails, or leaves what is no path: arrays of
 *  different sizes, numbers that are not finite, normals into the material, axes that lie in the surface, lifts that are not the
 *  distances of the contacts from their feet. */
Status modifyPath(const std::vector<std::shared_ptr<const PathModifier>>& modifiers, const Surface& surface, const SpiralSettings& settings,
                  SpiralPath& path, AxisReport& axes, GapReport& gaps);

} // namespace pcl_spiral
