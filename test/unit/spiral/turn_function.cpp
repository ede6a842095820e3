// SPDX-License-Identifier: BSD-3-Clause
// The turn function on exact lines: plane disc, square, sphere, bowl.
#include "support/checked_path.h"
#include "support/plane_lines.h"

#include <pcl_spiral/spiral/impl/turn_function.h>

#include <gtest/gtest.h>

#include <cstdio>

namespace turn_function_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

const auto from_origin = [](std::size_t) { return Vector3d(0, 0, 0); };

SpiralSettings
cutter(double radius, double scallop)
{
  SpiralSettings settings;
  settings.tool_radius = radius;
  settings.scallop_height = scallop;
  return settings;
}

/** Meridians of a sphere about the origin from its top down to \p reach of arc length; hollow: seen from inside. */
std::vector<RadialLine>
meridians(double radius, double reach, std::size_t count, bool hollow)
{
  std::vector<RadialLine> lines;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(count);
    lines.push_back(test::lineThrough([&](double t) {
      const double polar = t * reach / radius;
      SurfaceFoot foot;
      foot.normal = Vector3d(std::sin(polar) * std::cos(a), std::sin(polar) * std::sin(a), std::cos(polar));
      foot.position = radius * foot.normal;
      foot.direction1 = Vector3d(std::cos(polar) * std::cos(a), std::cos(polar) * std::sin(a), -std::sin(polar));
      foot.curvature1 = foot.curvature2 = (hollow ? -1.0 : 1.0) / radius;
      foot.normal *= hollow ? -1.0 : 1.0;
      return foot;
    }));
    lines[i].rim_share = lines[i].turn_share = static_cast<double>(i) / static_cast<double>(count);
  }
  return lines;
}

/** Turns increase evenly with arc length, and are as few as the step-over allows, up to half a percent and one turn. */
void
expectEven(const TurnFunction& turns, double length, double step, std::size_t lines)
{
  EXPECT_GE(static_cast<double>(turns.turns()), length / step);
  EXPECT_LE(static_cast<double>(turns.turns()), 1.005 * length / step + 1.0);
  const double pitch = length / static_cast<double>(turns.turns());
  for (std::size_t i = 0; i < lines; i += 5)
    for (const double share : {0.0, 0.004, 0.13, 0.5, 0.77, 0.999, 1.0}) {
      EXPECT_NEAR(turns.shareAt(i, share * length), share, 1e-6);
      EXPECT_NEAR(turns.arcLengthAt(i, share * static_cast<double>(turns.turns())), share * static_cast<double>(turns.turns()) * pitch,
                  1e-5 * length);
    }
}

TEST(TurnFunction, AFootThatIsNotValidTellsNothing)
{
  auto lines = meridians(100.0, 60.0, 48, false);
  for (RadialLine& line : lines)
    for (SurfaceFoot& foot : line.feet)
      foot.valid = true;
  const SpiralSettings settings = cutter(5.0, 0.05);
  TurnFunction whole(lines, settings, 0.5);
  ASSERT_TRUE(whole.compute().ok());
  // At its end a line may be slightly beyond the surface: the values of the foot there are not used.
  SurfaceFoot& end = lines[7].feet.back();
  end.valid = false;
  end.curvature1 = end.curvature2 = -1.0;
  TurnFunction beyond(lines, settings, 0.5);
  ASSERT_TRUE(beyond.compute().ok());
  EXPECT_EQ(beyond.turns(), whole.turns());
  EXPECT_NEAR(beyond.smallestStepOver(), whole.smallestStepOver(), 1e-12);
  lines[9].feet[20].valid = false;
  const Status status = TurnFunction(lines, settings, 0.5).compute();
  EXPECT_EQ(status.code(), StatusCode::Failed);
  EXPECT_NE(status.message().find("radial line 9 leaves the scanned surface"), std::string::npos) << status.message();
}

TEST(TurnFunction, EvenOnAPlaneDisc)
{
  const auto lines = test::straightLines(from_origin, test::ring(100.0, 64));
  const double step = test::exactStepOver(5.0, 0.05, 0.0);
  for (const Pitch pitch : {Pitch::AcrossFeed, Pitch::AlongLine}) {
    SpiralSettings settings = cutter(5.0, 0.05);
    settings.pitch = pitch;
    TurnFunction turns(lines, settings, 0.5);
    ASSERT_TRUE(turns.compute().ok());
    expectEven(turns, 100.0, step, lines.size());
    EXPECT_NEAR(turns.smallestStepOver(), step, 1e-9);
    EXPECT_NEAR(turns.largestStepOver(), step, 1e-9);
    EXPECT_DOUBLE_EQ(turns.feedStepAt(3, 50.0), 5.0); // no bend: the longest step, by default the tool radius
  }
}

