// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Unequal distances of rows: each row is as far from the next as the surface between them allows.
 */
#pragma once

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** The extent of a piece of surface across the rows, mm. */
struct RowPatch {
  double low = 0.0, high = 0.0; ///< where it is
  double most = 0.0;            ///< largest distance allowed for the two rows beside it; infinite: any
  double area = 0.0;            ///< its weight in RowLevels::held_share
};

/** Where rows run. */
struct RowLevels {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::vector<double> levels;                     ///< ascending
  double smallest_step = 0.0, largest_step = 0.0; ///< between neighbours; 0 with one row
  double held_share = 0.0;                        ///< share of the area in patches that allow less than the floor; they get the floor
  std::size_t narrowest = none;                   ///< the one of these patches that allows least
};

/** The fewest rows over \p low to \p high such that no patch lies between two neighbours farther apart than it
 * allows, nor between the first or last row and the end next to it, where half as much is allowed. Patches that
 * allow less than \p floor, above 0, count as if they allowed the floor. All rows take up the same share of what is
 * allowed, as small as their number permits, so that none is a sliver. What patches allow is looked up in bins of an
 * eighth of the floor: time grows with patches and bins. Values that are not numbers, and patches outside the
 * extent, are ignored. */
RowLevels rowLevels(const std::vector<RowPatch>& patches, double low, double high, double floor);

} // namespace pcl_spiral
