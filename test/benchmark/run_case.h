// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The timed whole runs. Lengths in mm.
 */
#pragma once

#include "clouds.h"

#include <pcl_spiral/spiral/spiral_settings.h>

namespace pcl_spiral::benchmarks {

/** A cloud and the settings of its path. */
struct RunCase {
  std::string name;
  CloudPlan cloud;
  SpiralSettings settings;
  bool round = false; ///< the least length of its path is known
};

/** dome (2 M points), dome200k, freeform (86 k) and dome12: 12 M raw points with noise and false echoes, filtered and
 *  thinned to about 2 M; all at equal pitch along radial lines. With _default: by the method that a user gets who names none;
 *  _scallop: at constant scallop; dome200k_published and freeform_published: by SpiralMethod::Published, between loops of BoundaryLoops
 *  where the published walk fails. */
const std::vector<std::string>& caseNames();

/** \throw std::invalid_argument for a name not among them */
RunCase runCase(const std::string& name, double scallop);

} // namespace pcl_spiral::benchmarks
