// SPDX-License-Identifier: BSD-3-Clause
// Profiles of cutters: continuity, inverse, closed forms of the special cases, contact to location by brute force.
#include <pcl_spiral/core/cutter_profile.h>

#include "support/cutters.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cutter_profile_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;
constexpr int many = 10000;

Vector3d
unitVector(Random& random)
{
  return Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

/** Points of the profile, (distance from the axis, height), at equal steps along each part and at every edge. */
std::vector<Eigen::Vector2d>
profilePoints(const CutterShape& s, int each)
{
  const double a = s.flank_angle * degree, r1 = s.radius - s.flank_length * std::sin(a);
  const double r2 = r1 - s.corner_radius * std::cos(a), h = s.corner_radius - s.corner_radius * std::sin(a);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= each; ++i) {
    const double f = static_cast<double>(i) / each, t = f * (0.5 * M_PI - a);
    points.emplace_back(f * r2, 0.0);
    points.emplace_back(r2 + s.corner_radius * std::sin(t), s.corner_radius - s.corner_radius * std::cos(t));
    points.emplace_back(r1 + f * s.flank_length * std::sin(a), h + f * s.flank_length * std::cos(a));
  }
  return points;
}

} // namespace

TEST(CutterProfile, IsContinuousAtBothJointsAndConvex)
{
  Random random(1);
  for (int i = 0; i < many; ++i) {
    const CutterProfile c(randomCutter(random));
    const double R = c.radius(), step = 1e-9 * R;
    for (const double joint : {c.flatRadius(), c.flankRadius()})
      if (joint > step && joint + step < R && (c.cornerRadius() > 0.0 || joint == c.flatRadius())) {
        // The profile is at most as steep as the flank, or as a corner of any radius this far beyond the flat.
        const double steepest = c.flankAngle() > 0.0 ? 1.0 / std::tan(c.flankAngle()) : 1e5;
        ASSERT_NEAR(c.height(joint - step), c.height(joint + step), 2.0 * step * steepest + 1e-12 * R) << i;
      }
    double before = 0.0, slope = 0.0;
    for (int k = 1; k <= 50; ++k) {
      const double l = R * k / 50.0, z = c.height(l);
      ASSERT_GE(z, before);
      ASSERT_GE((z - before) * 50.0 / R, slope - 1e-9);
      slope = (z - before) * 50.0 / R;
      before = z;
    }
    ASSERT_NEAR(c.height(c.flankRadius()), c.cornerHeight(), 1e-12 * R);
    if (c.flankAngle() > 0.0)
      ASSERT_NEAR(c.height(R), c.topHeight(), 1e-9 * (R + c.topHeight()));
  }
}

TEST(CutterProfile, LiesOnThePointsOfItsParametricForm)
{
  Random random(2);
  for (int i = 0; i < many; ++i) {
    const CutterShape shape = randomCutter(random);
    const CutterProfile c(shape);
    for (const Eigen::Vector2d& p : profilePoints(shape, 4)) {
      // Steep places define the radius well, level places the height.
      const double radius_off = std::abs(c.radiusAt(p.y()) - p.x());
      const double height_off = std::abs(c.height(std::min(p.x(), c.radius())) - p.y());
      ASSERT_LT(std::min(radius_off, height_off), 1e-9 * (shape.radius + shape.flank_length)) << i;
    }
  }
}

TEST(CutterProfile, HeightAndRadiusAreInverse)
{
  Random random(3);
  for (int i = 0; i < many; ++i) {
    const CutterProfile c(randomCutter(random));
    const double top = c.flankAngle() > 0.0 ? c.topHeight() : c.cornerHeight();
    const double z = random.uniform() * top;
    if (z > 0.0)
      ASSERT_NEAR(c.height(c.radiusAt(z)), z, 1e-7 * (c.radius() + z)) << i; // steep near a cylinder
    const double l = random.uniform(c.flatRadius(), c.radius());
    if (c.height(l) > 0.0)
      ASSERT_NEAR(c.radiusAt(c.height(l)), l, 1e-9 * c.radius()) << i;
  }
}

