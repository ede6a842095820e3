// SPDX-License-Identifier: BSD-3-Clause
// checkPath and measureTurns: closest turns against brute force, reversals and what they are called, least length of radial lines.
#include <pcl_spiral/common/impl/thread_limit.h>
#include <pcl_spiral/spiral/impl/path_reversals.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include "core/self_crossing.h"
#include "spiral/path/turn_spacing.h"
#include "support/outline_loops.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace path_turns_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double pi = 3.14159265358979323846;
using Path = pcl::PointCloud<ToolpathPoint>;

/** A flat spiral; \p radius(turn). */
template <typename Radius>
SpiralPath
spiral(double turns, int points_a_turn, Radius radius)
{
  SpiralPath path;
  double length = 0.0;
  for (int i = 0; i <= turns * points_a_turn; ++i) {
    const double turn = static_cast<double>(i) / points_a_turn, t = 2.0 * pi * turn;
    const Vector3d p(radius(turn) * std::cos(t), radius(turn) * std::sin(t), 0.0);
    length += path.contacts.empty() ? 0.0 : (p - path.contacts.back()).norm();
    path.contacts.push_back(p);
    path.normals.push_back(Vector3d::UnitZ());
    path.turns.push_back(static_cast<float>(turn));
    path.arc_lengths.push_back(length);
  }
  return path;
}

/** By the definition: all points against all moves. */
double
bruteForce(const SpiralPath& path)
{
  double least = std::numeric_limits<double>::max();
  const double last = path.turns.back();
  const auto counts = [&](std::size_t i) { return path.turns[i] > 1.0f && last - path.turns[i] > 1.0; };
  for (std::size_t i = 0; i < path.contacts.size(); ++i)
    for (std::size_t k = 0; k + 1 < path.contacts.size(); ++k) {
      if (!counts(i) || !counts(k) || !counts(k + 1) || std::abs(double(path.turns[k]) - path.turns[i]) < 0.5 ||
          std::abs(double(path.turns[k + 1]) - path.turns[i]) < 0.5)
        continue;
      const Vector3d a = path.contacts[k], d = path.contacts[k + 1] - a, m = path.contacts[i] - a;
      least = std::min(least, (m - std::clamp(m.dot(d) / d.squaredNorm(), 0.0, 1.0) * d).norm());
    }
  return least;
}

SpiralSettings
ballOfFive(SpiralMethod method = SpiralMethod::Radial)
{
  SpiralSettings s;
  s.tool_radius = 5.0;
  s.scallop_height = 0.1;
  s.chord_error = 0.01;
  s.method = method;
  return s;
}

} // namespace

TEST(PathTurns, EvenTurnsAreOnePitchApart)
{
  ToolpathReport figures;
  measureTurns(spiral(12.0, 400, [](double turn) { return 1.5 * turn; }), ballOfFive(), figures);
  EXPECT_NEAR(figures.closest.distance, 1.5, 0.01); // the normal of the spiral leans a little from the radius
  EXPECT_EQ(figures.reversals.count, 0u);
}

TEST(PathTurns, ThePlaceWhereTurnsBunchIsFound)
{
  // A seam at +x: turns there are squeezed, the more the farther out.
  const SpiralPath path = spiral(10.0, 300, [](double turn) {
    const double squeeze = 0.02 * turn * std::exp(-std::pow(std::remainder(turn, 1.0) / 0.02, 2));
    return 1.5 * turn * (1.0 - squeeze);
  });
  std::vector<ClosestTurns> found;
  for (const int threads : {1, 4}) {
    const ThreadLimit limit(threads);
    ToolpathReport figures;
    measureTurns(path, ballOfFive(), figures);
    found.push_back(figures.closest);
  }
  EXPECT_EQ(found[0].distance, found[1].distance);
  EXPECT_EQ(found[0].place, found[1].place);
  EXPECT_NEAR(found[0].distance, bruteForce(path), 1e-12);
  EXPECT_LT(std::abs(found[0].place.y()), 1.0);
  EXPECT_GT(found[0].place.x(), 5.0);
}

