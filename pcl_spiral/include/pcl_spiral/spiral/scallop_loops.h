// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Closed loops one step-over apart that cover a surface.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/spiral/scallop_loop.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <vector>

namespace pcl_spiral {

/** Loops at constant scallop height, and the middle lines of their fingers. */
struct ScallopLoopSet {
  std::vector<ScallopLoop> loops; ///< by level, boundaries first
  std::vector<Polyline> axes;     ///< of fingers
};

/** Loops D = 0, 1, 2 ... of \p field. These can leave a ridge higher than the scallop height: at corners, over saddles, in cores
 *  where no further loop fits. There the upper loop reaches out with a finger, two of whose sides lie 0.6 step-overs apart,
 *  or a loop is added. False if cancelled. */
bool makeScallopLoops(const StepOverDistance& field, const ProgressCallback& progress, ScallopLoopSet& set);

/** Ok, or an error in the user's own \p loops: none, arrays of different sizes, fewer than three points, places that are not finite,
 *  lengths that are not above 0, no boundary at the front. The message reports which loop. */
Status checkScallopLoops(const std::vector<ScallopLoop>& loops);

/** \p loops as closed passes on \p surface: contacts so close that straight moves keep the chord error, with normals and tilted
 *  axes. Fails where the cutter does not fit or a loop leaves the surface. Settings used: tool radius, chord error, longest step,
 *  tilt, lead, sense (counter-clockwise: larger distances from the boundaries on the left). */
Status putLoopsOnSurface(const std::vector<ScallopLoop>& loops, const Surface& surface, const SpiralSettings& settings,
                         const ProgressCallback& progress, DrivePasses& passes);

/** Closed loops one step-over apart, from the rim inward and round every hole. With their fingers they leave no ridge above the
 *  scallop height. Use them one by one, or link them to one path with LoopLinking.
 *
 *  Takes a field (setInputField), or a cloud or surface and loops, from which StepOverField makes one. Lengths in mm. The output
 *  does not depend on the number of threads.
 */
template <typename PointT, typename PointNT = pcl::Normal>
class ScallopLoops : public FieldInput<PointT, PointNT> {
public:
  using Ptr = pcl::shared_ptr<ScallopLoops>;            ///< A shared pointer.
  using ConstPtr = pcl::shared_ptr<const ScallopLoops>; ///< A shared pointer to a constant one.

  /** For passes: largest distance between a linear move and the loop, mm; 0.005 by default. */
  void setChordError(double error) { this->settings_.chord_error = error; }
  double getChordError() const { return this->settings_.chord_error; } ///< The value of setChordError.

  /** For passes: longest linear move, mm; 0, the default, means the tool radius. */
  void setMaxStep(double step) { this->settings_.max_step = step; }
  double getMaxStep() const { return this->settings_.max_step; } ///< The value of setMaxStep.

  /** For passes: side tilt of the tool axis about the feed direction, degrees; 15 by default. */
  void setTiltAngle(double degrees) { this->settings_.tilt_angle = degrees; }
  double getTiltAngle() const { return this->settings_.tilt_angle; } ///< The value of setTiltAngle.

  /** For passes: lead of the tool axis in the feed direction, degrees; 0 by default. */
  void setLeadAngle(double degrees) { this->settings_.lead_angle = degrees; }
  double getLeadAngle() const { return this->settings_.lead_angle; } ///< The value of setLeadAngle.

  /** For passes: which way they go round the area inside them, seen from outside; CounterClockwise by default. Round holes of the
   *  part they go the other way, so that the boundary is always on the same side. */
  void setSense(SpiralSense sense) { this->settings_.sense = sense; }
  SpiralSense getSense() const { return this->settings_.sense; } ///< The value of setSense.

  /** Make the loops. \p set is empty on failure; see getStatus. */
  void compute(ScallopLoopSet& set);

  /** Make the loops and put them on the surface, as a toolpath of closed passes for CutterLocation, programs and other writers.
   *  Needs a cloud or surface, and the tool radius. \p passes is empty on failure. */
  void compute(DrivePasses& passes);

private:
  Status run(Surface::ConstPtr& surface, const ProgressCallback& progress, ScallopLoopSet& set);
  Status runPasses(DrivePasses& passes);
};

} // namespace pcl_spiral

#include <pcl_spiral/spiral/impl/scallop_loops.hpp>

namespace pcl_spiral {
extern template class ScallopLoops<pcl::PointXYZ>;
extern template class ScallopLoops<pcl::PointXYZRGB>;
extern template class ScallopLoops<pcl::PointNormal>;
} // namespace pcl_spiral
