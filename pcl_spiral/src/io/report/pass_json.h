// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Parts that reports of passes share. Private to io.
 */
#pragma once

#include <pcl_spiral/io/pass_report_writer.h>

#include <nlohmann/json.hpp>

#include <string>

namespace pcl_spiral {

nlohmann::ordered_json cutterJson(const CutterShape& cutter);

nlohmann::ordered_json placeJson(const Eigen::Vector3d& place);

/** Passes, locations, times, warnings and the machine's program. */
void addPasses(const RunFiles& files, const PassRun& run, const PassPlan& plan, nlohmann::ordered_json& report);

/** With two blanks a level. */
std::string jsonText(const nlohmann::ordered_json& report);

/** \throw FileError */
void writeText(const std::string& file, const std::string& text);

} // namespace pcl_spiral
