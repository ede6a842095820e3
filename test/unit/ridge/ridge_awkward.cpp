// SPDX-License-Identifier: BSD-3-Clause
// Difficult measurements of ridges: rails through the upright direction, dense or noisy lines, lines that do not meet, rings that do not
// close, hollows with a smaller radius than the stand-off, edges sharper than the steps.
#include <pcl_spiral/ridge/ridge_rows.h>

#include "support/made_ridge.h"
#include "support/ridges.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>

namespace ridge_awkward_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double degree = M_PI / 180.0;
const ExactRidge die = dieRidge();

Polyline
lineOf(int count, const std::function<Vector3d(double)>& at)
{
  Polyline points;
  for (int i = 0; i < count; ++i)
    points.push_back(at(static_cast<double>(i) / (count - 1)));
  return points;
}

/** Along x, from 0 to 100 mm. */
Polyline
straight()
{
  return lineOf(60, [](double t) -> Vector3d { return Vector3d(100.0 * t, 0.0, 0.0); });
}

bool
warns(const pcl_spiral::Diagnostics& warnings, const std::string& words)
{
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const pcl_spiral::Diagnostic& w) { return w.text().find(words) != std::string::npos; });
}

Status
statusOf(const Polyline& rail, const Polyline& generator, const RidgeSettings& settings = {})
{
  RidgeSurface::ConstPtr none;
  return RidgeSurface::make(rail, generator, settings, none);
}

DrivePasses
rowsOver(const RidgeSurface::ConstPtr& ridge, const RidgeRowSettings& settings, RidgeRowReport& report)
{
  DrivePasses rows;
  const Status status = planRidgeRows(*ridge, settings, rows, report);
  EXPECT_TRUE(status.ok()) << status.message();
  return rows;
}

/** Rows across a straight ridge, 50 mm apart. */
RidgeRowSettings
across(double stand_off)
{
  RidgeRowSettings settings;
  settings.direction = RidgeDirection::AcrossRail;
  settings.step_over = 50.0;
  settings.stand_off = stand_off;
  return settings;
}

} // namespace

TEST(AwkwardRidge, IsRefusedWhereItsRailPassesTheReferenceNormal)
{
  const Polyline wheel =
      lineOf(200, [](double t) -> Vector3d { return 50.0 * Vector3d(std::cos(1.5 * M_PI * t), 0.0, std::sin(1.5 * M_PI * t)); });
  for (const double theta : {0.0, 1e-4}) { // such a chord can have any angle
    const Polyline tread = lineOf(30, [&](double t) -> Vector3d {
      return 50.0 * Vector3d(0.0, 0.0, 1.0) + 10.0 * (t - 0.5) * Vector3d(0.0, std::cos(theta), std::sin(theta));
    });
    const Status refused = statusOf(wheel, tread);
    EXPECT_EQ(refused.code(), StatusCode::InvalidInput);
    EXPECT_NE(refused.message().find(theta == 0.0 ? "is upright, along the reference normal, at (" : "has a slope of"), std::string::npos)
        << refused.message();
    RidgeSettings settings;
    settings.reference = Vector3d::UnitY(); // the remedy: across the rail
    const Polyline leaning = lineOf(30, [](double t) -> Vector3d { return Vector3d(0.0, 10.0 * (t - 0.5), 50.0 + 4.0 * (t - 0.5)); });
    EXPECT_TRUE(statusOf(wheel, leaning, settings).ok()) << statusOf(wheel, leaning, settings).message();
  }
  const Polyline steep = lineOf(200, [](double t) -> Vector3d { return 50.0 * Vector3d(std::sin(1.45 * t), 0.0, std::cos(1.45 * t)); });
  const Polyline tread = lineOf(30, [](double t) -> Vector3d { return Vector3d(0.0, 10.0 * (t - 0.5), 50.0); });
  EXPECT_TRUE(warns(madeRidge(steep, tread)->report().warnings, "is nearly upright at ("));
}

