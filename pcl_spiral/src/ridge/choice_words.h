// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Words for the choices in the settings of this room.
 */
#pragma once

#include <pcl_spiral/core/choice.h>
#include <pcl_spiral/ridge/ridge_rows.h>

#include <array>
#include <utility>

namespace pcl_spiral {

template <>
struct ChoiceNames<RidgeDirection> {
  static constexpr std::array<std::pair<RidgeDirection, const char*>, 2> words{
      {{RidgeDirection::AlongRail, "along"}, {RidgeDirection::AcrossRail, "across"}}};
};
template <>
struct ChoiceNames<RidgeSteps> {
  static constexpr std::array<std::pair<RidgeSteps, const char*>, 2> words{
      {{RidgeSteps::EqualOnRow, "equal"}, {RidgeSteps::Stations, "stations"}}};
};
template <>
struct ChoiceNames<RidgeNormals> {
  static constexpr std::array<std::pair<RidgeNormals, const char*>, 3> words{
      {{RidgeNormals::True, "true"}, {RidgeNormals::InNormalPlane, "in-plane"}, {RidgeNormals::Arc, "arc"}}};
};

} // namespace pcl_spiral
