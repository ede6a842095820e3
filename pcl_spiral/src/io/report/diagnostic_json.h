// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a run says, for scripts.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace pcl_spiral {

/** For each its id, text in \p words, places moved by \p shift, directions, numbers, names, and settings by their names in C++. */
nlohmann::ordered_json diagnosticsJson(const Diagnostics& diagnostics, const Vocabulary& words, const Eigen::Vector3d& shift);

} // namespace pcl_spiral
