// SPDX-License-Identifier: BSD-3-Clause
#include "core/smooth_axes.h"
#include "core/tilted_axes.h"
#include <pcl_spiral/spiral/axis_field.h>

#include <pcl/console/print.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>

namespace axis_field_test {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;

namespace {

constexpr double degree = M_PI / 180.0;

double
angleBetween(const Vector3d& a, const Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

struct TestPath {
  Polyline points;
  Vectors normals, wanted;
};

/** An Archimedean spiral of pitch 1 mm over the pole of a sphere of radius 200, its axes tilted 15 degrees. */
TestPath
sphereSpiral(double step, double end_radius)
{
  TestPath path;
  for (double angle = 0.0, r = 0.0; r < end_radius; angle += step / std::max(r, 0.2)) {
    r = angle / (2 * M_PI);
    const Vector3d n = Vector3d(r * std::cos(angle), r * std::sin(angle), std::sqrt(200.0 * 200.0 - r * r)) / 200.0;
    path.normals.push_back(n);
    path.points.push_back(200.0 * n);
  }
  path.wanted = tiltedAxes(path.points, path.normals, 15 * degree, 0.0);
  return path;
}

/** A straight path of uneven steps with axes tilted along and across it by functions of the arc length. */
template <typename Along, typename Across>
TestPath
straightPath(std::size_t count, double step, Along along, Across across)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uneven(0.5, 1.5);
  TestPath path;
  for (double s = 0.0; path.points.size() < count; s += step * uneven(random)) {
    path.points.emplace_back(s, 0.0, 0.0);
    path.wanted.push_back(Vector3d(along(s), across(s), 1.0).normalized());
    path.normals.push_back(Vector3d::UnitZ());
  }
  return path;
}

double
rateExcess(const Polyline& points, const Vectors& axes, double rate)
{
  double worst = -1.0;
  for (std::size_t i = 1; i < axes.size(); ++i)
    worst = std::max(worst, angleBetween(axes[i - 1], axes[i]) - rate * (points[i] - points[i - 1]).norm());
  return worst;
}

double
largestAngle(const Vectors& a, const Vectors& b)
{
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max(worst, angleBetween(a[i], b[i]));
  return worst;
}

const AxisFieldOptions both{20.0, 3 * degree, 2 * degree};

} // namespace

TEST(SmoothAxes, ConstantAxesStay)
{
  const TestPath path = straightPath(
      500, 0.3, [](double) { return 0.2; }, [](double) { return -0.4; });
  const SmoothAxes field = smoothAxes(path.points, path.wanted, both);
  EXPECT_LT(largestAngle(field.axes, path.wanted), 1e-15);
  EXPECT_LT(field.largest_change, 1e-15);
  EXPECT_EQ(field.deviating_points, 0u);
}

TEST(SmoothAxes, NothingAskedNothingDone)
{
  const TestPath path = sphereSpiral(0.2, 5.0);
  EXPECT_EQ(smoothAxes(path.points, path.wanted, {}).axes, path.wanted);
  EXPECT_GT(smoothAxes(path.points, path.wanted, {}).largest_rate, 30 * degree) << "it spins at the pole";
}

TEST(SmoothAxes, AWaveKeepsTheShareOfTheory)
{
  // Of the least of |a - w|^2 + L^4 |a''|^2 a wave of length 2 pi l keeps 1 / (1 + (L / l)^4).
  for (const double l : {10.0, 20.0, 40.0}) {
    const double length = 20.0, height = 1e-3;
    const TestPath path = straightPath(
        8000, 0.25, [&](double s) { return height * std::sin(s / l); }, [](double) { return 0.0; });
    const SmoothAxes field = smoothAxes(path.points, path.wanted, {length, 3 * degree, 0.0});
    const double share = 1.0 / (1.0 + std::pow(length / l, 4));
    for (std::size_t i = 2000; i < 6000; ++i) // away from the ends
      ASSERT_NEAR(field.axes[i].x(), share * height * std::sin(path.points[i].x() / l), 2e-4 * height) << l;
  }
}

TEST(SmoothAxes, NoiseFallsAsTheoryHasIt)
{
  // White noise of deviation sigma a step h: the kernel of the transfer 1 / (1 + (L k)^4) leaves the variance
  // sigma^2 h times the integral of its square, 1 / (2 pi L) B, B = integral of (1 + x^4)^-2 = 3 pi / (4 sqrt 2).
  const double length = 15.0, h = 0.1, sigma = 1 * degree;
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, sigma);
  TestPath path;
  for (int i = 0; i < 60000; ++i) {
    path.points.emplace_back(h * i, 0.0, 0.0);
    path.wanted.push_back(Vector3d(noise(random), noise(random), 1.0).normalized());
  }
  const SmoothAxes field = smoothAxes(path.points, path.wanted, {length, 3 * degree, 0.0});
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 3000; i < 57000; ++i, count += 2)
    sum += field.axes[i].head<2>().squaredNorm();
  const double theory = sigma * std::sqrt(h / (2 * M_PI * length) * 3 * M_PI / (4 * std::sqrt(2.0)));
  EXPECT_NEAR(std::sqrt(sum / static_cast<double>(count)) / theory, 1.0, 0.1) << "360 lengths of 2.5 L";
}

