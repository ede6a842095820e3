// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The mesh of a run as a JSON object for the reports. Private to io.
 */
#pragma once

#include <pcl_spiral/io/report_writer.h>

#include <nlohmann/json.hpp>

namespace pcl_spiral {

/** Keys in the order of writing; each finding as a count, and the place of the first if there is one. */
nlohmann::ordered_json meshJson(const RunMesh& mesh);

} // namespace pcl_spiral
