// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/material_removal_engine.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl_spiral {

double
leastLength(const ReferenceSurface& reference, const std::vector<float>& steps, const std::vector<Eigen::Vector3f>& feet, double rim_share,
            double& area)
{
  const Triangulation& mesh = reference.graph().triangulation();
  std::vector<std::size_t> sizes;
  const std::vector<std::uint32_t> parts = mesh.parts(sizes);
  double passes = 0.0, step_sum = 0.0;
  std::size_t count = 0;
  area = 0.0;
  for (std::size_t t = 0; t < mesh.triangleCount(); ++t) {
    if (parts[t] != 0 && !reference.mesh()) // in a scan they may be clusters of outliers
      continue;
    const auto& [i, j, k] = mesh.triangle(t);
    if (!(steps[i] > 0.0f && steps[j] > 0.0f && steps[k] > 0.0f))
      continue;
    const double size = 0.5 * (feet[j] - feet[i]).cast<double>().cross((feet[k] - feet[i]).cast<double>()).norm();
    const double step = (static_cast<double>(steps[i]) + steps[j] + steps[k]) / 3.0;
    area += size;
    passes += size / step;
    step_sum += step;
    ++count;
  }
  if (count == 0)
    return 0.0;
  area += rim_share * reference.rimStrip();
  passes += rim_share * reference.rimStrip() * static_cast<double>(count) / step_sum;
  return passes + 0.5 * rim_share * reference.rimLength();
}

} // namespace pcl_spiral