TEST(SmoothAxes, EndsAreNatural)
{
  // Linear in the arc length: not bent, and not made level at the ends.
  TestPath path;
  for (int i = 0; i <= 400; ++i) {
    path.points.emplace_back(0.25 * i, 0.0, 0.0);
    path.wanted.push_back(Vector3d(2e-5 * i, -4e-5 * i, 1.0).normalized());
  }
  for (const double length : {5.0, 50.0}) {
    const SmoothAxes field = smoothAxes(path.points, path.wanted, {length, 3 * degree, 0.0});
    EXPECT_LT(largestAngle(field.axes, path.wanted), 2e-6) << "straight in space is nearly so on the sphere";
  }
}

TEST(SmoothAxes, AStepBecomesARampWithinTheRate)
{
  const double height = 0.5;
  const TestPath path = straightPath(
      1000, 0.2, [&](double s) { return s < 100.0 ? 0.0 : height; }, [](double) { return 0.0; });
  for (const double rate : {0.3 * degree, 2 * degree}) {
    const SmoothAxes field = smoothAxes(path.points, path.wanted, {0.0, 3 * degree, rate});
    EXPECT_LE(rateExcess(path.points, field.axes, rate), 1e-8 * rate + 1e-12);
    EXPECT_GT(field.largest_rate, 0.45 * rate) << "slower than it need";
    double before = -1.0;
    for (std::size_t i = 0; i < field.axes.size(); ++i) {
      EXPECT_LT(std::abs(field.axes[i].y()), 1e-12);
      EXPECT_GE(field.axes[i].x(), before - 1e-12) << "turns back";
      before = field.axes[i].x();
      const double off = std::abs(path.points[i].x() - 100.0);
      if (off > 1.1 * std::atan(height) / rate) // the ramps of both passes are inside
        EXPECT_LT(angleBetween(field.axes[i], path.wanted[i]), 1e-9);
    }
  }
}

TEST(SmoothAxes, SameUnderRigidMotionAndFromEitherEnd)
{
  TestPath path = sphereSpiral(0.3, 12.0);
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0.0, 0.02);
  for (Vector3d& a : path.wanted)
    a = (a + Vector3d(noise(random), noise(random), noise(random))).normalized();
  const SmoothAxes field = smoothAxes(path.points, path.wanted, both);

  const Eigen::AngleAxisd turn(2.1, Vector3d(1, -2, 0.5).normalized());
  TestPath moved = path;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    moved.points[i] = turn * path.points[i] + Vector3d(30, -70, 200);
    moved.wanted[i] = turn * path.wanted[i];
  }
  const SmoothAxes there = smoothAxes(moved.points, moved.wanted, both);
  for (std::size_t i = 0; i < path.points.size(); ++i)
    ASSERT_LT((there.axes[i] - turn * field.axes[i]).norm(), 1e-9) << i;

  std::reverse(path.points.begin(), path.points.end());
  std::reverse(path.wanted.begin(), path.wanted.end());
  const SmoothAxes back = smoothAxes(path.points, path.wanted, both);
  for (std::size_t i = 0; i < path.points.size(); ++i)
    ASSERT_LT((back.axes[i] - field.axes[path.points.size() - 1 - i]).norm(), 1e-9) << i;
}

