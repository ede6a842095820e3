// SPDX-License-Identifier: BSD-3-Clause
#include "own_frame.h"

#include "pieces.h"

#include <Eigen/Eigenvalues>

namespace pcl_spiral {

std::vector<Eigen::Vector3f>
inOwnFrame(const std::vector<Eigen::Vector3f>& points)
{
  using Eigen::Array3d, Eigen::Matrix3d, Eigen::Vector3d;
  const std::size_t n = points.size();
  const Vector3d sum =
      sumOverPoints(n, Vector3d(Vector3d::Zero()), [&](std::uint32_t i, Vector3d& part) { part += points[i].cast<double>(); });
  const Vector3d mean = sum / static_cast<double>(n);
  const Matrix3d second = sumOverPoints(n, Matrix3d(Matrix3d::Zero()), [&](std::uint32_t i, Matrix3d& part) {
    const Vector3d d = points[i].cast<double>() - mean;
    part += d * d.transpose();
  });
  Matrix3d axes = Eigen::SelfAdjointEigenSolver<Matrix3d>(second).eigenvectors().rowwise().reverse();
  const Array3d third = sumOverPoints(n, Array3d(Array3d::Zero()), [&](std::uint32_t i, Array3d& part) {
    part += (axes.transpose() * (points[i].cast<double>() - mean)).array().cube();
  });
  for (int k = 0; k < 3; ++k)
    if (third[k] < 0.0)
      axes.col(k) *= -1.0;
  std::vector<Eigen::Vector3f> own(n);
  forPoints(n, [&](std::uint32_t i) { own[i] = (axes.transpose() * (points[i].cast<double>() - mean)).cast<float>(); });
  return own;
}

} // namespace pcl_spiral
