// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Words for the choices in the settings of this room.
 */
#pragma once

#include <pcl_spiral/core/choice.h>
#include <pcl_spiral/surface/surface_settings.h>

#include <array>
#include <utility>

namespace pcl_spiral {

template <>
struct ChoiceNames<ClusterHandling> {
  static constexpr std::array<std::pair<ClusterHandling, const char*>, 3> words{
      {{ClusterHandling::Refuse, "refuse"}, {ClusterHandling::Ride, "ride"}, {ClusterHandling::LeaveOut, "leave-out"}}};
};

} // namespace pcl_spiral
