// SPDX-License-Identifier: BSD-3-Clause
// Paths over places that the ball does not reach, against parts in closed form: no gouge, and what stays is reported.
#include "support/ball_turns.h"
#include "support/sampling.h"
#include "support/surfaces.h"
#include "support/tight_parts.h"

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/verify/deviation_estimation.h>
#include <pcl_spiral/verify/material_removal.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <random>

namespace tight_ride_test {

namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;

constexpr double scallop = 0.05;

struct Made {
  Path::Ptr path = std::make_shared<Path>();
  SpiralReport report;
  Status status;
};

Made
pathOver(const Cloud::Ptr& cloud, SpiralMethod method, double ball, unsigned int threads = 2)
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(cloud);
  spiral.setMethod(method);
  spiral.setToolRadius(ball);
  spiral.setScallopHeight(scallop);
  spiral.setNumberOfThreads(threads);
  Made made;
  spiral.compute(*made.path);
  made.report = spiral.getReport();
  made.status = spiral.getStatus();
  EXPECT_TRUE(made.status.ok()) << made.status.message();
  return made;
}

/** The deepest that the ball is in the true surface, at the points of the path and on the way between them. */
double
deepest(const TightPart& part, const Path& path, double ball)
{
  double depth = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    for (const double share : {0.0, 0.25, 0.5, 0.75}) {
      const Vector3d centre = (1.0 - share) * ballCentre(path[i - 1], ball) + share * ballCentre(path[i], ball);
      depth = std::max(depth, ball - part.distance(centre));
    }
  return depth;
}

/** Whole turns on which the ball is lifted everywhere. In a valley both sides of such a turn are in its lowest line: it turns back at both
 *  ends. */
std::size_t
liftedTurns(const Path& path)
{
  std::map<int, bool> lifted;
  for (const ToolpathPoint& point : path)
    lifted.try_emplace(static_cast<int>(point.turn), true).first->second &= point.lift > 0.0f;
  return static_cast<std::size_t>(std::count_if(lifted.begin(), lifted.end(), [](const auto& turn) { return turn.second; }));
}

/** The highest that the ball runs over the true surface where it is lifted, at the points of the path and on the way between them. */
double
highest(const TightPart& part, const Path& path, double ball)
{
  double height = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    for (const double share : {0.0, 0.5})
      if (path[i].lift > 0.0f && path[i - 1].lift > 0.0f)
        height = std::max(height, part.distance((1.0 - share) * ballCentre(path[i], ball) + share * ballCentre(path[i - 1], ball)) - ball);
  return height;
}

/** The largest move of the ball between points, and the largest change of the axis, degrees. */
void
expectSmooth(const Path& path, double ball)
{
  double jump = 0.0, turn = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    jump = std::max(jump, (ballCentre(path[i], ball) - ballCentre(path[i - 1], ball)).norm());
    const double cosine = path[i].getAxisVector3fMap().dot(path[i - 1].getAxisVector3fMap());
    turn = std::max(turn, std::acos(std::min(1.0, cosine)) * 180.0 / M_PI);
  }
  std::printf("  longest move of the ball %.3f mm, largest change of the axis %.1f degrees\n", jump, turn);
  EXPECT_LT(jump, 1.1 * ball);
  EXPECT_LT(turn, 60.0);
}

class TightRide : public ::testing::TestWithParam<SpiralMethod> {};

