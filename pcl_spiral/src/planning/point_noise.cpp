// SPDX-License-Identifier: BSD-3-Clause
#include "planning/point_noise.h"

#include "search/neighbour_search.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl_spiral {
namespace {

constexpr int fitted = 9;                    // points of a fit: one of a grid and those about it
constexpr int freedom = fitted - 6;          // of what a quadric leaves
constexpr double lower_quartile = 0.6357;    // of a standard deviation by three degrees of freedom: sqrt(1.2125 / 3), chi squared
constexpr std::size_t most_looked_at = 2000; // fits

using Offsets = Eigen::Matrix<double, fitted, 3>;

/** Standard deviation of the points at \p offsets about the quadric through them. */
double
deviationAbout(Offsets offsets)
{
  offsets.rowwise() -= offsets.colwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(offsets.transpose() * offsets); // the least first
  offsets *= axes.eigenvectors();
  const auto u = offsets.col(1).array(), v = offsets.col(2).array();
  Eigen::Matrix<double, fitted, 6> terms;
  terms << Eigen::Matrix<double, fitted, 1>::Ones(), u, v, u * u, u * v, v * v;
  const Eigen::Matrix<double, fitted, 1> heights = offsets.col(0);
  return (heights - terms * terms.colPivHouseholderQr().solve(heights)).norm() / std::sqrt(static_cast<double>(freedom));
}

} // namespace

double
pointNoise(const std::vector<Eigen::Vector3f>& points)
{
  const std::size_t every = points.size() / most_looked_at + 1;
  const PointBlocks blocks(points);
  NeighbourSearch search(blocks, fitted);
  std::vector<double> deviations;
  for (std::size_t i = 0; i < blocks.size(); i += every) {
    const Eigen::Vector3d at = blocks.position(i);
    Box box;
    box.extend(blocks.point(i).data());
    search.setRun(box);
    const Neighbourhood& near = search.find(at);
    if (near.size < fitted)
      return 0.0;
    Offsets offsets;
    for (int j = 0; j < fitted; ++j)
      offsets.row(j) << near.x[j], near.y[j], near.z[j];
    deviations.push_back(deviationAbout(offsets));
  }
  if (deviations.empty())
    return 0.0;
  const auto quartile = deviations.begin() + static_cast<std::ptrdiff_t>(deviations.size() / 4);
  std::nth_element(deviations.begin(), quartile, deviations.end());
  return *quartile / lower_quartile;
}

} // namespace pcl_spiral
