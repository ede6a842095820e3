// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How far single precision rounds coordinates. Private.
 */
#pragma once

namespace pcl_spiral {

constexpr double coordinate_rounding = 2.4e-7; ///< of the largest coordinate: two steps of single precision

} // namespace pcl_spiral
