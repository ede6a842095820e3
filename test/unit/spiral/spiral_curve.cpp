// SPDX-License-Identifier: BSD-3-Clause
// The spiral between exact lines: on a plane disc it is an Archimedean spiral.
#include "support/plane_lines.h"

#include <pcl_spiral/spiral/impl/spiral_curve.h>

#include <gtest/gtest.h>

namespace spiral_curve_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

constexpr double radius = 60.0;

/** Lines, turns and the spiral on them. */
class Case {
public:
  Case(std::vector<RadialLine> lines, Polyline rim, std::vector<std::size_t> corners, Polyline inner = {})
  : lines_(std::move(lines)), rim_(std::move(rim)), corners_(std::move(corners)), inner_(std::move(inner))
  {
    settings.tool_radius = 5.0;
    settings.scallop_height = 0.1;
    settings.chord_error = 0.002;
  }

  std::vector<SpiralPoint> sample()
  {
    TurnFunction turn_function(lines_, settings, 0.5);
    EXPECT_TRUE(turn_function.compute().ok());
    SpiralCurve curve(lines_, turn_function, settings, 0.5);
    curve.setRim(rim_, corners_);
    if (!inner_.empty())
      curve.setInner(inner_, {});
    turns = static_cast<double>(turn_function.turns());
    longest = curve.largestAllowedStep();
    corner_places.clear();
    for (std::size_t i = 0; i < lines_.size(); ++i)
      for (double j = 0.0; lines_[i].corner && j < turns; ++j)
        corner_places.push_back(lines_[i].curve.positionAt(turn_function.arcLengthAt(i, j + lines_[i].turn_share)));
    return curve.sample();
  }

  SpiralSettings settings;
  double turns = 0.0, longest = 0.0;
  Polyline corner_places; ///< points where turns meet the lines that end on corners

private:
  std::vector<RadialLine> lines_;
  Polyline rim_;
  std::vector<std::size_t> corners_;
  Polyline inner_;
};

Case
disc()
{
  return Case(test::straightLines([](std::size_t) { return Vector3d(0, 0, 0); }, test::ring(radius, 128)), test::ring(radius, 1024), {});
}

Vector3d
archimedes(double turn, double turns)
{
  const double r = radius * turn / turns, angle = 2.0 * M_PI * turn;
  return {r * std::cos(angle), r * std::sin(angle), 0.0};
}

/** Distance across the spiral; \p turn only selects one of its turns. */
double
offArchimedes(const Vector3d& p, double turn, double turns)
{
  const double whole = std::floor(turn);
  double angle = std::atan2(p.y(), p.x()) / (2.0 * M_PI);
  angle += std::round(turn - whole - angle);
  return std::abs(p.norm() - radius * (whole + angle) / turns);
}

