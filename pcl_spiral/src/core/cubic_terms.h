// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Terms of a cubic polynomial of two variables. Private.
 */
#pragma once

#include <Eigen/Core>

namespace pcl_spiral {

constexpr int cubic_term_count = 10;

/** One row of a system for the coefficients of z = f(x, y); x and y of about 1. */
inline Eigen::Matrix<double, 1, cubic_term_count>
cubicTerms(double x, double y)
{
  Eigen::Matrix<double, 1, cubic_term_count> row;
  row << 1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
  return row;
}

} // namespace pcl_spiral
