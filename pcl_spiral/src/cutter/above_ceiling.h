// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What lies above the ceiling of a drop. Private.
 */
#pragma once

#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/cutter/impl/cutter_location_engine.h>
#include <pcl_spiral/cutter/tool_location.h>

#include <cmath>
#include <cstddef>

namespace pcl_spiral {

/** The tool, for the places above the ceiling: they do not hold the cutter up, so they may lie in it. */
class AboveCeiling {
public:
  AboveCeiling(const CutterProfile& profile, const LocationOptions& options);

  /** Adds to \p location a collision of the cutter, or of a shank as wide if there is no holder, with what lies above the ceiling, and
   *  whether more lies above the end of the tool. \p find gives the deepest place above the ceiling in a HolderProfile. */
  template <typename Find>
  void look(Find find, ToolLocation& location) const
  {
    if (!std::isfinite(options_.ceiling))
      return;
    if (const HolderCollision met = find(body_); met.depth > location.collision.depth) {
      location.collision = met;
      location.collision.part = static_cast<std::size_t>(met.segment) < cutter_segments_ ? ToolPart::Cutter : ToolPart::Shank;
      location.collision.segment = -1;
    }
    location.under_scan = find(beyond_).found();
  }

private:
  LocationOptions options_;
  std::size_t cutter_segments_ = 0; ///< of body_
  HolderProfile body_, beyond_;     ///< beyond_ is what the end of the tool would be if it went on as wide as it is
};

} // namespace pcl_spiral
