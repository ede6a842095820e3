// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/bspline_fit.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bspline_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

constexpr double pi = 3.14159265358979323846;

/** The definition of Cox and de Boor. */
double
basisByDefinition(const std::vector<double>& t, std::size_t i, int degree, double u)
{
  if (degree == 0) {
    const bool last = u == t.back() && t[i + 1] == t.back() && t[i] < t[i + 1];
    return (t[i] <= u && u < t[i + 1]) || last ? 1.0 : 0.0;
  }
  auto ratio = [](double a, double b) { return b > 0.0 ? a / b : 0.0; };
  return ratio(u - t[i], t[i + degree] - t[i]) * basisByDefinition(t, i, degree - 1, u) +
         ratio(t[i + degree + 1] - u, t[i + degree + 1] - t[i + 1]) * basisByDefinition(t, i + 1, degree - 1, u);
}

Vector3d
curveByDefinition(const BSplineCurve& c, double u)
{
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < c.controlPoints().size(); ++i)
    sum += basisByDefinition(c.knots(), i, 3, u) * c.controlPoints()[i];
  return sum;
}

BSplineCurve
randomCurve()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  std::vector<double> knots(4, 2.0);
  for (int i = 0; i < 9; ++i)
    knots.push_back(knots.back() + 0.2 + value(random));
  knots.insert(knots.end(), 3, knots.back());
  Polyline control;
  while (control.size() + 4 < knots.size())
    control.emplace_back(value(random), value(random), value(random));
  return BSplineCurve(knots, control);
}

const double helix_radius = 50.0, helix_rise = 10.0; // rise per radian
const double helix_speed = std::hypot(helix_radius, helix_rise);

Vector3d
helix(double s)
{
  const double a = s / helix_speed;
  return {helix_radius * std::cos(a), helix_radius * std::sin(a), helix_rise * a};
}

Polyline
helixPoints(std::size_t n, double end)
{
  Polyline points(n);
  for (std::size_t i = 0; i < n; ++i)
    points[i] = helix(end * static_cast<double>(i) / static_cast<double>(n - 1));
  return points;
}

BSplineFit
fitWithSpans(const Polyline& points, std::size_t spans)
{
  BSplineFitOptions options;
  options.tolerance = 1e-300;
  options.min_spans = options.max_spans = spans;
  return *fitBSpline(points, options);
}

} // namespace

TEST(BSplineCurve, AgreesWithTheDefinition)
{
  const BSplineCurve c = randomCurve();
  const double h = 1e-3;
  for (double u = c.firstParameter() + 2 * h; u < c.lastParameter() - 2 * h; u += 0.0173) {
    EXPECT_LT((c.position(u) - curveByDefinition(c, u)).norm(), 1e-13);
    const Vector3d first = (curveByDefinition(c, u + h) - curveByDefinition(c, u - h)) / (2 * h);
    EXPECT_LT((c.derivative(u) - first).norm(), 1e-4);
    const Vector3d second = (c.derivative(u + h) - c.derivative(u - h)) / (2 * h);
    EXPECT_LT((c.secondDerivative(u) - second).norm(), 0.02);
  }
  EXPECT_EQ(c.position(c.firstParameter()), c.controlPoints().front());
  EXPECT_EQ(c.position(c.lastParameter()), c.controlPoints().back());
  EXPECT_EQ(c.position(1e9), c.controlPoints().back());
  EXPECT_EQ(c.position(-1e9), c.controlPoints().front());
}

TEST(BSplineCurve, DerivativesAreContinuousAtKnots)
{
  const BSplineCurve c = randomCurve();
  for (std::size_t k = 4; k + 4 < c.knots().size(); ++k) {
    const double u = c.knots()[k], e = 1e-9;
    EXPECT_LT((c.derivative(u - e) - c.derivative(u + e)).norm(), 1e-6);
    EXPECT_LT((c.secondDerivative(u - e) - c.secondDerivative(u + e)).norm(), 1e-5);
  }
}

