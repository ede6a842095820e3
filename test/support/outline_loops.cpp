// SPDX-License-Identifier: BSD-3-Clause
#include "support/outline_loops.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral::test {

namespace {

/** Points of a circle from one angle to another, both ends included. */
void
addArc(PlaneLoop& loop, const Eigen::Vector2d& centre, double radius, double from, double to, std::size_t count)
{
  for (std::size_t i = 0; i <= count; ++i) {
    const double t = from + (to - from) * static_cast<double>(i) / static_cast<double>(count);
    loop.push_back(centre + radius * Eigen::Vector2d(std::cos(t), std::sin(t)));
  }
}

} // namespace

PlaneLoop
superellipse(double a, double b, double power, std::size_t count)
{
  const auto rounded = [&](double c) { return std::copysign(std::pow(std::abs(c), 2.0 / power), c); };
  PlaneLoop loop = ellipse(1.0, 1.0, count);
  for (Eigen::Vector2d& u : loop)
    u = {a * rounded(u.x()), b * rounded(u.y())};
  return loop;
}

PlaneLoop
dumbbell(double radius, double apart, double neck, std::size_t count)
{
  const double open = std::asin(neck / radius);
  PlaneLoop loop;
  addArc(loop, {-apart, 0.0}, radius, open, 2.0 * pi - open, count / 2);
  addArc(loop, {apart, 0.0}, radius, pi + open, 3.0 * pi - open, count / 2);
  return loop;
}

PlaneLoop
cross(double size, double arm)
{
  const double s = 0.5 * size, a = 0.5 * arm;
  return {{-a, -s}, {a, -s}, {a, -a}, {s, -a}, {s, a}, {a, a}, {a, s}, {-a, s}, {-a, a}, {-s, a}, {-s, -a}, {-a, -a}};
}

PlaneLoop
smoothStar(int tips, double radius, double swing, std::size_t count)
{
  PlaneLoop loop = ellipse(1.0, 1.0, count);
  for (std::size_t i = 0; i < count; ++i)
    loop[i] *= radius + swing * std::cos(2.0 * pi * tips * static_cast<double>(i) / static_cast<double>(count));
  return loop;
}

PlaneLoop
uShape(double width, double height, double limb)
{
  const double x = 0.5 * width, y = 0.5 * height;
  return {{-x, -y}, {x, -y}, {x, y}, {x - limb, y}, {x - limb, -y + limb}, {-x + limb, -y + limb}, {-x + limb, y}, {-x, y}};
}

PlaneLoop
band(double radius, double width, double degrees, std::size_t count)
{
  const double half = 0.5 * degrees * pi / 180.0, w = 0.5 * width;
  const auto middle = [&](double t) { return Eigen::Vector2d(radius * std::cos(t), radius * std::sin(t)); };
  PlaneLoop loop;
  addArc(loop, {0.0, 0.0}, radius + w, -half, half, count / 3);
  addArc(loop, middle(half), w, half, half + pi, count / 6);
  addArc(loop, {0.0, 0.0}, radius - w, half, -half, count / 3);
  addArc(loop, middle(-half), w, pi - half, 2.0 * pi - half, count / 6);
  for (Eigen::Vector2d& u : loop)
    u.x() -= radius;
  return loop;
}

PlaneLoop
slitDisc(double radius, double width, std::size_t count)
{
  const double half = 0.5 * width, open = std::asin(half / radius);
  PlaneLoop loop;
  addArc(loop, {0.0, 0.0}, radius, open, 2.0 * pi - open, count);
  addArc(loop, {0.0, 0.0}, half, 1.5 * pi, 0.5 * pi, count / 16);
  return loop;
}

PlaneLoop
bent(const PlaneLoop& loop, double longest, const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& f)
{
  PlaneLoop result;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d edge = loop[(i + 1) % loop.size()] - loop[i];
    const int pieces = std::max(1, static_cast<int>(std::ceil(edge.norm() / longest)));
    for (int k = 0; k < pieces; ++k)
      result.push_back(f(loop[i] + edge * (static_cast<double>(k) / pieces)));
  }
  return result;
}

} // namespace pcl_spiral::test
