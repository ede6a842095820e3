// SPDX-License-Identifier: BSD-3-Clause
// Refined geodesics against published lengths on a spheroid, integrated geodesics, helices and straight lines.
#include "support/geodesic_oracle.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include "geodesic/distance_field.h"
#include <pcl_spiral/geodesic/impl/geodesic_refinement.h>

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

namespace geodesic_refinement_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

constexpr double a = 1650.0, b = 860.0;
// GeographicLib's GeodSolve, latitude 60 longitude 0 to latitude 0 longitude 0, 30 ... 180, mm.
constexpr double published[] = {749.802870802,  1072.315413128, 1683.675783644, 2306.561014625,
                                2827.778170366, 3171.441917434, 3291.158860704};

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

std::vector<GeodesicLine>
traced(const SurfaceGraph& graph, const Vector3d& source, const Polyline& targets)
{
  DistanceField field;
  EXPECT_TRUE(field.compute(graph, source));
  std::vector<GeodesicLine> lines(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i)
    lines[i].points = field.trace(targets[i]);
  return lines;
}

Polyline
rimOfSpheroid()
{
  Polyline targets;
  for (int k = 0; k < 7; ++k)
    targets.push_back(test::onSpheroid(a, b, 0, 30 * k));
  return targets;
}

struct Worst {
  double length = 0.0, sideways = 0.0;
};

/** Lengths against published lengths, paths against integrated paths. */
Worst
worstOnSpheroid(const std::vector<GeodesicLine>& lines)
{
  const auto surface = test::spheroidCap(a, b);
  const Vector3d source = test::onSpheroid(a, b, 60, 0);
  const Polyline targets = rimOfSpheroid();
  Worst worst;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const GeodesicLine& line = lines[k];
    EXPECT_EQ(line.points.front(), source);
    EXPECT_EQ(line.points.back(), targets[k]);
    EXPECT_FALSE(line.left_surface);
    const auto exact = test::exactGeodesic(*surface, source, targets[k], line.points[1] - line.points[0], line.length);
    EXPECT_LT(exact.miss, 1e-6);
    EXPECT_NEAR(exact.length, published[k], 1e-6);
    const double sideways = test::sidewaysDistance(*surface, line.points, exact.points);
    std::printf("  longitude %3zu: length %+.6f mm, sideways %.5f mm, last move %.6f\n", 30 * k, line.length - published[k], sideways,
                line.largest_move);
    worst.length = std::max(worst.length, std::abs(line.length - published[k]));
    worst.sideways = std::max(worst.sideways, sideways);
  }
  return worst;
}

class OnSpheroid : public ::testing::Test {
protected:
  static void SetUpTestSuite() { graph_ = new SurfaceGraph(graphOf(test::sampleUniform(*test::spheroidCap(a, b), 200000, 31).points)); }
  static void TearDownTestSuite() { delete graph_; }
  static SurfaceGraph* graph_;
};
SurfaceGraph* OnSpheroid::graph_ = nullptr;

TEST_F(OnSpheroid, PublishedDistances)
{
  const MlsSurface surface(*graph_);
  auto lines = traced(*graph_, test::onSpheroid(a, b, 60, 0), rimOfSpheroid());
  refineGeodesics(surface, {}, lines);
  for (const GeodesicLine& line : lines) {
    EXPECT_TRUE(line.converged);
    EXPECT_EQ(line.points.size(), 129u);
    EXPECT_EQ(line.feet.size(), 129u);
  }
  const Worst worst = worstOnSpheroid(lines);
  EXPECT_LT(worst.length, 2e-4);
  EXPECT_LT(worst.sideways, 0.005);
}

TEST_F(OnSpheroid, PublishedMethodComesToTheSame)
{
  const MlsSurface surface(*graph_);
  auto lines = traced(*graph_, test::onSpheroid(a, b, 60, 0), rimOfSpheroid());
  RefinementOptions options;
  options.method = RefinementMethod::ConjugateGradientNewton;
  refineGeodesics(surface, options, lines);
  const Worst worst = worstOnSpheroid(lines);
  EXPECT_LT(worst.length, 1e-3);
  EXPECT_LT(worst.sideways, 0.1);
}

TEST_F(OnSpheroid, AnyRoughStartComesToTheSame)
{
  const MlsSurface surface(*graph_);
  const Vector3d source = test::onSpheroid(a, b, 60, 0);
  auto lines = traced(*graph_, source, rimOfSpheroid());
  std::vector<SurfaceFoot> feet;
  for (GeodesicLine& line : lines) { // moved sideways by up to 60 mm, and jagged
    for (std::size_t i = 1; i + 1 < line.points.size(); ++i) {
      Vector3d& p = line.points[i];
      const Vector3d side(-p.y(), p.x(), 0.0);
      p += (60.0 * std::sin(M_PI * i / (line.points.size() - 1)) + 3.0 * ((i * 7919) % 5 - 2.0)) * side.normalized();
    }
    surface.project(line.points, feet);
    for (std::size_t i = 1; i + 1 < line.points.size(); ++i)
      line.points[i] = feet[i].position;
  }
  refineGeodesics(surface, {}, lines);
  const Worst worst = worstOnSpheroid(lines);
  EXPECT_LT(worst.length, 2e-4);
  EXPECT_LT(worst.sideways, 0.005);
}

