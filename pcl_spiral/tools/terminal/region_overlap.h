// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether regions of a scan overlap.
 */
#pragma once

#include <array>
#include <string>
#include <vector>

/** The points of a region. */
struct RegionPoints {
  std::string name;
  std::vector<std::array<float, 3>> points;
};

/** \throw pcl_spiral::FileError if two regions of \p scan have points in common: they would be cut twice */
void requireApart(const std::string& scan, const std::vector<RegionPoints>& regions);
