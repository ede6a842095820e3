// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How much memory this process could still get.
 */
#pragma once

#include <cstddef>
#include <optional>

namespace pcl_spiral {

/** Bytes: the least of what the system has to give (MemAvailable of Linux) and what the process's own limits leave it
 *  (RLIMIT_AS). Nothing where that is not known. */
std::optional<double> availableMemory();

} // namespace pcl_spiral
