// SPDX-License-Identifier: BSD-3-Clause
// Distances along surfaces against exact distances: plane, sphere, cylinder, spheroid; from points and from curves.
#include "support/sampling.h"
#include "support/surfaces.h"

#include "geodesic/distance_field.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>

namespace distance_field_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

SurfaceGraph
graphOf(const std::vector<Vector3d>& points)
{
  std::vector<Eigen::Vector3f> single;
  for (const Vector3d& p : points)
    single.push_back(p.cast<float>());
  SurfaceGraph graph;
  EXPECT_TRUE(graph.build(single, {}).ok());
  return graph;
}

struct Errors {
  double rms = 0.0, mean = 0.0, largest = 0.0;
  std::size_t unreached = 0;
};

Errors
errorsOf(const SurfaceGraph& graph, const DistanceField& field, const std::function<double(const Vector3d&)>& exact)
{
  Errors e;
  std::size_t count = 0;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (!(field.distance(i) < DistanceField::unreached)) {
      ++e.unreached;
      continue;
    }
    const double error = field.distance(i) - exact(graph.position(i));
    e.rms += error * error;
    e.mean += error;
    e.largest = std::max(e.largest, std::abs(error));
    ++count;
  }
  e.rms = std::sqrt(e.rms / count);
  e.mean /= count;
  std::printf("  %zu points: mean %.5f rms %.5f largest %.4f mm, %zu unreached\n", graph.size(), e.mean, e.rms, e.largest, e.unreached);
  return e;
}

/** Arc length of the meridian of the spheroid (a, a, b) from the pole, by parametric colatitude. */
class Meridian {
public:
  Meridian(double a, double b) : a_(a), b_(b), arc_(200001, 0.0)
  {
    const double step = 0.5 * M_PI / 200000;
    for (std::size_t i = 1; i < arc_.size(); ++i) {
      const double t = (i - 0.5) * step;
      arc_[i] = arc_[i - 1] + std::hypot(a * std::cos(t), b * std::sin(t)) * step;
    }
  }
  double operator()(const Vector3d& p) const
  {
    const double at = std::atan2(std::hypot(p.x(), p.y()) / a_, p.z() / b_) / (0.5 * M_PI) * 200000;
    const auto i = std::min<std::size_t>(199999, static_cast<std::size_t>(std::max(0.0, at)));
    return arc_[i] + (at - i) * (arc_[i + 1] - arc_[i]);
  }

private:
  double a_, b_;
  std::vector<double> arc_;
};

TEST(DistanceField, Plane)
{
  const auto surface = test::flat(test::Region({test::rectangle(200, 160)}));
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 20000, 11).points);
  const Vector3d source(13.0, -7.0, 0.0);
  DistanceField field;
  ASSERT_TRUE(field.compute(graph, source));
  const Errors e = errorsOf(graph, field, [&](const Vector3d& p) { return (p - source).norm(); });
  EXPECT_LT(e.largest, 0.05 * graph.spacing());
  EXPECT_LT(e.rms, 2e-3);
  for (std::size_t i = 0; i < graph.size(); i += 7)
    if (field.distance(i) < DistanceField::unreached && field.distance(i) > 5.0) {
      EXPECT_GT(field.gradient(i).dot((graph.position(i) - source).normalized()), 0.999);
    }
}

TEST(DistanceField, SpheroidMeridians)
{
  const auto surface = test::spheroidCap(1650, 860);
  const Meridian exact(1650, 860);
  for (const std::size_t n : {40000, 200000}) {
    const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, n, n).points);
    DistanceField field;
    const auto start = std::chrono::steady_clock::now();
    ASSERT_TRUE(field.compute(graph, Vector3d(0, 0, 860)));
    std::printf("  %.3f s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    const Errors e = errorsOf(graph, field, exact);
    EXPECT_LT(e.rms, n == 200000 ? 0.15 : 0.6);
    EXPECT_LT(e.unreached, n / 2000);
  }
}

