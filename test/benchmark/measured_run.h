// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What one process measures: our whole run, or PCL's pair.
 */
#pragma once

#include "run_case.h"

#include <nlohmann/json.hpp>

namespace pcl_spiral::benchmarks {

using Json = nlohmann::ordered_json; // keeps the order of writing

/** From the PCD \p scan to the written CSV: seconds, stages with time and memory, peak memory, accuracy. It has to be the
 *  first that the process does, for the peak to be its own. \throw std::runtime_error where no path is made */
Json measureOurs(const RunCase& run, const std::string& scan, const std::string& csv, int threads);

/** PCL's normals and boundary points of the same file, whose reading is not counted. */
Json measurePcl(const std::string& scan, int threads);

} // namespace pcl_spiral::benchmarks