TEST(BSplineCurve, ArcLengthAndItsInverse)
{
  const BSplineCurve c = randomCurve();
  double sum = 0.0;
  const int n = 200000;
  const double step = (c.lastParameter() - c.firstParameter()) / n;
  for (int i = 0; i < n; ++i)
    sum += c.derivative(c.firstParameter() + (i + 0.5) * step).norm() * step;
  EXPECT_NEAR(c.length(), sum, 1e-9 * sum);
  for (double f = 0.0; f <= 1.0; f += 0.0137) {
    const double s = f * c.length();
    EXPECT_NEAR(c.arcLength(c.parameterAt(s)), s, 1e-12 * c.length());
  }
  EXPECT_EQ(c.parameterAt(-1.0), c.firstParameter());
  EXPECT_EQ(c.parameterAt(c.length() + 1.0), c.lastParameter());
}

TEST(BSplineCurve, RefusesBadKnots)
{
  const Polyline control(5, Vector3d::Zero());
  EXPECT_THROW(BSplineCurve({0, 0, 0, 0, 1, 1, 1, 1}, control), std::invalid_argument);
  EXPECT_THROW(BSplineCurve({0, 0, 0, 0, 0, 1, 1, 1, 1}, control), std::invalid_argument);
  EXPECT_THROW(BSplineCurve({0, 0, 0, 0, 2, 1, 1, 1, 1}, control), std::invalid_argument);
  EXPECT_THROW(BSplineCurve({0, 0, 0, 1}, {}), std::invalid_argument);
  EXPECT_EQ(BSplineCurve().length(), 0.0);
}

TEST(BSplineFit, IsTheLeastSquaresSolution)
{
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.3);
  Polyline points = helixPoints(60, 200.0);
  for (Vector3d& p : points)
    p += Vector3d(noise(random), noise(random), noise(random));
  const BSplineFit fit = fitWithSpans(points, 9);
  const std::size_t controls = 12;
  const std::vector<double> u = arcLengths(points);
  Eigen::MatrixXd a(60, controls), right(60, 3);
  for (int i = 0; i < 60; ++i) {
    right.row(i) = points[i].transpose();
    for (std::size_t c = 0; c < controls; ++c)
      a(i, c) = basisByDefinition(fit.curve.knots(), c, 3, u[i]);
  }
  right -= a.col(0) * points.front().transpose() + a.col(controls - 1) * points.back().transpose();
  const Eigen::MatrixXd dense = a.middleCols(1, controls - 2).colPivHouseholderQr().solve(right);
  for (std::size_t c = 1; c + 1 < controls; ++c)
    EXPECT_LT((fit.curve.controlPoints()[c] - dense.row(c - 1).transpose()).norm(), 1e-10);
  EXPECT_EQ(fit.curve.position(0.0), points.front());
  EXPECT_EQ(fit.curve.position(u.back()), points.back());
}

TEST(BSplineFit, HelixConvergesWithOrderFour)
{
  const double end = 2 * pi * helix_speed;
  std::vector<double> errors;
  for (std::size_t spans : {8u, 16u, 32u}) {
    const BSplineCurve c = fitWithSpans(helixPoints(4 * spans + 1, end), spans).curve;
    double worst = 0.0;
    for (int i = 0; i <= 1000; ++i)
      worst = std::max(worst, (c.positionAt(end * i / 1000.0) - helix(end * i / 1000.0)).norm());
    errors.push_back(worst);
  }
  RecordProperty("finest", std::to_string(errors.back()));
  EXPECT_GT(std::log2(errors[0] / errors[1]), 3.7);
  EXPECT_GT(std::log2(errors[1] / errors[2]), 3.7);
  EXPECT_LT(errors.back(), 1e-3);
}

