// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether tool, motion and outputs can be meant.
 */
#pragma once

#include "pass_job.h"
#include "terminal/file_names.h"

#include <string>
#include <vector>

bool isGiven(const PassJob& job, const std::string& option);

/** A ball has a tip that follows from contact and normal. */
bool isBall(const PassJob& job);

/** Without a corner radius the cutter is a ball, or a tapered one. \throw UsageError for a cutter or a holder that cannot be */
void completeCutter(PassJob& job);

/** Of a cutter: how close its path is kept. \throw UsageError */
void checkTool(const PassJob& job);

/** Axes and feed. \throw UsageError */
void checkMotion(const PassJob& job);

/** \p files: all that the outputs come to, none of which may be an input. \throw UsageError */
void checkOutputs(const PassJob& job, const std::vector<std::string>& files, std::vector<InputName> inputs);