TEST(CutterProfile, SpecialCasesHaveTheirClosedForms)
{
  const CutterProfile ball(CutterShape::ball(5.0, 20.0)), flat(CutterShape::flatEnd(5.0));
  const CutterProfile bull(CutterShape::bullNose(5.0, 1.5)), cone(CutterShape::taper(5.0, 10.0, 20.0));
  const CutterProfile tapered_ball(CutterShape::taperedBall(6.0, 30.0, 5.0));
  const double cone_tip = 5.0 - 10.0 * std::sin(20.0 * degree);
  for (double l = 0.0; l <= 5.0; l += 0.01) {
    EXPECT_NEAR(ball.height(l), 5.0 - std::sqrt(25.0 - l * l), 1e-12);
    EXPECT_EQ(flat.height(l), 0.0);
    EXPECT_NEAR(bull.height(l), l <= 3.5 ? 0.0 : 1.5 - std::sqrt(2.25 - (l - 3.5) * (l - 3.5)), 1e-12);
    EXPECT_NEAR(cone.height(l), l <= cone_tip ? 0.0 : (l - cone_tip) / std::tan(20.0 * degree), 1e-12);
  }
  EXPECT_NEAR(ball.topHeight(), 25.0, 1e-12);
  EXPECT_EQ(ball.radiusAt(12.0), 5.0);
  EXPECT_EQ(tapered_ball.flatRadius(), 0.0);
  const double r = (6.0 - 30.0 * std::sin(5.0 * degree)) / std::cos(5.0 * degree);
  EXPECT_NEAR(tapered_ball.cornerRadius(), r, 1e-12);
  EXPECT_NEAR(tapered_ball.height(0.5 * r), r - std::sqrt(0.75) * r, 1e-12);
  EXPECT_NEAR(tapered_ball.topHeight(), r * (1.0 - std::sin(5.0 * degree)) + 30.0 * std::cos(5.0 * degree), 1e-12);
  EXPECT_EQ(ball.height(5.001), std::numeric_limits<double>::infinity());
  EXPECT_EQ(ball.radiusAt(-0.001), 0.0);
}

TEST(CutterProfile, NormalsAreAcrossTheProfile)
{
  Random random(4);
  for (int i = 0; i < many; ++i) {
    const CutterProfile c(randomCutter(random));
    const double l = random.uniform(0.0, c.radius()), step = 1e-6 * c.radius();
    const bool at_edge = std::abs(l - c.flatRadius()) < 2 * step || std::abs(l - c.flankRadius()) < 2 * step;
    if (at_edge || l < step || l + step > c.radius())
      continue;
    const Eigen::Vector2d along(2.0 * step, c.height(l + step) - c.height(l - step));
    ASSERT_NEAR(c.normal(l).norm(), 1.0, 1e-12);
    ASSERT_NEAR(c.normal(l).dot(along.normalized()), 0.0, 1e-3) << i << ' ' << l;
    ASSERT_GE(c.normal(l).x(), 0.0);
    ASSERT_LE(c.normal(l).y(), 0.0);
  }
}

