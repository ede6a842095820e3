// SPDX-License-Identifier: BSD-3-Clause
#include "core/band_system.h"
#include "core/tridiagonal.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace band_system_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

constexpr std::size_t longest = 200;

/** The same matrix as a band and in full. */
struct Matrices {
  BandSystem band;
  Eigen::MatrixXd full;
};

/** I + B^T B, where the rows of B have reach + 1 entries next to each other. */
Matrices
randomMatrices(std::size_t n, std::size_t reach, bool closed, std::mt19937& random)
{
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  Matrices result{BandSystem(n, reach, closed), Eigen::MatrixXd::Identity(n, n)};
  for (std::size_t i = 0; i < n; ++i)
    result.band.add(i, i, 1.0);
  for (std::size_t r = 0; r < n; ++r) {
    const std::size_t size = std::min(reach + 1, closed ? n : n - r);
    std::vector<double> factors(size);
    for (double& f : factors)
      f = value(random);
    for (std::size_t a = 0; a < size; ++a)
      for (std::size_t b = 0; b < size; ++b) {
        const std::size_t i = (r + a) % n, j = (r + b) % n;
        result.full(i, j) += factors[a] * factors[b];
        if (b <= a)
          result.band.add(i, j, factors[a] * factors[b]);
      }
  }
  return result;
}

Polyline
randomPoints(std::size_t n, std::mt19937& random)
{
  std::uniform_real_distribution<double> value(-10.0, 10.0);
  Polyline points(n);
  for (Vector3d& p : points)
    p = Vector3d(value(random), value(random), value(random));
  return points;
}

/** Rows are points. */
Eigen::MatrixXd
inFull(const Polyline& points)
{
  Eigen::MatrixXd matrix(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    matrix.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return matrix;
}

double
largestDifference(const Polyline& points, const Eigen::MatrixXd& expected)
{
  return (inFull(points) - expected).cwiseAbs().maxCoeff();
}

} // namespace

TEST(BandSystem, SolvesAsAFullMatrixDoes)
{
  std::mt19937 random(1);
  for (const bool closed : {false, true})
    for (std::size_t reach = 1; reach <= 3; ++reach)
      for (std::size_t n = 1; n <= longest; ++n) {
        const Matrices matrices = randomMatrices(n, reach, closed, random);
        const Polyline right = randomPoints(n, random);
        const Eigen::MatrixXd expected = matrices.full.fullPivLu().solve(inFull(right));
        Polyline quick = right, careful = right;
        std::vector<double> single(n);
        for (std::size_t i = 0; i < n; ++i)
          single[i] = right[i].y();
        BandSystem band = matrices.band;
        ASSERT_TRUE(band.solve(quick));
        EXPECT_LT(largestDifference(quick, expected), 1e-13) << n << ' ' << reach << ' ' << closed;
        band = matrices.band;
        ASSERT_TRUE(band.solveIfIndependent(careful, 1e-8));
        EXPECT_LT(largestDifference(careful, expected), 1e-13) << n << ' ' << reach << ' ' << closed;
        band = matrices.band;
        ASSERT_TRUE(band.solve(single));
        for (std::size_t i = 0; i < n; ++i)
          EXPECT_EQ(single[i], quick[i].y()) << "three right sides are each solved as one is";
      }
}

TEST(BandSystem, RefusesASingularMatrix)
{
  for (const bool closed : {false, true}) {
    const std::size_t n = 30;
    BandSystem band(n, 1, closed);
    for (std::size_t i = 0; i < (closed ? n : n - 1); ++i) { // squared differences: constants are in the null space
      band.add(i, i, 1.0);
      band.add((i + 1) % n, (i + 1) % n, 1.0);
      band.add((i + 1) % n, i, -1.0);
    }
    Polyline right(n, Vector3d::Ones());
    BandSystem copy = band;
    EXPECT_FALSE(copy.solveIfIndependent(right, 1e-8)) << closed;
    for (std::size_t i = 0; i < n; ++i)
      band.add(i, i, 1e-3);
    right.assign(n, Vector3d::Ones());
    EXPECT_TRUE(band.solveIfIndependent(right, 1e-8)) << closed;
    EXPECT_NEAR(right[n / 2].x(), 1000.0, 1e-6);
  }
}

TEST(BandSystem, GivesNoNumberWhereAPivotIsNotPositive)
{
  BandSystem band(3, 1, false);
  for (std::size_t i = 0; i < 3; ++i)
    band.add(i, i, i == 1 ? -1.0 : 1.0);
  std::vector<double> right{1.0, 2.0, 3.0};
  EXPECT_FALSE(band.solve(right));
  EXPECT_TRUE(std::all_of(right.begin(), right.end(), [](double x) { return std::isnan(x); }));
}

TEST(Tridiagonal, SolvesInnerPointsAsAFullMatrixDoes)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (std::size_t n = 3; n <= longest; ++n) {
    std::vector<TridiagonalRow> rows(n);
    Eigen::MatrixXd full = Eigen::MatrixXd::Identity(n, n);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      rows[i] = {value(random), 3.0, value(random)};
      full(i, i - 1) = rows[i].before;
      full(i, i) = rows[i].diagonal;
      full(i, i + 1) = rows[i].after;
    }
    const Polyline right = randomPoints(n, random);
    Polyline ends_zero = right;
    ends_zero.front() = ends_zero.back() = Vector3d::Zero();
    const Polyline x = solveInnerPoints(rows, right);
    EXPECT_LT(largestDifference(x, full.fullPivLu().solve(inFull(ends_zero))), 1e-13) << n;
  }
}

} // namespace band_system_test
