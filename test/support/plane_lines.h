// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Exact radial lines: straight in the plane z = 0, or meridians of a sphere. Lengths in mm.
 */
#pragma once

#include <pcl_spiral/core/bspline_fit.h>
#include <pcl_spiral/spiral/radial_line.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace pcl_spiral::test {

/** A line through 129 points; \p foot gives the point at a share of its length. */
inline RadialLine
lineThrough(const std::function<SurfaceFoot(double)>& foot)
{
  RadialLine line;
  Polyline points;
  for (int k = 0; k <= 128; ++k) {
    line.feet.push_back(foot(k / 128.0));
    line.feet.back().valid = true;
    points.push_back(line.feet.back().position);
  }
  BSplineFitOptions options;
  options.tolerance = 1e-7;
  options.min_spans = 16;
  const auto fitted = fitBSpline(points, options);
  if (!fitted)
    return {};
  line.curve = fitted->curve;
  return line;
}

/** Straight lines from \p start(i) to vertex i of the closed \p rim; every fourth is coarse, the lines between are finer. */
inline std::vector<RadialLine>
straightLines(const std::function<Eigen::Vector3d(std::size_t)>& start, const Polyline& rim, const std::vector<std::size_t>& corners = {})
{
  const std::vector<double> s = arcLengths(rim, true);
  std::vector<RadialLine> lines;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    lines.push_back(lineThrough([&](double t) {
      SurfaceFoot foot;
      foot.position = (1.0 - t) * start(i) + t * rim[i];
      return foot;
    }));
    lines[i].rim_share = lines[i].turn_share = s[i] / s.back();
    lines[i].corner = std::count(corners.begin(), corners.end(), i) > 0;
    lines[i].level = i % 4 == 0 ? 0 : i % 2 == 0 ? 1 : 2;
  }
  return lines;
}

/** \p count points of a circle about the z axis, from the x axis counter-clockwise. */
inline Polyline
ring(double radius, std::size_t count, double z = 0.0)
{
  Polyline points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return points;
}

/** \p per_side points on each side of a square of half side \p half, from the corner (half, -half) counter-clockwise. */
inline Polyline
squareRim(double half, std::size_t per_side)
{
  Polyline points;
  for (int side = 0; side < 4; ++side)
    for (std::size_t k = 0; k < per_side; ++k) {
      const double t = half * (2.0 * static_cast<double>(k) / static_cast<double>(per_side) - 1.0);
      const Eigen::Vector3d sides[] = {{half, t, 0}, {-t, half, 0}, {-half, -t, 0}, {t, -half, 0}};
      points.push_back(sides[side]);
    }
  return points;
}

} // namespace pcl_spiral::test
