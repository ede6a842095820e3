// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/step_over.h>

#include <boost/multiprecision/cpp_dec_float.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace step_over_test {

using namespace pcl_spiral;
using Real = boost::multiprecision::cpp_dec_float_100;

namespace {

/** The closed formula, as written, with a hundred digits: cancellation has no effect. */
Real
exactStep(double radius, double curvature, double height)
{
  const Real R(radius), h(height), rho = Real(1) / Real(curvature);
  const Real cosine = ((rho + R) * (rho + R) + (rho + h) * (rho + h) - R * R) / (2 * (rho + R) * (rho + h));
  return 2 * abs(rho) * acos(cosine);
}

/** Height above a convex or concave circle of the point that balls at +-phi leave, by bisection along the
 * ray. */
double
ridgeByBisection(double R, double rho, double step)
{
  const double r = std::abs(rho), phi = 0.5 * step / r, sign = rho > 0.0 ? 1.0 : -1.0;
  const double cx = (r + sign * R) * std::sin(phi), cy = (r + sign * R) * std::cos(phi);
  double low = 0.0, high = R; // at height low the point is outside the ball (material), at high inside
  for (int i = 0; i < 200; ++i) {
    const double mid = 0.5 * (low + high), y = r + sign * mid;
    (std::hypot(cx, cy - y) > R ? low : high) = mid;
  }
  return low;
}

} // namespace

TEST(StepOver, KnownValues)
{
  EXPECT_NEAR(*stepOver(10, 1.0 / 1650, 0.01), 0.89150, 5e-6);
  EXPECT_NEAR(*stepOver(10, 1.0 / 50, 0.05), 1.82257, 5e-6);
  EXPECT_NEAR(*stepOver(10, 1.0 / 20, 0.1), 2.29820, 5e-6);
  EXPECT_NEAR(*stepOver(10, -1.0 / 15, 0.05), 3.46748, 5e-6);
  EXPECT_DOUBLE_EQ(*stepOver(10, 0.0, 0.05), 2.0 * std::sqrt(2 * 10 * 0.05 - 0.05 * 0.05));
}

TEST(StepOver, AgreesWithHundredDigits)
{
  double worst = 0.0;
  for (double R : {0.5, 3.0, 10.0, 200.0})
    for (double share : {1e-6, 1e-3, 0.02, 0.5, 0.99})
      for (double size : {1e-18, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 0.1, 0.5, 0.8})
        for (double sign : {1.0, -1.0}) {
          const double kappa = sign * size / R, h = share * R;
          if (sign < 0 && h > 1.99 * (1.0 / size - 1.0) * R)
            continue; // no ridge of this height, or the arc cosine loses digits near it
          const Real exact = exactStep(R, kappa, h);
          const Real error = abs(Real(*stepOver(R, kappa, h)) / exact - 1);
          worst = std::max(worst, error.convert_to<double>());
        }
  EXPECT_LT(worst, 2e-15) << "relative";
  RecordProperty("worst_relative_error", std::to_string(worst));
}

TEST(StepOver, ContinuousThroughFlat)
{
  const double flat = *stepOver(10, 0.0, 0.05);
  for (double kappa = 1e-300; kappa < 1e-10; kappa *= 10) {
    EXPECT_NEAR(*stepOver(10, kappa, 0.05), flat, 1e-8 * flat);
    EXPECT_NEAR(*stepOver(10, -kappa, 0.05), flat, 1e-8 * flat);
    EXPECT_LE(*stepOver(10, kappa, 0.05), *stepOver(10, -kappa, 0.05));
  }
}

TEST(StepOver, LeavesTheScallopAsked)
{
  for (double rho : {1650.0, 50.0, 20.0, 3.0, -15.0, -12.0, -400.0})
    for (double h : {0.01, 0.05, 0.3}) {
      const double step = *stepOver(10, 1.0 / rho, h);
      EXPECT_NEAR(ridgeByBisection(10, rho, step), h, 1e-9) << "rho " << rho;
      EXPECT_NEAR(*scallopHeight(10, 1.0 / rho, step), h, 1e-13 + 1e-12 * h) << "rho " << rho;
    }
  EXPECT_NEAR(*scallopHeight(10, 0.0, *stepOver(10, 0.0, 0.05)), 0.05, 1e-15);
}

TEST(StepOver, ScallopIsStableForSmallSteps)
{
  const double R = 10, kappa = 1e-7, s = 1e-5; // h = s^2/8 (1/R + kappa), about 1e-12
  EXPECT_NEAR(*scallopHeight(R, kappa, s) / (s * s / 8 * (1 / R + kappa)), 1.0, 1e-12);
  EXPECT_EQ(*scallopHeight(R, kappa, 0.0), 0.0);
}

