// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One continuous path at constant scallop height over a surface of any outline.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/spiral/scallop_loop.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_spiral {

struct LinkedPath;
struct ScallopLoop;
struct StepOverDistance;

/** D on \p surface between the rim and holes among \p loops, each of type Outer or Inner: the output of class StepOverField.
 *  Settings used: tool radius, scallop height. */
Status makeStepOverField(const Surface& surface, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings,
                         const ProgressCallback& progress, StepOverDistance& field);

/** One path over \p loops (linkLoops), which have the surface on their left and the rim first. It is moved where it would leave
 *  more of \p field than requested; with a null pointer it is not moved. The output of class LoopLinking. Settings used:
 *  direction, sense, one way. With Outward every pass runs outward, and the one along the rim is last. */
Status makeScallopPath(std::vector<ScallopLoop> loops, const StepOverDistance* field, const SpiralSettings& settings,
                       const ProgressCallback& progress, StageClock& clock, LinkedPath& path, ScallopReport& figures);

/** The figures of \p path itself: step-overs, bridges, the share against the sense, lifts. */
void measureLinked(const LinkedPath& path, ScallopReport& figures);

/** One path over \p loops as makeScallopPath makes it; without loops, over those of makeScallopLoops on \p field. */
Status linkOnField(const StepOverDistance* field, std::vector<ScallopLoop> loops, const SpiralSettings& settings,
                   const ProgressCallback& progress, StageClock& clock, LinkedPath& path, ScallopReport& figures);

/** The curve of a path over \p surface between the rim and holes among \p loops, each of type Outer or Inner: distances from them
 *  in step-overs (makeStepOverField), loops that cover everything (makeScallopLoops), one path over these (makeScallopPath), its
 *  points (samplePath). Settings used: tool radius, scallop height, chord error, longest step, direction, sense. \p drop: the
 *  triangles of \p surface, which the field has its own of, are given up. */
Status planConstantScallop(Surface::ConstPtr& surface, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings,
                           const ProgressCallback& progress, bool drop, StageClock& clock, SpiralTurns& turns, ScallopReport& figures);

} // namespace pcl_spiral
