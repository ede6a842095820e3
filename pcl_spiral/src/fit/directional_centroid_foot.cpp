// SPDX-License-Identifier: BSD-3-Clause
#include "local_fit.h"

#include <pcl_spiral/core/impl/frame.h>

#include <Eigen/LU>

#include <cmath>

namespace pcl_spiral {

SurfaceFoot
directionalCentroidFoot(const Eigen::Vector3d& query, const Neighbourhood& near, const std::vector<Eigen::Vector3f>& normals)
{
  SurfaceFoot foot;
  foot.position = query;
  const double h = 0.5 * std::sqrt(static_cast<double>(near.squared_distance[near.size - 1]));
  double whole = 0.0;
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero(), mean = Eigen::Vector3d::Zero();
  for (int j = 0; j < near.size; ++j) {
    const Eigen::Vector3d d(near.x[j], near.y[j], near.z[j]);
    const double weight = std::exp(-d.squaredNorm() / (h * h)); // (9)
    whole += weight;
    centroid += weight * d;                                   // (10)
    normal += weight * normals[near.index[j]].cast<double>(); // (8)
    mean += d / near.size;
  }
  if (!(whole > 0.0) || !(normal.norm() > 0.0))
    return foot;
  centroid /= whole;
  foot.normal = normal.normalized();
  foot.position = query + centroid.dot(foot.normal) * foot.normal; // (11)
  foot.overhang = overhang(near, mean - mean.dot(foot.normal) * foot.normal);
  // Curvatures from the change of the normals: least squares of n(d) - n = W d over the tangent plane.
  Eigen::Vector3d e1, e2;
  tangentFrame(foot.normal, e1, e2);
  Eigen::Matrix2d moment = Eigen::Matrix2d::Zero(), turning = Eigen::Matrix2d::Zero();
  double squares = 0.0;
  for (int j = 0; j < near.size; ++j) {
    const Eigen::Vector3d d = Eigen::Vector3d(near.x[j], near.y[j], near.z[j]) - (foot.position - query);
    const double weight = std::exp(-d.squaredNorm() / (h * h));
    const Eigen::Vector3d turn = normals[near.index[j]].cast<double>() - foot.normal;
    const Eigen::Vector2d p(d.dot(e1), d.dot(e2)), w(turn.dot(e1), turn.dot(e2));
    moment += weight * p * p.transpose();
    turning += weight * w * p.transpose();
    squares += weight * std::pow(d.dot(foot.normal), 2);
  }
  foot.residual = std::sqrt(squares / whole);
  if (!(moment.determinant() > 1e-6 * moment.trace() * moment.trace()))
    return foot;
  const Eigen::Matrix2d shape = turning * moment.inverse();
  const double k12 = 0.5 * (shape(0, 1) + shape(1, 0)), half = 0.5 * (shape(0, 0) - shape(1, 1));
  const double spread = std::hypot(half, k12), angle = spread > 0.0 ? 0.5 * std::atan2(k12, half) : 0.0;
  foot.curvature1 = 0.5 * shape.trace() + spread;
  foot.curvature2 = 0.5 * shape.trace() - spread;
  foot.direction1 = std::cos(angle) * e1 + std::sin(angle) * e2;
  foot.valid = true;
  return foot;
}

} // namespace pcl_spiral
