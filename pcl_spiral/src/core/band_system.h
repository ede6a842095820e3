// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Symmetric positive definite systems with few diagonals, of a run of unknowns open or closed. Private.
 */
#pragma once

#include <pcl_spiral/core/polyline.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace pcl_spiral {

/** A matrix in which unknowns couple only with those at most \p reach places away along a run. A closed run is folded
 *  flat (0, m-1, 1, m-2, ...), so that it has a band, twice as wide, too. Solved by Cholesky (Golub and Van Loan 2013,
 *  section 4.3.5). A solution takes the place of the right side, and the matrix is lost.
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
    entries_[(row + width_) * (width_ + 1) + width_ + column - row] += value;
  }

  /** For matrices known to be positive definite: multiplies by the pivots' inverses, which is fast. False if one is not; the
   *  solution is then not a number. */
  bool solve(std::vector<double>& right);
  bool solve(Polyline& right); ///< The same for three right sides at once.

  /** Divides by the pivots, which rounds less. False, too, if the square of one is not above \p least_pivot times the entry of
   *  the diagonal: unknowns depend on one another. */
  bool solveIfIndependent(Polyline& right, double least_pivot);

private:
  std::size_t folded(std::size_t i) const { return !closed_ ? i : 2 * i < n_ ? 2 * i : 2 * (n_ - 1 - i) + 1; }
  template <typename Rounding, typename Value>
  bool solveFolded(std::vector<Value>& right, double least_pivot);
  template <std::size_t Width, typename Rounding, typename Value>
  bool solveBand(std::vector<Value>& x, double least_pivot);

  std::size_t n_, width_;
  bool closed_;
  std::vector<double> entries_; ///< row by row, from width_ columns before the diagonal up to it, after width_ empty rows
};

} // namespace pcl_spiral