TEST(StepOver, ConcaveNarrowerThanTheBallHasNone)
{
  EXPECT_FALSE(cutterFits(10, -0.1));
  EXPECT_FALSE(stepOver(10, -0.1, 0.05));
  EXPECT_FALSE(stepOver(200, -1.0 / 130, 0.02));
  EXPECT_FALSE(stepOverFirstOrder(200, -1.0 / 130, 0.02));
  EXPECT_FALSE(scallopHeight(200, -1.0 / 130, 1.0));
  EXPECT_TRUE(stepOver(10, -0.0999, 0.05));
}

TEST(StepOver, SnugBowlNeedsOnePassOnly)
{
  const double r = 10.01; // the ball leaves at most 2 (r - R) = 0.02
  EXPECT_DOUBLE_EQ(*stepOver(10, -1.0 / r, 0.03), 2 * M_PI * r);
  EXPECT_LT(*stepOver(10, -1.0 / r, 0.0199), 2 * M_PI * r);
  EXPECT_NEAR(*scallopHeight(10, -1.0 / r, 2 * M_PI * r), 0.02, 1e-10);
  EXPECT_FALSE(scallopHeight(10, -1.0 / r, 2.1 * M_PI * r));
}

TEST(StepOver, PassesTooFarApartLeaveItUncut)
{
  EXPECT_FALSE(scallopHeight(10, 0.0, 20.001));
  EXPECT_NEAR(*scallopHeight(10, 0.0, 19.9999), 10.0, 0.04);
  EXPECT_FALSE(scallopHeight(10, 1.0 / 20, 2 * 20 * std::asin(10.0 / 30) + 1e-6));
  EXPECT_TRUE(scallopHeight(10, 1.0 / 20, 2 * 20 * std::asin(10.0 / 30) - 1e-6));
  EXPECT_FALSE(scallopHeight(10, 1.0 / 20, 2 * M_PI * 20));
}

TEST(StepOver, RefusesWhatMakesNoSense)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (double bad : {0.0, -1.0, nan, inf}) {
    EXPECT_FALSE(stepOver(bad, 0.0, 0.05));
    EXPECT_FALSE(stepOver(10, 0.0, bad));
    EXPECT_FALSE(stepOverPublished(bad, 0.05));
    EXPECT_FALSE(stepOverFirstOrder(10, 0.0, bad));
    EXPECT_FALSE(scallopHeight(bad, 0.0, 1.0));
  }
  EXPECT_FALSE(stepOver(10, 0.0, 10.0));
  EXPECT_FALSE(stepOver(10, nan, 0.05));
  EXPECT_FALSE(scallopHeight(10, 0.0, -1.0));
}

TEST(StepOver, OtherFormsDifferAsTheyShould)
{
  EXPECT_DOUBLE_EQ(*stepOverPublished(10, 0.05), 2.0);
  EXPECT_NEAR(*stepOverFirstOrder(10, 0.02, 0.05), std::sqrt(8 * 0.05 / (0.1 + 0.02)), 1e-14);
  // First order is wrong in the next power of h: half of h gives half of the relative error.
  auto relative = [](double h) { return *stepOverFirstOrder(10, 0.02, h) / *stepOver(10, 0.02, h) - 1; };
  EXPECT_NEAR(relative(0.002) / relative(0.001), 2.0, 0.01);
}

TEST(ChordStep, SagittaIsTheErrorAsked)
{
  for (double rho : {1e9, 1650.0, 300.0, 2.0}) {
    const double c = stepFromChordError(1 / rho, 0.005, 1e9), half = 0.5 * c;
    const Real sagitta = Real(rho) - sqrt(Real(rho) * Real(rho) - Real(half) * Real(half));
    EXPECT_NEAR(sagitta.convert_to<double>(), 0.005, 1e-15 * rho + 1e-12) << rho;
    EXPECT_EQ(stepFromChordError(-1 / rho, 0.005, 1e9), c);
  }
}

TEST(ChordStep, IsBounded)
{
  EXPECT_EQ(stepFromChordError(0.0, 0.005, 7.0), 7.0);
  EXPECT_EQ(stepFromChordError(1e-300, 0.005, 7.0), 7.0);
  EXPECT_EQ(stepFromChordError(100.0, 0.02, 7.0), 0.02); // the diameter
  EXPECT_EQ(stepFromChordError(1e-3, 0.0, 7.0), 0.0);
  EXPECT_EQ(stepFromChordError(1e-3, std::nan(""), 7.0), 0.0);
}

TEST(ChordStep, OnTheCentreCurve)
{
  for (double rho : {300.0, 20.0, -20.0, -300.0}) {
    const double R = 10, e = 0.005, contact = stepFromChordErrorAtCentre(R, 1 / rho, e, 100.0);
    const double phi = std::asin(0.5 * contact / std::abs(rho)), centre_radius = std::abs(rho + R);
    EXPECT_NEAR(centre_radius * (1 - std::cos(phi)), e, 1e-12) << rho;
  }
  EXPECT_EQ(stepFromChordErrorAtCentre(10, 0.0, 0.005, 4.0), 4.0);
  EXPECT_EQ(stepFromChordErrorAtCentre(10, -0.2, 0.005, 4.0), 0.0);
}

} // namespace step_over_test
