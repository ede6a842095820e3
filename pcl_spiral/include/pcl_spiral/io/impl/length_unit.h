// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Units of the numbers in a scan.
 */
#pragma once

namespace pcl_spiral {

/** Unit of the coordinates in a file; the library uses millimetres. */
enum class LengthUnit { Millimetre, Metre, Inch };

/** Millimetres in one \p unit. */
constexpr double
millimetres(LengthUnit unit)
{
  return unit == LengthUnit::Metre ? 1000.0 : unit == LengthUnit::Inch ? 25.4 : 1.0;
}

} // namespace pcl_spiral
