// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The options of a run, in its report.
 */
#pragma once

#include <pcl_spiral/io/report_page.h>

#include <nlohmann/json_fwd.hpp>

namespace pcl_spiral {

/** A map that a program reads back with --config: the values as text, the outputs as a list. */
nlohmann::ordered_json optionsJson(const RunOptions& options);

} // namespace pcl_spiral
