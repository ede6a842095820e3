// SPDX-License-Identifier: BSD-3-Clause
#include "band_system.h"

#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

/** Sums from the outermost diagonal inwards; pivots are held as inverses. */
struct FastRounding {
  static std::size_t term(std::size_t k, std::size_t) { return k; }
  static double pivot(double square) { return 1.0 / std::sqrt(square); }
  template <typename Value>
  static void divide(Value& value, double pivot)
  {
    value *= pivot;
  }
};

/** Sums from the innermost diagonal outwards; quotients are rounded once. */
struct CarefulRounding {
  static std::size_t term(std::size_t k, std::size_t terms) { return terms - 1 - k; }
  static double pivot(double square) { return std::sqrt(square); }
  template <typename Value>
  static void divide(Value& value, double pivot)
  {
    value /= pivot;
  }
};

double
zero(double)
{
  return 0.0;
}

Eigen::Vector3d
zero(const Eigen::Vector3d&)
{
  return Eigen::Vector3d::Zero();
}

} // namespace

bool
BandSystem::solve(std::vector<double>& right)
{
  return solveFolded<FastRounding>(right, 0.0);
}

bool
BandSystem::solve(Polyline& right)
{
  return solveFolded<FastRounding>(right, 0.0);
}

bool
BandSystem::solveIfIndependent(Polyline& right, double least_pivot)
{
  return solveFolded<CarefulRounding>(right, least_pivot);
}

template <typename Rounding, typename Value>
bool
BandSystem::solveFolded(std::vector<Value>& right, double least_pivot)
{
  std::vector<Value> x(n_ + width_, zero(Value()));
  for (std::size_t i = 0; i < n_; ++i)
    x[width_ + folded(i)] = right[i];
  const bool solved = width_ == 3   ? solveBand<3, Rounding>(x, least_pivot)
                      : width_ == 6 ? solveBand<6, Rounding>(x, least_pivot)
                                    : solveBand<0, Rounding>(x, least_pivot);
  for (std::size_t i = 0; i < n_; ++i)
    right[i] = solved ? x[width_ + folded(i)] : Value(std::numeric_limits<double>::quiet_NaN() * x[width_ + folded(i)]);
  return solved;
}

/** The solution replaces \p x, which begins with width_ zeros, as entries_ do with rows. \p Width: of the band, known
 *  beforehand so that its loops are unrolled; 0 if it is not. */
template <std::size_t Width, typename Rounding, typename Value>
bool
BandSystem::solveBand(std::vector<Value>& x, double least_pivot)
{
  const std::size_t w = Width > 0 ? Width : width_;
  const auto rowOf = [&](std::size_t i) { return entries_.data() + i * (w + 1); };
  std::vector<double> pivots(n_ + w, 1.0);
  for (std::size_t i = w; i < n_ + w; ++i) {
    double* const row = rowOf(i);
    for (std::size_t j = 0; j < w; ++j) {
      const double* const other = rowOf(i - w + j);
      double sum = row[j];
      for (std::size_t n = 0; n < j; ++n) {
        const std::size_t k = Rounding::term(n, j);
        sum -= row[k] * other[w - j + k];
      }
      Rounding::divide(sum, pivots[i - w + j]);
      row[j] = sum;
    }
    double square = row[w];
    Value value = x[i];
    for (std::size_t n = 0; n < w; ++n) {
      const std::size_t k = Rounding::term(n, w);
      square -= row[k] * row[k];
      value -= row[k] * x[i - w + k];
    }
    if (!(square > least_pivot * row[w]))
      return false;
    pivots[i] = Rounding::pivot(square);
    Rounding::divide(value, pivots[i]);
    x[i] = value;
  }
  for (std::size_t i = n_ + w; i-- > w;) {
    Value value = x[i];
    Rounding::divide(value, pivots[i]);
    x[i] = value;
    const double* const row = rowOf(i);
    for (std::size_t k = 0; k < w; ++k)
      x[i - w + k] -= row[k] * value;
  }
  return true;
}

} // namespace pcl_spiral