TEST(PathTurns, OneWalkFindsTheClosestTurnsAndTheFirstCrossing)
{
  for (int trial = 0; trial < 12; ++trial) {
    SpiralPath path = spiral(8.0, 60 + 20 * trial, [](double turn) { return 1.5 * turn; });
    std::mt19937 random(trial);
    std::uniform_int_distribution<std::size_t> any(path.contacts.size() / 4, path.contacts.size() * 3 / 4);
    for (int k = 0; k < trial % 4; ++k)
      path.contacts[any(random)] += Vector3d(0.9, 0.4, 0.1); // some turns are crossed, some not
    const auto crossing = firstSelfCrossing(path.contacts, path.normals, ballOfFive().chord_error);
    ToolpathReport figures;
    std::optional<std::size_t> found;
    measureTurns(path, ballOfFive(), {}, figures, found);
    EXPECT_EQ(found, crossing) << trial;
    EXPECT_NEAR(figures.closest.distance, bruteForce(path), 1e-12) << trial;
  }
}

TEST(PathTurns, AReversalIsRefusedWithPlaceAngleCountAndRemedy)
{
  SpiralPath path = spiral(8.0, 800, [](double turn) { return 1.5 * turn; });
  const auto spike = [&](std::size_t i) { path.contacts[i] *= 1.0 + 0.7 / path.contacts[i].norm(); };
  spike(3600);
  spike(4400);
  spike(400);  // in the first turn
  spike(6100); // in the last, elsewhere along it
  ToolpathReport figures;
  measureTurns(path, ballOfFive(), figures);
  EXPECT_EQ(figures.reversals.count, 2u);
  EXPECT_GT(figures.reversals.angle, 150.0);
  EXPECT_TRUE(figures.reversals.place == path.contacts[3600] || figures.reversals.place == path.contacts[4400]);
  const Status radial = checkReversals(figures.reversals, ballOfFive());
  EXPECT_EQ(radial.code(), StatusCode::Failed);
  for (const char* part : {"at (", "degrees", "2 places", "setMethod"})
    EXPECT_NE(radial.message().find(part), std::string::npos) << radial.message();
  EXPECT_TRUE(checkReversals(figures.reversals, ballOfFive(SpiralMethod::ConstantScallop)).ok());
  SpiralSettings centred = ballOfFive();
  centred.centre = Vector3d::Zero();
  EXPECT_NE(checkReversals(figures.reversals, centred).message().find("setCenter"), std::string::npos);
}

TEST(PathTurns, ReversalsOfTheBallAreThoseOfItsCentre)
{
  // The feet go straight on in steps of 1 mm. The ball of radius 5 rests 7 mm over the feet 10 to 30, and is held back once.
  const double radius = 5.0;
  SpiralPath path;
  for (int i = 0; i < 40; ++i) {
    const bool lifted = i >= 10 && i <= 30;
    const double tilt = lifted ? 0.02 * (20 - i) : 0.0; // normals that turn move the contacts, not the centres
    const Vector3d foot(i, 0.0, 0.0), normal(std::sin(tilt), 0.0, std::cos(tilt));
    const Vector3d centre(i == 20 ? 18.5 : i, 0.0, lifted ? 7.0 : radius);
    path.feet.push_back(foot);
    path.normals.push_back(normal);
    path.contacts.push_back(centre - radius * normal);
    path.lifts.push_back(lifted ? 2.0f : 0.0f);
    path.turns.push_back(0.1f * static_cast<float>(i));
  }
  const PathReversals found = ballReversals(path, radius);
  EXPECT_EQ(found.count, 2u); // back to 18.5, and on again
  EXPECT_EQ(found.lifted, 2u);
  EXPECT_NEAR(found.angle, 180.0, 1e-6);
  EXPECT_EQ(found.place, path.contacts[19]);
  EXPECT_FLOAT_EQ(static_cast<float>(found.turn), 1.9f);

  SpiralPath feet_too = path; // where the feet turn back with it, the reversal is theirs
  feet_too.feet[20].x() = 18.5;
  EXPECT_EQ(ballReversals(feet_too, radius).count, 0u);

  SpiralPath passes = path; // the way from pass to pass is no move
  passes.passes = {20};
  EXPECT_EQ(ballReversals(passes, radius).count, 0u);

  SpiralPath on_surface = path;
  on_surface.lifts.assign(path.lifts.size(), 0.0f);
  EXPECT_EQ(ballReversals(on_surface, radius).count, 2u) << "in a hollow as tight as the ball it turns back without a lift";
  EXPECT_EQ(ballReversals(on_surface, radius).lifted, 0u);
  on_surface.lifts.clear();
  on_surface.feet.clear();
  EXPECT_EQ(ballReversals(on_surface, radius).count, 0u);
}

