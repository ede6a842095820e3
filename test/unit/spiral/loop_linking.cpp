// SPDX-License-Identifier: BSD-3-Clause
// One path over given loops: it runs along every loop, and nothing crosses.
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/spiral/loop_linking.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace loop_linking_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

/** A circle of \p radius step-overs (one is 1 mm) about (x, 0). */
ScallopLoop
ring(double radius, double x, int level)
{
  ScallopLoop loop;
  loop.level = level;
  const int n = std::max(24, static_cast<int>(radius * 2.0 * M_PI / 0.2));
  for (int i = 0; i < n; ++i) {
    const double a = 2.0 * M_PI * i / n;
    loop.points.emplace_back(x + radius * std::cos(a), radius * std::sin(a), 0.0);
    loop.metric.emplace_back(Eigen::Matrix3d::Identity());
  }
  loop.measure();
  return loop;
}

/** Outline of the area within \p radius of the line from (x, -half) to (x, half). */
ScallopLoop
oval(double radius, double half, double x, int level)
{
  ScallopLoop loop;
  loop.level = level;
  const int cap = 24, side = 12;
  for (const double end : {1.0, -1.0}) {
    for (int i = 0; i < cap; ++i) {
      const double a = M_PI * i / cap;
      loop.points.emplace_back(x + end * radius * std::cos(a), end * (half + radius * std::sin(a)), 0.0);
    }
    for (int i = 0; i < side; ++i)
      loop.points.emplace_back(x - end * radius, end * half * (1.0 - 2.0 * i / side), 0.0);
  }
  loop.metric.assign(loop.points.size(), StepOverMetric(Eigen::Matrix3d::Identity()));
  loop.measure();
  return loop;
}

double
lengthOf(const Polyline& line)
{
  return length(line);
}

bool
cross(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d)
{
  const auto side = [](const Vector3d& p, const Vector3d& q, const Vector3d& x) {
    return (q.x() - p.x()) * (x.y() - p.y()) - (q.y() - p.y()) * (x.x() - p.x());
  };
  return side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0;
}

std::size_t
crossings(const Polyline& p)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    for (std::size_t j = i + 2; j + 1 < p.size(); ++j)
      count += (p[i] - p[j]).norm() < 1.0 && cross(p[i], p[i + 1], p[j], p[j + 1]);
  return count;
}

double
farthest(const ScallopLoop& loop, const Polyline& path)
{
  double most = 0.0;
  for (const Vector3d& q : loop.points) {
    double least = 1e30;
    for (const Vector3d& p : path)
      least = std::min(least, (p - q).norm());
    most = std::max(most, least);
  }
  return most;
}

void
expectOnePath(const std::vector<ScallopLoop>& loops, LinkedPath& path)
{
  const Status status = linkLoops(loops, path);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(crossings(path.points), 0u);
  for (std::size_t i = 1; i < path.points.size(); ++i)
    EXPECT_LT((path.points[i] - path.points[i - 1]).norm(), 0.55); // the straight part of a bridge
  for (const ScallopLoop& loop : loops)
    EXPECT_LT(farthest(loop, path.points), 0.65) << "level " << loop.level;
  EXPECT_EQ(path.points.size(), path.turns.size());
  EXPECT_EQ(path.points.size(), path.reversed.size());
  std::vector<int> hangs(loops.size(), 0); // every loop except that of the outer rim is a child of another loop near it
  for (const LoopJoint& joint : path.joints) {
    ++hangs[joint.loop];
    EXPECT_NE(joint.parent, joint.loop);
    EXPECT_LT((joint.place - joint.parent_place).norm(), joint.kind == LoopJointKind::Ramp ? 2.5 : 1.75);
  }
  EXPECT_EQ(path.joints.size() + 1, loops.size());
  EXPECT_EQ(hangs[0], 0);
  EXPECT_EQ(std::count(hangs.begin() + 1, hangs.end(), 1), static_cast<std::ptrdiff_t>(loops.size()) - 1);
}

} // namespace

