// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  One try to plan one region.
 */
#pragma once

#include "planning/part_selection.h"
#include <pcl_spiral/planning/impl/spiral_planning.h>

namespace pcl_spiral {

/** Why a try gave no plan. */
enum class Refusal {
  None,    ///< it gave one
  Input,   ///< settings or points that another try does not change, or cancelled
  NoPath,  ///< surface or generator found no path
  KeepOut, ///< the path enters a keep-out
  Things   ///< tool and path meet something else, or the part cannot be chosen
};

/** What a try gave. */
struct AttemptResult {
  Status status;
  Refusal refusal = Refusal::None;
  bool late = false;    ///< refused after turns were made: as slow as a path
  double room = 0.0;    ///< of KeepOut: how much farther away the ball should stay, mm
  bool crosses = false; ///< of KeepOut: the path does not only run a little beyond the last points
};

/** Plans the region that \p choice chooses of \p input, without its narrow \p strips beside keep-outs. \p plan has whole scan and mesh
 *  samples already, and gets the rest. */
AttemptResult attempt(const PlanInput& input, const PartChoice& choice, const StripChoice& strips, const ProgressCallback& progress,
                      SpiralPlan& plan);

} // namespace pcl_spiral
