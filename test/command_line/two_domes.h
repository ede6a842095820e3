// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Two domes over a table with a tower between them, and what a path over them leaves, by brute force.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/machine/machine_program.h>

#include <Eigen/Core>
#include <gtest/gtest.h>
#include <pcl/point_cloud.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace two_domes {

using Eigen::Vector3d;

constexpr double sphere = 60.0, radius = 4.0, scallop = 0.05, table = -20.0; // mm

/** A cap of the sphere with its rim in the plane z = 0. */
struct Dome {
  double x, y, rim;
  Vector3d centre() const { return {x, y, -std::sqrt(sphere * sphere - rim * rim)}; }
  Vector3d at(double dx, double dy) const { return {x + dx, y + dy, centre().z() + std::sqrt(sphere * sphere - dx * dx - dy * dy)}; }
};

const Dome left{-75.0, 0.0, 24.0}, right{85.0, 10.0, 28.0};
constexpr double tower_x = 4.0, tower_y = 30.0, tower_z = 25.0; // higher than the domes and the rapid height together

/** Adds 5000 points of a dome. */
inline void
addDome(const Dome& dome, std::mt19937& random, std::vector<Vector3d>& points)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> noise(0.0, 0.002);
  for (int i = 0; i < 5000; ++i) {
    const double r = dome.rim * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
    points.push_back(dome.at(r * std::cos(angle), r * std::sin(angle)) + Vector3d(0.0, 0.0, noise(random)));
  }
}

/** Two domes over a table, and a tower between them. */
inline std::vector<Vector3d>
twoDomes()
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::normal_distribution<double> noise(0.0, 0.002);
  std::vector<Vector3d> points;
  for (const Dome& dome : {left, right})
    addDome(dome, random, points);
  for (int i = 0; i < 12000; ++i) {
    const Vector3d p(140.0 * unit(random), 70.0 * unit(random), table + noise(random));
    const auto under = [&](const Dome& dome) { return std::hypot(p.x() - dome.x, p.y() - dome.y) < dome.rim; };
    if (!under(left) && !under(right) && (std::abs(p.x()) > tower_x || std::abs(p.y()) > tower_y))
      points.push_back(p);
  }
  for (int i = 0; i < 1200; ++i)
    points.emplace_back(tower_x * unit(random), tower_y * unit(random), tower_z + noise(random));
  return points;
}

using Path = pcl::PointCloud<pcl_spiral::ToolpathPoint>;

/** The path points of one pass. */
inline Path
passOf(const Path& path, std::size_t pass)
{
  std::vector<std::size_t> begins = pcl_spiral::passBegins(path);
  begins.insert(begins.begin(), 0);
  begins.push_back(path.size());
  Path own;
  for (std::size_t i = begins[pass]; i < begins[pass + 1]; ++i)
    own.push_back(path[i]);
  return own;
}

/** Places of the ball's centre, close together. */
inline std::vector<Vector3d>
centres(const Path& pass)
{
  std::vector<Vector3d> all;
  for (std::size_t i = 0; i < pass.size(); ++i) {
    const auto at = [&](std::size_t k) {
      return Vector3d(pass[k].getVector3fMap().cast<double>() + radius * pass[k].getNormalVector3fMap().cast<double>());
    };
    const Vector3d from = at(i), to = at(std::min(i + 1, pass.size() - 1));
    for (int k = 0; k < 10; ++k)
      all.push_back(from + (to - from) * (k / 10.0));
  }
  return all;
}

/** The ball rolls on the dome, and leaves no more than twice the scallop height where \p inside holds. */
template <typename Inside>
void
expectCut(const Path& pass, const Dome& dome, Inside inside)
{
  const std::vector<Vector3d> way = centres(pass);
  ASSERT_GT(way.size(), 3000U);
  for (const Vector3d& c : way)
    ASSERT_NEAR((c - dome.centre()).norm(), sphere + radius, 0.03) << c.transpose();
  int counted = 0;
  for (double x = -dome.rim; x <= dome.rim; x += 1.7)
    for (double y = -dome.rim; y <= dome.rim; y += 1.7) {
      if (std::hypot(x, y) > dome.rim - 2.0 || !inside(dome.x + x, dome.y + y))
        continue;
      ++counted;
      const Vector3d p = dome.at(x, y);
      double least = std::numeric_limits<double>::max();
      for (const Vector3d& c : way)
        least = std::min(least, (c - p).norm() - radius);
      EXPECT_LT(least, 1.5 * scallop) << "not cut: " << p.transpose();
      EXPECT_GT(least, -0.03) << "gouged: " << p.transpose();
    }
  EXPECT_GT(counted, 150);
}

/** How deep the deepest of \p points is in the cutter and its shank on the moves of \p program that do not cut. */
inline double
deepestInLinks(const pcl_spiral::MachineProgram& program, std::size_t first, std::size_t end, const std::vector<Vector3d>& points)
{
  constexpr double shank = 300.0; // mm
  double deepest = 0.0;
  for (std::size_t i = std::max<std::size_t>(first, 1); i < end; ++i) {
    const pcl_spiral::ProgramBlock &from = program.blocks[i - 1], &to = program.blocks[i];
    const int pieces = 1 + static_cast<int>((to.tip - from.tip).norm() / 0.5);
    for (int k = 0; k <= pieces; ++k) {
      const double share = static_cast<double>(k) / pieces;
      const Vector3d axis = (from.axis + (to.axis - from.axis) * share).normalized();
      const Vector3d ball = from.tip + (to.tip - from.tip) * share + radius * axis;
      for (const Vector3d& p : points) {
        const double along = std::clamp((p - ball).dot(axis), 0.0, shank);
        deepest = std::max(deepest, radius - (p - ball - along * axis).norm());
      }
    }
  }
  return deepest;
}

} // namespace two_domes