TEST(PathTurns, ReversalsWithStopsAndBetweenPassesAreCountedAlongAWholePath)
{
  SpiralPath path;
  std::size_t turned = 0;
  double x = 0.0, step = 1.0;
  const auto add = [&path](double at) {
    path.contacts.push_back({at, 0.0, 0.0});
    path.normals.push_back(Vector3d::UnitZ());
    path.turns.push_back(0.0f);
    path.feet.push_back({static_cast<double>(path.feet.size()), 0.0, 0.0}); // of the path over the surface, which runs on
  };
  add(x);
  for (int turn = 0; path.contacts.size() < 30000; ++turn) {
    for (int move = 0; move < 5 + turn % 7; ++move)
      add(x += step);
    for (int stop = 0; stop < turn % 4; ++stop) // the tool waits where it turns back
      add(x);
    if (turn % 5 == 0)
      path.passes.push_back(path.contacts.size() - 1); // lifted: a new pass begins where it turns back
    else
      ++turned;
    step = -step;
  }
  for (int move = 0; move < 5; ++move)
    add(x += step);
  const PathReversals found = ballReversals(path, 5.0);
  EXPECT_EQ(found.count, turned);
  EXPECT_NEAR(found.angle, 180.0, 1e-6);
}

TEST(PathTurns, ReversalsAtCornersOfTheOutlineAreAllowed)
{
  // Turns like a rhombus, which turn by 180 - 2 atan(0.15) = 162.9 degrees at two corners.
  SpiralPath path = spiral(8.0, 800, [](double turn) {
    const double t = 2.0 * pi * turn;
    return 1.5 * turn / (std::abs(std::cos(t)) + std::abs(std::sin(t)) / 0.15);
  });
  ToolpathReport figures;
  measureTurns(path, ballOfFive(), figures);
  EXPECT_GE(figures.reversals.count, 11u);
  EXPECT_EQ(figures.reversals.at_corners, figures.reversals.count);
  EXPECT_NEAR(figures.reversals.angle, 162.9, 2.0);
  EXPECT_TRUE(checkReversals(figures.reversals, ballOfFive()).ok());
  path.contacts[3350] *= 1.3; // a spike at another place
  measureTurns(path, ballOfFive(), figures);
  EXPECT_EQ(figures.reversals.at_corners + 1, figures.reversals.count);
  EXPECT_EQ(figures.reversals.place, path.contacts[3350]);
  EXPECT_FALSE(checkReversals(figures.reversals, ballOfFive()).ok());
}

