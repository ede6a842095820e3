// SPDX-License-Identifier: BSD-3-Clause
#include "support/path_motion.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral::test {

namespace {} // namespace

double
lineLength(const Points& line)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += (line[i] - line[i - 1]).norm();
  return sum;
}

Points
atEqualSteps(const Points& line, double step)
{
  std::vector<double> s(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i)
    s[i] = s[i - 1] + (line[i] - line[i - 1]).norm();
  const auto pieces = static_cast<std::size_t>(std::max(1.0, std::floor(s.back() / step)));
  Points points;
  std::size_t i = 0;
  for (std::size_t k = 0; k <= pieces; ++k) {
    const double at = s.back() * static_cast<double>(k) / static_cast<double>(pieces);
    while (i + 2 < line.size() && s[i + 1] < at)
      ++i;
    const double span = s[i + 1] - s[i];
    const double f = span > 0.0 ? std::clamp((at - s[i]) / span, 0.0, 1.0) : 0.0;
    points.push_back((1.0 - f) * line[i] + f * line[i + 1]);
  }
  return points;
}

double
circleRadius(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
  const double twice_area = (b - a).cross(c - a).norm();
  const double sides = (b - a).norm() * (c - b).norm() * (c - a).norm();
  if (twice_area > 1e-12 * (b - a).norm() * (c - b).norm())
    return sides / (2.0 * twice_area);
  return (b - a).dot(c - b) < 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
}

TurningReport
turningRadii(const Points& line, double pitch)
{
  TurningReport f;
  f.least.value = f.smallest.value = std::numeric_limits<double>::infinity();
  const Points p = atEqualSteps(line, 0.06 * pitch);
  std::vector<std::pair<double, std::size_t>> radii;
  for (std::size_t i = 2; i + 2 < p.size(); ++i)
    radii.emplace_back(circleRadius(p[i - 2], p[i], p[i + 2]) / pitch, i);
  if (radii.empty())
    return f;
  const auto place = [&](const std::pair<double, std::size_t>& r) { return Place{r.first, p[r.second], 0.0, 0.0, r.second}; };
  const auto rank = radii.begin() + static_cast<std::ptrdiff_t>(0.001 * static_cast<double>(radii.size()));
  std::nth_element(radii.begin(), rank, radii.end());
  f.smallest = place(*rank);
  f.least = place(*std::min_element(radii.begin(), radii.end()));
  return f;
}

ReversalReport
reversals(const Points& line, double pitch)
{
  constexpr std::size_t half = 10; // steps of a tenth of a pitch to each side
  ReversalReport f;
  const Points p = atEqualSteps(line, 0.1 * pitch);
  std::size_t turned = 0;
  bool before = false;
  for (std::size_t i = half; i + half + 1 < p.size(); ++i) {
    const Eigen::Vector3d a = p[i - half + 1] - p[i - half], b = p[i + half + 1] - p[i + half];
    const double angle = in_degrees * std::atan2(a.cross(b).norm(), a.dot(b));
    const bool now = angle > 150.0;
    if (now && !before && f.count++ == 0)
      f.first = {angle, p[i], 0.0, 0.0, i};
    turned += now ? 1 : 0;
    before = now;
  }
  f.share = static_cast<double>(turned) / static_cast<double>(p.size());
  return f;
}

double
machineTime(const Points& line, double speed, double acceleration, double window)
{
  constexpr std::size_t w = 3;
  const Points p = atEqualSteps(line, window / w);
  const double step = lineLength(line) / static_cast<double>(p.size() - 1);
  const double sharpest = 0.1 * window;                 // otherwise a fold back onto itself takes infinite time
  std::vector<double> squares(p.size(), speed * speed); // of the speed
  for (std::size_t i = w; i + w < p.size(); ++i)
    squares[i] = std::min(squares[i], acceleration * std::max(sharpest, circleRadius(p[i - w], p[i], p[i + w])));
  squares.front() = squares.back() = 0.0;
  for (std::size_t i = 1; i < p.size(); ++i)
    squares[i] = std::min(squares[i], squares[i - 1] + 2.0 * acceleration * step);
  for (std::size_t i = p.size() - 1; i-- > 0;)
    squares[i] = std::min(squares[i], squares[i + 1] + 2.0 * acceleration * step);
  double time = 0.0;
  for (std::size_t i = 1; i < p.size(); ++i)
    time += 2.0 * step / (std::sqrt(squares[i - 1]) + std::sqrt(squares[i]));
  return time;
}

} // namespace pcl_spiral::test