// Every cutter against a plane: no point of the cutter below the plane, no point of the plane in the cutter, and the
// contact on both.
TEST(CutterProfile, LocationsTouchTiltedPlanes)
{
  Random random(5);
  int parts[3] = {0, 0, 0};
  for (int i = 0; i < many; ++i) {
    const CutterShape shape = randomCutter(random);
    const CutterProfile c(shape);
    const Vector3d axis = unitVector(random), side = axis.cross(unitVector(random)).normalized();
    const double steepest = 0.5 * M_PI - c.flankAngle(), choice = random.uniform();
    const double lean = choice < 0.1 ? 0.0 : choice < 0.3 ? steepest : random.uniform(0.0, steepest);
    const Vector3d normal = std::cos(lean) * axis + std::sin(lean) * side;
    const Vector3d contact = 100.0 * unitVector(random);
    const CutterContact found = c.locate(contact, normal, axis);
    ASSERT_TRUE(found.touches) << i;
    ++parts[static_cast<int>(found.part)];
    const double scale = shape.radius + shape.flank_length;

    const Vector3d from_tip = contact - found.tip;
    const double l = (from_tip - from_tip.dot(axis) * axis).norm();
    ASSERT_NEAR(l, found.distance, 1e-9 * scale + 1e-12);
    ASSERT_NEAR(from_tip.dot(axis), found.height, 1e-9 * scale + 1e-12);
    ASSERT_LT(std::min(std::abs(c.radiusAt(found.height) - l), std::abs(c.height(std::min(l, c.radius())) - found.height)), 1e-9 * scale);

    const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
    double least = 1e300;
    for (const Eigen::Vector2d& p : profilePoints(shape, 12))
      for (int k = 0; k < 24; ++k) {
        const double t = 2.0 * M_PI * k / 24;
        const Vector3d at = found.tip + p.x() * (std::cos(t) * u + std::sin(t) * v) + p.y() * axis;
        least = std::min(least, (at - contact).dot(normal));
      }
    ASSERT_GT(least, -1e-9) << i;
    const Vector3d e = normal.unitOrthogonal(), f = normal.cross(e);
    for (int k = 0; k < 50; ++k) {
      const Vector3d at = contact + shape.radius * (random.uniform(-2.0, 2.0) * e + random.uniform(-2.0, 2.0) * f);
      const double height = (at - found.tip).dot(axis);
      const double distance = (at - found.tip - height * axis).norm();
      if (distance <= c.radius() && height < c.topHeight())
        ASSERT_FALSE(c.contains(distance, height, 1e-9 * scale / std::max(1e-3, std::cos(lean)))) << i;
    }
  }
  for (const int count : parts)
    EXPECT_GT(count, 500);
}

TEST(CutterProfile, TouchesAreTheReverseOfLocations)
{
  Random random(8);
  for (int i = 0; i < many; ++i) {
    const CutterProfile c(randomCutter(random));
    const Vector3d point = 50.0 * unitVector(random), normal = unitVector(random), axis = unitVector(random);
    const CutterContact contact = c.locate(point, normal, axis);
    if (!contact.touches)
      continue;
    const CutterTouch touch = c.touchAt(contact.tip, axis, point, normal);
    ASSERT_LT((touch.place - point).norm(), 1e-7 * c.radius() + 1e-9) << i;
    ASSERT_LT((touch.normal - normal).norm(), 1e-5) << i;
    // A place known less well: still on the cutter, with the cutter's normal.
    const CutterTouch near = c.touchAt(contact.tip, axis, point + 0.01 * c.radius() * unitVector(random), Vector3d::Zero());
    const Vector3d from = near.place - contact.tip;
    const double z = from.dot(axis), l = (from - z * axis).norm();
    ASSERT_FALSE(c.contains(l * (1.0 + 1e-9), z, 1e-6 * c.radius())) << i; // on a cylinder, not within its rounding
    ASSERT_TRUE(c.contains(l * (1.0 - 1e-5), z + 1e-5 * c.radius())) << i;
    ASSERT_NEAR(near.normal.norm(), 1.0, 1e-9);
    ASSERT_GE(near.normal.dot(axis), std::sin(c.flankAngle()) - 1e-9);
  }
}

TEST(CutterProfile, ATouchOfABallHasTheWayToItsCentreAsNormal)
{
  Random random(9);
  const CutterProfile ball(CutterShape::ball(3.0, 5.0));
  const Vector3d tip(1, 2, 3), axis = Vector3d(0.2, -0.3, 1.0).normalized(), centre = tip + 3.0 * axis;
  for (int i = 0; i < 1000; ++i) {
    Vector3d down = unitVector(random);
    down *= down.dot(axis) > 0.0 ? -1.0 : 1.0;
    const CutterTouch touch = ball.touchAt(tip, axis, centre + random.uniform(2.5, 3.5) * down, Vector3d::Zero());
    EXPECT_LT((touch.place - centre - 3.0 * down).norm(), 1e-9);
    EXPECT_LT((touch.normal + down).norm(), 1e-9);
  }
  const CutterTouch below = ball.touchAt(tip, axis, tip, Vector3d::UnitX());
  EXPECT_LT((below.normal - axis).norm() + (below.place - tip).norm(), 1e-9);
  const CutterTouch beside = ball.touchAt(tip, axis, centre + 2.0 * axis + 3.0 * axis.unitOrthogonal(), axis);
  EXPECT_LT((beside.normal + axis.unitOrthogonal()).norm(), 1e-9);
}

