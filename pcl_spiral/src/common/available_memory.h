// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How much memory this process could still get.
 */
#pragma once

#include <cstddef>
#include <optional>

namespace pcl_spiral {

/** Bytes: the smaller of what the system can give (MemAvailable of Linux) and what the limits of the process leave
 *  (RLIMIT_AS). Nothing if that is not known. */
std::optional<double> availableMemory();

} // namespace pcl_spiral
