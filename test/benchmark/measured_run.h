// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The measurement of one process: the whole run of pcl_spiral, or the pair of PCL.
 */
#pragma once

#include "run_case.h"

#include <nlohmann/json.hpp>

namespace pcl_spiral::benchmarks {

using Json = nlohmann::ordered_json; // keeps the order of writing

/** From the PCD \p scan to the written CSV: seconds, stages with time and memory, peak memory, accuracy. It must be the
 *  first task of the process, so that the peak is its own. \throw std::runtime_error if no path is made */
Json measureOurs(const RunCase& run, const std::string& scan, const std::string& csv, int threads);

/** PCL's normals and boundary points of the same file; reading is not counted. */
Json measurePcl(const std::string& scan, int threads);

} // namespace pcl_spiral::benchmarks
