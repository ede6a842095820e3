// SPDX-License-Identifier: BSD-3-Clause
// Ridges of measured lines against exact ridges.
#include <pcl_spiral/ridge/ridge_surface.h>

#include "support/made_ridge.h"
#include "support/ridges.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridge_surface_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double degree = M_PI / 180.0;

std::string
refusal(const Polyline& rail, const Polyline& generator, const RidgeSettings& settings = {})
{
  RidgeSurface::ConstPtr surface;
  const Status status = RidgeSurface::make(rail, generator, settings, surface);
  EXPECT_FALSE(status.ok());
  EXPECT_FALSE(surface);
  return status.message();
}

/** Root mean square and largest distance of a grid of places from the exact ridge. */
struct Off {
  double rms = 0.0, largest = 0.0;
};

Off
offOf(const RidgeSurface& surface, const ExactRidge& exact)
{
  constexpr int along = 60, across = 12;
  Off off;
  for (int i = 0; i <= along; ++i)
    for (int j = 0; j <= across; ++j) {
      const Vector3d p = surface.position(surface.rail().length() * i / along, surface.generator().length() * j / across);
      double t = static_cast<double>(i) / along, w = static_cast<double>(j) / across;
      const double near = exact.distance(p, t, w), d = near < 0.2 ? near : exact.distance(p);
      off.rms += d * d / ((along + 1) * (across + 1));
      off.largest = std::max(off.largest, d);
    }
  off.rms = std::sqrt(off.rms);
  return off;
}

Vector3d
arch(double w)
{
  return {0.0, 24.0 * w, 16.0 * w * (1.0 - w)};
}

} // namespace

TEST(RidgeSurface, OfAStraightRailIsThePrism)
{
  ExactRidge exact = dieRidge();
  exact.rail = [](double t) { return Vector3d(3.0 + 200.0 * t, 1.0 + 40.0 * t, 30.0 * t); };
  const Polyline generator = exact.generatorPoints(0.3, 60);
  const auto surface = madeRidge(exact.railPoints(101), generator);
  ASSERT_TRUE(surface);
  const Vector3d along = surface->rail().tangent(0.0);
  for (double u = 0.0; u <= surface->rail().length(); u += 7.3)
    for (double v = 0.0; v <= surface->generator().length(); v += 1.1) {
      const Vector3d shift = (u - surface->report().meeting) * along;
      EXPECT_NEAR((surface->position(u, v) - surface->position(surface->report().meeting, v) - shift).norm(), 0.0, 1e-9);
      for (const RidgeNormals normals : {RidgeNormals::True, RidgeNormals::InNormalPlane}) {
        const Vector3d n = surface->normal(u, v, normals);
        EXPECT_NEAR(n.dot(along), 0.0, 1e-9);
        EXPECT_NEAR(n.dot(surface->alongGenerator(u, v)), 0.0, 1e-9);
        EXPECT_NEAR(n.norm(), 1.0, 1e-9);
      }
    }
  EXPECT_LT(offOf(*surface, exact).largest, 1e-4);
}

TEST(RidgeSurface, OfARingIsATorusWithoutASeam)
{
  const ExactRidge exact = ringRidge(50.0, arch, -15.0 * degree);
  Polyline rail = exact.railPoints(315);
  rail.pop_back(); // the first point is repeated
  const auto surface = madeRidge(rail, exact.generatorPoints(0.2, 80));
  ASSERT_TRUE(surface);
  EXPECT_TRUE(surface->report().closed);
  EXPECT_NEAR(surface->rail().length(), 100.0 * M_PI, 1e-5);
  EXPECT_LT(offOf(*surface, exact).largest, 1e-5);
  const double round = surface->rail().length();
  for (double v = 0.0; v < surface->generator().length(); v += 2.0)
    for (const double u : {0.0, 0.3 * round}) {
      EXPECT_NEAR((surface->position(u, v) - surface->position(u + round, v)).norm(), 0.0, 1e-9);
      EXPECT_NEAR((surface->position(u - 1e-7, v) - surface->position(u + round + 1e-7, v)).norm(), 2e-7, 1e-7);
      EXPECT_NEAR((surface->normal(u, v) - surface->normal(u + round, v)).norm(), 0.0, 1e-9);
    }
}

TEST(RidgeSurface, FoldsWhereTheGeneratorReachesTheMiddleOfTheBend)
{
  const auto inward = [](double reach) {
    return ringRidge(
        50.0, [reach](double w) { return Vector3d(0.0, reach * w, 0.0); }, 0.0);
  };
  Polyline rail = inward(1.0).railPoints(315);
  rail.pop_back();
  EXPECT_TRUE(madeRidge(rail, inward(49.0).generatorPoints(0.2, 50)));
  const std::string message = refusal(rail, inward(51.0).generatorPoints(0.2, 50));
  EXPECT_NE(message.find("folds at ("), std::string::npos) << message;
  EXPECT_NE(message.find("51 mm from the rail, but at most 50 mm are possible"), std::string::npos) << message;
}