TEST_F(OnSpheroid, SameBytesForAnyThreads)
{
  const MlsSurface surface(*graph_);
  auto one = traced(*graph_, test::onSpheroid(a, b, 60, 0), rimOfSpheroid()), two = one;
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  refineGeodesics(surface, {}, one);
  omp_set_num_threads(3);
  refineGeodesics(surface, {}, two);
  omp_set_num_threads(threads);
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].points, two[k].points);
    EXPECT_EQ(one[k].length, two[k].length);
  }
}

TEST(GeodesicRefinement, NoisySpheroid)
{
  auto sampled = test::sampleUniform(*test::spheroidCap(a, b), 200000, 32);
  test::addNoise(sampled, 0.02, 33);
  const SurfaceGraph graph = graphOf(sampled.points);
  const MlsSurface surface(graph);
  auto lines = traced(graph, test::onSpheroid(a, b, 60, 0), rimOfSpheroid());
  refineGeodesics(surface, {}, lines);
  const Worst worst = worstOnSpheroid(lines);
  EXPECT_LT(worst.length, 0.02);
  EXPECT_LT(worst.sideways, 1.0);
}

TEST(GeodesicRefinement, HelicesOnACylinder)
{
  const double radius = 60.0;
  const auto surface = test::cylinder(radius, test::Region({test::rectangle(110, 200)}));
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 40000, 34).points);
  const auto at = [&](double angle, double y) { return Vector3d(radius * std::sin(angle), y, radius * std::cos(angle)); };
  const double ends[][2] = {{0.9, 80}, {0.9, -70}, {0.2, 95}, {-1.0, 60}, {1.0, -50.5}};
  Polyline targets;
  for (const auto& e : ends)
    targets.push_back(at(e[0], e[1]));
  auto lines = traced(graph, at(-0.5, -50), targets);
  refineGeodesics(MlsSurface(graph), {}, lines);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double turn = ends[k][0] + 0.5, rise = ends[k][1] + 50;
    EXPECT_TRUE(lines[k].converged);
    EXPECT_NEAR(lines[k].length, std::hypot(radius * turn, rise), 1e-3);
    for (const Vector3d& p : lines[k].points) // sideways: along (-rise, radius turn) in the unrolled plane
      EXPECT_LT(std::abs(radius * (std::atan2(p.x(), p.z()) + 0.5) * rise - (p.y() + 50) * radius * turn) / std::hypot(radius * turn, rise),
                0.01);
  }
}

TEST(GeodesicRefinement, SaysWhereALineLeavesTheSurface)
{
  const auto surface = test::flat(test::Region({test::ell(200, 90)}));
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 30000, 35).points);
  const Eigen::Vector2d low = surface->region().lower();
  const Vector3d corner(low.x() + 90, low.y() + 90, 0), source(low.x() + 195, low.y() + 45, 0);
  auto lines = traced(graph, source, {{low.x() + 45, low.y() + 195, 0}, {low.x() + 10, low.y() + 10, 0}});
  refineGeodesics(MlsSurface(graph), {}, lines);
  EXPECT_TRUE(lines[0].left_surface);
  EXPECT_FALSE(lines[0].converged);
  EXPECT_LT((lines[0].left_at - corner).norm(), 10.0);
  for (const Vector3d& p : lines[0].points)
    EXPECT_LT(std::min(p.x() - corner.x(), p.y() - corner.y()), 5.0 * graph.spacing());
  EXPECT_FALSE(lines[1].left_surface); // its neighbour is not affected
  EXPECT_TRUE(lines[1].converged);
  EXPECT_NEAR(lines[1].length, (lines[1].points.back() - source).norm(), 1e-4);
}

TEST(GeodesicRefinement, LinesThatCannotBeLinesComeBackUnconverged)
{
  const auto surface = test::flat(test::Region({test::rectangle(100, 100)}));
  const SurfaceGraph graph = graphOf(test::sampleUniform(*surface, 5000, 36).points);
  std::vector<GeodesicLine> lines(4);
  lines[1].points = {Vector3d(1, 1, 0), Vector3d(1, 1, 0)};
  lines[2].points = {Vector3d(1, 1, 0), Vector3d(std::nan(""), 1, 0)};
  lines[3].points = {Vector3d(1, 1, 0), Vector3d(30, 20, 0)};
  refineGeodesics(MlsSurface(graph), {}, lines);
  EXPECT_FALSE(lines[0].converged);
  EXPECT_TRUE(lines[1].converged); // from a point to itself
  EXPECT_EQ(lines[1].length, 0.0);
  EXPECT_FALSE(lines[2].converged);
  EXPECT_TRUE(lines[3].converged);
  EXPECT_NEAR(lines[3].length, std::hypot(29, 19), 1e-6);
}

} // namespace

} // namespace geodesic_refinement_test