TEST(SpiralCurve, ArchimedesOnADisc)
{
  Case c = disc();
  const auto points = c.sample();
  EXPECT_EQ(points.front().position, Vector3d(0, 0, 0));
  EXPECT_EQ(points.front().turn, 0.0);
  EXPECT_NEAR((points.back().position - Vector3d(radius, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(points.back().turn, c.turns + 1.0);
  double inside = 0.0, outside = 0.0, rim = 0.0, sagitta = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const SpiralPoint &a = points[i - 1], &b = points[i];
    ASSERT_GT(b.turn, a.turn);
    EXPECT_LE((b.position - a.position).norm(), c.longest);
    if (b.turn > c.turns) {
      rim = std::max(rim, std::abs(b.position.norm() - radius));
      continue;
    }
    const double off = offArchimedes(b.position, b.turn, c.turns);
    (b.position.norm() > 5.0 ? outside : inside) = std::max(b.position.norm() > 5.0 ? outside : inside, off);
    if (b.position.norm() > 5.0)
      sagitta = std::max(sagitta, offArchimedes(0.5 * (a.position + b.position), 0.5 * (a.turn + b.turn), c.turns));
  }
  std::printf("  off Archimedes' spiral: %.2g mm within 5 mm of the centre, %.2g mm outside; sagitta %.4f mm\n", inside, outside, sagitta);
  EXPECT_LT(inside, 2e-3);
  EXPECT_LT(outside, 1e-3); // the chord error is twice that
  EXPECT_LT(rim, 1e-3);
  EXPECT_LT(sagitta, 1.25 * c.settings.chord_error);
  EXPECT_GT(sagitta, 0.5 * c.settings.chord_error); // no finer than asked for
}

TEST(SpiralCurve, LastLineOfATurnMeetsTheFirstOfTheNext)
{
  Case c = disc();
  const auto points = c.sample();
  std::size_t met = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double j = std::floor(points[i].turn);
    if (points[i - 1].turn >= j || j > c.turns)
      continue;
    ++met;
    const double t = (j - points[i - 1].turn) / (points[i].turn - points[i - 1].turn);
    const Vector3d p = (1.0 - t) * points[i - 1].position + t * points[i].position;
    EXPECT_NEAR((p - archimedes(j, c.turns)).norm(), 0.0, 2.0 * c.settings.chord_error) << "turn " << j;
  }
  EXPECT_EQ(static_cast<double>(met), c.turns);
}

TEST(SpiralCurve, ClockwiseIsTheMirrorAndInwardTheOtherSensesReverse)
{
  Case c = disc();
  const auto plain = c.sample();
  c.settings.sense = SpiralSense::Clockwise;
  const auto clockwise = c.sample();
  ASSERT_EQ(clockwise.size(), plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    EXPECT_NEAR((clockwise[i].position.cwiseProduct(Vector3d(1, -1, 1)) - plain[i].position).norm(), 0.0, 1e-6);
    EXPECT_NEAR(clockwise[i].turn, plain[i].turn, 1e-9);
  }
  // From its end, the clockwise spiral runs counter-clockwise.
  c.settings.sense = SpiralSense::CounterClockwise;
  c.settings.direction = SpiralDirection::Inward;
  const auto inward = c.sample();
  ASSERT_EQ(inward.size(), clockwise.size());
  for (std::size_t i = 0; i < inward.size(); ++i) {
    const SpiralPoint& other = clockwise[clockwise.size() - 1 - i];
    EXPECT_EQ(inward[i].position, other.position);
    EXPECT_NEAR(inward[i].turn, c.turns + 1.0 - other.turn, 1e-9);
  }
}

TEST(SpiralCurve, SquareKeepsItsCorners)
{
  const Polyline rim = test::squareRim(radius, 32);
  const std::vector<std::size_t> corners{0, 32, 64, 96};
  Case c(test::straightLines([](std::size_t) { return Vector3d(0, 0, 0); }, rim, corners), rim, corners);
  const auto points = c.sample();
  ASSERT_EQ(c.corner_places.size(), static_cast<std::size_t>(4.0 * c.turns));
  for (const Vector3d& corner : c.corner_places) {
    double nearest = 1e300;
    for (const SpiralPoint& p : points)
      nearest = std::min(nearest, (p.position - corner).norm());
    EXPECT_LT(nearest, 1e-9) << corner.transpose();
  }
  for (const std::size_t k : corners) // also those of the rim
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), [&](const SpiralPoint& p) { return p.position == rim[k]; }));
  for (const SpiralPoint& p : points)
    EXPECT_LT(p.position.cwiseAbs().maxCoeff(), radius + 1e-9);
}

TEST(SpiralCurve, AnnulusBeginsAndEndsRoundItsLoopsInTheSenseAskedFor)
{
  const Polyline outer = test::ring(radius, 128), inner = test::ring(20.0, 128);
  Case c(test::straightLines([&](std::size_t i) { return inner[i]; }, outer), test::ring(radius, 1024), {}, test::ring(20.0, 1024));
  const auto [ccw, cw] = std::pair(SpiralSense::CounterClockwise, SpiralSense::Clockwise);
  const auto [out, in] = std::pair(SpiralDirection::Outward, SpiralDirection::Inward);
  for (const auto& [sense, direction] : {std::pair(ccw, out), std::pair(cw, out), std::pair(ccw, in), std::pair(cw, in)}) {
    c.settings.sense = sense;
    c.settings.direction = direction;
    const auto points = c.sample();
    EXPECT_EQ(points.back().turn, c.turns + 2.0);
    double turned = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double r = points[i].position.norm();
      const double turn = direction == in ? c.turns + 2.0 - points[i].turn : points[i].turn;
      const double expected = 20.0 + 40.0 * std::clamp((turn - 1.0) / c.turns, 0.0, 1.0);
      EXPECT_NEAR(r, expected, 1e-2) << "turn " << turn;
      if (i > 0)
        turned += std::asin(points[i - 1].position.cross(points[i].position).z() / (r * points[i - 1].position.norm()));
    }
    EXPECT_NEAR(turned, (sense == SpiralSense::Clockwise ? -2.0 : 2.0) * M_PI * (c.turns + 2.0), 1e-6);
  }
}

} // namespace

} // namespace spiral_curve_test