TEST(CutterProfile, SaysWhereThePlaneLeansOverTheFlank)
{
  const CutterProfile c(CutterShape::taperedBullNose(6.0, 1.0, 20.0, 10.0));
  const Vector3d axis = Vector3d::UnitZ();
  const auto leaning = [](double degrees) { return Vector3d(std::sin(degrees * degree), 0.0, std::cos(degrees * degree)); };
  EXPECT_EQ(c.locate(Vector3d::Zero(), leaning(79.9), axis).part, CutterPart::Corner);
  EXPECT_EQ(c.locate(Vector3d::Zero(), leaning(80.0), axis).part, CutterPart::Flank);
  EXPECT_FALSE(c.locate(Vector3d::Zero(), leaning(80.0), axis).unique);
  const CutterContact over = c.locate(Vector3d::Zero(), leaning(85.0), axis);
  EXPECT_FALSE(over.touches);
  EXPECT_NEAR(over.excess_angle, 5.0, 1e-9);
  EXPECT_NEAR(over.distance, 6.0, 1e-12);
  EXPECT_FALSE(c.locate(Vector3d::Zero(), -axis, axis).touches);
  EXPECT_NEAR(CutterProfile(CutterShape::ball(3.0)).locate(Vector3d::Zero(), leaning(90.0), axis).tip.x(), 3.0, 1e-9);
}

TEST(CutterProfile, ABallsCentreIsARadiusOffTheContact)
{
  Random random(6);
  const CutterProfile ball(CutterShape::ball(4.0));
  for (int i = 0; i < 1000; ++i) {
    const Vector3d n = unitVector(random), contact = 10.0 * unitVector(random);
    Vector3d axis = unitVector(random);
    if (n.dot(axis) < 0.0)
      axis = -axis;
    ASSERT_LT((ball.locate(contact, n, axis).tip + 4.0 * axis - contact - 4.0 * n).norm(), 1e-12);
  }
}

TEST(CutterProfile, BadMeasuresAreNamedWithTheirValueAndARemedy)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const struct {
    CutterShape shape;
    const char* says;
  } cases[] = {
      {CutterShape::ball(0.0), "radius is 0 mm"},
      {CutterShape::ball(-3.0), "radius is -3 mm"},
      {CutterShape::ball(nan), "radius is nan mm"},
      {CutterShape::ball(inf), "radius is inf mm"},
      {CutterShape::bullNose(5.0, 6.0), "corner reaches across the axis: its radius is 6 mm; set it to 5 mm"},
      {CutterShape::bullNose(5.0, -1.0), "corner radius is -1 mm"},
      {CutterShape::bullNose(5.0, nan), "corner radius is nan mm"},
      {CutterShape::taper(5.0, 10.0, 90.0), "flank angle is 90 degrees"},
      {CutterShape::taper(5.0, 10.0, -5.0), "flank angle is -5 degrees"},
      {CutterShape::taper(5.0, 11.0, 30.0), "it meets the axis above its lower end: its length is 11 mm; set it to 10 mm"},
      {CutterShape::taper(5.0, -1.0, 30.0), "flank length is -1 mm"},
      {CutterShape::taper(5.0, nan, 30.0), "flank length is nan mm"},
      {CutterShape::taperedBall(5.0, 60.0, 10.0), "it meets the axis above its lower end"},
      {CutterShape::taperedBullNose(5.0, 4.0, 10.0, 10.0), "corner reaches across the axis: its radius is 4 mm"},
  };
  for (const auto& one : cases) {
    EXPECT_NE(faultOf(one.shape).text().find(one.says), std::string::npos) << faultOf(one.shape);
    EXPECT_THROW(CutterProfile{one.shape}, std::invalid_argument);
  }
  EXPECT_EQ(faultOf(CutterShape::taper(5.0, 10.0, 30.0)), ""); // a cone with a point
  EXPECT_EQ(faultOf(CutterShape::taperedBall(6.0, 30.0, 5.0)), "");
}

} // namespace cutter_profile_test
