// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The way from the end of a pass to the next without leaving the surface far.
 */
#pragma once

#include "tool_leads.h"

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** Adds the way to a pass to the blocks of \p program: \p entry from the top, which comes after the retract of the pass before; or, if
 *  \p may_link, a link from the end of its last lead to where the lead in \p entry begins, without that retract. The tip moves straight,
 *  the axis along its arc, split as cuts are. There is no link if the way is longer than stay_down, or if a rotary axis would turn by more
 *  than half a turn. Nothing here knows the part: LeadCheck does. \return the first block that belongs to the pass */
std::size_t addEntry(const Kinematics& kinematics, const ProgramSettings& settings, const ToolLeads& leads,
                     const std::vector<ProgramBlock>& entry, bool may_link, MachineProgram& program);

} // namespace pcl_spiral
