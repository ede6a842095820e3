// SPDX-License-Identifier: BSD-3-Clause
// Calibration of the checker: exact peaks on plane, cylinder and sphere, and planted faults.
#include "support/removed_material.h"
#include "support/move_tree.h"
#include "support/passes.h"
#include "support/path_checks.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace removed_material_test {

using namespace pcl_spiral::test;

namespace {

constexpr double R = 10.0, h = 0.05, degree = 0.017453292519943295;

RemovalSettings
settings(std::size_t samples = 5000)
{
  RemovalSettings s;
  s.tool_radius = R;
  s.scallop_height = h;
  s.samples = samples;
  return s;
}

/** Passes along y on the plane at the exact step, over a square of side 60. */
CheckedPath
planePasses(const AnalyticSurface& plane, int missing = 99)
{
  const double step = exactStepOver(R, h, 0.0);
  std::vector<double> us;
  for (int i = -15; i <= 15; ++i)
    if (i != missing)
      us.push_back(i * step);
  return straightPasses(plane, us, 32.0, 2.0);
}

SurfacePtr
plane()
{
  return flat(Region({rectangle(58.0, 60.0)}));
}

/** Index of the contact nearest to a place. */
std::size_t
nearest(const CheckedPath& path, const Eigen::Vector3d& p)
{
  std::size_t best = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    if ((path.contacts[i] - p).norm() < (path.contacts[best] - p).norm())
      best = i;
  return best;
}

} // namespace

TEST(StepOver, MatchesThePublishedValues)
{
  EXPECT_NEAR(exactStepOver(10, 0.01, 1 / 1650.0), 0.89150, 5e-6);
  EXPECT_NEAR(exactStepOver(10, 0.05, 1 / 50.0), 1.82257, 5e-6);
  EXPECT_NEAR(exactStepOver(10, 0.1, 1 / 20.0), 2.29820, 5e-6);
  EXPECT_NEAR(exactStepOver(10, 0.05, -1 / 15.0), 3.46748, 5e-6);
  for (double kappa = 1e-3; kappa > 1e-14; kappa *= 0.3) // nearly flat, from both sides
    for (const double sign : {-1.0, 1.0}) {
      const double flat_step = exactStepOver(10, 0.05, 0.0);
      EXPECT_NEAR(exactStepOver(10, 0.05, sign * kappa) / flat_step, 1.0 - sign * 5.025 * kappa, 60 * kappa * kappa + 1e-9);
    }
}

TEST(MoveTree, AgreesWithTryingEveryMove)
{
  Random random(1);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 400; ++i)
    points.push_back({random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-3, 3)});
  const MoveTree tree(points);
  int met = 0;
  for (int k = 0; k < 2500; ++k) {
    const Eigen::Vector3d x{random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-9, 2)};
    const Eigen::Vector3d n = Eigen::Vector3d{random.normal(), random.normal(), random.normal()}.normalized();
    double first = 3.0, near = 1e9;
    const int pieces = k % 20 == 0 ? 2000 : 1;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      double enter = 0.0, leave = 0.0;
      if (capsuleInterval(x, n, points[i], points[i + 1], 0.7, enter, leave) && leave >= -0.5)
        first = std::min(first, std::max(enter, -0.5));
      for (int j = 0; j <= pieces; ++j)
        near = std::min(near, (x - points[i] - (points[i + 1] - points[i]) * j / pieces).norm());
    }
    const MoveTree::Entry entry = tree.entry(x, n, 0.7, 0.5, 3.0);
    EXPECT_DOUBLE_EQ(entry.t, first);
    met += entry.met && entry.t > -0.5 ? 1 : 0;
    EXPECT_LE(tree.nearest(x).first, near + 1e-12);
    if (pieces > 1)
      EXPECT_GE(tree.nearest(x).first, near - 0.015);
  }
  EXPECT_GT(met, 300);
}

