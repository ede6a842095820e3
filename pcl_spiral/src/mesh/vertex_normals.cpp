// SPDX-License-Identifier: BSD-3-Clause
#include "vertex_normals.h"

#include "fitted_normal.h"

#include "core/median.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** Weight of a face at its corner, between the edges a and b that leave it, times the face's unit normal. */
Vector3d
weighted(const Vector3d& a, const Vector3d& b, MeshNormals kind)
{
  const Vector3d cross = a.cross(b); // of length 2 area, or |a| |b| sin(angle)
  return kind == MeshNormals::AreaWeighted ? cross : Vector3d(cross / (a.squaredNorm() * b.squaredNorm()));
}

/** Sum over a sector's faces, of unit length. */
Vector3d
faceMean(const Triangulation& mesh, const std::vector<Vector3d>& positions, const CornerSectors& sectors, std::size_t s, MeshNormals kind)
{
  Vector3d sum = Vector3d::Zero();
  for (std::uint32_t k = sectors.begin[s]; k < sectors.begin[s + 1]; ++k) {
    const std::uint32_t h = sectors.corners[k];
    const Vector3d& p = positions[mesh.origin(h)];
    sum += weighted(positions[mesh.target(h)] - p, positions[mesh.origin(Triangulation::previous(h))] - p, kind);
  }
  return sum.normalized();
}

} // namespace

std::vector<Vector3d>
sectorNormals(const Triangulation& mesh, const std::vector<Vector3d>& positions, const CornerSectors& sectors, MeshNormals kind,
              std::vector<std::uint8_t>& fallback)
{
  const auto count = static_cast<std::int64_t>(sectors.count());
  std::vector<Vector3d> normals(sectors.count());
  fallback.assign(sectors.count(), 0);
#pragma omp parallel
  {
    NormalFit fit(mesh, positions, sectors);
#pragma omp for schedule(dynamic, 256)
    for (std::int64_t s = 0; s < count; ++s) {
      // Small faces, which noise turns most, weigh most by Max, so a fit starts from the mean by areas.
      normals[s] = faceMean(mesh, positions, sectors, s, kind == MeshNormals::Max ? kind : MeshNormals::AreaWeighted);
      if (kind != MeshNormals::Fitted || fit.refine(static_cast<std::uint32_t>(s), normals[s]))
        continue;
      fallback[s] = 1;
      normals[s] = faceMean(mesh, positions, sectors, s, MeshNormals::Max);
    }
  }
  return normals;
}

double
vertexNoise(const Triangulation& mesh, const std::vector<Vector3d>& positions, const CornerSectors& sectors)
{
  constexpr std::size_t most = 2000;
  const std::size_t stride = 1 + sectors.count() / most;
  NormalFit fit(mesh, positions, sectors);
  std::vector<double> noises;
  std::size_t tried = 0;
  for (std::size_t s = 0; s < sectors.count(); s += stride, ++tried) {
    Vector3d normal = faceMean(mesh, positions, sectors, s, MeshNormals::AreaWeighted);
    double noise = 0.0;
    if (fit.refine(static_cast<std::uint32_t>(s), normal, &noise))
      noises.push_back(noise);
  }
  if (2 * noises.size() < tried || noises.empty())
    return 0.0;
  return medianOf(std::move(noises));
}

} // namespace pcl_spiral