TEST(AwkwardRidge, DenseLinesAreNoLessSmooth)
{
  for (const std::size_t count : {300UL, 2000UL, 6000UL})
    for (const double error : {0.0, 0.02}) {
      RidgeSettings settings;
      settings.measuring_error = error;
      const auto ridge = madeRidge(moved(die.railPoints(count), 0.02, 5), moved(die.generatorPoints(0.37, 60), 0.02, 6), settings);
      double largest = 0.0;
      for (int k = 0; k <= 400; ++k) {
        const double u = ridge->rail().length() * k / 400.0, t = ridge->rail().position(u).x() / 600.0;
        const double off =
            std::acos(std::min(1.0, std::abs(ridge->rail().tangent(u).dot(die.frame(std::clamp(t, 0.0, 1.0)).col(0))))) / degree;
        largest = std::max(largest, off);
      }
      EXPECT_LT(largest, 0.6) << count << " points, error given: " << error;
      EXPECT_NEAR(ridge->report().rail_error, 0.02, 0.002);
      EXPECT_NEAR(ridge->rail().length(), 640.4, 0.2);
    }
}

TEST(AwkwardRidge, SaysHowWellDirectionsAreKnown)
{
  EXPECT_FALSE(
      warns(madeRidge(moved(die.railPoints(300), 0.02, 1), moved(die.generatorPoints(0.37, 60), 0.02, 2))->report().warnings, "direction"));
  const auto noisy = madeRidge(die.railPoints(300), moved(die.generatorPoints(0.37, 50), 0.3, 3));
  EXPECT_TRUE(warns(noisy->report().warnings, "the direction of the generator is known to only"));
  double squares = 0.0; // of the true error, inside
  for (int k = 5; k <= 95; ++k) {
    const double v = noisy->generator().length() * k / 100.0;
    const Vector3d along = noisy->alongGenerator(noisy->report().meeting, v), place = noisy->position(noisy->report().meeting, v);
    double best = 1e9, angle = 0.0;
    for (int j = 0; j <= 1000; ++j) {
      const double w = j / 1000.0;
      if (const double d = (die.position(0.37, w) - place).norm(); d < best) {
        best = d;
        const Vector3d exact = (die.position(0.37, w + 1e-4) - die.position(0.37, w - 1e-4)).normalized();
        angle = std::acos(std::min(1.0, std::abs(exact.dot(along)))) / degree;
      }
    }
    squares += angle * angle / 91.0;
  }
  const double said = noisy->report().generator_direction;
  EXPECT_GT(said, 0.25 * std::sqrt(squares));
  EXPECT_LT(said, 4.0 * std::sqrt(squares));
}

TEST(AwkwardRidge, LinesThatDoNotMeetAndRingsThatDoNotCloseAreWarnedOf)
{
  Polyline beside = die.generatorPoints(0.37, 60);
  for (Vector3d& p : beside)
    p += 5.8 * die.normal(0.37, 0.0);
  EXPECT_TRUE(warns(madeRidge(die.railPoints(300), beside)->report().warnings, "mm apart where they are closest, at ("));
  EXPECT_FALSE(warns(madeRidge(die.railPoints(300), die.generatorPoints(0.37, 60))->report().warnings, "are closest"));

  const auto ring = [](double share) {
    return lineOf(300, [share](double t) -> Vector3d {
      return 50.0 * Vector3d(std::cos(2.0 * M_PI * share * t), std::sin(2.0 * M_PI * share * t), 0.0);
    });
  };
  const Polyline generator = lineOf(30, [](double t) -> Vector3d { return Vector3d(-50.0 - 8.0 * t, 0.0, 2.0 * t); });
  const auto open = madeRidge(ring(0.987), generator); // a gap of four spacings
  EXPECT_FALSE(open->report().closed);
  EXPECT_TRUE(warns(open->report().warnings, "if it is a ring, measure the rest of it"));
  EXPECT_FALSE(warns(madeRidge(ring(0.5), generator)->report().warnings, "if it is a ring"));
}

