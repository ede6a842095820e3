// SPDX-License-Identifier: BSD-3-Clause
#include "tridiagonal.h"

namespace pcl_spiral {

Polyline
solveInnerPoints(const std::vector<TridiagonalRow>& rows, const Polyline& right)
{
  const std::size_t n = rows.size();
  Polyline x(n, Eigen::Vector3d::Zero());
  std::vector<double> after(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const TridiagonalRow& row = rows[i];
    const double pivot = row.diagonal - row.before * after[i - 1];
    after[i] = row.after / pivot;
    x[i] = (right[i] - row.before * x[i - 1]) / pivot;
  }
  for (std::size_t i = n < 3 ? 1 : n - 2; i-- > 1;)
    x[i] -= after[i] * x[i + 1];
  return x;
}

} // namespace pcl_spiral
