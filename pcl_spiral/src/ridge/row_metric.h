// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How close together rows over a ridge must lie. Private to ridge.
 */
#pragma once

#include <pcl_spiral/common/status.h>
#include <pcl_spiral/ridge/ridge_rows.h>

#include <vector>

namespace pcl_spiral {

/** Places of the rows, along the generator or the rail, so that neighbours are nowhere farther apart than set. */
Status rowPlaces(const RidgeSurface& surface, const RidgeRowSettings& settings, std::vector<double>& places);

} // namespace pcl_spiral