TEST(AwkwardRidge, LeadAndRunsFollowTheContactInHollowsToo)
{
  constexpr double radius = 4.0;
  const Polyline hollow = lineOf(60, [](double t) -> Vector3d {
    return Vector3d(50.0, radius * std::sin(0.45 * M_PI * t), radius * (1.0 - std::cos(0.45 * M_PI * t)));
  });
  const auto ridge = madeRidge(straight(), hollow);
  for (const double stand_off : {0.0, 2.0, 10.0}) {
    RidgeRowSettings settings = across(stand_off);
    settings.lead = 10.0;
    settings.run_in = settings.run_out = 3.0;
    RidgeRowReport report;
    const DrivePass row = rowsOver(ridge, settings, report).front();
    EXPECT_EQ(warns(report.warnings, "hollow with a smaller radius than the stand-off of 10 mm"), stand_off > radius);
    Polyline contacts;
    for (const DrivePoint& p : row.points)
      contacts.push_back(p.position - stand_off * p.normal);
    for (std::size_t i = 1; i < contacts.size(); ++i) {
      const Vector3d travel = (contacts[i] - contacts[i - 1]).normalized();
      EXPECT_GT(travel.dot(contacts[1] - contacts[0]), 0.0) << "one way through";
      EXPECT_NEAR(std::asin(row.points[i].axis.dot(travel)) / degree, 10.0, 4.0); // steps turn by a few degrees
    }
    EXPECT_NEAR((contacts[3] - contacts[0]).norm(), 3.0, 1e-3);
    EXPECT_NEAR((contacts.back() - contacts[contacts.size() - 4]).norm(), 3.0, 1e-3);
  }
}

TEST(AwkwardRidge, MovesBetweenStepsKeepTheChordError)
{
  constexpr double radius = 0.5, stand_off = 10.0;
  const Polyline edge = lineOf(60, [](double t) -> Vector3d {
    return Vector3d(50.0, radius * std::sin(0.5 * M_PI * (t - 0.5)), radius * std::cos(0.5 * M_PI * (t - 0.5)));
  });
  const auto ridge = madeRidge(straight(), edge);
  for (const double error : {0.05, 0.005}) {
    RidgeRowSettings settings = across(stand_off);
    settings.chord_error = error;
    RidgeRowReport report;
    const DrivePass row = rowsOver(ridge, settings, report).front();
    double largest = 0.0, smallest_step = 1e9, largest_step = 0.0;
    for (std::size_t i = 1; i < row.points.size(); ++i) {
      const Vector3d a = row.points[i - 1].position, b = row.points[i].position;
      largest = std::max(largest, radius + stand_off - (0.5 * (a + b)).tail<2>().norm()); // of the tool from its circle
      smallest_step = std::min(smallest_step, (b - a).norm());
      largest_step = std::max(largest_step, (b - a).norm());
    }
    EXPECT_LT(largest, error);
    EXPECT_GT(largest, 0.2 * error);
    EXPECT_LT(largest_step, 1.01 * smallest_step);
  }
}

TEST(AwkwardRidge, SaysHowFarRowsAreApart)
{
  const Polyline ring =
      lineOf(315, [](double t) -> Vector3d { return 50.0 * Vector3d(std::cos(1.99365 * M_PI * t), std::sin(1.99365 * M_PI * t), 0.0); });
  const Polyline generator = lineOf(30, [](double t) -> Vector3d { return Vector3d(50.0 + 10.0 * t, 0.0, 3.0 * t * (1.0 - t)); });
  const auto ridge = madeRidge(ring, generator);
  ASSERT_TRUE(ridge->report().closed);
  RidgeRowSettings settings;
  settings.direction = RidgeDirection::AcrossRail;
  settings.step_over = 3.0;
  RidgeRowReport report;
  const DrivePasses rows = rowsOver(ridge, settings, report);
  double largest = 0.0; // at the outer ends, also over the seam
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto outer = [](const DrivePass& row) {
      const Vector3d a = row.points.front().position, b = row.points.back().position;
      return a.head<2>().norm() > b.head<2>().norm() ? a : b;
    };
    largest = std::max(largest, (outer(rows[k]) - outer(rows[(k + 1) % rows.size()])).norm());
  }
  EXPECT_NEAR(report.largest_step, largest, 0.01);
  EXPECT_LE(largest, 3.0);
}

TEST(AwkwardRidge, StandsOffOutwardsAlone)
{
  const auto ridge = madeRidge(straight(), lineOf(30, [](double t) -> Vector3d { return Vector3d(50.0, 10.0 * t, 8.0 * t * (1.0 - t)); }));
  RidgeRowReport report;
  DrivePasses rows;
  const Status refused = planRidgeRows(*ridge, across(-10.0), rows, report);
  EXPECT_EQ(refused.code(), StatusCode::InvalidArgument);
  EXPECT_NE(refused.message().find("the stand-off is -10 mm"), std::string::npos) << refused.message();
}

} // namespace ridge_awkward_test
