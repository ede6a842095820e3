// SPDX-License-Identifier: BSD-3-Clause
// The generator finishes what the user gives: a field, loops or a linked path of its own stages give the bytes of one call; a curve and a
// planner of the user's own are judged on the exact sphere; what does not fit is refused.
#include "support/given_loops.h"
#include "support/outlines.h"
#include "support/sampling.h"

#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <stdexcept>

namespace given_parts_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

using Point = pcl::PointXYZ;
using Cloud = pcl::PointCloud<Point>;
using Path = pcl::PointCloud<ToolpathPoint>;

struct Generator : SpiralToolpathGenerator<Point> {
  Generator()
  {
    setQuiet(true);
    setToolRadius(5.0);
    setScallopHeight(0.1);
    setChordError(0.01);
  }
  Path made()
  {
    Path path;
    compute(path);
    return path;
  }
  Path done()
  {
    const Path path = made();
    EXPECT_TRUE(getStatus().ok()) << getStatus().message();
    return path;
  }
  /** The message of a refusal without a path. */
  std::string refusal()
  {
    EXPECT_TRUE(made().empty());
    EXPECT_FALSE(getStatus().ok());
    return getStatus().message();
  }
};

bool
sameBytes(const Path& a, const Path& b)
{
  if (a.size() != b.size())
    return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].getVector3fMap() != b[i].getVector3fMap() || a[i].getNormalVector3fMap() != b[i].getNormalVector3fMap() ||
        a[i].getAxisVector3fMap() != b[i].getAxisVector3fMap() || a[i].arc_length != b[i].arc_length || a[i].turn != b[i].turn)
      return false;
  return true;
}

/** The stages of one part, each by its class. */
struct Stages {
  Cloud::Ptr cloud;
  Surface::ConstPtr surface;
  std::vector<BoundaryLoop> rims;
  StepOverDistance::ConstPtr field;
  ScallopLoopSet loops;
  LinkedPath linked;

  explicit Stages(const char* outline) : cloud(toCloud(sampleUniform(*outlinedPart(outline, 0, 0.5), 5000, 3).points))
  {
    GapBridging<Point> bridging;
    bridging.setInputCloud(cloud);
    bridging.setBoundaryMode(BoundaryMode::AllBoundaries);
    bridging.compute(surface, rims);
    StepOverField<Point> distances;
    distances.setInputSurface(surface);
    distances.setBoundaryLoops(rims);
    distances.setToolRadius(5.0);
    distances.setScallopHeight(0.1);
    distances.compute(field);
    ScallopLoops<Point> rings;
    rings.setInputField(field);
    rings.compute(loops);
    LoopLinking<Point> linking;
    linking.setInputField(field);
    linking.setInputLoops(loops.loops);
    linking.compute(linked);
    EXPECT_TRUE(linking.getStatus().ok()) << linking.getStatus().message();
  }
};

constexpr double sphere = 60.0, reach = 25.0; ///< mm: of the ball under the scan, and of its rim from the axis

Cloud::Ptr
cap()
{
  return toCloud(sampleUniform(*ball(sphere, Region({circle({0.0, 0.0}, reach)})), 6000, 5).points);
}

Vector3d
onSphere(double x, double y)
{
  return {x, y, std::sqrt(sphere * sphere - x * x - y * y)};
}

/** Coarse circles round the top, each a pass of its own. */
std::vector<SpiralPoint>
circles(const std::vector<double>& radii)
{
  std::vector<SpiralPoint> curve;
  for (const double r : radii)
    for (int i = 0; i <= 90; ++i) {
      const double a = 2.0 * M_PI * i / 90.0;
      curve.push_back({onSphere(r * std::cos(a), r * std::sin(a)), 0.0, i == 0 && !curve.empty()});
    }
  return curve;
}

/** Circles, or a failure, or an exception; keeps what it was given. */
struct Circles : PathPlanner {
  enum class Ending { Done, Fails, Throws, Empty, Uneven } ending = Ending::Done;
  mutable std::size_t rims = 0;
  mutable double area = 0.0;