TEST(MoveTree, TheIntervalIsWhereTheSegmentIsWithinTheRadius)
{
  Random random(2);
  const auto vec = [&](double r) { return Eigen::Vector3d(random.uniform(-r, r), random.uniform(-r, r), random.uniform(-r, r)); };
  for (int k = 0; k < 500; ++k) {
    const Eigen::Vector3d a = vec(2), b = k % 10 == 0 ? a : vec(2), x = vec(2), n = vec(1).normalized();
    const MoveTree one({a, b});
    double enter = 0.0, leave = 0.0;
    const bool met = capsuleInterval(x, n, a, b, 1.0, enter, leave);
    for (double t = -8.0; t <= 8.0; t += 0.01) {
      const double d = one.nearest(x + t * n).first;
      if (std::abs(d - 1.0) > 1e-9)
        ASSERT_EQ(d < 1.0, met && t > enter && t < leave) << k << ' ' << t;
    }
  }
}

TEST(RemovedMaterial, PeakOnThePlaneIsExact)
{
  const SurfacePtr surface = plane();
  const RemovalReport f = removedMaterial(*surface, planePasses(*surface), settings());
  EXPECT_NEAR(f.ridge.max.value / h, 1.0, 0.001);
  EXPECT_LE(f.ridge.max.value, h + 1e-9);
  EXPECT_NEAR(f.ridge.p50 / h, 1.0, 0.005);
  EXPECT_NEAR(f.stock.p50 / h, 0.25, 0.02); // stock grows with the square of the distance from the pass
  EXPECT_NEAR(f.gouge.value, 0.0, 1e-9);
  EXPECT_EQ(f.ridge.uncut_share, 0.0);
  EXPECT_NEAR(f.band, exactStepOver(R, h, 0.0), 1e-12);
}

TEST(RemovedMaterial, PeakOnTheCylinderIsExact)
{
  for (const double radius : {50.0, 15.0}) {
    const SurfacePtr surface = cylinder(radius, Region({rectangle(16.0, 40.0)}));
    const double angle = exactStepOver(R, h, 1.0 / radius) / radius;
    std::vector<double> us;
    for (int i = -8; i <= 8; ++i)
      us.push_back(radius * std::sin(i * angle));
    const RemovalReport f = removedMaterial(*surface, straightPasses(*surface, us, 25.0, 5.0), settings());
    EXPECT_NEAR(f.ridge.max.value / h, 1.0, 0.002) << radius;
    EXPECT_NEAR(f.ridge.p50 / h, 1.0, 0.005) << radius;
    // Straight moves link the passes across the cylinder: their chords cut in.
    EXPECT_NEAR(f.gouge.value, (radius + R) * (1.0 - std::cos(0.5 * angle)), 1e-6);
  }
}

TEST(RemovedMaterial, PeakOnTheSphereIsExactOutsideAndInside)
{
  for (const bool convex : {true, false}) {
    const double radius = 50.0, kappa = convex ? 1.0 / radius : -1.0 / radius;
    const SurfacePtr surface = convex ? ball(radius, Region({circle({0, 0}, 30.0)})) : bowl(radius, 30.0);
    const double angle = exactStepOver(R, h, kappa) / radius;
    std::vector<double> radii;
    for (double a = 0.25 * angle; a < std::asin(33.0 / radius); a += angle)
      radii.push_back(radius * std::sin(a));
    const CheckedPath path = circularPasses(*surface, radii, [](double r) { return 24 + static_cast<int>(25.0 * r); });
    const RemovalReport f = removedMaterial(*surface, path, settings());
    EXPECT_NEAR(f.ridge.max.value / h, 1.0, 0.005) << convex;
    EXPECT_NEAR(f.ridge.p50 / h, 1.0, 0.005) << convex;
    const double chord = (radius + R) * (1.0 - std::cos(0.5 * angle)); // of the links between circles
    EXPECT_NEAR(f.gouge.value, convex ? chord : 0.0, 1e-6) << convex;
  }
}

