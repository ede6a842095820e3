// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The machine's program of passes.
 */
#pragma once

#include "pass_job.h"
#include "pass_result.h"

#include <optional>

/** The machine where a program is asked for. \throw pcl_spiral::FileError */
std::optional<pcl_spiral::Machine> machineOf(const PassJob& job);

/** Lays the passes on \p machine; the way of a cutter to them is kept free of the scan in \p result.
 *  \throw pcl_spiral::FileError, Cancelled */
void addProgram(const PassJob& job, const pcl_spiral::Machine& machine, PassResult& result);
