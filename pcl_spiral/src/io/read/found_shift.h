// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A round place near points with large coordinates, such as map coordinates.
 */
#pragma once

#include "number_column.h"

#include <pcl_spiral/io/cloud_reader.h>

#include <Eigen/Core>

namespace pcl_spiral {

constexpr double noticed_rounding = 0.001; ///< mm; a fifth of the usual chord error

/** Largest rounding of a coordinate \p value to single precision, mm. */
double floatRounding(double value);

/** A place near the columns x y z, mm, which are scaled and shifted by \p options: rounded to a power of ten that is at least as large as
 *  the part. A coordinate is 0 if rounding does not matter there, or if the points are about as far spread as they are from 0. */
Eigen::Vector3d foundShift(const PointColumns& columns, const ReadOptions& options);

} // namespace pcl_spiral