TEST(DistanceField, GreatCircles)
{
  const double radius = 100.0;
  const auto surface = test::ball(radius, test::Region({test::circle({0, 0}, 95)}));
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 40000, 12).points);
  const Vector3d source = radius * Vector3d(0.3, 0.2, std::sqrt(1 - 0.13)), s = source / radius;
  DistanceField field;
  ASSERT_TRUE(field.compute(graph, source));
  const Errors e = errorsOf(graph, field, [&](const Vector3d& p) { return radius * std::atan2(s.cross(p).norm(), s.dot(p)); });
  EXPECT_LT(e.rms, 0.05);
}

TEST(DistanceField, Cylinder)
{
  const double radius = 60.0;
  const auto surface = test::cylinder(radius, test::Region({test::rectangle(110, 200)}));
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 40000, 13).points);
  const Vector3d source(radius * std::sin(-0.4), 30.0, radius * std::cos(-0.4));
  DistanceField field;
  ASSERT_TRUE(field.compute(graph, source));
  const Errors e =
      errorsOf(graph, field, [&](const Vector3d& p) { return std::hypot(radius * (std::atan2(p.x(), p.z()) + 0.4), p.y() - 30.0); });
  EXPECT_LT(e.rms, 0.01);
}

/** A source curve: distance to a circle, seen from inside and outside. */
TEST(DistanceField, FromACircleInThePlane)
{
  const auto surface = test::flat(test::Region({test::circle({0, 0}, 100)}));
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 40000, 14).points);
  Polyline circle;
  for (int i = 0; i < 500; ++i)
    circle.emplace_back(5 + 30 * std::cos(2 * M_PI * i / 500), 30 * std::sin(2 * M_PI * i / 500), 0.0);
  DistanceField field;
  ASSERT_TRUE(field.compute(graph, circle));
  const Errors e = errorsOf(graph, field, [&](const Vector3d& p) { return std::abs(30.0 - (p - Vector3d(5, 0, 0)).norm()); });
  EXPECT_LT(e.rms, 0.01);
}

TEST(DistanceField, FromASquareInThePlane)
{
  const auto surface = test::flat(test::Region({test::circle({0, 0}, 100)}));
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 40000, 15).points);
  const Polyline square{{-40, -40, 0}, {40, -40, 0}, {40, 40, 0}, {-40, 40, 0}};
  DistanceField field;
  ASSERT_TRUE(field.compute(graph, square));
  const Errors e = errorsOf(graph, field, [&](const Vector3d& p) {
    const Eigen::Vector2d q = p.head<2>().cwiseAbs() - Eigen::Vector2d(40, 40);
    return q.maxCoeff() < 0.0 ? -q.maxCoeff() : q.cwiseMax(0.0).norm();
  });
  EXPECT_LT(e.rms, 0.07); // fronts turn sharply at the bisectors of corners: the error there is up to a spacing
  EXPECT_LT(e.largest, graph.spacing());
}

TEST(DistanceField, FromTheHoleOfASpheroid)
{
  const auto surface = test::spheroidCap(1650, 860, 260);
  const Meridian exact(1650, 860);
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 200000, 16).points);
  const Polyline& hole = surface->outlines()[1];
  DistanceField field;
  ASSERT_TRUE(field.compute(graph, hole));
  const double inner = exact(hole[0]);
  const Errors e = errorsOf(graph, field, [&](const Vector3d& p) { return exact(p) - inner; });
  EXPECT_LT(e.rms, 0.15);
}

double
longestStep(const Polyline& line)
{
  double largest = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
    largest = std::max(largest, (line[i] - line[i - 1]).norm());
  return largest;
}