  Status plan(const PlannerInput& input, LinkedPath& path) const override
  {
    rims = input.boundaries.size();
    area = input.surface.area();
    if (ending == Ending::Fails)
      return {StatusCode::Failed, "no rows fit on this part"};
    if (ending == Ending::Throws)
      throw std::runtime_error("out of rows");
    if (ending == Ending::Empty)
      return Status::success();
    for (const SpiralPoint& point : circles({8.0, 16.0})) {
      if (point.begins_pass)
        path.passes.push_back(path.points.size());
      path.points.push_back(point.position);
    }
    if (ending == Ending::Uneven)
      path.turns.push_back(0.0f);
    return Status::success();
  }
};

/** Changes the path as it is told. */
struct Change : PathModifier {
  std::function<void(SpiralPath&)> change;
  explicit Change(std::function<void(SpiralPath&)> what) : change(std::move(what)) {}
  Status modify(const Surface&, const SpiralSettings&, SpiralPath& path) const override
  {
    change(path);
    return Status::success();
  }
};

} // namespace

TEST(GivenParts, EveryStageOfConstantScallopGivesTheBytesOfOneCall)
{
  for (const char* outline : {"disc", "L", "ring", "holes_2"}) {
    SCOPED_TRACE(outline);
    const Stages stages(outline);
    Generator whole;
    whole.setInputCloud(stages.cloud);
    whole.setMethod(SpiralMethod::ConstantScallop);
    const Path expected = whole.done();
    for (const unsigned int threads : {1u, 3u})
      for (int from = 0; from < 4; ++from) {
        SCOPED_TRACE(from);
        Generator finish;
        finish.setInputCloud(stages.cloud);
        finish.setNumberOfThreads(threads);
        if (from == 0 || from == 3)
          finish.setStepOverField(stages.field);
        if (from == 1 || from == 3)
          finish.setScallopLoops(stages.loops.loops);
        if (from == 2)
          finish.setLinkedPath(stages.linked);
        const Path path = finish.done();
        if (from != 1) // loops alone: the path is not moved to where it would leave more
          EXPECT_TRUE(sameBytes(path, expected));
        else
          EXPECT_NEAR(path.back().arc_length, expected.back().arc_length, 0.1 * expected.back().arc_length);
        if (from == 0 || from == 3)
          EXPECT_EQ(finish.getReport().least_length, whole.getReport().least_length);
        EXPECT_EQ(finish.getReport().method, SpiralMethod::ConstantScallop);
        EXPECT_EQ(finish.getReport().loops.size(), whole.getReport().loops.size());
      }
  }
}

TEST(GivenParts, PartsOfAnotherToolOrHeightAreRefused)
{
  const Stages stages("disc");
  for (int from = 0; from < 3; ++from) {
    Generator finish;
    finish.setInputCloud(stages.cloud);
    if (from == 0)
      finish.setStepOverField(stages.field);
    if (from == 1)
      finish.setScallopLoops(stages.loops.loops);
    if (from == 2)
      finish.setLinkedPath(stages.linked);
    finish.setToolRadius(4.0);
    EXPECT_NE(finish.refusal().find("made with the tool radius 5 mm, but here it is 4 mm"), std::string::npos);
    finish.setToolRadius(5.0);
    finish.setScallopHeight(0.05);
    EXPECT_NE(finish.refusal().find("made with the scallop height 0.1 mm, but here it is 0.05 mm"), std::string::npos);
    finish.setScallopHeight(0.1);
    finish.setMethod(SpiralMethod::Radial);
    EXPECT_NE(finish.refusal().find("setMethod"), std::string::npos);
    finish.setMethod(SpiralMethod::Shortest);
    finish.setCurve(circles({8.0}));
    EXPECT_NE(finish.refusal().find("only one of them can make the path"), std::string::npos);
    finish.clearGivenParts();
    finish.setCurve({});
    EXPECT_NE(finish.refusal().find("the curve has no points"), std::string::npos);
    finish.clearGivenParts();
    EXPECT_FALSE(finish.done().empty());
  }
}