TEST(LoopLinking, RingsBecomeASpiral)
{
  std::vector<ScallopLoop> loops;
  double sum = 0.0;
  for (int k = 0; k < 12; ++k) {
    loops.push_back(ring(12.3 - k, 0.0, k));
    sum += loops.back().length();
  }
  LinkedPath path;
  expectOnePath(loops, path);
  EXPECT_EQ(path.chain_loops, 12u);
  EXPECT_EQ(path.bridges, 0u);
  EXPECT_NEAR(lengthOf(path.points), sum, 0.02 * sum);
  EXPECT_EQ(std::count(path.reversed.begin(), path.reversed.end(), 1), 0);
}

TEST(LoopLinking, ALobesLoopsAreBridged)
{
  std::vector<ScallopLoop> loops{ring(20.0, 0.0, 0)}; // a rim round two nests of rings that almost touch
  for (int k = 0; k < 9; ++k)
    loops.push_back(ring(9.5 - k, -9.5, k + 1));
  for (int k = 0; k < 7; ++k)
    loops.push_back(ring(8.9 - k, 10.1, k + 1));
  LinkedPath path;
  expectOnePath(loops, path);
  EXPECT_EQ(path.chain_loops, 10u);
  EXPECT_EQ(path.bridges + path.dots, 7u);
  EXPECT_GT(std::count(path.reversed.begin(), path.reversed.end(), 1), 0);
}

/** Number of times the passes cross the line from (x, 0) by \p reach at \p angle, minus the number in the opposite sense; \p back:
 *  the latter. */
int
timesRound(const LinkedPath& path, double x, double reach, double angle, int& back)
{
  const Vector3d from(x, 0.0, 0.0), to = from + reach * Vector3d(std::cos(angle), std::sin(angle), 0.0);
  int round = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const Vector3d &a = path.points[i - 1], &b = path.points[i];
    if (beginsPass(path.passes, i) || !cross(from, to, a, b))
      continue;
    const bool forth = (to - from).cross(b - a).z() > 0.0;
    round += forth ? 1 : -1;
    back += !forth;
  }
  return round;
}

TEST(LoopLinking, OneWayEveryLoopIsTravelledOnceInItsSense)
{
  std::vector<ScallopLoop> loops{ring(20.0, 0.0, 0)};
  for (int k = 0; k < 9; ++k)
    loops.push_back(ring(9.5 - k, -9.5, k + 1));
  for (int k = 0; k < 7; ++k)
    loops.push_back(ring(8.9 - k, 10.1, k + 1));
  LinkedPath path;
  const Status status = linkLoops(loops, path, std::nullopt, true);
  ASSERT_TRUE(status.ok()) << status.message();
  ASSERT_EQ(path.passes.size(), 1u);
  EXPECT_EQ(path.bridges, 0u);
  EXPECT_EQ(std::count(path.reversed.begin(), path.reversed.end(), 1), 0);
  for (const PassRange& pass : passRanges(path.passes, path.points.size()))
    EXPECT_EQ(crossings(Polyline(path.points.begin() + static_cast<std::ptrdiff_t>(pass.begin),
                                 path.points.begin() + static_cast<std::ptrdiff_t>(pass.end))),
              0u);
  for (const auto& [x, reach, count] : {std::tuple(-9.5, 9.9, 9), std::tuple(10.1, 9.3, 7)}) {
    std::vector<int> times;
    int back = 0;
    for (int k = 0; k < 90; ++k)
      times.push_back(timesRound(path, x, reach, 0.01 + 2.0 * M_PI * k / 90.0, back));
    EXPECT_EQ(back, 0);
    EXPECT_GT(std::count(times.begin(), times.end(), count), 60); // except beside the ends of a pass, where its strips are machined twice
    EXPECT_LE(*std::max_element(times.begin(), times.end()), count + 2);
    EXPECT_GE(*std::min_element(times.begin(), times.end()), count - 1);
  }
  EXPECT_EQ(path.joints.size() + 1, loops.size());
  EXPECT_EQ(std::count_if(path.joints.begin(), path.joints.end(), [](const LoopJoint& j) { return j.kind == LoopJointKind::Lift; }), 1);
}

