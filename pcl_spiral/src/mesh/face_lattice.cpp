// SPDX-License-Identifier: BSD-3-Clause
#include "face_lattice.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

bool
isBefore(const Vector3d& a, const Vector3d& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/** Corner at which the longest side begins; of equally long sides, the one whose start comes first by its coordinates. */
int
longestSide(const Eigen::Matrix3d& corners)
{
  const auto squared = [&](int k) { return (corners.col((k + 1) % 3) - corners.col(k)).squaredNorm(); };
  int longest = 0;
  for (const int k : {1, 2})
    if (squared(k) > squared(longest) || (squared(k) == squared(longest) && isBefore(corners.col(k), corners.col(longest))))
      longest = k;
  return longest;
}

std::size_t
parts(double length, double step)
{
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length / step)));
}

} // namespace

FaceLattice::FaceLattice(const SurfaceMesh& mesh, std::size_t face, double step)
{
  const MeshPatch given = mesh.patch(face);
  const int first = longestSide(given.corners);
  for (int k = 0; k < 3; ++k) {
    patch_.corners.col(k) = given.corners.col((first + k) % 3);
    patch_.bows.col(k) = given.bows.col((first + k) % 3);
    patch_.normals.col(k) = given.normals.col((first + k) % 3);
  }
  const Vector3d side = patch_.corners.col(1) - patch_.corners.col(0), across = patch_.corners.col(2) - patch_.corners.col(0);
  const double length = side.norm();
  const double bow = std::sqrt(patch_.bows.colwise().squaredNorm().maxCoeff());
  step_ = step / (1.0 + bow / length); // the curved face is longer than the flat one
  apex_ = std::clamp(across.dot(side) / side.squaredNorm(), 0.0, 1.0);
  height_ = side.cross(across).norm() / length;
  columns_ = parts(length, step_);
}

double
FaceLattice::heightShare(double u) const
{
  return u < apex_ ? u / apex_ : (1.0 - u) / (1.0 - apex_);
}

std::size_t
FaceLattice::rows(std::size_t column) const
{
  return parts(height_ * heightShare((static_cast<double>(column) + 0.5) / static_cast<double>(columns_)), step_);
}

std::size_t
FaceLattice::count() const
{
  std::size_t sum = 0;
  for (std::size_t column = 0; column < columns_; ++column)
    sum += rows(column);
  return sum;
}

Vector3d
FaceLattice::place(std::size_t column, std::size_t row) const
{
  const double u = (static_cast<double>(column) + 0.5) / static_cast<double>(columns_);
  const double up = heightShare(u) * (static_cast<double>(row) + 0.5) / static_cast<double>(rows(column));
  const double along = std::max(0.0, u - up * apex_);
  return {std::max(0.0, 1.0 - along - up), along, up};
}

} // namespace pcl_spiral
