#include "vertex_normals.h"

#include "fitted_normal.h"

#include <Eigen/Geometry>

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

} // namespace

std::vector<Vector3d>
sectorNormals(const Triangulation& mesh, const std::vector<Vector3d>& positions, const CornerSectors& sectors, MeshNormals kind,
              std::vector<std::uint8_t>& fallback)
{
  std::vector<Vector3d> normals(sectors.count());
  fallback.assign(sectors.count(), 0);
#pragma omp parallel for schedule(static)
  for (std::int64_t s = 0; s < static_cast<std::int64_t>(sectors.count()); ++s) {
    Vector3d sum = Vector3d::Zero();
    for (std::uint32_t k = sectors.begin[s]; k < sectors.begin[s + 1]; ++k) {
      const std::uint32_t h = sectors.corners[k];
      const Vector3d& p = positions[mesh.origin(h)];
      sum += weighted(positions[mesh.target(h)] - p, positions[mesh.origin(Triangulation::previous(h))] - p, kind);
    }
    normals[s] = sum.normalized();
  }
  if (kind != MeshNormals::Fitted)
    return normals;
  std::vector<Vector3d> fitted(sectors.count());
#pragma omp parallel
  {
    NormalFit fit(mesh, positions, sectors);
#pragma omp for schedule(dynamic, 256)
    for (std::int64_t s = 0; s < static_cast<std::int64_t>(sectors.count()); ++s) {
      fitted[s] = normals[s];
      fallback[s] = !fit.refine(static_cast<std::uint32_t>(s), fitted[s]);
    }
  }
  return fitted;
}

} // namespace pcl_spiral
