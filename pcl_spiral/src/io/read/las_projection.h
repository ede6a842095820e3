// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The coordinate system of a LAS file.
 */
#pragma once

#include <string_view>

namespace pcl_spiral {

/** Kind of the coordinates that a LAS file names. */
enum class LasCoordinates {
  Unknown, ///< nothing is said
  Metric,  ///< projected or geocentric
  Degrees  ///< geographic: longitude and latitude
};

/** By the keys of GeoTIFF and the well-known text in the variable length records. \p bytes is a LAS file with a whole header of at least
 *  227 bytes; records that are cut off are not read. */
LasCoordinates lasCoordinates(std::string_view bytes);

} // namespace pcl_spiral
