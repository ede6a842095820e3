// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Words for the choices in the settings of this room.
 */
#pragma once

#include <pcl_spiral/common/drive_pass.h>
#include <pcl_spiral/core/choice.h>
#include <pcl_spiral/drive/drive_settings.h>

#include <array>
#include <utility>

namespace pcl_spiral {

template <>
struct ChoiceNames<DriveKind> {
  static constexpr std::array<std::pair<DriveKind, const char*>, 5> words{{{DriveKind::Planes, "planes"},
                                                                           {DriveKind::Helix, "helix"},
                                                                           {DriveKind::Rings, "rings"},
                                                                           {DriveKind::Curve, "curve"},
                                                                           {DriveKind::BoundaryOffset, "offset"}}};
};
template <>
struct ChoiceNames<DriveRows> {
  static constexpr std::array<std::pair<DriveRows, const char*>, 2> words{{{DriveRows::Even, "even"}, {DriveRows::Kept, "kept"}}};
};
template <>
struct ChoiceNames<DriveAxisMode> {
  static constexpr std::array<std::pair<DriveAxisMode, const char*>, 4> words{{{DriveAxisMode::Fixed, "fixed"},
                                                                               {DriveAxisMode::Cylinder, "cylinder"},
                                                                               {DriveAxisMode::LocalPlane, "plane"},
                                                                               {DriveAxisMode::Surface, "surface"}}};
};

} // namespace pcl_spiral