TEST(GivenParts, ACurveIsPutOnTheSurfaceWithinTheChordErrorAndKeepsItsPasses)
{
  Generator finish;
  finish.setInputCloud(cap());
  finish.setCurve(circles({5.0, 12.0, 20.0}));
  const Path path = finish.done();
  ASSERT_EQ(finish.getPassBegins().size(), 2u);
  std::size_t begins = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vector3d p = path[i].getVector3fMap().cast<double>();
    EXPECT_NEAR(p.norm(), sphere, 2e-3);
    EXPECT_GT(path[i].getNormalVector3fMap().cast<double>().dot(p) / p.norm(), 0.9999);
    if (i > 0 && begins < 2 && i == finish.getPassBegins()[begins]) {
      ++begins;
      continue;
    }
    if (i > 0) { // the middle of a move of the ball's centre stays within the chord error of its sphere
      const Vector3d a = p + 5.0 * path[i].getNormalVector3fMap().cast<double>(),
                     b = (path[i - 1].getVector3fMap() + 5.0f * path[i - 1].getNormalVector3fMap()).cast<double>();
      EXPECT_LT(std::abs((0.5 * (a + b)).norm() - (sphere + 5.0)), 0.01 + 2e-3);
    }
  }
  const double around = 2.0 * M_PI * (5.0 + 12.0 + 20.0);
  EXPECT_NEAR(path.back().arc_length, around, 2e-3 * around);
  finish.setNumberOfThreads(3);
  EXPECT_TRUE(sameBytes(path, finish.done()));
}

TEST(GivenParts, ACurveThatLeavesTheSurfaceOrCrossesItselfOrIsNoCurveIsRefused)
{
  Generator finish;
  finish.setInputCloud(cap());
  finish.setCurve(circles({8.0, 32.0}));
  EXPECT_NE(finish.refusal().find("off the scanned surface at"), std::string::npos);
  std::vector<SpiralPoint> eight = circles({8.0, 8.0});
  for (SpiralPoint& point : eight)
    point.begins_pass = false;
  for (std::size_t i = eight.size() / 2; i < eight.size(); ++i)
    eight[i].position = onSphere(12.0 - eight[i].position.x(), eight[i].position.y());
  finish.setCurve(eight);
  const std::string crosses = finish.refusal();
  EXPECT_NE(crosses.find("crosses itself at"), std::string::npos) << crosses;
  finish.setCurve({{{0.0, 0.0, sphere}, 0.0}});
  EXPECT_NE(finish.refusal().find("one point"), std::string::npos);
  std::vector<SpiralPoint> bad = circles({8.0});
  bad[17].position.y() = std::nan("");
  finish.setCurve(bad);
  EXPECT_NE(finish.refusal().find("point 17"), std::string::npos);
}

TEST(GivenParts, WhatStandsInTheWayOfACurveRefusesIt)
{
  Generator finish;
  finish.setInputCloud(cap());
  finish.setCurve(circles({8.0, 20.0}));
  Surroundings around;
  const double r = 20.0; // a post on the way of the outer circle, up from the surface
  for (double up = 0.5; up < 12.0; up += 0.5)
    for (int k = 0; k < 8; ++k)
      around.standing.emplace_back(static_cast<float>(r + 0.3 * std::cos(k)), static_cast<float>(0.3 * std::sin(k)),
                                   static_cast<float>(std::sqrt(sphere * sphere - r * r) + up));
  finish.setSurroundings(around);
  finish.refusal();
  ASSERT_TRUE(finish.getReport().blocked_way);
  finish.setCurve(circles({8.0}));
  EXPECT_FALSE(finish.done().empty());
}

