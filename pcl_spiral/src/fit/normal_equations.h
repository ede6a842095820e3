// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Small symmetric systems. Private.
 */
#pragma once

#include <Eigen/Core>

#include <utility>

namespace pcl_spiral {

template <typename Body, int... I>
inline __attribute__((always_inline)) void
forEachOf(Body&& body, std::integer_sequence<int, I...>)
{
  (body(std::integral_constant<int, I>()), ...);
}

/** Call \p body with the constants 0 .. N - 1: a loop that the compiler unrolls, also inside another. */
template <int N, typename Body>
inline __attribute__((always_inline)) void
unrolled(Body&& body)
{
  forEachOf(body, std::make_integer_sequence<int, N>());
}

/** Factors L D L' of a symmetric matrix of \p N rows, of which the lower triangle is read. The leading rows of the
 *  factors are the factors of the leading block, so they also give a fit of lower degree. */
template <int N>
class NormalEquations {
public:
  using Matrix = Eigen::Matrix<double, N, N>;

  explicit NormalEquations(const Matrix& matrix)
  {
    double whole[N][N]; // L D
    unrolled<N>([&](auto row) {
      constexpr int i = row;
      unrolled<i>([&](auto column) {
        constexpr int j = column;
        double sum = matrix(i, j);
        unrolled<j>([&](auto k) { sum -= whole[i][k] * l_[j][k]; });
        whole[i][j] = sum;
        l_[i][j] = sum * inverse_[j];
      });
      double pivot = matrix(i, i);
      unrolled<i>([&](auto k) { pivot -= whole[i][k] * l_[i][k]; });
      // Too small: the column hardly differs from those before it.
      if (rows_ == i && pivot > 1e-6 * matrix(i, i))
        rows_ = i + 1;
      inverse_[i] = 1.0 / pivot;
    });
  }

  /** How many leading rows are determined. */
  int determined() const { return rows_; }

  /** Solution of the leading \p Rows equations. */
  template <int Rows>
  Eigen::Matrix<double, Rows, 1> solve(Eigen::Matrix<double, Rows, 1> b) const
  {
    unrolled<Rows>([&](auto i) { unrolled<i>([&](auto k) { b[i] -= l_[i][k] * b[k]; }); });
    unrolled<Rows>([&](auto i) { b[i] *= inverse_[i]; });
    unrolled<Rows>([&](auto from_end) {
      constexpr int i = Rows - 1 - from_end;
      unrolled<Rows - 1 - i>([&](auto k) { b[i] -= l_[i + 1 + k][i] * b[i + 1 + k]; });
    });
    return b;
  }

private:
  double l_[N][N]; ///< below the diagonal
  double inverse_[N];
  int rows_ = 0;
};

} // namespace pcl_spiral
