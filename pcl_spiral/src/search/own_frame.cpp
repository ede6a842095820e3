#include "own_frame.h"

#include <Eigen/Eigenvalues>

namespace pcl_spiral {

std::vector<Eigen::Vector3f>
inOwnFrame(const std::vector<Eigen::Vector3f>& points)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& p : points)
    mean += p.cast<double>();
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3d d = p.cast<double>() - mean;
    second += d * d.transpose();
  }
  Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(second).eigenvectors().rowwise().reverse();
  Eigen::Array3d third = Eigen::Array3d::Zero();
  for (const Eigen::Vector3f& p : points)
    third += (axes.transpose() * (p.cast<double>() - mean)).array().cube();
  for (int i = 0; i < 3; ++i)
    if (third[i] < 0.0)
      axes.col(i) *= -1.0;
  std::vector<Eigen::Vector3f> own;
  own.reserve(points.size());
  for (const Eigen::Vector3f& p : points)
    own.emplace_back((axes.transpose() * (p.cast<double>() - mean)).cast<float>());
  return own;
}

} // namespace pcl_spiral