TEST(TurnFunction, SphereOutsideAndInside)
{
  for (const bool hollow : {false, true}) {
    const double radius = 60.0, reach = 75.0, curvature = (hollow ? -1.0 : 1.0) / radius;
    const auto lines = meridians(radius, reach, 48, hollow);
    TurnFunction turns(lines, cutter(8.0, 0.02), 0.5);
    const Status status = turns.compute();
    ASSERT_TRUE(status.ok()) << status.message();
    expectEven(turns, reach, test::exactStepOver(8.0, 0.02, curvature), lines.size());
    // A move whose ball centre leaves its arc of radius rho + R by the chord error, as seen at the contact.
    const double centre_radius = radius + (hollow ? -8.0 : 8.0), e = 0.005;
    const double move = 2.0 * std::sqrt(2.0 * centre_radius * e - e * e) * radius / centre_radius;
    EXPECT_NEAR(turns.feedStepAt(7, 40.0), move, 1e-6);
  }
}

TEST(TurnFunction, EvenStepsAreTakenAsTheyAre)
{
  const double length = 75.0, step_over = 1.7, step = 0.9;
  auto lines = meridians(60.0, length, 48, true);
  lines[5].feet[64].curvature2 = -1.0; // the cutter does not fit: not checked
  SpiralSettings settings = cutter(8.0, 0.02);
  settings.pitch = Pitch::AlongLine;
  TurnFunction turns(lines, settings, 0.5);
  turns.setEvenSteps(step_over, step);
  const Status status = turns.compute();
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(turns.turns(), static_cast<std::size_t>(std::ceil(length / step_over)));
  EXPECT_EQ(turns.smallestStepOver(), step_over);
  EXPECT_EQ(turns.largestStepOver(), step_over);
  for (std::size_t i = 0; i < lines.size(); i += 5)
    for (double tau = 0.0; tau <= static_cast<double>(turns.turns()); tau += 3.7) {
      const double s = lines[i].length() * tau / static_cast<double>(turns.turns());
      EXPECT_NEAR(turns.arcLengthAt(i, tau), s, 1e-9 * length); // (17)-(19) with the same step-over everywhere
      EXPECT_DOUBLE_EQ(turns.feedStepAt(i, s), step);
    }
}

TEST(TurnFunction, SquareSavesTheRootOfTwo)
{
  const double half = 100.0;
  const Polyline rim = test::squareRim(half, 32);
  const auto lines = test::straightLines(from_origin, rim, {0, 32, 64, 96});
  SpiralSettings settings = cutter(5.0, 0.01);
  const double step = test::exactStepOver(5.0, 0.01, 0.0);
  settings.pitch = Pitch::AlongLine;
  TurnFunction along(lines, settings, 1.0);
  ASSERT_TRUE(along.compute().ok());
  EXPECT_NEAR(static_cast<double>(along.turns()), std::sqrt(2.0) * half / step, 2.0);
  settings.pitch = Pitch::AcrossFeed;
  TurnFunction across(lines, settings, 1.0);
  ASSERT_TRUE(across.compute().ok());
  EXPECT_GE(static_cast<double>(across.turns()), half / step);
  EXPECT_LT(static_cast<double>(across.turns()), 1.025 * half / step);

  // In the middle between two contours no place is farther than half a step-over from the nearer contour.
  const auto contour = [&](double tau) {
    Polyline points;
    for (std::size_t i = 0; i < lines.size(); ++i)
      points.push_back(lines[i].curve.positionAt(across.arcLengthAt(i, tau)));
    return points;
  };
  const auto distance = [](const Vector3d& p, const Polyline& closed) {
    double best = 1e300;
    for (std::size_t k = 0; k < closed.size(); ++k) {
      const Vector3d a = closed[k], d = closed[(k + 1) % closed.size()] - a;
      const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      best = std::min(best, (a + t * d - p).norm());
    }
    return best;
  };
  double widest = 0.0;
  for (double tau = 2.0; tau + 1.0 <= static_cast<double>(across.turns()); tau += 3.0) {
    const Polyline inside = contour(tau), outside = contour(tau + 1.0);
    for (const Vector3d& p : contour(tau + 0.5))
      widest = std::max(widest, 2.0 * std::min(distance(p, inside), distance(p, outside)));
  }
  std::printf("  turns %zu along, %zu across; widest pitch %.4f of the step-over\n", along.turns(), across.turns(), widest / step);
  EXPECT_LT(widest, 1.001 * step);
}

TEST(TurnFunction, HollowTighterThanTheCutterIsRefusedWithItsPlace)
{
  auto lines = test::straightLines(from_origin, test::ring(100.0, 16));
  lines[5].feet[64].curvature2 = -1.0 / 7.5;
  char place[32]; // as in messages
  std::snprintf(place, sizeof place, "(%.3f, ", lines[5].feet[64].position.x());
  SpiralSettings refusing = cutter(8.0, 0.05);
  refusing.tight = TightHandling::Refuse;
  TurnFunction tight(lines, refusing, 0.5);
  const Status status = tight.compute();
  EXPECT_EQ(status.code(), StatusCode::Failed);
  for (const std::string& part : {std::string("7.5 mm"), std::string(place), std::string("smaller tool")})
    EXPECT_NE(status.message().find(part), std::string::npos) << part << " is not in: " << status.message();
  TurnFunction small(lines, cutter(7.0, 0.05), 0.5);
  EXPECT_TRUE(small.compute().ok());
}

} // namespace

} // namespace turn_function_test