TEST(SmoothAxes, ThroughThePoleWithoutASpin)
{
  for (const double step : {0.05, 0.2, 0.7})
    for (const double length : {0.0, 10.0, 50.0}) {
      const double rate = 4 * degree;
      const TestPath path = sphereSpiral(step, 60.0);
      const SmoothAxes field = smoothAxes(path.points, path.wanted, {length, 3 * degree, rate});
      EXPECT_LE(rateExcess(path.points, field.axes, rate), 1e-8 * rate + 1e-12) << step << ' ' << length;
      EXPECT_LE(field.largest_rate, rate * (1 + 1e-8));
      EXPECT_LT(largestLean(path.normals, field.axes).angle, 25 * degree);
      double least = 90.0, most = 0.0;
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        const double radius = std::hypot(path.points[i].x(), path.points[i].y());
        const double tilt = angleBetween(field.axes[i], path.normals[i]);
        if (radius > 8.0 && radius < 58.0) { // at radius r the tilt spins at sin(15 deg) / r: the rate at 3.7 mm
          least = std::min(least, tilt);
          most = std::max(most, tilt);
        }
        else if (radius > 2.0 && radius < 3.5)
          ASSERT_GT(std::sin(tilt) / radius, 0.4 * rate) << "gives away too much at " << radius;
      }
      EXPECT_GT(least, (15 - 3 * 1.05 - 0.3) * degree) << "smoothing takes no more tilt than allowed";
      EXPECT_LT(most, 15.5 * degree);
    }
}

TEST(SmoothAxes, ADentOfTheTurnsIsSmoothedAway)
{
  // Turns of radius 150 mm with a dent of 2 mm, 60 mm long: the feed direction changes by about 6 degrees, and so does the axis.
  TestPath path;
  for (int i = 0; i < 6000; ++i) {
    const double angle = 2 * M_PI * i / 600.0, off = std::remainder(angle - M_PI, 2 * M_PI) * 150.0 / 15.0;
    const double r = 150.0 + 2.0 * i / 600.0 - 2.0 * std::exp(-0.5 * off * off);
    path.normals.push_back(Vector3d(r * std::cos(angle), r * std::sin(angle), std::sqrt(9e4 - r * r)) / 300.0);
    path.points.push_back(300.0 * path.normals.back());
  }
  path.wanted = tiltedAxes(path.points, path.normals, 15 * degree, 0.0);
  const auto deepest = [&](const Vectors& axes) { // decrease of the angle to the pole after its largest value
    double reached = 0.0, fall = 0.0;
    for (std::size_t i = 700; i < 5300; ++i) {
      reached = std::max(reached, angleBetween(axes[i], Vector3d::UnitZ()));
      fall = std::max(fall, reached - angleBetween(axes[i], Vector3d::UnitZ()));
    }
    return fall;
  };
  const SmoothAxes field = smoothAxes(path.points, path.wanted, {50.0, 3 * degree, 0.0});
  EXPECT_GT(deepest(path.wanted), 0.3 * degree);
  EXPECT_LT(deepest(field.axes), 0.1 * deepest(path.wanted));
  EXPECT_LT(field.deviating_points, 10u) << "but at the very ends, where a circle runs out straight";
}

/** Axes smoothed with one largest deviation do not keep the next from another. */
TEST(SmoothAxes, ASmallerDeviationIsKeptAfterALargerOne)
{
  const auto along = [](double s) { return s > 50.0 ? 0.8 : 0.0; };
  const auto flat = [](double) { return 0.0; };
  for (const std::size_t count : {41, 200, 1000, 20000}) {
    const TestPath path = straightPath(count, 100.0 / static_cast<double>(count), along, flat);
    const SmoothAxes alone = smoothAxes(path.points, path.wanted, {5.0, 3.0 * degree, 0.0});
    for (int round = 0; round < 3; ++round) {
      smoothAxes(path.points, path.wanted, {5.0, 90.0 * degree, 0.0});
      const SmoothAxes again = smoothAxes(path.points, path.wanted, {5.0, 3.0 * degree, 0.0});
      ASSERT_LT(largestAngle(again.axes, alone.axes), 1e-12) << count;
    }
    EXPECT_GT(largestAngle(alone.axes, smoothAxes(path.points, path.wanted, {5.0, 90.0 * degree, 0.0}).axes), 0.1);
  }
}

