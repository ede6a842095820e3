// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The figures of a path for people, and the limits that it must keep.
 */
#pragma once

#include "io/report/verification_writer.h"

#include <string>
#include <vector>

/** The limits that do not hold, each with the value found and its place. */
std::vector<std::string> brokenLimits(const pcl_spiral::Limits& limits, const pcl_spiral::Verification& verification);

/** The limits that are kept but lie below three times the noise of the scan's surface, where that tells nothing. */
std::vector<std::string> unprovenLimits(const pcl_spiral::Limits& limits, const pcl_spiral::Verification& verification);

void printFigures(const pcl_spiral::Verification& verification);
