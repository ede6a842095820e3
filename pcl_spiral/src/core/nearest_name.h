// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a misspelt name may mean.
 */
#pragma once

#include <string>
#include <vector>

namespace pcl_spiral {

/** The first of \p names that is nearest to \p name, or begins with it; empty if none is similar. */
std::string nearestName(const std::string& name, const std::vector<std::string>& names);

} // namespace pcl_spiral
