// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One continuous path at constant scallop height over a surface of any outline.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/spiral/spiral_turns.h>
#include <pcl_spiral/surface/surface.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

struct LinkedPath;
struct ScallopLoop;
struct StepOverDistance;

/** Parts and figures of a path at constant scallop height. Lengths in mm. */
struct ScallopFigures {
  std::size_t loops = 0;       ///< from the boundaries inward
  std::size_t chain_loops = 0; ///< in the spiral from the rim to the innermost loop
  std::size_t bridges = 0;     ///< loops beside it, each joined to a neighbour by two narrow turns
  std::size_t dots = 0;        ///< small loops that became a finger of a neighbour
  std::vector<Polyline> lines; ///< the loops, closed, simplified for pictures
  std::vector<Polyline> axes;  ///< of the fingers
  std::size_t fingers = 0;     ///< places where loops reach out so that no higher ridge is left
  double reversed_share = 0.0; ///< of the path, travelled against the requested sense, as loops beside the chain must be
  std::size_t lifts = 0;       ///< from one pass to the next, if the requested sense is kept everywhere
  double lift_length = 0.0;    ///< of the straight moves between passes, which path lengths do not count
  double least_length = 0.0;   ///< integral of dA / largest step-over, plus half the boundary length: least of any path at this scallop
  double smallest_step_over = 0.0, largest_step_over = 0.0; ///< mm: that the height allows along the path
  double start_off = 0.0;                                   ///< mm: distance of the path's end on the rim from the requested start point
  double rim_length = 0.0;                                  ///< mm
  double turn_radius = 0.0;                                 ///< step-overs: all but 0.1 % of the path have a larger radius
  double least_radius = 0.0;                                ///< step-overs: of the sharpest turn
  Eigen::Vector3d sharpest_place = Eigen::Vector3d::Zero(); ///< its place
  double farthest = 0.0; ///< largest distance of a place of the surface from the path, in step-overs; 0.5 leaves the requested height
  Eigen::Vector3d farthest_place = Eigen::Vector3d::Zero();
};

/** D on \p surface between the rim and holes among \p loops, each of type Outer or Inner: the output of class StepOverField.
 *  Settings used: tool radius, scallop height. */
Status makeStepOverField(const Surface& surface, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings,
                         const ProgressCallback& progress, StepOverDistance& field);

/** One path over \p loops (linkLoops), which have the surface on their left and the rim first. It is moved where it would leave
 *  more of \p field than requested; with a null pointer it is not moved. The output of class LoopLinking. Settings used:
 *  direction, sense, one way. With Outward every pass runs outward, and the one along the rim is last. */
Status makeScallopPath(std::vector<ScallopLoop> loops, const StepOverDistance* field, const SpiralSettings& settings,
                       const ProgressCallback& progress, StageClock& clock, LinkedPath& path, ScallopFigures& figures);

/** The curve of a path over \p surface between the rim and holes among \p loops, each of type Outer or Inner: distances from them
 *  in step-overs (makeStepOverField), loops that cover everything (makeScallopLoops), one path over these (makeScallopPath), its
 *  points (samplePath). Settings used: tool radius, scallop height, chord error, longest step, direction, sense. */
Status planConstantScallop(const Surface& surface, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings,
                           const ProgressCallback& progress, StageClock& clock, SpiralTurns& turns, ScallopFigures& figures);

} // namespace pcl_spiral
