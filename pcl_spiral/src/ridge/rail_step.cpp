// SPDX-License-Identifier: BSD-3-Clause
#include "rail_step.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/** Stations beside \p i; at the ends of an open rail \p i itself. */
std::pair<std::size_t, std::size_t>
besides(std::size_t i, std::size_t n, bool closed)
{
  return {i > 0 ? i - 1 : (closed ? n - 1 : 0), i + 1 < n ? i + 1 : (closed ? 0 : n - 1)};
}

/** Derivative by the length. */
Matrix
slopes(std::size_t n, double length, bool closed)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [before, after] = besides(i, n, closed);
    const double steps = before == i || after == i ? 1.0 : 2.0;
    entries.emplace_back(i, after, 1.0 / (steps * length));
    entries.emplace_back(i, before, -1.0 / (steps * length));
  }
  Matrix result(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/** How far each station is off the middle of its neighbours. */
Matrix
kinks(std::size_t n, bool closed)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [before, after] = besides(i, n, closed);
    if (before == i || after == i)
      continue;
    entries.emplace_back(i, before, 1.0);
    entries.emplace_back(i, i, -2.0);
    entries.emplace_back(i, after, 1.0);
  }
  Matrix result(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace

std::optional<std::size_t>
allShifts(const std::vector<SectionShift>& shifts, bool closed, std::vector<SectionShift>& all)
{
  const auto n = static_cast<std::ptrdiff_t>(shifts.size());
  const auto at = [&](std::ptrdiff_t i) -> const SectionShift& { return shifts[static_cast<std::size_t>((i + n) % n)]; };
  const auto nearest = [&](std::ptrdiff_t i, std::ptrdiff_t way) { // steps to the next that was found, n: none
    for (std::ptrdiff_t k = 0; k < n; ++k)
      if (const std::ptrdiff_t j = i + way * k; !closed && (j < 0 || j >= n))
        return n;
      else if (at(j).found)
        return k;
    return n;
  };
  all = shifts;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const std::ptrdiff_t before = nearest(i, -1), after = nearest(i, 1);
    if (3 * std::min(before, after) >= n)
      return static_cast<std::size_t>(i);
    const SectionShift &first = at(before < n ? i - before : i + after), &second = at(after < n ? i + after : i - before);
    const double t = before > 0 && after < n && before < n ? static_cast<double>(before) / static_cast<double>(before + after) : 0.0;
    all[static_cast<std::size_t>(i)].shift = (1.0 - t) * first.shift + t * second.shift;
    all[static_cast<std::size_t>(i)].roll = (1.0 - t) * first.roll + t * second.roll;
  }
  return std::nullopt;
}

Polyline
railSteps(const std::vector<SectionShift>& shifts, const std::vector<RidgeFrame>& frames, const Vector3d& reference, double length,
          bool closed)
{
  constexpr double stiffness = 1e-3; // keeps stations apart that the slopes do not tell apart
  const std::size_t n = shifts.size();
  const auto size = static_cast<Eigen::Index>(n);
  VectorXd right(size), factor(size);
  for (std::size_t i = 0; i < n; ++i) {
    right[static_cast<Eigen::Index>(i)] = shifts[i].shift.y();
    factor[static_cast<Eigen::Index>(i)] = frames[i].tangent.dot(reference) / frames[i].up.dot(reference);
  }
  VectorXd rolled = factor;
  for (std::size_t i = 0; i < n; ++i)
    rolled[static_cast<Eigen::Index>(i)] *= shifts[i].roll.y();
  const Matrix slope = slopes(n, length, closed), kink = kinks(n, closed);
  Matrix whole = Matrix(rolled.asDiagonal() * slope);
  for (Eigen::Index i = 0; i < size; ++i)
    whole.coeffRef(i, i) += 1.0;
  if (!closed)
    for (const Eigen::Index end : {Eigen::Index{0}, size - 1}) { // half by its own section, half carried on
      for (Eigen::Index k = 0; k < size; ++k)
        if (whole.coeff(end, k) != 0.0)
          whole.coeffRef(end, k) *= 0.5;
      whole.coeffRef(end, end) += 0.5;
      for (Eigen::Index k = 0; k < 3; ++k)
        whole.coeffRef(end, end == 0 ? k + 1 : end - k - 1) -= 0.5 * carry_on[static_cast<std::size_t>(k)];
      right[end] *= 0.5;
    }
  const Matrix normal = Matrix(whole.transpose() * whole) + stiffness * Matrix(kink.transpose() * kink);
  const Eigen::SimplicialLDLT<Matrix> solver(normal);
  const VectorXd across = solver.solve(VectorXd(whole.transpose() * right));
  const VectorXd turns = factor.cwiseProduct(slope * across);
  Polyline steps;
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    steps.emplace_back(0.0, across[k], shifts[i].shift.z() - turns[k] * shifts[i].roll.z());
  }
  return steps;
}

} // namespace pcl_spiral