TEST(RemovedMaterial, ChordsAddTheirSagittaWhereTheFeedIsConcaveAndGougeWhereConvex)
{
  for (const bool convex : {true, false}) {
    const double radius = 50.0, e = 0.01, kappa = convex ? 1.0 / radius : -1.0 / radius;
    const SurfacePtr surface = convex ? ball(radius, Region({circle({0, 0}, 30.0)})) : bowl(radius, 30.0);
    const double angle = exactStepOver(R, h, kappa) / radius;
    std::vector<double> radii;
    for (double a = 0.25 * angle; a < std::asin(33.0 / radius); a += angle)
      radii.push_back(radius * std::sin(a));
    // On every circle, the chords of the centre's path leave the offset surface by e along the normal.
    const CheckedPath path = circularPasses(*surface, radii, [&](double r) {
      const double sine = r / radius, centre = (convex ? radius + R : radius - R) * sine;
      return std::max(24, static_cast<int>(std::lround(M_PI / std::acos(std::max(0.0, 1.0 - e / (centre * sine))))));
    });
    const RemovalReport f = removedMaterial(*surface, path, settings());
    if (convex)
      EXPECT_NEAR(f.gouge.value, e, 0.02 * e);
    else
      EXPECT_NEAR(f.ridge.max.value, h + e, 0.02 * h);
  }
}

TEST(RemovedMaterial, AMissingPassIsFound)
{
  const SurfacePtr surface = plane();
  const RemovalReport f = removedMaterial(*surface, planePasses(*surface, 5), settings());
  const double step = exactStepOver(R, h, 0.0);
  EXPECT_NEAR(f.ridge.max.value, R - std::sqrt(R * R - step * step), 1e-3 * h);
  EXPECT_NEAR(f.ridge.max.at.x(), 5.0 * step, 0.01);
  EXPECT_GT(f.ridge.p99, 2.0 * h);
}

TEST(RemovedMaterial, AFewMicrometresOfGougeAreFound)
{
  const SurfacePtr surface = plane();
  CheckedPath path = planePasses(*surface);
  const std::size_t at = nearest(path, {3.0, 7.0, 0.0});
  Eigen::Vector3d feed = (path.contacts[at + 1] - path.contacts[at]).normalized();
  const Eigen::Vector3d place = path.contacts[at];
  const std::vector<double> along{-0.51, -0.5, 0.5, 0.51}, depth{0.0, 0.005, 0.005, 0.0};
  path.contacts.erase(path.contacts.begin() + static_cast<std::ptrdiff_t>(at));
  path.normals.push_back(path.normals.back());
  path.normals.push_back(path.normals.back());
  path.normals.push_back(path.normals.back());
  path.turns.clear();
  for (std::size_t k = 4; k-- > 0;)
    path.contacts.insert(path.contacts.begin() + static_cast<std::ptrdiff_t>(at),
                         place + along[k] * feed - depth[k] * Eigen::Vector3d::UnitZ());
  const RemovalReport f = removedMaterial(*surface, path, settings(1000));
  EXPECT_NEAR(f.gouge.value, 0.005, 1e-6);
  EXPECT_LT((f.gouge.at - place).norm(), 0.51);
}

TEST(RemovedMaterial, OnePointOffIsFoundBySurfaceAndByStock)
{
  const SurfacePtr surface = plane();
  CheckedPath path = planePasses(*surface);
  const std::size_t at = nearest(path, {-8.0, 4.0, 0.0});
  path.contacts[at].z() += 0.02;
  const ToolpathReport p = checkPath(*surface, path, 1.0);
  EXPECT_NEAR(p.deviation.value, 0.02, 1e-9);
  EXPECT_EQ(p.deviation.index, at);
  // Where balls at (0, R + 0.02) and (step, R) meet.
  const double step = exactStepOver(R, h, 0.0);
  double lo = 0.0, hi = step;
  for (int i = 0; i < 60; ++i) {
    const double y = 0.5 * (lo + hi);
    const double raised = R + 0.02 - std::sqrt(R * R - y * y);
    const double flat_one = R - std::sqrt(R * R - (step - y) * (step - y));
    (raised < flat_one ? lo : hi) = y;
  }
  const double peak = R + 0.02 - std::sqrt(R * R - lo * lo);
  const RemovalReport f = removedMaterial(*surface, path, settings(1000));
  EXPECT_NEAR(f.ridge.max.value / peak, 1.0, 0.005);
  EXPECT_LT((f.ridge.max.at - path.contacts[at]).norm(), step);
}

