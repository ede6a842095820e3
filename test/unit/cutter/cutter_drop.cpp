// SPDX-License-Identifier: BSD-3-Clause
// Cutters moved down onto points and height models, against brute force.
#include "core/model_touch.h"
#include "core/sampling_gap.h"
#include <pcl_spiral/cutter/impl/cutter_drop.h>

#include "support/cutters.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cutter_drop_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

Vector3d
unitVector(Random& random)
{
  return Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

/** Height of the profile by its published formulas. */
double
publishedHeight(const CutterShape& s, double l)
{
  const double a = s.flank_angle * M_PI / 180.0, r = s.corner_radius;
  const double r1 = s.radius - s.flank_length * std::sin(a), r2 = r1 - r * std::cos(a);
  if (l <= r2)
    return 0.0;
  if (l <= r1 || s.flank_angle == 0.0)
    return r - std::sqrt(std::max(0.0, r * r - (l - r2) * (l - r2)));
  return r - r * std::sin(a) + (l - r1) / std::tan(a);
}

/** The published method: over all points, without a search. */
double
highestTip(const std::vector<Eigen::Vector3f>& points, const CutterShape& cutter, const Vector3d& through, const Vector3d& axis)
{
  double highest = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3f& point : points) {
    const Vector3d d = point.cast<double>() - through;
    const double l = d.cross(axis).norm();
    if (l <= cutter.radius)
      highest = std::max(highest, d.dot(axis) - publishedHeight(cutter, l));
  }
  return highest;
}

} // namespace

TEST(CutterDrop, EqualsBruteForceForTenThousandCutters)
{
  Random random(1);
  std::size_t missed = 0;
  for (int cloud = 0; cloud < 100; ++cloud) {
    // A box of points, a thin layer, or a few clusters far apart, somewhere in space.
    std::vector<Eigen::Vector3f> points(1 + random.below(400));
    const Vector3d middle = 200.0 * unitVector(random);
    const Vector3d size = cloud % 3 == 0 ? Vector3d(40, 40, 40) : cloud % 3 == 1 ? Vector3d(60, 60, 1) : Vector3d(3, 3, 3);
    for (Eigen::Vector3f& p : points) {
      const Vector3d spread(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      const Vector3d cluster = cloud % 3 == 2 ? Vector3d(30.0 * Vector3d::Unit(static_cast<int>(random.below(3)))) : Vector3d(0, 0, 0);
      p = (middle + cluster + size.cwiseProduct(spread)).cast<float>();
    }
    const PointBlocks blocks(points);
    for (int k = 0; k < 100; ++k) {
      const CutterShape cutter = randomCutter(random);
      const Vector3d axis = unitVector(random), through = middle + 30.0 * unitVector(random);
      const DropContact drop = CutterDrop(blocks, CutterProfile(cutter)).highest(AxisFrame(through, axis));
      const double expected = highestTip(points, cutter, through, axis);
      ASSERT_EQ(drop.found, std::isfinite(expected));
      missed += !drop.found;
      // A point next to a cylinder's wall: its height depends on the last digit of its distance.
      if (drop.found)
        ASSERT_NEAR(drop.height, expected, cutter.flank_angle == 0.0 ? 1e-5 : 1e-9) << cloud << ' ' << k;
    }
  }
  EXPECT_GT(missed, 500u);
  EXPECT_LT(missed, 7000u);
}

TEST(CutterDrop, NoPointLiesInTheCutterThatRestsOnThem)
{
  Random random(2);
  for (int k = 0; k < 1000; ++k) {
    std::vector<Eigen::Vector3f> points(300);
    for (Eigen::Vector3f& p : points)
      p = Vector3d(random.uniform(-20, 20), random.uniform(-20, 20), random.uniform(-2, 2)).cast<float>();
    const PointBlocks blocks(points);
    const CutterProfile cutter(randomCutter(random));
    const AxisFrame frame({random.uniform(-20, 20), random.uniform(-20, 20), 0.0}, unitVector(random));
    const DropContact drop = CutterDrop(blocks, cutter).highest(frame);
    int touching = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      const double l = frame.across(blocks.position(i)).norm(), height = frame.along(blocks.position(i)) - drop.height;
      ASSERT_FALSE(cutter.contains(l, height, 1e-12 * (1.0 + std::abs(drop.height)))) << k;
      touching += l <= cutter.radius() && std::abs(height - cutter.height(l)) < 1e-9;
    }
    ASSERT_EQ(touching >= 1, drop.found);
  }
}

TEST(CutterDrop, AFloorHidesWhatIsLower)
{
  const PointBlocks blocks({{0, 0, 1}, {1, 0, 0}, {50, 0, 9}});
  const CutterDrop drop(blocks, CutterProfile(CutterShape::flatEnd(5.0)));
  const AxisFrame frame(Vector3d::Zero(), Vector3d::UnitZ());
  EXPECT_TRUE(drop.highest(frame, 0.9).found);
  EXPECT_FALSE(drop.highest(frame, 1.1).found);
  EXPECT_FALSE(CutterDrop(PointBlocks(), CutterProfile(CutterShape::ball(1.0))).highest(frame).found);
}

