// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Symmetric positive definite systems with few diagonals, of a run of unknowns open or closed. Private to features.
 */
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** A matrix in which unknowns couple only with those at most \p reach places away along a run. A closed run is folded
 *  flat (0, m-1, 1, m-2, ...), so that it has a band, twice as wide, too.
 */
class BandSystem {
public:
  BandSystem(std::size_t unknowns, std::size_t reach, bool closed)
  : n_(unknowns), width_(closed ? 2 * reach : reach), closed_(closed), entries_((unknowns + width_) * (width_ + 1), 0.0)
  {}

  /** Add \p value to the entry (i, j) and to (j, i). */
  void add(std::size_t i, std::size_t j, double value)
  {
    std::size_t row = folded(i), column = folded(j);
    if (row < column)
      std::swap(row, column);
    rowOf(row + width_)[width_ + column - row] += value;
  }

  /** Solve for \p right, by Cholesky; the matrix is lost. */
  std::vector<double> solve(const std::vector<double>& right)
  {
    std::vector<double> x(n_ + width_, 0.0);
    for (std::size_t i = 0; i < n_; ++i)
      x[width_ + folded(i)] = right[i];
    if (width_ == 3)
      solveBand<3>(x);
    else if (width_ == 6)
      solveBand<6>(x);
    else
      solveBand<0>(x);
    std::vector<double> result(n_);
    for (std::size_t i = 0; i < n_; ++i)
      result[i] = x[width_ + folded(i)];
    return result;
  }

private:
  std::size_t folded(std::size_t i) const { return !closed_ ? i : 2 * i < n_ ? 2 * i : 2 * (n_ - 1 - i) + 1; }
  double* rowOf(std::size_t i) { return entries_.data() + i * (width_ + 1); }

  /** The solution replaces \p x, which begins with width_ zeros, as entries_ do with rows. \p Width: of the band, known
   *  beforehand so that its loops are unrolled; 0 if it is not. */
  template <std::size_t Width>
  void solveBand(std::vector<double>& x)
  {
    const std::size_t w = Width > 0 ? Width : width_;
    std::vector<double> inverse(n_ + w, 0.0); // of the factor's diagonal
    for (std::size_t i = w; i < n_ + w; ++i) {
      double* const row = rowOf(i);
      double pivot = row[w], sum_right = x[i];
      for (std::size_t j = 0; j < w; ++j) {
        const double* const other = rowOf(i - w + j);
        double sum = row[j];
        for (std::size_t k = 0; k < j; ++k)
          sum -= row[k] * other[w - j + k];
        row[j] = sum * inverse[i - w + j];
        pivot -= row[j] * row[j];
        sum_right -= row[j] * x[i - w + j];
      }
      inverse[i] = 1.0 / std::sqrt(pivot);
      x[i] = sum_right * inverse[i];
    }
    for (std::size_t i = n_ + w; i-- > w;) {
      x[i] *= inverse[i];
      const double* const row = rowOf(i);
      for (std::size_t k = 0; k < w; ++k)
        x[i - w + k] -= row[k] * x[i];
    }
  }

  std::size_t n_, width_;
  bool closed_;
  std::vector<double> entries_; ///< row by row, from width_ columns before the diagonal up to it, after width_ empty rows
};

} // namespace pcl_spiral