TEST(DistanceField, TracesArriveAndAreShort)
{
  const auto surface = test::spheroidCap(1650, 860);
  const Meridian exact(1650, 860);
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 40000, 17).points);
  const Vector3d pole(0, 0, 860);
  DistanceField field;
  ASSERT_TRUE(field.compute(graph, pole));
  for (int k = 0; k < 200; ++k) {
    const double t = M_PI / 2 * (k + 1) / 200, l = 2.4 * k;
    const Vector3d to(1650 * std::sin(t) * std::cos(l), 1650 * std::sin(t) * std::sin(l), 860 * std::cos(t));
    const Polyline line = field.trace(to);
    ASSERT_GE(line.size(), 2u);
    EXPECT_EQ(line.front(), pole);
    EXPECT_EQ(line.back(), to);
    EXPECT_LT(longestStep(line), 4.0 * graph.spacing());
    EXPECT_LT(length(line), 1.01 * exact(to) + 0.1 * graph.spacing());
    for (const Vector3d& p : line)
      EXPECT_LT(std::abs(Vector3d(-to.y(), to.x(), 0).normalized().dot(p)), 0.02 * exact(to) + 0.5 * graph.spacing());
  }
  EXPECT_TRUE(field.trace(Vector3d(0, 0, 1000)).empty());
  EXPECT_TRUE(field.trace(Vector3d(0, std::nan(""), 0)).empty());
}

TEST(DistanceField, TracesGoRoundACorner)
{
  // From one limb of an L to the other: straight to the re-entrant corner, then straight again.
  const auto surface = test::flat(test::Region({test::ell(200, 90)}));
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 30000, 18).points);
  const Eigen::Vector2d low = surface->region().lower();
  const Vector3d corner(low.x() + 90, low.y() + 90, 0), source(low.x() + 195, low.y() + 45, 0), to(low.x() + 45, low.y() + 195, 0);
  DistanceField field;
  ASSERT_TRUE(field.compute(graph, source));
  const double exact = (source - corner).norm() + (to - corner).norm();
  EXPECT_NEAR(field.distanceAt(to), exact, 2.0 * graph.spacing()); // triangles cut the corner slightly
  const Polyline line = field.trace(to);
  ASSERT_GE(line.size(), 2u);
  EXPECT_EQ(line.front(), source);
  EXPECT_LT(length(line), 1.02 * exact);
  double nearest = 1e9;
  for (const Vector3d& p : line)
    nearest = std::min(nearest, (p - corner).norm());
  EXPECT_LT(nearest, 5.0 * graph.spacing());
}

TEST(DistanceField, TracesEndOnTheSourceCurve)
{
  const auto surface = test::offCentreAnnulus();
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 30000, 19).points);
  const Polyline& hole = surface->outlines()[1];
  DistanceField field;
  ASSERT_TRUE(field.compute(graph, hole));
  const Polyline rim = resampled(surface->outlines()[0], 100, true);
  for (const Vector3d& to : rim) {
    const Polyline line = field.trace(to);
    ASSERT_GE(line.size(), 2u);
    EXPECT_EQ(line.back(), to);
    double off = 1e9;
    for (const Vector3d& p : hole)
      off = std::min(off, (p - line.front()).norm());
    EXPECT_LT(off, 0.1);
    EXPECT_NEAR(length(line), field.distanceAt(to), 0.01 * length(line) + 0.5 * graph.spacing());
  }
}

TEST(DistanceField, RefusesASourceOffTheCloud)
{
  const auto surface = test::flat(test::Region({test::rectangle(100, 100)}));
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 5000, 20).points);
  DistanceField field;
  EXPECT_FALSE(field.compute(graph, Vector3d(0, 0, 50)));
  EXPECT_FALSE(field.compute(graph, Vector3d(std::nan(""), 0, 0)));
  EXPECT_FALSE(field.compute(graph, Polyline{{0, 0, 0}}));
  EXPECT_TRUE(field.trace(Vector3d(0, 0, 0)).empty());
}

} // namespace

} // namespace distance_field_test
