// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Machine programs as paths to judge.
 */
#pragma once

#include "outputs.h"
#include "region_passes.h"

#include <memory>
#include <string>

/** Whether \p file is a program, by its extension: .ngc .nc .mpf .h .apt .cls */
bool isProgramFile(const std::string& file);

/** Reads \p passes of the program \p file and sets its path and its figures in \p judged: what the control will do, and what its tool
 *  would hit off the path. \p reference is made from the scan if it is null. \throw pcl_spiral::FileError, Cancelled */
void readJudgedProgram(const VerifyJob& job, const JudgedPart& part, const std::string& file, const JudgedPasses& passes,
                       std::shared_ptr<const pcl_spiral::ReferenceSurface>& reference, JudgedPath& judged);
