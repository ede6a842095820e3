// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Parts that reports of passes share.
 */
#pragma once

#include "pass_job.h"
#include "pass_result.h"

#include <nlohmann/json.hpp>

#include <string>

nlohmann::ordered_json cutterOf(const PassJob& job);

/** Passes, locations, times, warnings and the machine's program. */
void addPasses(const PassResult& result, nlohmann::ordered_json& report);

/** \throw pcl_spiral::FileError */
void writeJSON(const std::string& file, const nlohmann::ordered_json& report);
