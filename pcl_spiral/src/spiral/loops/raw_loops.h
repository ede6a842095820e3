// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Loops as drawn on a mesh.
 */
#pragma once

#include "raised_field.h"
#include "spiral/field/ridge_band.h"
#include "spiral/field/ridge_climb.h"
#include "spiral/lines/segment_set.h"

#include <pcl_spiral/spiral/scallop_loop.h>

#include <cstdint>
#include <unordered_set>
#include <vector>

namespace pcl_spiral {

/** A loop as drawn on the mesh, with facts about its points. */
struct RawLoop {
  ScallopLoop line;
  Polyline uphill;                    ///< one a point: direction to larger distances, mm
  std::vector<std::uint8_t> is_fine;  ///< one a point: within the band about the ridges
  std::vector<float> edge;            ///< one a point: the usual edge of the mesh there, step-overs
  std::vector<std::uint8_t> is_near;  ///< one a point: so near to the band that nodes of the band may be nearest to this point
  std::vector<std::uint32_t> summits; ///< that the nodes within it lead to
  bool is_thin = false;               ///< goes only round summits that a finger reaches
};

/** The closed lines of \p values at \p level through \p triangles, ascending; without those shorter than half a step-over. \p raised: what
 *  values are those of where they are above D; between nodes, its own zeros count there. */
std::vector<RawLoop> traceLoops(const StepOverDistance& field, const RidgeBand& band, const RidgeClimb& climb,
                                const std::vector<double>& values, int level, const std::vector<std::uint32_t>& triangles,
                                const RaisedField* raised = nullptr);

/** Summits that lie only in thin loops of \p loops. */
std::unordered_set<std::uint32_t> thinSummits(const std::vector<RawLoop>& loops);

/** \p loop without the zigzag of the mesh. */
ScallopLoop finishedLoop(const RawLoop& loop);

/** Add the parts of \p loop that are near the band to \p set. */
void addNearRuns(const ScallopLoop& loop, const std::vector<std::uint8_t>& is_near, std::size_t label, SegmentSet& set);

} // namespace pcl_spiral
