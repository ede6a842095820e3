// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Adds points to parts of a path.
 */
#pragma once

#include <pcl_spiral/spiral/loop_linking.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Add points, at most \p grain step-overs apart, beside the points of \p path marked in \p near. \p moves: the marks of the new
 *  points, without the first \p held step-overs; \p places: where the points of before are now, and the end. */
void densify(const std::vector<std::uint8_t>& near, double held, double grain, LinkedPath& path, std::vector<std::uint8_t>& moves,
             std::vector<std::size_t>& places);

} // namespace pcl_spiral
