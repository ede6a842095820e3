// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_bends.h"

#include <pcl_spiral/core/impl/frame.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

namespace pcl_spiral {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/** The shape operator of a face, as a matrix in space: the least-squares symmetric one that takes each edge to the change of the
 *  normals along it. Source: Rusinkiewicz, Estimating curvatures and their derivatives on triangle meshes, 2004. */
Matrix3d
shapeOf(const SurfaceMesh& mesh, std::uint32_t t)
{
  const MeshPatch patch = mesh.patch(t);
  const Vector3d n = mesh.faceNormal(t);
  Vector3d e1, e2;
  tangentFrame(n, e1, e2);
  Eigen::Matrix<double, 6, 3> system; // unknown: the operator's entries 11, 12, 22 in (e1, e2)
  Eigen::Matrix<double, 6, 1> change;
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const Vector3d edge = patch.corners.col(next) - patch.corners.col(k), turn = patch.normals.col(next) - patch.normals.col(k);
    const double x = e1.dot(edge), y = e2.dot(edge);
    system.row(2 * k) << x, y, 0.0;
    system.row(2 * k + 1) << 0.0, x, y;
    change[2 * k] = e1.dot(turn);
    change[2 * k + 1] = e2.dot(turn);
  }
  const Vector3d s = system.colPivHouseholderQr().solve(change);
  return s[0] * e1 * e1.transpose() + s[1] * (e1 * e2.transpose() + e2 * e1.transpose()) + s[2] * e2 * e2.transpose();
}

SurfaceBend
bendOf(const Vector3d& normal, const Matrix3d& shape)
{
  Vector3d e1, e2;
  tangentFrame(normal, e1, e2);
  Eigen::Matrix2d flat;
  flat << e1.dot(shape * e1), e1.dot(shape * e2), e2.dot(shape * e1), e2.dot(shape * e2);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(0.5 * (flat + flat.transpose()));
  const Eigen::Vector2d d = solver.eigenvectors().col(1);
  return {normal, d.x() * e1 + d.y() * e2, solver.eigenvalues()[1], solver.eigenvalues()[0]};
}

} // namespace

std::vector<SurfaceBend>
meshBends(const SurfaceMesh& mesh)
{
  const auto faces = static_cast<std::int64_t>(mesh.faceCount());
  std::vector<Matrix3d> shapes(mesh.faceCount());
#pragma omp parallel for schedule(static)
  for (std::int64_t t = 0; t < faces; ++t)
    shapes[t] = mesh.faceArea(t) * shapeOf(mesh, static_cast<std::uint32_t>(t));
  std::vector<Matrix3d> sums(mesh.sectorCount(), Matrix3d::Zero());
  std::vector<double> areas(mesh.sectorCount(), 0.0);
  std::vector<SurfaceBend> bends(mesh.sectorCount());
  for (std::uint32_t h = 0; h < mesh.triangles().halfEdgeCount(); ++h) {
    sums[mesh.sector(h)] += shapes[h / 3];
    areas[mesh.sector(h)] += mesh.faceArea(h / 3);
    bends[mesh.sector(h)].normal = mesh.normal(h);
  }
#pragma omp parallel for schedule(static)
  for (std::int64_t s = 0; s < static_cast<std::int64_t>(bends.size()); ++s)
    bends[s] = bendOf(bends[s].normal, sums[s] / areas[s]);
  return bends;
}

} // namespace pcl_spiral
