// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Tridiagonal systems of the inner points of a line. Private.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** One equation: before x[i-1] + diagonal x[i] + after x[i+1] = right[i]. */
struct TridiagonalRow {
  double before = 0.0, diagonal = 1.0, after = 0.0;
};

/** Solves the equations of all points but the first and the last, where x is 0. \p rows and \p right have one entry a point; those
 *  of the ends have no effect. By elimination without exchange of rows (Golub and Van Loan 2013, algorithm 4.3.6): the matrix
 *  must be definite, or have a dominant diagonal. It need not be symmetric. */
Polyline solveInnerPoints(const std::vector<TridiagonalRow>& rows, const Polyline& right);

} // namespace pcl_spiral