/** Steps of the axes far apart, each above the deviation and so weighted in several rounds, are smoothed as each alone. */
TEST(SmoothAxes, StepsFarApartDoNotMix)
{
  const AxisFieldOptions options{5.0, 3.0 * degree, 0.0};
  const auto flat = [](double) { return 0.0; };
  const auto stepsAt = [&](const std::vector<double>& places) {
    const auto along = [&places](double s) { // the second is smaller: it needs fewer rounds
      return (s > places[0] ? 0.8 : 0.0) - (places.size() > 1 && s > places[1] ? 0.5 : 0.0);
    };
    return straightPath(6000, 0.5, along, flat);
  };
  const TestPath both = stepsAt({1000.0, 2000.0}), first = stepsAt({1000.0});
  const SmoothAxes together = smoothAxes(both.points, both.wanted, options), alone = smoothAxes(first.points, first.wanted, options);
  EXPECT_GT(together.largest_deviation, options.max_deviation);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < both.points.size() && both.points[i].x() < 1500.0; ++i, ++compared)
    ASSERT_LT(angleBetween(together.axes[i], alone.axes[i]), 1e-7) << both.points[i].transpose();
  EXPECT_GT(compared, 2500u);
  // From the other end, where the rounds go through other rows first.
  TestPath back = both;
  std::reverse(back.wanted.begin(), back.wanted.end());
  std::reverse(back.points.begin(), back.points.end());
  const SmoothAxes reversed = smoothAxes(back.points, back.wanted, options);
  for (std::size_t i = 0; i < both.points.size(); ++i)
    ASSERT_LT(angleBetween(together.axes[i], reversed.axes[both.points.size() - 1 - i]), 1e-7) << both.points[i].transpose();
}

/** A long path is solved in parts of at least 1000 smoothing lengths: steps of the axes on both sides of such a place, above the deviation
 *  and so weighted in several rounds, come out as on a piece of the path about that place, which is solved at once. */
TEST(SmoothAxes, PartsOfALongPathMeetAsIfSolvedAtOnce)
{
  const AxisFieldOptions options{1.0, 3.0 * degree, 0.0};
  for (const double place : {880.0, 905.0, 990.0, 999.9, 1000.1, 1015.0, 1095.0, 1120.0}) {
    const auto along = [place](double s) { return 0.3 * std::sin(0.4 * s) + (s > place ? 0.8 : 0.0); };
    const TestPath whole = straightPath(12000, 0.25, along, [](double s) { return 0.1 * std::cos(0.9 * s); });
    ASSERT_GT(whole.points.back().x(), 2500.0);
    const auto from = std::find_if(whole.points.begin(), whole.points.end(), [](const Vector3d& p) { return p.x() > 650.0; });
    const auto to = std::find_if(from, whole.points.end(), [](const Vector3d& p) { return p.x() > 1450.0; });
    const auto first = from - whole.points.begin(), last = to - whole.points.begin();
    const SmoothAxes all = smoothAxes(whole.points, whole.wanted, options);
    const SmoothAxes piece = smoothAxes({from, to}, {whole.wanted.begin() + first, whole.wanted.begin() + last}, options);
    EXPECT_GT(all.largest_deviation, options.max_deviation);
    std::size_t compared = 0;
    for (auto i = first; i < last; ++i)
      if (const double x = whole.points[i].x(); x > 750.0 && x < 1350.0) {
        ASSERT_LT(angleBetween(all.axes[i], piece.axes[i - first]), 1e-12) << "step at " << place << ", axis at " << x;
        ++compared;
      }
    EXPECT_GT(compared, 2000u);
  }
}

/** The same with points in clusters far apart: a change of the axes goes through the gaps, however long they are. */
TEST(SmoothAxes, PartsOfAPathInClustersMeetAsIfSolvedAtOnce)
{
  constexpr std::size_t clusters = 1000, in_cluster = 60, first = 300, last = 700;
  const AxisFieldOptions options{1.0, 90.0 * degree, 0.0};
  for (const double gap : {10.0, 101.0, 300.0}) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> lean(-0.3, 0.3);
    Polyline points;
    Vectors wanted;
    for (std::size_t c = 0; c < clusters; ++c)
      for (std::size_t i = 0; i < in_cluster; ++i) {
        points.emplace_back(gap * static_cast<double>(c) + 0.004 * static_cast<double>(i), 0.0, 0.0);
        wanted.push_back(Vector3d(lean(random), lean(random), 1.0).normalized());
      }
    const auto from = static_cast<std::ptrdiff_t>(first * in_cluster), to = static_cast<std::ptrdiff_t>(last * in_cluster);
    const SmoothAxes all = smoothAxes(points, wanted, options);
    const SmoothAxes piece =
        smoothAxes({points.begin() + from, points.begin() + to}, {wanted.begin() + from, wanted.begin() + to}, options);
    double worst = 0.0;
    for (std::size_t i = (first + 100) * in_cluster; i < (last - 100) * in_cluster; ++i)
      worst = std::max(worst, angleBetween(all.axes[i], piece.axes[i - first * in_cluster]));
    EXPECT_LT(worst, 1e-8) << "gap of " << gap << " lengths"; // the rounding of a badly conditioned system
    EXPECT_GT(largestAngle(all.axes, wanted), 0.1);
  }
}