TEST(RemovedMaterial, ATiltedNormalIsFound)
{
  const SurfacePtr surface = plane();
  CheckedPath path = planePasses(*surface);
  const std::size_t at = nearest(path, {0.0, -12.0, 0.0});
  path.normals[at] = Eigen::Vector3d(std::sin(5 * degree), 0.0, std::cos(5 * degree));
  const ToolpathReport p = checkPath(*surface, path, 1.0);
  EXPECT_NEAR(p.normal_error.value, 5.0, 1e-6);
  EXPECT_EQ(p.normal_error.index, at);
  const RemovalReport f = removedMaterial(*surface, path, settings(1000));
  EXPECT_NEAR(f.gouge.value, R * (1.0 - std::cos(5 * degree)), 1e-6);
  EXPECT_LT((f.gouge.at - path.contacts[at]).norm(), 1.0);
}

TEST(RemovedMaterial, AnUncutPatchIsCounted)
{
  const SurfacePtr surface = plane();
  CheckedPath all = planePasses(*surface), path;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all.contacts[i].x() < 0.0) {
      path.contacts.push_back(all.contacts[i]);
      path.normals.push_back(all.normals[i]);
    }
  const RemovalReport f = removedMaterial(*surface, path, settings());
  // From half the plane the ball reaches sqrt(2 R 20 h) beyond the last pass.
  const double last = -exactStepOver(R, h, 0.0), limit = 20 * h;
  const double reach = last + std::sqrt(2 * R * limit - limit * limit);
  EXPECT_NEAR(f.stock.uncut_share, (29.0 - f.band - reach) / (58.0 - 2 * f.band), 0.01);
}

TEST(PathChecks, CrossingsGapsAndTurnsAreFound)
{
  const SurfacePtr surface = plane();
  CheckedPath path = planePasses(*surface);
  EXPECT_TRUE(crossings(*surface, path).empty());
  const std::size_t at = nearest(path, {5.0, 5.0, 0.0});
  path.contacts[at].x() += 3.0; // over the next pass and back: crosses it twice
  const ToolpathReport p = checkPath(*surface, path, 1.0);
  EXPECT_EQ(p.crossings, 2u);
  EXPECT_LT((p.crossing.at - path.contacts[at]).norm(), 4.0);
  EXPECT_NEAR(p.gap.value, std::sqrt(4.0 + 9.0), 1e-9);
  EXPECT_NEAR(p.turning.value, 180.0 - 2.0 * std::atan2(2.0, 3.0) / degree, 1e-6);
  EXPECT_EQ(p.turning.index, at);
}

TEST(PathChecks, TheRimThatThePathMissesIsMeasured)
{
  const SurfacePtr surface = flat(Region({rectangle(100.0, 100.0)}));
  PassBuilder builder(*surface);
  for (const Eigen::Vector2d& u : {Eigen::Vector2d(-50, -50), Eigen::Vector2d(50, -50), Eigen::Vector2d(50, 47), Eigen::Vector2d(47, 50),
                                   Eigen::Vector2d(-52, 50), Eigen::Vector2d(-50, -50)})
    builder.add(u, 0.0);
  const ToolpathReport p = checkPath(*surface, builder.path(), 1.0);
  EXPECT_NEAR(p.rim_missed.value, 1.5 * std::sqrt(2.0), 1e-9); // the missing corner
  EXPECT_NEAR(p.beyond_rim.value, 2.0, 1e-9);
}

} // namespace removed_material_test
