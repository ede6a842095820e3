// SPDX-License-Identifier: BSD-3-Clause
#include "support/region.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral::test {

namespace {

constexpr std::size_t bucket_count = 1024;

/** Abscissa where the edge a-b meets the row v, for edges that cross it (half open). */
bool
crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double v, double& x)
{
  if ((a.y() > v) == (b.y() > v))
    return false;
  x = a.x() + (v - a.y()) * (b.x() - a.x()) / (b.y() - a.y());
  return true;
}

} // namespace

Region::Region(std::vector<PlaneLoop> loops) : loops_(std::move(loops)), buckets_(bucket_count)
{
  lower_ = upper_ = loops_.front().front();
  for (const PlaneLoop& loop : loops_)
    for (const Eigen::Vector2d& u : loop) {
      lower_ = lower_.cwiseMin(u);
      upper_ = upper_.cwiseMax(u);
    }
  const double height = upper_.y() - lower_.y();
  const auto slot_of = [&](double v) {
    const double at = (v - lower_.y()) / height * static_cast<double>(bucket_count);
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(bucket_count - 1)));
  };
  for (const PlaneLoop& loop : loops_)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Edge edge{loop[i], loop[(i + 1) % loop.size()]};
      const std::size_t last = slot_of(std::max(edge.a.y(), edge.b.y()));
      for (std::size_t s = slot_of(std::min(edge.a.y(), edge.b.y())); s <= last; ++s)
        buckets_[s].push_back(edge);
    }
}

const std::vector<Region::Edge>&
Region::bucket(double v) const
{
  const double at = (v - lower_.y()) / (upper_.y() - lower_.y()) * static_cast<double>(bucket_count);
  return buckets_[static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(bucket_count - 1)))];
}

bool
Region::contains(const Eigen::Vector2d& u) const
{
  if ((u.array() < lower_.array()).any() || (u.array() > upper_.array()).any())
    return false;
  bool inside = false;
  double x = 0.0;
  for (const Edge& edge : bucket(u.y()))
    if (crossing(edge.a, edge.b, u.y(), x) && x > u.x())
      inside = !inside;
  return inside;
}

std::vector<std::pair<double, double>>
Region::row(double v) const
{
  std::vector<double> at;
  double x = 0.0;
  for (const Edge& edge : bucket(v))
    if (crossing(edge.a, edge.b, v, x))
      at.push_back(x);
  std::sort(at.begin(), at.end());
  std::vector<std::pair<double, double>> intervals;
  for (std::size_t i = 0; i + 1 < at.size(); i += 2)
    intervals.emplace_back(at[i], at[i + 1]);
  return intervals;
}

double
Region::integrate(const std::function<double(const Eigen::Vector2d&)>& f, int rows) const
{
  static const std::array<double, 4> nodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  static const std::array<double, 4> weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
  const int pieces = 8;
  const double dv = (upper_.y() - lower_.y()) / rows;
  double sum = 0.0;
  for (int r = 0; r < rows; ++r) {
    const double v = lower_.y() + (r + 0.5) * dv;
    for (const auto& [from, to] : row(v)) {
      const double half = 0.5 * (to - from) / pieces;
      for (int p = 0; p < pieces; ++p) {
        const double middle = from + (2 * p + 1) * half;
        for (std::size_t i = 0; i < nodes.size(); ++i)
          sum += weights[i] * half * dv * (f({middle - half * nodes[i], v}) + f({middle + half * nodes[i], v}));
      }
    }
  }
  return sum;
}

PlaneLoop
circle(const Eigen::Vector2d& centre, double radius, std::size_t count)
{
  PlaneLoop loop = ellipse(radius, radius, count);
  for (Eigen::Vector2d& u : loop)
    u += centre;
  return loop;
}

PlaneLoop
ellipse(double a, double b, std::size_t count)
{
  PlaneLoop loop(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 2.0 * pi * static_cast<double>(i) / static_cast<double>(count);
    loop[i] = {a * std::cos(t), b * std::sin(t)};
  }
  return loop;
}

PlaneLoop
rectangle(double width, double height, const Eigen::Vector2d& centre)
{
  const double x = 0.5 * width, y = 0.5 * height;
  PlaneLoop loop{{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  for (Eigen::Vector2d& u : loop)
    u += centre;
  return loop;
}

PlaneLoop
ell(double size, double limb)
{
  const double s = 0.5 * size;
  return {{-s, -s}, {s, -s}, {s, -s + limb}, {-s + limb, -s + limb}, {-s + limb, s}, {-s, s}};
}

PlaneLoop
slot(double length, double width, std::size_t count)
{
  const double radius = 0.5 * width, half = 0.5 * length - radius;
  PlaneLoop loop;
  for (int end = 0; end < 2; ++end)
    for (std::size_t i = 0; i <= count / 2; ++i) {
      const double t = pi * (static_cast<double>(i) / static_cast<double>(count / 2) - 0.5 + end);
      loop.emplace_back(radius * std::cos(t) + (end == 0 ? half : -half), radius * std::sin(t));
    }
  return loop;
}

PlaneLoop
star(int tips, double outer, double inner)
{
  PlaneLoop loop;
  for (int i = 0; i < 2 * tips; ++i) {
    const double t = pi * i / tips, r = i % 2 == 0 ? outer : inner;
    loop.emplace_back(r * std::cos(t), r * std::sin(t));
  }
  return loop;
}

PlaneLoop
kidney(double a, double b, double c, std::size_t count)
{
  PlaneLoop loop = ellipse(a, b, count);
  for (Eigen::Vector2d& u : loop)
    u.y() += c * u.x() * u.x();
  return loop;
}

} // namespace pcl_spiral::test
