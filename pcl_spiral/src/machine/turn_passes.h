// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Splits a path into passes within the range of a rotary axis.
 */
#pragma once

#include <pcl_spiral/machine/impl/rotary_path.h>

#include <vector>

namespace pcl_spiral {

/** Locations first to last, with the first angle shifted by whole turns. The next pass begins where this one
 *  ends. */
struct TurnPass {
  std::size_t first = 0;
  std::size_t last = 0;
  double shift = 0.0; ///< radians
};

/** Passes that keep the first angle within its range, each as long as possible; one pass if there are no limits.
 *  Empty if no shift brings a location or a block into the range; \p failed is its index then. */
std::vector<TurnPass> turnPasses(const MachineLocations& path, const RotaryAxis& axis, std::size_t& failed);

} // namespace pcl_spiral
