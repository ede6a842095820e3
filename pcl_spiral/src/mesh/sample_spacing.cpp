// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/mesh/mesh_sampling.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_spiral {

double
defaultSampleSpacing(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& chosen)
{
  constexpr double usual_points = 1e5, most_points = 5e5, points_a_square = 1.6; // of one spacing
  constexpr double sharpest_left_out = 1e-3;                                     // share of the area
  std::vector<std::pair<double, double>> radii;                                  // of curvature, and the area of the face
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.faceCount(); ++t) {
    if (!chosen.empty() && !chosen[t])
      continue;
    const MeshPatch patch = mesh.patch(t);
    double curvature = 0.0; // an edge of length d and bow b has the curvature 2 b / d^2
    for (int k = 0; k < 3; ++k)
      curvature =
          std::max(curvature, 2.0 * patch.bows.col(k).norm() / (patch.corners.col((k + 1) % 3) - patch.corners.col(k)).squaredNorm());
    area += mesh.faceArea(t);
    radii.emplace_back(curvature > 0.0 ? 1.0 / curvature : std::numeric_limits<double>::infinity(), mesh.faceArea(t));
  }
  std::sort(radii.begin(), radii.end());
  double below = 0.0, radius = std::numeric_limits<double>::infinity();
  for (const auto& [r, face] : radii)
    if ((below += face) > sharpest_left_out * area) {
      radius = r;
      break;
    }
  const double widest = std::sqrt(area * points_a_square / usual_points), closest = std::sqrt(area * points_a_square / most_points);
  return std::clamp(0.1 * std::pow(radius, 0.75), closest, widest);
}

} // namespace pcl_spiral
