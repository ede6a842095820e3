/** \file
 *  Small symmetric systems. Private to surface.
 */
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace pcl_spiral {

/** Cholesky factors of a symmetric matrix of \p N rows, of which the lower triangle is read. The leading rows of the
 *  factor are the factor of the leading block: a fit of lower degree comes with it. */
template <int N>
class NormalEquations {
public:
  using Matrix = Eigen::Matrix<double, N, N>;

  explicit NormalEquations(const Matrix& matrix) : l_(matrix)
  {
    for (; rows_ < N; ++rows_) {
      const double whole = l_(rows_, rows_);
      for (int j = 0; j <= rows_; ++j) {
        double sum = l_(rows_, j);
        for (int k = 0; k < j; ++k)
          sum -= l_(rows_, k) * l_(j, k);
        if (j < rows_)
          l_(rows_, j) = sum / l_(j, j);
        else if (!(sum > 1e-6 * whole)) // the column hardly differs from the ones before it
          return;
        else
          l_(j, j) = std::sqrt(sum);
      }
    }
  }

  /** How many leading rows are determined. */
  int determined() const { return rows_; }

  /** Solution of the leading \p Rows equations. */
  template <int Rows>
  Eigen::Matrix<double, Rows, 1>
  solve(Eigen::Matrix<double, Rows, 1> b) const
  {
    for (int i = 0; i < Rows; ++i) {
      for (int k = 0; k < i; ++k)
        b[i] -= l_(i, k) * b[k];
      b[i] /= l_(i, i);
    }
    for (int i = Rows - 1; i >= 0; --i) {
      for (int k = i + 1; k < Rows; ++k)
        b[i] -= l_(k, i) * b[k];
      b[i] /= l_(i, i);
    }
    return b;
  }

private:
  Eigen::Matrix<double, N, N, Eigen::RowMajor> l_;
  int rows_ = 0;
};

} // namespace pcl_spiral
