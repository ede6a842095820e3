// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Words for the choices in the settings of this room.
 */
#pragma once

#include <pcl_spiral/core/choice.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include <array>
#include <utility>

namespace pcl_spiral {

template <>
struct ChoiceNames<LeadKind> {
  static constexpr std::array<std::pair<LeadKind, const char*>, 2> words{{{LeadKind::Normal, "normal"}, {LeadKind::Arc, "arc"}}};
};

} // namespace pcl_spiral