TEST(LoopLinking, OneWayALoopThatStandsAloneIsAPass)
{
  std::vector<ScallopLoop> loops;
  for (int k = 0; k < 5; ++k)
    loops.push_back(ring(8.0 - k, 0.0, k));
  loops.push_back(ring(4.0, 30.0, 1));
  LinkedPath path;
  const Status status = linkLoops(loops, path, std::nullopt, true);
  ASSERT_TRUE(status.ok()) << status.message();
  ASSERT_EQ(path.passes.size(), 1u);
  int back = 0;
  for (int k = 0; k < 12; ++k)
    EXPECT_LE(timesRound(path, 30.0, 6.0, 0.01 + M_PI * k / 6.0, back), 1);
  EXPECT_LT(farthest(loops.back(), path.points), 0.2);
}

TEST(LoopLinking, NoBridgeLeadsAcrossALoop)
{
  std::vector<ScallopLoop> loops; // of a ring: from the outer rim and from the hole, and a narrow loop between them
  for (int k = 0; k < 4; ++k)
    loops.push_back(ring(12.0 - k, 0.0, k));
  for (int k = 0; k < 4; ++k)
    loops.push_back(ring(4.6 + k, 0.0, k));
  loops.push_back(ring(8.55, 0.0, 4));
  loops.push_back(ring(8.05, 0.0, 4));
  LinkedPath path;
  expectOnePath(loops, path);
}

TEST(LoopLinking, ADotBecomesAFingerOfItsNeighbour)
{
  std::vector<ScallopLoop> loops;
  for (int k = 0; k < 5; ++k)
    loops.push_back(ring(8.0 - k, 0.0, k));
  loops.push_back(ring(0.35, 9.1, 1)); // beside the rim
  loops[0] = ring(8.0, 0.0, 0);
  LinkedPath path;
  expectOnePath(loops, path);
  EXPECT_EQ(path.dots, 1u);
}

/** \p loop moved along y. */
ScallopLoop
movedUp(ScallopLoop loop, double y)
{
  for (Vector3d& p : loop.points)
    p.y() += y;
  return loop;
}

TEST(LoopLinking, NoRampLeadsThroughAnotherCore)
{
  // The middle of a long part: several cores in a row, each beside the same loop.
  for (const double half : {3.0, 4.5, 6.0})
    for (const int cores : {2, 3})
      for (const double core : {0.5, 0.9})
        for (const int levels : {2, 3, 4}) {
          if (cores * (2.0 * core + 0.8) > 2.0 * half + 1.2)
            continue;
          std::vector<ScallopLoop> loops;
          for (int k = 0; k < levels; ++k)
            loops.push_back(oval(levels - k, half, 0.0, k));
          for (int c = 0; c < cores; ++c)
            loops.push_back(movedUp(oval(0.35, core + (c == 0 ? 0.05 : 0.0), 0.0, levels), (c - 0.5 * (cores - 1)) * (2.0 * core + 0.8)));
          LinkedPath path;
          const Status status = linkLoops(loops, path);
          ASSERT_TRUE(status.ok()) << status.message();
          EXPECT_EQ(crossings(path.points), 0u) << half << " " << cores << " " << core << " " << levels;
        }
}

TEST(LoopLinking, NoBridgeLeadsToADot)
{
  std::vector<ScallopLoop> loops;
  for (int k = 0; k < 5; ++k)
    loops.push_back(ring(8.0 - k, 0.0, k));
  loops.push_back(oval(1.05, 0.6, 10.05, 1)); // a lobe beside the rim
  loops.push_back(oval(0.08, 0.6, 10.05, 2)); // and in its middle a dot, which is a better neighbour than the rim
  LinkedPath path;
  const Status status = linkLoops(loops, path);
  ASSERT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(crossings(path.points), 0u);
  EXPECT_EQ(path.dots, 1u);
  EXPECT_EQ(path.bridges, 1u);
  EXPECT_LT(farthest(loops[5], path.points), 0.65);
}

TEST(LoopLinking, ALoopThatStandsAloneIsRefusedWithItsPlace)
{
  std::vector<ScallopLoop> loops;
  for (int k = 0; k < 5; ++k)
    loops.push_back(ring(8.0 - k, 0.0, k));
  loops.push_back(ring(4.0, 30.0, 1));
  LinkedPath path;
  const Status status = linkLoops(loops, path);
  ASSERT_FALSE(status.ok());
  EXPECT_NE(status.message().find("(34, 0, 0)"), std::string::npos) << status.message();
}

} // namespace loop_linking_test