namespace {

SpiralToolpathGenerator<pcl::PointXYZ>
generatorOn(const PlaneLoop& outline)
{
  SpiralToolpathGenerator<pcl::PointXYZ> generator;
  generator.setInputCloud(toCloud(sampleUniform(*flat(Region({outline})), 12000, 3).points));
  generator.setToolRadius(3.0);
  generator.setScallopHeight(0.02);
  generator.setQuiet(true);
  return generator;
}

/** The default and the method that messages advise must make a path. */
void
expectRemedyWorks(SpiralToolpathGenerator<pcl::PointXYZ>& generator)
{
  Path path;
  for (const SpiralMethod method : {SpiralMethod::ConstantScallop, SpiralMethod::Shortest}) {
    generator.setMethod(method);
    generator.compute(path);
    ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    EXPECT_EQ(generator.getReport().method, SpiralMethod::ConstantScallop);
    EXPECT_GT(generator.getReport().turn_radius, 0.0);
  }
}

} // namespace

TEST(PathTurns, RadialTurnsIntoSharpCornersOfTheOutlineAreNamed)
{
  // A lens: its rim turns by 157 degrees at two corners, which all radial turns keep.
  PlaneLoop lens;
  const double half = 0.2, radius = 60.0 / std::sin(half); // radians; half of the inner angle
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i < 400; ++i) {
      const double t = half * (-1.0 + i / 200.0);
      lens.emplace_back(-side * radius * std::sin(t), side * radius * (std::cos(t) - std::cos(half)));
    }
  SpiralToolpathGenerator<pcl::PointXYZ> generator = generatorOn(lens);
  generator.setMethod(SpiralMethod::Radial);
  Path path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  EXPECT_GT(generator.getReport().reversals, 0u);
  bool named = false;
  for (const pcl_spiral::Diagnostic& warning : generator.getReport().warnings)
    named = named || (warning.text().find("turns back") != std::string::npos && warning.text().find("setMethod") != std::string::npos);
  EXPECT_TRUE(named);
  expectRemedyWorks(generator);
}

TEST(PathTurns, TheRemedyOfTurnsThatCrossWorksOnTheSameScan)
{
  PlaneLoop arc; // about the middle of its circle, radial turns cross
  for (const double side : {1.0, -1.0})
    for (int i = 0; i <= 400; ++i) {
      const double t = side * 1.2 * (-1.0 + i / 200.0);
      arc.emplace_back((30.0 + 8.0 * side) * std::cos(t), (30.0 + 8.0 * side) * std::sin(t));
    }
  SpiralToolpathGenerator<pcl::PointXYZ> generator = generatorOn(arc);
  generator.setMethod(SpiralMethod::Radial);
  Path path;
  generator.compute(path);
  ASSERT_FALSE(generator.getStatus().ok());
  EXPECT_NE(generator.getStatus().message().find("crosses itself"), std::string::npos) << generator.getStatus().message();
  EXPECT_NE(generator.getStatus().message().find("constant scallop height (setMethod)"), std::string::npos);
  expectRemedyWorks(generator);
}

TEST(PathTurns, LeastLengthIsTheSameForBothMethods)
{
  const Region region({ellipse(60.0, 25.0)});
  SpiralToolpathGenerator<pcl::PointXYZ> generator;
  generator.setInputCloud(toCloud(sampleUniform(*ball(300.0, region), 8000, 3).points));
  generator.setToolRadius(5.0);
  generator.setScallopHeight(0.05);
  generator.setQuiet(true);
  Path path;
  std::vector<double> least;
  for (const SpiralMethod method : {SpiralMethod::Radial, SpiralMethod::ConstantScallop}) {
    generator.setMethod(method);
    generator.compute(path);
    ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    const SpiralReport& report = generator.getReport();
    least.push_back(report.least_length);
    EXPECT_NEAR(report.efficiency, report.least_length / report.path_length, 1e-12);
    bool warned = false;
    for (const pcl_spiral::Diagnostic& warning : report.warnings)
      warned = warned || warning.text().find("times as long as the least") != std::string::npos;
    EXPECT_EQ(warned, report.efficiency < 0.8);
    EXPECT_EQ(warned, method == SpiralMethod::Radial); // turns of an ellipse bunch at its flanks
  }
  EXPECT_NEAR(least[0], least[1], 0.02 * least[1]);
}

} // namespace path_turns_test
