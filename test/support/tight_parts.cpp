// SPDX-License-Identifier: BSD-3-Clause
#include "support/tight_parts.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace pcl_spiral::test {

double
ProfilePiece::length() const
{
  return radius > 0.0 ? radius * std::abs(b - a) : (end - begin).norm();
}

Eigen::Vector2d
ProfilePiece::at(double share) const
{
  const double angle = a + share * (b - a);
  return radius > 0.0 ? Eigen::Vector2d(centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)))
                      : Eigen::Vector2d(begin + share * (end - begin));
}

double
ProfilePiece::distance(const Eigen::Vector2d& p) const
{
  const double to_ends = std::min((p - at(0.0)).norm(), (p - at(1.0)).norm());
  if (radius > 0.0) {
    const Eigen::Vector2d d = p - centre;
    const double middle = 0.5 * (a + b), off = std::remainder(std::atan2(d.y(), d.x()) - middle, 2.0 * M_PI);
    return std::abs(off) <= 0.5 * std::abs(b - a) ? std::abs(d.norm() - radius) : to_ends;
  }
  const Eigen::Vector2d along = (end - begin).normalized(), d = p - begin;
  const double t = d.dot(along);
  return t >= 0.0 && t <= (end - begin).norm() ? std::abs(along.x() * d.y() - along.y() * d.x()) : to_ends;
}

ProfilePiece
segment(const Eigen::Vector2d& begin, const Eigen::Vector2d& end)
{
  return {begin, end, Eigen::Vector2d::Zero(), 0.0, 0.0, 0.0};
}

ProfilePiece
arc(const Eigen::Vector2d& centre, double radius, double a, double b)
{
  return {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), centre, radius, a, b};
}

double
TightPart::distance(const Eigen::Vector3d& p) const
{
  const Eigen::Vector2d flat(turned ? std::hypot(p.x(), p.y()) : p.x(), p.z());
  double least = 1e300;
  for (const ProfilePiece& piece : profile)
    least = std::min(least, piece.distance(flat));
  return least;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
TightPart::scan(double spacing, double noise, unsigned int seed) const
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shake(-0.3, 0.3);
  std::normal_distribution<double> normal(0.0, 1.0);
  auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const ProfilePiece& piece : profile) {
    const int steps = std::max(2, static_cast<int>(std::lround(piece.length() / spacing)));
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector2d middle = piece.at((i + 0.5) / steps);
      const int across = turned ? std::max(1, static_cast<int>(std::lround(2.0 * M_PI * middle.x() / spacing)))
                                : static_cast<int>(std::lround(2.0 * half_width / spacing));
      for (int k = 0; k < across; ++k) {
        const double share = (i + 0.5 + shake(random)) / steps, place = (k + 0.5 + shake(random)) / across;
        const Eigen::Vector2d before = piece.at(share - 1e-6), after = piece.at(share + 1e-6), way = (after - before).normalized();
        const Eigen::Vector2d p = piece.at(share) + noise * normal(random) * Eigen::Vector2d(-way.y(), way.x());
        const double angle = 2.0 * M_PI * place;
        const Eigen::Vector3d q = turned ? Eigen::Vector3d(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y())
                                         : Eigen::Vector3d(p.x(), half_width * (2.0 * place - 1.0), p.y());
        cloud->push_back({static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z())});
      }
    }
  }
  return cloud;
}

TightPart
valley(double slope, double fillet, double reach, double half_width)
{
  const double s = std::sin(slope), c = std::cos(slope);
  const Eigen::Vector2d foot(fillet * s, fillet * (1.0 - c)), top = foot + (reach - foot.x()) / c * Eigen::Vector2d(c, s);
  const auto mirrored = [](const Eigen::Vector2d& p) { return Eigen::Vector2d(-p.x(), p.y()); };
  return {
      {segment(mirrored(top), mirrored(foot)), arc({0.0, fillet}, fillet, -0.5 * M_PI - slope, -0.5 * M_PI + slope), segment(foot, top)},
      false,
      half_width};
}

double
valleyCentre(double slope, double fillet, double ball)
{
  return fillet + (ball - fillet) / std::cos(slope);
}

TightPart
pittedPlane(double pit, double rim, double reach)
{
  const Eigen::Vector2d ring(std::sqrt((pit + rim) * (pit + rim) - rim * rim), -rim);
  const double down = std::atan2(ring.y(), ring.x());
  return {{arc({0.0, 0.0}, pit, -0.5 * M_PI, down), arc(ring, rim, M_PI + down, 0.5 * M_PI), segment({ring.x(), 0.0}, {reach, 0.0})},
          true,
          0.0};
}

double
pitCentre(double pit, double rim, double ball)
{
  return -rim + std::sqrt((ball + rim) * (ball + rim) - (pit + rim) * (pit + rim) + rim * rim);
}

TightPart
ballOnPlane(double sphere, double fillet, double reach)
{
  const Eigen::Vector2d ring(std::sqrt((sphere + fillet) * (sphere + fillet) - fillet * fillet), fillet);
  const double up = std::atan2(ring.y(), ring.x());
  return {{arc({0.0, 0.0}, sphere, 0.5 * M_PI, up), arc(ring, fillet, -M_PI + up, -0.5 * M_PI), segment({ring.x(), 0.0}, {reach, 0.0})},
          true,
          0.0};
}

double
besideSphere(double sphere, double ball)
{
  return std::sqrt((sphere + ball) * (sphere + ball) - ball * ball);
}

} // namespace pcl_spiral::test
