// SPDX-License-Identifier: BSD-3-Clause
// Measured lines: any order, any place, and points that are not lines.
#include <pcl_spiral/ridge/ridge_surface.h>

#include "support/made_ridge.h"
#include "support/ridges.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ridge_lines_measured_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

Polyline
shuffled(Polyline points, std::uint64_t seed)
{
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
  return points;
}

void
refused(const Polyline& rail, const Polyline& generator, const std::string& words, const RidgeSettings& settings = {})
{
  RidgeSurface::ConstPtr surface;
  const Status status = RidgeSurface::make(rail, generator, settings, surface);
  EXPECT_FALSE(status.ok());
  EXPECT_NE(status.message().find(words), std::string::npos) << "'" << words << "' in: " << status.message();
}

/** Largest difference of places and normals, with \p motion applied to the first. */
double
difference(const RidgeSurface& a, const RidgeSurface& b, const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity())
{
  double most = std::abs(a.rail().length() - b.rail().length()) + std::abs(a.generator().length() - b.generator().length());
  for (int i = 0; i <= 50; ++i)
    for (int j = 0; j <= 10; ++j) {
      const double u = a.rail().length() * i / 50, v = a.generator().length() * j / 10;
      most = std::max(most, (motion * a.position(u, v) - b.position(u, v)).norm());
      most = std::max(most, (motion.linear() * a.normal(u, v) - b.normal(u, v)).norm());
    }
  return most;
}

const ExactRidge die = dieRidge();

} // namespace

TEST(RidgeLines, MayComeInAnyOrder)
{
  const Polyline rail = moved(die.railPoints(300), 0.02, 1), generator = moved(die.generatorPoints(0.37, 60), 0.02, 2);
  const auto surface = madeRidge(rail, generator);
  for (const std::uint64_t seed : {1, 2, 3})
    EXPECT_LT(difference(*surface, *madeRidge(shuffled(rail, seed), shuffled(generator, 10 + seed))), 1e-9);
  EXPECT_LT(difference(*surface, *madeRidge(Polyline(rail.rbegin(), rail.rend()), Polyline(generator.rbegin(), generator.rend()))), 1e-9);
  Polyline twice = rail;
  twice.insert(twice.end(), rail.begin(), rail.begin() + 50);
  EXPECT_LT(difference(*surface, *madeRidge(twice, generator)), 1e-9);
}

TEST(RidgeLines, MayLieAnywhereWithTheirReference)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::AngleAxisd(1.1, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  motion.translation() = Vector3d(120.0, -80.0, 45.0);
  Polyline rail = moved(die.railPoints(300), 0.02, 1), generator = moved(die.generatorPoints(0.37, 60), 0.02, 2);
  const auto surface = madeRidge(rail, generator);
  for (Polyline* line : {&rail, &generator})
    for (Vector3d& p : *line)
      p = motion * p;
  RidgeSettings settings;
  settings.reference = motion.linear() * Vector3d::UnitZ();
  EXPECT_LT(difference(*surface, *madeRidge(rail, generator, settings), motion), 1e-6);
}

TEST(RidgeLines, TheOtherSideIsUpWhereAsked)
{
  RidgeSettings settings;
  settings.flip = true;
  const auto up = madeRidge(die.railPoints(300), die.generatorPoints(0.37, 60));
  const auto down = madeRidge(die.railPoints(300), die.generatorPoints(0.37, 60), settings);
  const double v = 0.5 * up->generator().length();
  EXPECT_GT(up->normal(100.0, v).z(), 0.0);
  EXPECT_LT((up->normal(100.0, v) + down->normal(100.0, v)).norm(), 1e-3);
  EXPECT_LT((up->position(100.0, v) - down->position(100.0, v)).norm(), 1e-2);
}

TEST(RidgeLines, ThatAreNoneAreRefused)
{
  const Polyline rail = die.railPoints(200), generator = die.generatorPoints(0.37, 40);
  Polyline bad = rail;
  bad[7].y() = std::numeric_limits<double>::quiet_NaN();
  refused(bad, generator, "point 8 of the rail is not finite");
  refused({rail[0], rail[1], rail[2]}, generator, "the rail has 3 different points");
  refused(rail, {generator[0], generator[0], generator[1]}, "the generator has 2 different points");
  refused(Polyline(20001, rail[0]), generator, "the rail has 20001 points");
  bad = rail;
  bad.erase(bad.begin() + 80, bad.begin() + 100);
  refused(bad, generator, "the rail has a gap of ");
  bad = rail;
  for (int k = 1; k < 12; ++k)
    bad.push_back(rail[100] + k * Vector3d(0.0, 0.0, 3.0));
  refused(bad, generator, "the rail has a branch at (301");
  bad = rail; // turns by 90 degrees after the middle
  for (std::size_t i = 100; i < bad.size(); ++i)
    bad[i] = rail[99] + static_cast<double>(i - 99) * Vector3d(0.0, -3.0, 0.0);
  refused(bad, generator, "the rail has a corner of ");
  Polyline ring;
  for (int k = 0; k <= 36; ++k)
    ring.push_back(generator[0] + 5.0 * Vector3d(0.0, std::cos(k * M_PI / 18.0) - 1.0, std::sin(k * M_PI / 18.0)));
  refused(rail, ring, "defines no direction");
  Polyline far = generator;
  for (Vector3d& p : far)
    p.y() += 100.0;
  refused(rail, far, " mm from the rail");
  Polyline beyond = generator;
  for (Vector3d& p : beyond)
    p += Vector3d(-300.0, -40.0, 0.0);
  refused(rail, beyond, "beyond the end of the rail");
  refused(rail, rail, "the generator");
  RidgeSettings settings;
  settings.reference.setZero();
  refused(rail, generator, "has no direction", settings);
  settings = {};
  settings.measuring_error = -1.0;
  refused(rail, generator, "setMeasuringError", settings);
}

TEST(RidgeLines, ATiltedGeneratorIsSaid)
{
  const auto tilted = [](double degrees) {
    Polyline points = die.generatorPoints(0.37, 40);
    const Vector3d foot = die.rail(0.37);
    const Eigen::AngleAxisd turn(degrees * M_PI / 180.0, die.frame(0.37).col(2));
    for (Vector3d& p : points)
      p = foot + turn * (p - foot);
    return points;
  };
  EXPECT_TRUE(madeRidge(die.railPoints(300), tilted(1.0))->report().warnings.empty());
  const auto warned = madeRidge(die.railPoints(300), tilted(5.0));
  EXPECT_NEAR(warned->report().tilt, 5.0, 0.1);
  ASSERT_EQ(warned->report().warnings.size(), 1u);
  EXPECT_NE(warned->report().warnings[0].text().find("is tilted by"), std::string::npos);
  refused(die.railPoints(300), tilted(16.0), "is tilted by 16");
}

} // namespace ridge_lines_measured_test
