// SPDX-License-Identifier: BSD-3-Clause
#include "axis_line.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double grain = 0.05; // step-overs

FingerAxis
densified(const FingerAxis& axis)
{
  const std::vector<double> arcs = arcsOf(axis);
  if (axis.points.size() < 2 || arcs.back() <= 0.0)
    return axis;
  const auto count = static_cast<std::size_t>(arcs.back() / grain) + 2;
  FingerAxis dense;
  std::size_t i = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double u = arcs.back() * static_cast<double>(k) / static_cast<double>(count - 1);
    while (i + 2 < arcs.size() && arcs[i + 1] <= u)
      ++i;
    const double share = std::clamp((u - arcs[i]) / std::max(arcs[i + 1] - arcs[i], 1e-300), 0.0, 1.0);
    dense.points.push_back((1.0 - share) * axis.points[i] + share * axis.points[i + 1]);
    dense.metric.push_back(between(axis.metric[i], axis.metric[i + 1], share));
  }
  return dense;
}

} // namespace

std::vector<double>
arcsOf(const FingerAxis& axis)
{
  std::vector<double> arcs(axis.points.empty() ? 0 : 1, 0.0);
  for (std::size_t i = 1; i < axis.points.size(); ++i)
    arcs.push_back(arcs.back() + between(axis.metric[i - 1], axis.metric[i], 0.5).length(axis.points[i] - axis.points[i - 1]));
  return arcs;
}

FingerAxis
axisOver(const StepOverMesh& mesh, const std::vector<std::uint32_t>& nodes, int rounds)
{
  FingerAxis axis;
  for (const std::uint32_t v : nodes) {
    axis.points.push_back(mesh.positions[v]);
    axis.metric.push_back(mesh.metric[v]);
  }
  axis = densified(axis);
  for (int r = 0; r < rounds; ++r) {
    const Polyline old = axis.points;
    for (std::size_t i = 1; i + 1 < old.size(); ++i)
      axis.points[i] = 0.25 * old[i - 1] + 0.5 * old[i] + 0.25 * old[i + 1];
  }
  return axis;
}

FingerAxis
partOf(const FingerAxis& axis, double from, double to)
{
  const std::vector<double> arcs = arcsOf(axis);
  FingerAxis part;
  for (std::size_t i = 0; i < arcs.size(); ++i)
    if (arcs[i] >= from && arcs[i] <= to) {
      part.points.push_back(axis.points[i]);
      part.metric.push_back(axis.metric[i]);
    }
  if (part.points.empty()) {
    const double middle = std::clamp(0.5 * (from + to), 0.0, arcs.back());
    const auto at = static_cast<std::size_t>(std::lower_bound(arcs.begin(), arcs.end(), middle) - arcs.begin());
    part.points.push_back(axis.points[at]);
    part.metric.push_back(axis.metric[at]);
  }
  return part;
}

} // namespace pcl_spiral
