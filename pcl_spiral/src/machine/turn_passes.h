// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A path in passes that a rotary axis of finite range can make.
 */
#pragma once

#include <pcl_spiral/machine/impl/rotary_path.h>

#include <vector>

namespace pcl_spiral {

/** Locations first to last, their first angle turned by whole turns. The next pass begins where this one
 * ends. */
struct TurnPass {
  std::size_t first = 0;
  std::size_t last = 0;
  double shift = 0.0; ///< radians
};

/** Passes that keep the first angle within its range, each as long as can be. One without limits. Nothing
 * where a location or a block has no turn within the range; \p failed is its index then. */
std::vector<TurnPass> turnPasses(const MachineLocations& path, const RotaryAxis& axis, std::size_t& failed);

} // namespace pcl_spiral
