// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Checks of tool, motion and outputs.
 */
#pragma once

#include "pass_job.h"
#include "terminal/file_names.h"

#include <string>
#include <vector>

/** Whether the cutter is a ball: its tip follows from contact and normal. */
bool isBall(const PassJob& job);

/** Without a corner radius the cutter is a ball, or a tapered ball. \throw UsageError for an impossible cutter or holder */
void completeCutter(PassJob& job);

/** Checks the tolerance of a cutter's path. \throw UsageError */
void checkTool(const PassJob& job);

/** Checks axes and feed. \throw UsageError */
void checkMotion(const PassJob& job);

/** \p files: all files of the outputs; none of them may be an input. \p more_kinds: extensions that the program writes too.
 *  \throw UsageError */
void checkOutputs(const PassJob& job, const std::vector<std::string>& files, std::vector<InputName> inputs,
                  const std::vector<std::string>& more_kinds = {});