TEST(BSplineFit, GreatCircleOfATankDome)
{
  const double R = 1650.0;
  Polyline points;
  for (int i = 0; i <= 128; ++i) {
    const double a = 0.5 * pi * i / 128.0;
    points.emplace_back(R * std::cos(a) * 0.6, R * std::cos(a) * 0.8, R * std::sin(a));
  }
  const std::optional<BSplineFit> fit = fitBSpline(points);
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->within_tolerance);
  EXPECT_LE(fit->curve.spans(), 32u);
  const Vector3d axis(0.8, -0.6, 0.0);
  for (double u = 0.0; u < fit->curve.lastParameter(); u += 1.7) {
    const Vector3d p = fit->curve.position(u), d = fit->curve.derivative(u);
    EXPECT_NEAR(p.norm(), R, 1.1e-3);
    EXPECT_NEAR(p.dot(axis), 0.0, 1e-9);
    const double curvature = d.cross(fit->curve.secondDerivative(u)).norm() / std::pow(d.norm(), 3);
    EXPECT_NEAR(curvature * R, 1.0, 5e-3);
  }
  EXPECT_NEAR(fit->curve.length(), 0.5 * pi * R, 1e-3);
}

TEST(BSplineFit, DeviationIsWhatItSays)
{
  Polyline points = helixPoints(80, 300.0);
  points[40] += Vector3d(0.0, 0.0, 3.0);
  const BSplineFit fit = fitWithSpans(points, 6);
  const std::vector<double> u = arcLengths(points);
  double worst = 0.0, nearest_worst = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    worst = std::max(worst, (curveByDefinition(fit.curve, u[i]) - points[i]).norm());
    double nearest = 1e9;
    for (double v = 0.0; v < u.back(); v += 0.05)
      nearest = std::min(nearest, (fit.curve.position(v) - points[i]).norm());
    nearest_worst = std::max(nearest_worst, nearest);
  }
  EXPECT_NEAR(fit.max_deviation, worst, 1e-12);
  EXPECT_GE(fit.max_deviation, nearest_worst - 1e-3);
  EXPECT_LT(fit.rms_deviation, fit.max_deviation);
  EXPECT_FALSE(fit.within_tolerance);
  EXPECT_TRUE(fitBSpline(points)->within_tolerance) << "as many control points as points interpolate";
}

TEST(BSplineFit, UnevenPoints)
{
  Polyline points;
  for (int i = 0; i < 60; ++i)
    points.push_back(helix(i < 30 ? 0.05 * i : 1.5 + 6.0 * (i - 29)));
  points.insert(points.begin() + 20, points[20]); // a repeated point
  const std::optional<BSplineFit> fit = fitBSpline(points);
  ASSERT_TRUE(fit);
  EXPECT_TRUE(fit->within_tolerance);
  for (double s = 0.0; s < 180.0; s += 0.9)
    EXPECT_LT((fit->curve.positionAt(s) - helix(s)).norm(), 0.01) << s;
}

TEST(BSplineFit, FewPoints)
{
  const Polyline two{Vector3d(1, 2, 3), Vector3d(4, 6, 3)};
  EXPECT_LT((fitBSpline(two)->curve.positionAt(2.5) - Vector3d(2.5, 4, 3)).norm(), 1e-14);
  const Polyline three{Vector3d(0, 0, 0), Vector3d(1, 1, 0), Vector3d(3, 0, 1)};
  EXPECT_LT(fitBSpline(three)->max_deviation, 1e-14);
  for (std::size_t n = 4; n < 12; ++n)
    EXPECT_LT(fitBSpline(helixPoints(n, 200.0))->max_deviation, 1e-3) << n;
  EXPECT_FALSE(fitBSpline({}));
  EXPECT_FALSE(fitBSpline({Vector3d::Zero(), Vector3d::Zero()}));
  EXPECT_FALSE(fitBSpline({Vector3d::Zero(), Vector3d(NAN, 0, 0), Vector3d::Ones()}));
}

} // namespace bspline_test