TEST_P(TightRide, OverAValleyNeverGouges)
{
  const double slope = 0.7, fillet = 3.0, ball = 6.0, half_width = 20.0;
  const TightPart part = valley(slope, fillet, 20.0, half_width);
  for (const double noise : {0.0, 0.01}) {
    const Made made = pathOver(part.scan(0.5, noise, 11), GetParam(), ball);
    ASSERT_FALSE(made.path->empty());
    const double depth = deepest(part, *made.path, ball);
    const double height = (ball - fillet) * (1.0 / std::cos(slope) - 1.0);
    // More than the scallop height stays between the contacts of the resting ball, where the surface is farther from it than that.
    const double rest = valleyCentre(slope, fillet, ball), touched = fillet * slope + (ball - fillet) * std::tan(slope);
    double area = 0.0;
    for (double t = 0.0; t < touched; t += 1e-3) {
      const double turned = std::min(t / fillet, slope), on = std::max(0.0, t - fillet * slope);
      const Eigen::Vector2d place(fillet * std::sin(turned) + on * std::cos(slope),
                                  fillet * (1.0 - std::cos(turned)) + on * std::sin(slope));
      if (std::hypot(place.x(), place.y() - rest) - ball > scallop)
        area += 2.0 * 1e-3 * 2.0 * half_width;
    }
    std::printf("  noise %g: deepest %.4f; %zu places, %.4f of %.4f mm high, %.1f of %.1f mm2, ball %.3f; lifted %.1f mm up to %.3f\n",
                noise, depth, made.report.tight_places.size(), made.report.tight_places.front().height, height,
                made.report.tight_places.front().area, area, made.report.fitting_radius, made.report.lifted_length,
                made.report.largest_lift);
    EXPECT_LT(depth, 0.005 + 0.015 + 4.0 * noise);
    ASSERT_EQ(made.report.tight_places.size(), 1U);
    EXPECT_NEAR(made.report.tight_places.front().height, height, 0.02 + 4.0 * noise);
    EXPECT_NEAR(made.report.tight_places.front().area, area, 0.1 * area);
    EXPECT_NEAR(std::hypot(made.report.tight_places.front().place.x(), made.report.tight_places.front().place.z()), 0.0, 0.3);
    EXPECT_NEAR(made.report.fitting_radius, fillet, 0.1 * fillet);
    EXPECT_GT(made.report.lifted_length, 2.0 * half_width);
    expectSmooth(*made.path, ball);
    const std::size_t back = ballTurns(*made.path, ball);
    const double over = highest(part, *made.path, ball);
    std::printf("  turns back at %zu places, reported %zu, %zu turns lifted; up to %.4f mm over the offset\n", back, made.report.reversals,
                liftedTurns(*made.path), over);
    const std::size_t by_noise = noise > 0.0 ? 1 : 0; // of loops of their own
    EXPECT_LE(back, GetParam() == SpiralMethod::Radial ? 2 * (liftedTurns(*made.path) + 1) : by_noise);
    EXPECT_EQ(made.report.reversals, back);
    EXPECT_LT(over, 0.005 + 0.015 + 4.0 * noise);
    EXPECT_TRUE(pathOver(part.scan(0.5, noise, 11), GetParam(), made.report.fitting_radius).report.tight_places.empty());
    ASSERT_FALSE(made.report.warnings.empty());
    EXPECT_TRUE(std::any_of(made.report.warnings.begin(), made.report.warnings.end(), [](const pcl_spiral::Diagnostic& text) {
      return text.text().find("the ball does not reach 1 place:") != std::string::npos;
    }));
  }
}

TEST_P(TightRide, OverAPitRestsOnItsRim)
{
  const double pit = 4.0, rim = 1.5, ball = 6.0;
  const TightPart part = pittedPlane(pit, rim, 20.0);
  const Made made = pathOver(part.scan(0.4, 0.0, 5), GetParam(), ball);
  ASSERT_FALSE(made.path->empty());
  const double height = pitCentre(pit, rim, ball) + pit - ball;
  double lowest = 1e9;
  for (const ToolpathPoint& point : *made.path)
    lowest = std::min(lowest, ballCentre(point, ball).z());
  std::printf("  lowest centre %.4f of %.4f, deepest %.4f, height %.4f of %.4f\n", lowest, pitCentre(pit, rim, ball),
              deepest(part, *made.path, ball), made.report.tight_places.front().height, height);
  EXPECT_NEAR(lowest, pitCentre(pit, rim, ball), 0.05);
  EXPECT_LT(deepest(part, *made.path, ball), 0.03);
  ASSERT_EQ(made.report.tight_places.size(), 1U);
  EXPECT_NEAR(made.report.tight_places.front().height, height, 0.05);
  expectSmooth(*made.path, ball);
  EXPECT_EQ(ballTurns(*made.path, ball), 0U);
}

