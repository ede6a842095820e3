// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The options of a run, in its report.
 */
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** Options of a program by name, with their values as given; "output" once for each file. */
using RunOptions = std::vector<std::pair<std::string, std::string>>;

/** A map that a program reads back with --config: the values as text, the outputs as a list. */
nlohmann::ordered_json optionsJson(const RunOptions& options);

} // namespace pcl_spiral
