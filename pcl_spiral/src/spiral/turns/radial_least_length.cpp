// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/radial_least_length.h>

#include <pcl_spiral/core/impl/step_over_metric.h>
#include <pcl_spiral/core/polyline.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace pcl_spiral {
namespace {

StepOverMetric
metricAt(const SurfaceFoot& foot, const SpiralSettings& settings)
{
  return stepOverMetric(foot.normal, foot.direction1, foot.valid ? foot.curvature1 : 0.0, foot.valid ? foot.curvature2 : 0.0,
                        settings.tool_radius, settings.scallop_height);
}

double
areaOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  return 0.5 * (b - a).cross(c - a).norm();
}

/** Integral of dA / largest step-over between two lines. */
double
passesBetween(const RadialLine& one, const RadialLine& other, const SpiralSettings& settings)
{
  double passes = 0.0;
  for (std::size_t k = 0; k + 1 < std::min(one.feet.size(), other.feet.size()); ++k) {
    const SurfaceFoot &a = one.feet[k], &b = one.feet[k + 1], &c = other.feet[k + 1], &d = other.feet[k];
    StepOverMetric mean = metricAt(a, settings).times(0.25);
    for (const SurfaceFoot* foot : {&b, &c, &d})
      mean += metricAt(*foot, settings).times(0.25);
    passes += (areaOf(a.position, b.position, c.position) + areaOf(a.position, c.position, d.position)) / longestStepOver(mean);
  }
  return passes;
}

} // namespace

double
leastLength(const RadialLineSet& lines, const SpiralSettings& settings)
{
  const auto count = static_cast<std::int64_t>(lines.lines.size());
  std::vector<double> passes(lines.lines.size(), 0.0);
#pragma omp parallel for schedule(dynamic, 8)
  for (std::int64_t i = 0; i < count; ++i)
    passes[i] = passesBetween(lines.lines[i], lines.lines[(i + 1) % count], settings);
  const double all = std::accumulate(passes.begin(), passes.end(), 0.0);
  return all + 0.5 * (length(lines.rim, true) + (lines.inner.empty() ? 0.0 : length(lines.inner, true)));
}

} // namespace pcl_spiral
