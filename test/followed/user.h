// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A user who does what the messages say, word by word.
 */
#pragma once

#include "refused_input.h"

#include "support/scratch_folder.h"

#include <string>
#include <vector>

namespace pcl_spiral::followed {

/** How it ended. */
enum class End {
  PathAtOnce, ///< nothing was refused
  Right,      ///< a path that is right by the raw points, within three commands after the refusal
  Wrong,      ///< a path that cuts into the raw points
  Reported,   ///< a refusal that says that nothing but another scan helps
  DeadEnd,    ///< a refusal that names nothing that can be done, or four refusals
  Loop        ///< all that the refusal names was done before
};

/** What the user did. */
struct Followed {
  End end = End::DeadEnd;
  std::size_t commands = 0;       ///< after the refusal
  bool planner_named = false;     ///< the first refusal named a change that the planner had tried
  std::vector<std::string> story; ///< commands and messages
  std::vector<double> seconds;    ///< of each command, the first one too
};

/** Gives the command of \p input to \p program, and does what its refusals say. */
Followed follow(const RefusedInput& input, const std::string& program, const ScratchFolder& folder);

} // namespace pcl_spiral::followed