TEST_P(TightRide, BesideASphereNeverGouges)
{
  const double ball = 4.0;
  const TightPart part = ballOnPlane(8.0, 1.0, 20.0);
  const Made made = pathOver(part.scan(0.35, 0.0, 9), GetParam(), ball);
  ASSERT_FALSE(made.path->empty());
  std::printf("  deepest %.4f, %.4f high\n", deepest(part, *made.path, ball), made.report.tight_places.front().height);
  EXPECT_LT(deepest(part, *made.path, ball), 0.03);
  EXPECT_EQ(ballTurns(*made.path, ball), 0U);
}

/** The judge: gouge 0 up to what the scan shows, stock reported where it stays, the scallop height kept elsewhere. */
TEST_P(TightRide, IsJudgedRight)
{
  const double slope = 0.7, fillet = 3.0, ball = 6.0;
  const TightPart part = valley(slope, fillet, 20.0, 20.0);
  const auto cloud = part.scan(0.5, 0.0, 11);
  const Made made = pathOver(cloud, GetParam(), ball);
  ASSERT_FALSE(made.path->empty());
  MaterialRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(cloud);
  removal.setInputToolpath(made.path);
  removal.setToolRadius(ball);
  removal.setScallopHeight(scallop);
  removal.setReach(5.0);
  pcl::PointCloud<pcl::PointXYZI> stock;
  removal.compute(stock);
  ASSERT_TRUE(removal.getStatus().ok()) << removal.getStatus().message();
  const RemovalReport& r = removal.getReport();
  DeviationEstimation<pcl::PointXYZ> deviation;
  deviation.setInputCloud(cloud);
  deviation.setInputToolpath(made.path);
  pcl::PointCloud<pcl::PointXYZI> deviations;
  deviation.compute(deviations);
  ASSERT_TRUE(deviation.getStatus().ok()) << deviation.getStatus().message();
  const DeviationReport& d = deviation.getReport();
  std::printf("  gouge %.4f, unreached %zu samples up to %.4f, scallop p99 %.4f max %.4f, rim %.4f, deviation max %.4f, lifted %zu\n",
              r.gouge.value, r.unreached.samples, r.unreached.max.value, r.scallop.p99, r.scallop.max.value, r.rim.max.value, d.max.value,
              d.lifted);
  EXPECT_LT(r.gouge.value, 0.02);
  EXPECT_NEAR(r.unreached.max.value, (ball - fillet) * (1.0 / std::cos(slope) - 1.0), 0.1);
  EXPECT_LT(r.scallop.p99, 1.1 * scallop);
  EXPECT_LT(std::abs(d.max.value), 0.02);
  EXPECT_GT(d.lifted, 100U);
  EXPECT_EQ(d.unmeasured, 0U);
}

TEST(TightRideOf, ABallThatReachesLessThanHalfIsRefusedAndTheRemedyWorks)
{
  Cloud::Ptr bowl = std::make_shared<Cloud>(); // of radius 30, 50 degrees to each side
  const Sampled samples = sampleUniform(*ball(30.0, Region({circle({0, 0}, 23.0)})), 6000, 5);
  for (const Vector3d& p : samples.points)
    bowl->push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(-p.z())));
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(bowl);
  spiral.setQuiet(true);
  spiral.setToolRadius(40.0);
  spiral.setScallopHeight(scallop);
  Path path;
  spiral.compute(path);
  ASSERT_EQ(spiral.getStatus().code(), StatusCode::InvalidArgument) << spiral.getStatus().message();
  EXPECT_TRUE(path.empty());
  const std::string& message = spiral.getStatus().message();
  const std::string remedy = "Use a ball of radius ";
  ASSERT_NE(message.find(remedy), std::string::npos) << message;
  const double radius = std::strtod(message.c_str() + message.find(remedy) + remedy.size(), nullptr);
  EXPECT_GT(radius, 0.8 * 30.0);
  EXPECT_LT(radius, 30.0);
  spiral.setToolRadius(radius);
  spiral.compute(path);
  EXPECT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
}