TEST(SmoothAxes, PointsAtOnePlaceShareAnAxis)
{
  TestPath path = straightPath(
      200, 0.5, [](double s) { return 0.3 * std::sin(s); }, [](double) { return 0.1; });
  for (int i = 0; i < 6; ++i) {
    path.points.insert(path.points.begin() + 80, path.points[80]);
    path.wanted.insert(path.wanted.begin() + 80, Vector3d(0.1 * i, 0.0, 1.0).normalized());
  }
  for (const double length : {0.0, 5.0}) {
    const SmoothAxes field = smoothAxes(path.points, path.wanted, {length, 3 * degree, 3 * degree});
    EXPECT_LE(rateExcess(path.points, field.axes, 3 * degree), 1e-9);
    for (const Vector3d& a : field.axes)
      ASSERT_NEAR(a.norm(), 1.0, 1e-12);
  }
  const Polyline place(5, Vector3d(1, 2, 3));
  const Vectors axes(5, Vector3d::UnitX());
  EXPECT_EQ(smoothAxes(place, axes, both).axes, axes);
}

TEST(SmoothAxes, OppositeAxesAreTurnedThroughAndSaid)
{
  const TestPath path = straightPath(
      400, 0.5, [](double) { return 0.0; }, [](double) { return 0.0; });
  Vectors wanted = path.wanted;
  for (std::size_t i = 200; i < wanted.size(); ++i)
    wanted[i] = -wanted[i];
  for (const double length : {0.0, 20.0}) {
    const SmoothAxes field = smoothAxes(path.points, wanted, {length, 3 * degree, 2 * degree});
    EXPECT_LE(rateExcess(path.points, field.axes, 2 * degree), 1e-9);
    EXPECT_GT(field.deviating_points, 20u);
    EXPECT_GT(field.largest_deviation, 45 * degree);
    EXPECT_FALSE(liesInSurface(largestLean(wanted, wanted), wanted, wanted));
    EXPECT_FALSE(liesInSurface(largestLean(wanted, wanted), wanted, field.axes));
  }
}

TEST(SmoothAxes, SameBytesForAnyThreadsAndLinearTime)
{
  const TestPath path = sphereSpiral(0.035, 100.0);
  ASSERT_GT(path.points.size(), 800000u);
  const int all = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto start = std::chrono::steady_clock::now();
  const SmoothAxes one = smoothAxes(path.points, path.wanted, {50.0, 3 * degree, 10 * degree});
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  for (const int threads : {2, 3}) {
    omp_set_num_threads(threads);
    const SmoothAxes more = smoothAxes(path.points, path.wanted, {50.0, 3 * degree, 10 * degree});
    EXPECT_EQ(more.axes, one.axes);
    EXPECT_EQ(more.deviating_points, one.deviating_points);
    EXPECT_EQ(more.largest_rate, one.largest_rate);
  }
  omp_set_num_threads(all);
  RecordProperty("milliseconds", static_cast<int>(1e3 * seconds.count()));
  EXPECT_LT(seconds.count(), 30.0) << "linear in the number of points: about a second";
}

TEST(SmoothAxes, RefusesWhatCannotBe)
{
  const Vectors up(3, Vector3d::UnitZ());
  const Polyline line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_THROW(smoothAxes({line[0]}, up, both), std::invalid_argument);
  EXPECT_THROW(smoothAxes(line, up, {-1.0, 0.1, 0.1}), std::invalid_argument);
  EXPECT_THROW(smoothAxes(line, up, {1.0, 0.0, 0.1}), std::invalid_argument);
  EXPECT_THROW(smoothAxes(line, up, {1.0, 0.1, std::nan("")}), std::invalid_argument);
  EXPECT_TRUE(smoothAxes({}, {}, both).axes.empty());
}

namespace {

pcl::PointCloud<ToolpathPoint>::Ptr
toCloud(const TestPath& path)
{
  pcl::PointCloud<ToolpathPoint>::Ptr cloud(new pcl::PointCloud<ToolpathPoint>);
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    ToolpathPoint p;
    p.getVector3fMap() = path.points[i].cast<float>();
    p.getNormalVector3fMap() = path.normals[i].cast<float>();
    p.getAxisVector3fMap() = path.wanted[i].cast<float>();
    p.arc_length = static_cast<double>(i);
    cloud->push_back(p);
  }
  return cloud;
}

} // namespace