TEST(GivenParts, APlannerGetsTheSurfaceAndItsBoundariesAndItsEndingIsThatOfTheGenerator)
{
  const auto planner = std::make_shared<Circles>();
  Generator finish;
  finish.setInputCloud(cap());
  finish.setPlanner(planner);
  const Path path = finish.done();
  EXPECT_EQ(planner->rims, 1u);
  const double exact = 2.0 * M_PI * sphere * (sphere - std::sqrt(sphere * sphere - reach * reach));
  EXPECT_NEAR(planner->area, exact, 0.05 * exact);
  Generator given;
  given.setInputCloud(cap());
  given.setCurve(circles({8.0, 16.0}));
  EXPECT_TRUE(sameBytes(path, given.done()));

  planner->ending = Circles::Ending::Fails;
  EXPECT_EQ(finish.refusal(), "no rows fit on this part");
  planner->ending = Circles::Ending::Empty;
  EXPECT_NE(finish.refusal().find("the planner's path has no points"), std::string::npos);
  planner->ending = Circles::Ending::Uneven;
  EXPECT_NE(finish.refusal().find("182 points and 1 turns"), std::string::npos);
  planner->ending = Circles::Ending::Throws;
  Path none;
  EXPECT_THROW(finish.compute(none), std::runtime_error);
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(finish.getStatus().ok());
  planner->ending = Circles::Ending::Done;
  EXPECT_TRUE(sameBytes(path, finish.done()));
}

TEST(GivenParts, AModifierChangesThePathAndTheResultIsChecked)
{
  Generator finish;
  finish.setInputCloud(cap());
  const Path plain = finish.done();
  finish.addModifier(std::make_shared<Change>([](SpiralPath& path) {
    for (Eigen::Vector3f& axis : path.axes)
      axis = Eigen::Vector3f::UnitZ();
  }));
  finish.addModifier(std::make_shared<Change>([](SpiralPath& path) { // the first tenth is left out
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(path.contacts.size()) / 10;
    path.contacts.erase(path.contacts.begin(), path.contacts.begin() + first);
    path.normals.erase(path.normals.begin(), path.normals.begin() + first);
    path.axes.erase(path.axes.begin(), path.axes.begin() + first);
    path.turns.erase(path.turns.begin(), path.turns.begin() + first);
    path.over_gap.erase(path.over_gap.begin(), path.over_gap.begin() + first);
  }));
  const Path changed = finish.done();
  const std::size_t first = plain.size() / 10;
  ASSERT_EQ(changed.size(), plain.size() - first);
  EXPECT_EQ(changed.front().arc_length, 0.0);
  for (std::size_t i = 0; i < changed.size(); ++i) {
    ASSERT_EQ(changed[i].getVector3fMap(), plain[i + first].getVector3fMap());
    ASSERT_EQ(changed[i].getAxisVector3fMap(), Eigen::Vector3f::UnitZ());
  }
  const auto refused = [&](std::function<void(SpiralPath&)> change) {
    finish.clearModifiers();
    finish.addModifier(std::make_shared<Change>(std::move(change)));
    return finish.refusal();
  };
  EXPECT_NE(refused([](SpiralPath& path) { path.axes.pop_back(); }).find("keep one of each for every contact"), std::string::npos);
  EXPECT_NE(refused([](SpiralPath& path) { path.axes[3] *= 2.0f; }).find("point 3, ("), std::string::npos);
  EXPECT_NE(refused([](SpiralPath& path) { path.passes.push_back(0); }).find("begins at point 0"), std::string::npos);
  EXPECT_NE(refused([](SpiralPath& path) { path = SpiralPath(); }).find("without points"), std::string::npos);
  EXPECT_NE(refused([](SpiralPath& path) { path.contacts[path.contacts.size() / 2].x() += 30.0; }).find("the path jumps by"),
            std::string::npos);
}