/** Oblique sections of the hollow must not make all turns closer: at even step-overs of the plane, the area needs this length. */
TEST_P(TightRide, IsNotMuchLongerThanTheAreaNeeds)
{
  const double slope = 0.7, fillet = 3.0, ball = 6.0, half_width = 20.0, reach = 20.0;
  const Made made = pathOver(valley(slope, fillet, reach, half_width).scan(0.5, 0.0, 11), GetParam(), ball);
  ASSERT_FALSE(made.path->empty());
  double length = 0.0;
  for (std::size_t i = 1; i < made.path->size(); ++i)
    length += ((*made.path)[i].getVector3fMap() - (*made.path)[i - 1].getVector3fMap()).norm();
  const double side = fillet * slope + (reach - fillet * std::sin(slope)) / std::cos(slope);
  const double needed = 2.0 * side * 2.0 * half_width / (2.0 * std::sqrt(scallop * (2.0 * ball - scallop)));
  std::printf("  %.0f mm long, %.2f times what the area needs\n", length, length / needed);
  EXPECT_LT(length, 1.6 * needed);
}

INSTANTIATE_TEST_SUITE_P(Methods, TightRide, ::testing::Values(SpiralMethod::Radial, SpiralMethod::ConstantScallop));

TEST(TightRideOf, TheSamePartInAnyOrderOrPlaceLeavesTheSame)
{
  const TightPart part = valley(0.7, 3.0, 12.0, 12.0);
  const auto cloud = part.scan(0.5, 0.01, 3);
  const Made made = pathOver(cloud, SpiralMethod::Radial, 6.0, 1);
  auto shuffled = std::make_shared<Cloud>(*cloud);
  std::mt19937 random(1);
  std::shuffle(shuffled->begin(), shuffled->end(), random);
  const Made again = pathOver(shuffled, SpiralMethod::Radial, 6.0, 2);
  ASSERT_EQ(again.path->size(), made.path->size());
  for (std::size_t i = 0; i < made.path->size(); ++i) {
    ASSERT_EQ((*made.path)[i].getVector3fMap(), (*again.path)[i].getVector3fMap()) << i;
    ASSERT_EQ((*made.path)[i].lift, (*again.path)[i].lift) << i;
  }
  const Eigen::Affine3f moved =
      Eigen::Translation3f(40.0f, -25.0f, 10.0f) * Eigen::AngleAxisf(0.4f, Eigen::Vector3f(0.3f, 1.0f, 0.2f).normalized());
  auto elsewhere = std::make_shared<Cloud>(*cloud);
  for (auto& point : *elsewhere)
    point.getVector3fMap() = moved * point.getVector3fMap();
  const Made there = pathOver(elsewhere, SpiralMethod::Radial, 6.0);
  ASSERT_EQ(there.report.tight_places.size(), made.report.tight_places.size());
  EXPECT_NEAR(there.report.tight_places[0].height, made.report.tight_places[0].height, 0.003);
  EXPECT_NEAR(there.report.tight_places[0].area, made.report.tight_places[0].area, 0.02 * made.report.tight_places[0].area);
  EXPECT_NEAR(there.report.lifted_length, made.report.lifted_length, 0.05 * made.report.lifted_length);
}

} // namespace

} // namespace tight_ride_test