TEST(ModelTouch, TheProximalRadiusIsTheLeastOfItsFunction)
{
  Random random(3);
  for (int k = 0; k < 2000; ++k) {
    const CutterProfile cutter(randomCutter(random));
    const double R = cutter.radius(), q = random.uniform(0.0, 3.0 * R), c = R * std::pow(10.0, random.uniform(-2, 2));
    double derivative = 0.0, unused = 0.0;
    const double p = proximalRadius(cutter, q, c, derivative);
    const auto cost = [&](double l) { return cutter.height(l) + (l - q) * (l - q) / (2.0 * c); };
    ASSERT_GE(p, 0.0);
    ASSERT_LE(p, R);
    const double slack = 1e-9 * (1.0 + cost(p));
    for (int i = 0; i <= 1000; ++i)
      ASSERT_GE(cost(R * i / 1000.0), cost(p) - slack) << k;
    const double step = 1e-6 * R;
    const double change = (proximalRadius(cutter, q + step, c, unused) - p) / step;
    const double back = (p - proximalRadius(cutter, q - step, c, unused)) / step;
    ASSERT_LT(std::min(std::abs(change - derivative), std::abs(back - derivative)), 1e-3) << k;
  }
}

TEST(ModelTouch, FindsTheFirstTouchOfEveryQuadraticThatTheCutterFits)
{
  Random random(4);
  for (int k = 0; k < 3000; ++k) {
    const CutterShape shape = randomCutter(random);
    const CutterProfile cutter(shape);
    const double R = cutter.radius();
    HeightModel model;
    model.at = R * Vector2d(random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7));
    model.slope = Vector2d(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5));
    // Convex, level or a saddle, never with a smaller radius than the cutter: a concave sum, so one maximum.
    const double hollow = shape.flank_angle == 0.0 && shape.corner_radius == R ? 0.5 / R : 0.0;
    const double t = random.uniform(0.0, M_PI);
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(t).toRotationMatrix();
    model.bend = turn * Vector2d(random.uniform(-2.0 / R, hollow), random.uniform(-2.0 / R, hollow)).asDiagonal() * turn.transpose();
    const auto tip = [&](const Vector2d& x) { return model.value(x) - cutter.height(std::min(x.norm(), R)); };
    const Vector2d found = touchModel(cutter, model);
    ASSERT_LE(found.norm(), R * (1.0 + 1e-12));
    const double height = tip(found);
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; j < 60; ++j) {
        const double l = R * i / 40.0, a = 2.0 * M_PI * j / 60;
        ASSERT_LE(tip(Vector2d(l * std::cos(a), l * std::sin(a))), height + 1e-7 * R) << k;
      }
  }
}

// Cutters on planes and spheres known only at the points of a square grid, turned and shifted at random.
TEST(SamplingGap, BoundsWhatCuttersSinkOnAGrid)
{
  Random random(5);
  int bounded = 0, close = 0;
  for (int k = 0; k < 3000; ++k) {
    const CutterShape shape = randomCutter(random);
    const CutterProfile cutter(shape);
    const double s = cutter.radius() * random.uniform(0.08, 0.5), curvature = k % 2 ? 1.0 / random.uniform(30.0, 200.0) : 0.0;
    const double lean = random.uniform(0.0, std::min(1.2, 0.5 * M_PI - cutter.flankAngle() - 0.05));
    const Vector3d normal = Vector3d::UnitZ(), axis(std::sin(lean), 0.0, std::cos(lean));
    const CutterContact contact = cutter.locate(Vector3d::Zero(), normal, axis);
    const double a = random.uniform(0.0, 1.6), u = random.uniform(), v = random.uniform();
    std::vector<Eigen::Vector3f> points;
    const int reach = static_cast<int>(3.0 * cutter.radius() / s) + 2;
    double nearest = 1e300, widest = s / std::sqrt(2.0);
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach; j <= reach; ++j) {
        const double x = s * (i + u), y = s * (j + v), rho = x * x + y * y;
        const Vector3d p(x * std::cos(a) - y * std::sin(a), x * std::sin(a) + y * std::cos(a),
                         curvature > 0.0 ? -curvature * rho / (1.0 + std::sqrt(std::max(0.0, 1.0 - curvature * curvature * rho))) : 0.0);
        if (curvature * curvature * rho < 0.25)
          points.push_back(p.cast<float>());
        nearest = std::min(nearest, p.norm());
      }
    const double steeper = curvature > 0.0 ? 1.0 / std::sqrt(1.0 - std::pow(curvature * 4.0 * s, 2)) : 1.0;
    const double bound = samplingGap(cutter, {widest * steeper, lean, contact.distance, curvature});
    const DropContact drop = CutterDrop(PointBlocks(points), cutter).highest(AxisFrame(contact.tip, axis));
    ASSERT_LT(drop.height, 1e-4);
    if (!std::isfinite(bound))
      continue;
    ++bounded;
    ASSERT_TRUE(drop.found);
    ASSERT_LE(-drop.height, bound + 1e-5 * (1.0 + bound))
        << k << " R " << shape.radius << " r " << shape.corner_radius << " lean " << lean << " s " << s;
    close += -drop.height > 0.3 * bound;
  }
  EXPECT_GT(bounded, 1800);
  EXPECT_GT(close, 100); // a bound far from all heights would check nothing
}

TEST(SamplingGap, IsTheDesignsFigureOnALevelGrid)
{
  const CutterProfile ball(CutterShape::ball(5.0)), sharp(CutterShape::flatEnd(5.0));
  const double s = 0.2, d = s / std::sqrt(2.0);
  EXPECT_NEAR(samplingGap(ball, {d, 0.0, 0.0, 0.0}) / (s * s / (4.0 * 5.0)), 1.0, 1e-3);
  EXPECT_EQ(samplingGap(sharp, {d, 0.0, 0.0, 0.0}), 0.0); // the flat always covers a point
  EXPECT_GT(samplingGap(sharp, {d, 0.3, 5.0, 0.0}), 0.05);
  EXPECT_TRUE(std::isinf(samplingGap(ball, {6.0, 0.0, 0.0, 0.0})));
  EXPECT_TRUE(std::isinf(samplingGap(ball, {d, 1.571, 5.0, 0.0})));
}

} // namespace cutter_drop_test