TEST(GivenParts, AModifierMustLeaveAPath)
{
  Generator finish;
  finish.setInputCloud(cap());
  const auto refused = [&](std::function<void(SpiralPath&)> change) {
    finish.clearModifiers();
    finish.addModifier(std::make_shared<Change>(std::move(change)));
    return finish.refusal();
  };
  EXPECT_NE(refused([](SpiralPath& path) { path.normals[7] *= -1.0; }).find("point 7, "), std::string::npos);
  EXPECT_NE(refused([](SpiralPath& path) { path.axes[9] = -path.axes[9]; }).find("leans 89 degrees or more"), std::string::npos);
  EXPECT_NE(refused([](SpiralPath& path) { path.feet = path.contacts; }).find("feet and 0 lifts"), std::string::npos);
  EXPECT_NE(refused([](SpiralPath& path) {
              path.feet = path.contacts;
              path.lifts.assign(path.feet.size(), 0.0f);
              path.contacts[path.feet.size() / 2].x() += 30.0; // steps are those of the feet
            }).find("30 mm from its foot, but its lift is 0 mm"),
            std::string::npos);
  finish.clearModifiers();
  finish.addModifier(nullptr);
  EXPECT_NE(finish.refusal().find("null pointer"), std::string::npos);
  finish.clearModifiers();
  finish.addModifier(std::make_shared<Change>([](SpiralPath& path) {
    for (std::size_t i = 0; i < path.axes.size(); ++i)
      path.axes[i] = path.normals[i].cast<float>();
  }));
  finish.done();
  EXPECT_LT(finish.getReport().largest_axis_lean, 0.1); // not the tilt that was smoothed before
}

TEST(GivenParts, AFieldOrLoopsOfAnotherSurfaceAreRefusedWithThePlace)
{
  const Stages disc("disc"), ring("ring");
  for (const auto& [from, to] : {std::pair(&disc, &ring), std::pair(&ring, &disc)})
    for (const bool loops : {false, true}) {
      Generator finish;
      finish.setInputCloud(to->cloud);
      if (loops)
        finish.setScallopLoops(from->loops.loops);
      else
        finish.setStepOverField(from->field);
      EXPECT_NE(finish.refusal().find("made on another surface or between other boundaries"), std::string::npos);
    }
  Generator finish;
  finish.setInputCloud(ring.cloud);
  finish.setStepOverField(ring.field);
  finish.setRimOverhang(-3.0);
  EXPECT_NE(finish.refusal().find("rim"), std::string::npos);
  finish.setRimOverhang(0.0);
  finish.setHoleMargin(3.0);
  EXPECT_NE(finish.refusal().find("rim"), std::string::npos);
  finish.setHoleMargin(0.0);
  finish.setCenter(Vector3d::Zero());
  EXPECT_NE(finish.refusal().find("setCenter"), std::string::npos);
}

TEST(GivenParts, ACurveThroughAHoleOrItsMarginIsRefusedWithThePlace)
{
  const double hole = 3.0;
  const auto cloud = toCloud(sampleUniform(*ball(sphere, Region({circle({0.0, 0.0}, reach), circle({8.0, 0.0}, hole)})), 9000, 5).points);
  Generator finish;
  finish.setInputCloud(cloud);
  finish.setHoleSize(4.0);
  finish.setCurve(circles({8.0}));
  EXPECT_NE(finish.refusal().find("into a hole of the part"), std::string::npos);
  finish.setHoleHandling(HoleHandling::Over);
  EXPECT_FALSE(finish.done().empty());
  finish.setHoleHandling(HoleHandling::Around);
  finish.setCurve(circles({16.0})); // 5 mm from the edge of the hole
  EXPECT_FALSE(finish.done().empty());
  finish.setHoleMargin(8.0);
  EXPECT_FALSE(finish.made().size() > 0) << "8 mm are asked for";
}

TEST(GivenParts, ACoarseCurveFollowsTheSurfaceBetweenItsPoints)
{
  Generator finish;
  finish.setInputCloud(cap());
  finish.setCurve({{onSphere(-15.0, 4.0), 0.0}, {onSphere(15.0, 4.0), 1.0}}); // the chord between them is 2 mm under the sphere
  const Path path = finish.done();
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vector3d a = path[i - 1].getVector3fMap().cast<double>(), b = path[i].getVector3fMap().cast<double>();
    EXPECT_NEAR(b.norm(), sphere, 2e-3);
    EXPECT_LT(sphere - (0.5 * (a + b)).norm(), 0.01); // chord error of the contacts
    length += (b - a).norm();
  }
  const double across = std::sqrt(sphere * sphere - 16.0); // the plane y = 4 cuts the sphere in a circle of this radius
  EXPECT_NEAR(length, 2.0 * across * std::asin(15.0 / across), 0.05);
  EXPECT_TRUE(finish.getReport().own_curve);
}

} // namespace given_parts_test