TEST(RidgeSurface, OfAHelixTwists)
{
  const double slope = 20.0 * degree, radius = 100.0, twist = std::sin(slope) * std::cos(slope) / radius;
  for (const double side : {1.0, -1.0}) { // inwards and outwards
    ExactRidge exact = helixRidge(
        radius, slope, [](double w) { return Vector3d(0.0, 20.0 * w, 0.0); }, -15.0 * degree);
    if (side < 0.0)
      exact.rail = [first = exact.rail](double t) { return first(1.0 - t); };
    const auto surface = madeRidge(exact.railPoints(2100), exact.generatorPoints(0.4, 40));
    ASSERT_TRUE(surface);
    for (double u = 50.0; u < surface->rail().length() - 50.0; u += 37.0) {
      const RidgeFrame frame = surface->frame(u);
      const Vector3d omega = ridgeTurn(frame, surface->rail().curvature(u), Vector3d::UnitZ());
      EXPECT_NEAR(std::abs(omega.x()), twist, 1e-6 * twist);
      const double b = 20.0, v = surface->generator().length();
      const double expected = std::atan(std::abs(omega.x() * b / (1.0 - omega.z() * b))) / degree;
      const Vector3d n = surface->normal(u, v), published = surface->normal(u, v, RidgeNormals::InNormalPlane);
      EXPECT_NEAR(std::atan2(n.cross(published).norm(), n.dot(published)) / degree, expected, 1e-6);
      EXPECT_GT(expected, 3.0);
      EXPECT_LT(expected, 4.6);
      double t = 0.5, w = 1.0;
      exact.distance(surface->position(u, v), t = u / surface->rail().length(), w);
      const Vector3d truth = exact.normal(t, w);
      EXPECT_LT(std::atan2(n.cross(truth).norm(), std::abs(n.dot(truth))) / degree, 1e-4);
    }
  }
}

TEST(RidgeSurface, TheRailMayBeAsSteepAsTheChordLets)
{
  const auto rising = [](double most) { // an arc in the plane of x and z, up to the slope
    ExactRidge exact;
    exact.rail = [most](double t) {
      const double a = t * most;
      return Vector3d(300.0 * std::sin(a), 0.0, 300.0 * (1.0 - std::cos(a)));
    };
    exact.generator = [](double w) { return Vector3d(0.0, 20.0 * w, 4.0 * w * (1.0 - w)); };
    exact.theta = 30.0 * degree;
    return exact;
  };
  ExactRidge steep = rising(59.5 * degree);
  const auto surface = madeRidge(steep.railPoints(400), steep.generatorPoints(0.3, 40));
  ASSERT_TRUE(surface);
  ASSERT_EQ(surface->report().warnings.size(), 1u);
  EXPECT_NEAR(surface->report().slope_factor, 9.7, 0.1);
  EXPECT_NE(surface->report().warnings[0].text().find("times that error"), std::string::npos) << surface->report().warnings[0];
  EXPECT_LT(offOf(*surface, steep).largest, 1e-3);
  steep = rising(60.5 * degree);
  steep.rail = [rail = steep.rail](double t) { return rail(std::min(t, 0.999999)); };
  const std::string message = refusal(steep.railPoints(400), rising(59.0 * degree).generatorPoints(0.3, 40));
  EXPECT_NE(message.find("at 30 degrees allows at most 60"), std::string::npos) << message;
  EXPECT_NE(message.find("has a slope of 60"), std::string::npos) << message;
}

TEST(RidgeSurface, AnUprightRailTakesAReferenceNormalAcross)
{
  ExactRidge exact = dieRidge();
  exact.rail = [](double t) { return Vector3d(1.0, 2.0, 200.0 * t); };
  exact.reference = Vector3d::UnitX();
  RidgeSettings settings;
  settings.reference = Vector3d::UnitX();
  const auto surface = madeRidge(exact.railPoints(101), exact.generatorPoints(0.3, 60), settings);
  ASSERT_TRUE(surface);
  EXPECT_LT(offOf(*surface, exact).largest, 1e-4);
  const std::string message = refusal(exact.railPoints(101), exact.generatorPoints(0.3, 60));
  EXPECT_NE(message.find("setReferenceNormal"), std::string::npos) << message;
}

TEST(RidgeSurface, OfADieWithoutNoise)
{
  const ExactRidge exact = dieRidge();
  const auto surface = madeRidge(exact.railPoints(600), exact.generatorPoints(0.37, 100));
  ASSERT_TRUE(surface);
  EXPECT_TRUE(surface->report().warnings.empty());
  EXPECT_LT(offOf(*surface, exact).largest, 0.002);
  EXPECT_NEAR(surface->report().chord_angle, -15.0, 1e-3);
  EXPECT_LT(surface->report().tilt, 0.01);
}

TEST(RidgeSurface, OfADieMeasuredWithNoise)
{
  const ExactRidge exact = dieRidge();
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto surface = madeRidge(moved(exact.railPoints(300), 0.02, seed), moved(exact.generatorPoints(0.37, 60), 0.02, 100 + seed));
    ASSERT_TRUE(surface);
    const Off off = offOf(*surface, exact);
    std::printf("seed %2d: rms %.4f, largest %.4f mm, error found %.4f, %.4f\n", static_cast<int>(seed), off.rms, off.largest,
                surface->report().rail_error, surface->report().generator_error);
    EXPECT_LE(off.rms, 0.02) << seed;
    EXPECT_LE(off.largest, 0.1) << seed;
    EXPECT_NEAR(surface->report().rail_error, 0.02, 0.003);
  }
}

} // namespace ridge_surface_test