TEST(AxisField, SmoothsThePathAndReports)
{
  const TestPath path = sphereSpiral(0.4, 20.0);
  const auto cloud = toCloud(path);
  AxisField field;
  EXPECT_EQ(field.getStatus().code(), StatusCode::NotComputed);
  field.setInputPath(cloud);
  field.setAxisSmoothing(20.0);
  field.setMaxAxisRate(6.0);
  pcl::PointCloud<ToolpathPoint> out;
  field.compute(out);
  ASSERT_TRUE(field.getStatus().ok()) << field.getStatus().message();
  ASSERT_EQ(out.size(), cloud->size());
  EXPECT_EQ(out[7].arc_length, 7.0);
  double largest = 0.0, lean = 0.0, change = 0.0;
  std::size_t deviating = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Vector3d axis = out[i].getAxisVector3fMap().cast<double>();
    const double deviation = angleBetween(axis, path.wanted[i]) / degree;
    largest = std::max(largest, deviation);
    deviating += deviation > 2.0;
    lean = std::max(lean, angleBetween(axis, path.normals[i]) / degree);
    if (i > 0)
      change = std::max(change, angleBetween(axis, out[i - 1].getAxisVector3fMap().cast<double>()) / degree);
  }
  EXPECT_NEAR(field.getLargestDeviation(), largest, 1e-4);
  EXPECT_EQ(field.getDeviatingPoints(), deviating);
  EXPECT_NEAR(field.getLargestLean(), lean, 1e-4);
  EXPECT_NEAR(field.getLargestAxisChange(), change, 1e-4);
  EXPECT_LE(field.getLargestAxisRate(), 6.0 * 1.00001);
  field.compute(*cloud); // in place
  EXPECT_EQ(cloud->back().getAxisVector3fMap(), out.back().getAxisVector3fMap());
}

TEST(AxisField, SaysWhatIsWrong)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  AxisField field;
  pcl::PointCloud<ToolpathPoint> out;
  const auto said = [&](const pcl::PointCloud<ToolpathPoint>::Ptr& path) {
    out.resize(3);
    field.setInputPath(path);
    field.compute(out);
    EXPECT_TRUE(out.empty());
    EXPECT_FALSE(field.getStatus().ok());
    return field.getStatus().message();
  };
  EXPECT_NE(said(nullptr).find("setInputPath"), std::string::npos);
  auto bad = toCloud(sphereSpiral(0.4, 3.0));
  (*bad)[5].axis_x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(said(bad).find("point 5"), std::string::npos);
  bad = toCloud(sphereSpiral(0.4, 3.0));
  (*bad)[6].getAxisVector3fMap().setZero();
  EXPECT_NE(said(bad).find("point 6 has no axis"), std::string::npos);
  const auto good = toCloud(sphereSpiral(0.4, 3.0));
  field.setAxisSmoothing(-1.0);
  EXPECT_NE(said(good).find("-1 mm"), std::string::npos);
  field.setAxisSmoothing(10.0);
  field.setAxisDeviation(0.0);
  EXPECT_NE(said(good).find("deviation is 0"), std::string::npos);
  field.setAxisDeviation(2.0);
  field.setMaxAxisRate(-2.0);
  EXPECT_NE(said(good).find("-2 degrees per mm"), std::string::npos);
}

TEST(AxisField, RefusesAnAxisInTheSurface)
{
  // Over a fin 4 mm wide the normal turns by 150 degrees: the axis cannot follow it in time.
  TestPath path = straightPath(
      100, 0.5, [](double) { return 0.0; }, [](double) { return 0.0; });
  for (std::size_t i = 50; i < 58; ++i)
    path.wanted[i] = path.normals[i] = Vector3d(std::sin(150 * degree), 0.0, std::cos(150 * degree));
  AxisField field;
  field.setInputPath(toCloud(path));
  pcl::PointCloud<ToolpathPoint> out;
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  field.compute(out);
  EXPECT_EQ(field.getStatus().code(), StatusCode::Failed);
  EXPECT_NE(field.getStatus().message().find("raise the axis rate"), std::string::npos) << field.getStatus().message();
  EXPECT_TRUE(out.empty());
}

} // namespace axis_field_test
