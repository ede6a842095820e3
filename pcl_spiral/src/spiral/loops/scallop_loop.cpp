// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/scallop_loop.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** The segment of \p loop at \p u, and the share along it. */
std::pair<std::size_t, double>
segmentAt(const ScallopLoop& loop, double u)
{
  const double arc = loop.wrapped(u);
  const auto after = std::upper_bound(loop.arcs.begin(), loop.arcs.end(), arc);
  const auto i = std::min(loop.points.size() - 1, static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after - loop.arcs.begin())) - 1);
  return {i, std::clamp((arc - loop.arcs[i]) / std::max(loop.arcs[i + 1] - loop.arcs[i], 1e-300), 0.0, 1.0)};
}

} // namespace

double
ScallopLoop::wrapped(double u) const
{
  const double l = length();
  const double w = u - l * std::floor(u / l);
  return w < l ? w : 0.0;
}

Eigen::Vector3d
ScallopLoop::at(double u) const
{
  const auto [i, share] = segmentAt(*this, u);
  return (1.0 - share) * points[i] + share * points[(i + 1) % points.size()];
}

StepOverMetric
ScallopLoop::metricAt(double u) const
{
  const auto [i, share] = segmentAt(*this, u);
  return between(metric[i], metric[(i + 1) % points.size()], share);
}

void
ScallopLoop::measure()
{
  arcs.assign(1, 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t j = (i + 1) % points.size();
    arcs.push_back(arcs.back() + between(metric[i], metric[j], 0.5).length(points[j] - points[i]));
  }
}

} // namespace pcl_spiral
