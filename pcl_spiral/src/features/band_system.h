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
  : n_(unknowns), width_(closed ? 2 * reach : reach), closed_(closed), entries_(unknowns * (width_ + 1), 0.0)
  {
  }

  /** Add \p value to the entry (i, j) and to (j, i). */
  void
  add(std::size_t i, std::size_t j, double value)
  {
    std::size_t row = folded(i), column = folded(j);
    if (row < column)
      std::swap(row, column);
    entries_[row * (width_ + 1) + (row - column)] += value;
  }

  /** Solve for \p right, by Cholesky; the matrix is lost. */
  std::vector<double>
  solve(const std::vector<double>& right)
  {
    std::vector<double> x(n_);
    for (std::size_t i = 0; i < n_; ++i)
      x[folded(i)] = right[i];
    for (std::size_t i = 0; i < n_; ++i) {
      const std::size_t first = i > width_ ? i - width_ : 0;
      for (std::size_t j = first; j <= i; ++j) {
        double sum = at(i, j);
        for (std::size_t k = j > width_ && j - width_ > first ? j - width_ : first; k < j; ++k)
          sum -= at(i, k) * at(j, k);
        at(i, j) = i == j ? std::sqrt(sum) : sum / at(j, j);
      }
      for (std::size_t k = first; k < i; ++k)
        x[i] -= at(i, k) * x[k];
      x[i] /= at(i, i);
    }
    for (std::size_t i = n_; i-- > 0;) {
      x[i] /= at(i, i);
      for (std::size_t k = i > width_ ? i - width_ : 0; k < i; ++k)
        x[k] -= at(i, k) * x[i];
    }
    std::vector<double> result(n_);
    for (std::size_t i = 0; i < n_; ++i)
      result[i] = x[folded(i)];
    return result;
  }

private:
  std::size_t folded(std::size_t i) const { return !closed_ ? i : 2 * i < n_ ? 2 * i : 2 * (n_ - 1 - i) + 1; }
  double& at(std::size_t i, std::size_t j) { return entries_[i * (width_ + 1) + (i - j)]; }

  std::size_t n_, width_;
  bool closed_;
  std::vector<double> entries_;
};

} // namespace pcl_spiral
