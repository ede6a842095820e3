// SPDX-License-Identifier: BSD-3-Clause
// Boundary loops against exact outlines: number of loops, distance both ways, corners, invariance, given boundary
// points, the published walk, refusals.
#include "core/self_crossing.h"
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/features/centroid_boundary_estimation.h>

#include "support/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace boundary_loops_test {

namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Eigen::Vector3d;

struct Loops {
  std::vector<BoundaryLoop> loops;
  Status status;
};

Loops
loopsOf(const Cloud::Ptr& cloud)
{
  BoundaryLoops<pcl::PointXYZ> boundary;
  boundary.setInputCloud(cloud);
  Loops result;
  boundary.compute(result.loops);
  result.status = boundary.getStatus();
  return result;
}

double
distanceTo(const Vector3d& p, const Polyline& loop)
{
  double nearest = 1e30;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vector3d a = loop[i], d = loop[(i + 1) % loop.size()] - a;
    const double t = d.squaredNorm() > 0.0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, (p - a - t * d).norm());
  }
  return nearest;
}

double
farthest(const Polyline& from, const Polyline& to)
{
  double largest = 0.0;
  for (const Vector3d& p : from)
    largest = std::max(largest, distanceTo(p, to));
  return largest;
}

/** Largest distance between the curves and the true outlines, both ways. */
double
hausdorff(const std::vector<BoundaryLoop>& loops, const AnalyticSurface& surface, double step)
{
  double worst = 0.0;
  std::vector<int> hits(surface.outlines().size(), 0);
  for (const BoundaryLoop& loop : loops) {
    std::size_t nearest = 0;
    for (std::size_t o = 1; o < surface.outlines().size(); ++o)
      if (distanceTo(loop.curve[0], surface.outlines()[o]) < distanceTo(loop.curve[0], surface.outlines()[nearest]))
        nearest = o;
    ++hits[nearest];
    const Polyline& outline = surface.outlines()[nearest];
    const auto count = static_cast<std::size_t>(length(outline, true) / step);
    worst = std::max({worst, farthest(loop.curve, outline), farthest(resampled(outline, count, true), loop.curve)});
  }
  for (const int h : hits)
    EXPECT_EQ(h, 1);
  return worst;
}

double
spacingOf(const AnalyticSurface& surface, std::size_t points)
{
  return std::sqrt(surface.area() / static_cast<double>(points));
}

void
jitter(Sampled& sampled, double sigma, std::uint64_t seed)
{
  Random random(seed);
  for (std::size_t i = 0; i < sampled.points.size(); ++i) {
    const Vector3d e = sampled.normals[i].unitOrthogonal();
    sampled.points[i] += sigma * (random.normal() * e + random.normal() * sampled.normals[i].cross(e));
  }
}

struct Shape {
  const char* name;
  PlaneLoop outline;
  std::vector<PlaneLoop> holes;
  std::size_t points;
  std::size_t corners;           ///< 0: not checked
  std::uint64_t seeds;           ///< 1 to this
  double corner_tolerance = 1.5; ///< of the distance from each true corner to one found, spacings
};

std::vector<Shape>
shapes()
{
  return {{"square", rectangle(100, 100), {}, 4000, 4, 3},
          {"L", ell(200, 90), {}, 12000, 6, 6},
          {"star", star(5, 100, 45), {}, 12000, 10, 6, 3.0}, // blunt re-entrant corners slide along their sides
          {"slot", slot(100, 8), {}, 800, 0, 6},
          {"two holes", rectangle(100, 80), {circle({-20, 0}, 12), circle({25, 5}, 9)}, 8000, 4, 3}};
}

SurfacePtr
surfaceOf(const Shape& shape)
{
  std::vector<PlaneLoop> loops{shape.outline};
  loops.insert(loops.end(), shape.holes.begin(), shape.holes.end());
  return flat(Region(loops));
}

TEST(BoundaryLoops, KnownOutlines)
{
  for (const Shape& shape : shapes())
    for (std::uint64_t seed = 1; seed <= shape.seeds; ++seed) {
      SCOPED_TRACE(std::string(shape.name) + " seed " + std::to_string(seed));
      const SurfacePtr surface = surfaceOf(shape);
      const double spacing = spacingOf(*surface, shape.points);
      const Loops found = loopsOf(toCloud(sampleUniform(*surface, shape.points, seed).points));
      ASSERT_TRUE(found.status.ok()) << found.status.message();
      ASSERT_EQ(found.loops.size(), 1 + shape.holes.size());
      EXPECT_EQ(found.loops[0].type, LoopType::Outer);
      EXPECT_LE(hausdorff(found.loops, *surface, 0.5 * spacing), 1.5 * spacing);
      if (shape.corners == 0)
        continue;
      EXPECT_EQ(found.loops[0].corners.size(), shape.corners);
      for (const Eigen::Vector2d& corner : shape.outline) {
        double nearest = 1e30;
        for (const std::size_t c : found.loops[0].corners)
          nearest = std::min(nearest, (found.loops[0].curve[c].head<2>() - corner).norm());
        EXPECT_LE(nearest, shape.corner_tolerance * spacing);
      }
    }
}

TEST(BoundaryLoops, SmoothRimWithinAFractionOfTheSpacing)
{
  const SurfacePtr surface = spheroidCap(165, 86);
  const std::size_t points = 40000;
  const double spacing = spacingOf(*surface, points);
  for (const std::uint64_t seed : {11, 12}) {
    const Loops found = loopsOf(toCloud(sampleUniform(*surface, points, seed).points));
    ASSERT_EQ(found.loops.size(), 1u);
    EXPECT_TRUE(found.loops[0].corners.empty());
    double mean = 0.0, most_inside = 0.0, most_outside = 0.0;
    for (const Vector3d& p : found.loops[0].curve) {
      const double inside = (surface->contains(p) ? 1.0 : -1.0) * surface->rimDistance(p) / spacing;
      mean += inside / static_cast<double>(found.loops[0].curve.size());
      most_inside = std::max(most_inside, inside);
      most_outside = std::max(most_outside, -inside);
    }
    EXPECT_LE(std::abs(mean), 0.25);
    EXPECT_LE(most_inside, 0.6);
    EXPECT_LE(most_outside, 0.3);
  }
}

TEST(BoundaryLoops, ScanLinesTenTimesDenserAlong)
{
  for (const PlaneLoop& outline : {rectangle(100, 100), ell(100, 40)})
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
      const SurfacePtr surface = flat(Region({outline}));
      const Loops found = loopsOf(toCloud(sampleScanLines(*surface, 0.3, 3.0, seed).points));
      ASSERT_TRUE(found.status.ok()) << found.status.message();
      ASSERT_EQ(found.loops.size(), 1u);
      EXPECT_EQ(found.loops[0].corners.size(), outline.size());
      EXPECT_LE(hausdorff(found.loops, *surface, 0.5), 1.5 * 3.0); // rows 3 apart
    }
}

TEST(BoundaryLoops, NoiseAndJitter)
{
  const Shape square = shapes()[0];
  const SurfacePtr surface = surfaceOf(square);
  const double spacing = spacingOf(*surface, square.points);
  for (const std::uint64_t seed : {5, 6}) {
    Sampled noisy = sampleUniform(*surface, square.points, seed), shaken = noisy;
    addNoise(noisy, 0.3 * spacing, seed);
    jitter(shaken, 0.3 * spacing, seed);
    for (const Sampled* sampled : {&noisy, &shaken}) {
      const Loops found = loopsOf(toCloud(sampled->points));
      ASSERT_TRUE(found.status.ok()) << found.status.message();
      ASSERT_EQ(found.loops.size(), 1u);
      EXPECT_LE(hausdorff(found.loops, *surface, 0.5 * spacing), 1.5 * spacing);
    }
  }
}

TEST(BoundaryLoops, LatticeEdgeIsItsOutermostRow)
{
  Cloud::Ptr cloud(new Cloud);
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 40; ++j)
      cloud->emplace_back(static_cast<float>(i), static_cast<float>(j), 0.0f);
  const Loops found = loopsOf(cloud);
  ASSERT_EQ(found.loops.size(), 1u);
  EXPECT_EQ(found.loops[0].corners.size(), 4u);
  EXPECT_LE(farthest(found.loops[0].curve, {{0, 0, 0}, {60, 0, 0}, {60, 40, 0}, {0, 40, 0}}), 0.5);
}

TEST(BoundaryLoops, DiscsCutFromALatticeNeverCrossThemselves)
{
  // An earlier fault: a ragged rim got one corner, and its side ran beyond it at both ends.
  constexpr double radius = 66.0;
  for (int k = 0; k < 12; ++k) {
    SCOPED_TRACE(k);
    const double dx = 0.083 * k, dy = 0.031 * k;
    Cloud::Ptr cloud(new Cloud);
    for (int i = -70; i <= 70; ++i)
      for (int j = -70; j <= 70; ++j)
        if (std::hypot(i + dx, j + dy) <= radius)
          cloud->emplace_back(static_cast<float>(i + dx), static_cast<float>(j + dy),
                              static_cast<float>(2.0 * std::sin(0.3 * i) * std::cos(0.2 * j)));
    const Loops found = loopsOf(cloud);
    ASSERT_EQ(found.loops.size(), 1u);
    Polyline closed = found.loops[0].curve;
    closed.push_back(closed.front());
    EXPECT_FALSE(firstSelfCrossing(closed, std::vector<Vector3d>(closed.size(), Vector3d::UnitZ()), 1e-3));
    for (const Vector3d& p : closed)
      EXPECT_NEAR(std::hypot(p.x(), p.y()), radius, 1.5);
  }
}

TEST(BoundaryLoops, SameForAnyOrderAndMoved)
{
  const SurfacePtr surface = ellPatch();
  const Sampled sampled = sampleUniform(*surface, 10000, 8);
  const Loops first = loopsOf(toCloud(sampled.points));
  ASSERT_EQ(first.loops.size(), 1u);
  const std::vector<std::size_t> order = shuffled(sampled.points.size(), 9);
  std::vector<Vector3d> mixed;
  for (const std::size_t i : order)
    mixed.push_back(sampled.points[i]);
  const Loops second = loopsOf(toCloud(mixed));
  ASSERT_EQ(second.loops.size(), 1u);
  ASSERT_EQ(first.loops[0].curve.size(), second.loops[0].curve.size());
  for (std::size_t i = 0; i < first.loops[0].curve.size(); ++i)
    ASSERT_EQ(first.loops[0].curve[i], second.loops[0].curve[i]);
  EXPECT_EQ(first.loops[0].indices[3], order[second.loops[0].indices[3]]);

  const double angle = 0.7; // about an axis that keeps the outer side up
  const Eigen::AngleAxisd turn(angle, Vector3d(0.2, -0.3, 1.0).normalized());
  const Vector3d shift(12, -30, 45);
  std::vector<Vector3d> moved;
  for (const Vector3d& p : sampled.points)
    moved.push_back(turn * p + shift);
  const Loops third = loopsOf(toCloud(moved));
  ASSERT_EQ(third.loops.size(), 1u);
  Polyline back;
  for (const Vector3d& p : third.loops[0].curve)
    back.push_back(turn.inverse() * (p - shift));
  EXPECT_LE(farthest(back, first.loops[0].curve), 5e-3);
}

TEST(BoundaryLoops, DropsWhatIsNoPoint)
{
  const SurfacePtr surface = flat(Region({rectangle(100, 100)}));
  Cloud::Ptr cloud = toCloud(sampleUniform(*surface, 3000, 10).points);
  const Loops clean = loopsOf(cloud);
  const std::size_t points = cloud->size();
  for (std::size_t i = 0; i < points; i += 10)
    cloud->push_back((*cloud)[i]);
  cloud->emplace_back(std::nanf(""), 0.0f, 0.0f);
  const Loops found = loopsOf(cloud);
  ASSERT_EQ(found.loops.size(), 1u);
  EXPECT_EQ(found.loops[0].curve, clean.loops[0].curve);
}

TEST(BoundaryLoops, NormalsSayWhichSideIsOut)
{
  const SurfacePtr surface = flat(Region({rectangle(100, 100)}));
  const Sampled sampled = sampleUniform(*surface, 3000, 10);
  pcl::PointCloud<pcl::Normal>::Ptr down(new pcl::PointCloud<pcl::Normal>(3000, 1, pcl::Normal(0, 0, -1)));
  BoundaryLoops<pcl::PointXYZ> boundary;
  boundary.setInputCloud(toCloud(sampled.points));
  const auto signedArea = [&] {
    std::vector<BoundaryLoop> loops;
    boundary.compute(loops);
    double area = 0.0;
    for (std::size_t i = 0; i < loops[0].curve.size(); ++i)
      area += 0.5 * loops[0].curve[i].cross(loops[0].curve[(i + 1) % loops[0].curve.size()]).z();
    return area;
  };
  EXPECT_NEAR(signedArea(), 10000.0, 150.0);
  boundary.setInputNormals(down);
  EXPECT_NEAR(signedArea(), -10000.0, 150.0);
}

using Flags = pcl::PointCloud<pcl::Boundary>;

/** Flags of \p Estimation, a pcl::BoundaryEstimation, with \p k neighbours. */
template <typename Estimation>
Flags::Ptr
flagsOf(const Cloud::Ptr& cloud, const std::vector<Vector3d>& normals, int k)
{
  Estimation estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(toNormals(normals));
  estimation.setKSearch(k);
  Flags::Ptr flags(new Flags);
  estimation.compute(*flags);
  return flags;
}

Flags::Ptr
flagsWhere(const Cloud& cloud, const std::function<bool(const pcl::PointXYZ&)>& is_boundary)
{
  Flags::Ptr flags(new Flags);
  for (const pcl::PointXYZ& p : cloud) {
    flags->emplace_back();
    flags->back().boundary_point = is_boundary(p) ? 1 : 0;
  }
  return flags;
}

TEST(BoundaryLoops, BoundaryPointsFromEstimations)
{
  const SurfacePtr surface = surfaceOf(shapes()[4]); // two holes
  const Sampled sampled = sampleUniform(*surface, 8000, 2);
  const Cloud::Ptr cloud = toCloud(sampled.points);
  const Loops own = loopsOf(cloud);
  ASSERT_EQ(own.loops.size(), 3u);
  const Flags::Ptr by_gap = flagsOf<pcl::BoundaryEstimation<pcl::PointXYZ, pcl::Normal, pcl::Boundary>>(cloud, sampled.normals, 30);
  const Flags::Ptr combined = flagsOf<CentroidBoundaryEstimation<pcl::PointXYZ, pcl::Normal>>(cloud, sampled.normals, 32);
  BoundaryLoops<pcl::PointXYZ> boundary;
  boundary.setInputCloud(cloud);
  std::vector<BoundaryLoop> loops;
  for (const Flags::Ptr& flags : {by_gap, combined}) {
    boundary.setBoundaryPoints(flags);
    boundary.compute(loops);
    ASSERT_TRUE(boundary.getStatus().ok()) << boundary.getStatus().message();
    ASSERT_EQ(loops.size(), own.loops.size());
    for (std::size_t i = 0; i < loops.size(); ++i)
      EXPECT_EQ(loops[i].curve, own.loops[i].curve);
    EXPECT_EQ(boundary.getReport().unmarked_loops, 0u);
  }
  // If a user removes the marks round the smaller hole, at (25, 5), the hole is closed.
  Flags::Ptr fewer(new Flags(*combined));
  for (std::size_t i = 0; i < cloud->size(); ++i)
    if (std::hypot((*cloud)[i].x - 25.0f, (*cloud)[i].y - 5.0f) < 14.0f)
      (*fewer)[i].boundary_point = 0;
  boundary.setBoundaryPoints(fewer);
  boundary.compute(loops);
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[1].curve, own.loops[1].curve);
  EXPECT_EQ(boundary.getReport().unmarked_loops, 1u);
  // Without the marks of the rim there is no outer loop.
  boundary.setBoundaryPoints(flagsWhere(*cloud, [](const auto& p) { return std::hypot(p.x + 20.0f, p.y) < 14.0f; }));
  boundary.compute(loops);
  EXPECT_TRUE(loops.empty());
  EXPECT_NE(boundary.getStatus().message().find("outer boundary"), std::string::npos);
}

TEST(BoundaryLoops, RefusesFlagsThatDoNotFit)
{
  const SurfacePtr surface = flat(Region({rectangle(100, 100)}));
  const Cloud::Ptr cloud = toCloud(sampleUniform(*surface, 3000, 10).points);
  BoundaryLoops<pcl::PointXYZ> boundary;
  boundary.setInputCloud(cloud);
  std::vector<BoundaryLoop> loops(1);
  boundary.setBoundaryPoints(pcl::make_shared<Flags>(2999, 1));
  boundary.compute(loops);
  EXPECT_TRUE(loops.empty());
  EXPECT_EQ(boundary.getStatus().code(), StatusCode::InvalidInput);
  for (const char* word : {"2999", "3000", "setBoundaryPoints with one a point"})
    EXPECT_NE(boundary.getStatus().message().find(word), std::string::npos) << boundary.getStatus().message();
  boundary.setBoundaryPoints(flagsWhere(*cloud, [](const auto&) { return false; }));
  boundary.compute(loops);
  EXPECT_NE(boundary.getStatus().message().find("no point is marked"), std::string::npos);
  boundary.setBoundaryPoints(nullptr);
  boundary.compute(loops);
  EXPECT_EQ(loops.size(), 1u);
  boundary.setMaxTurn(0.0);
  boundary.compute(loops);
  EXPECT_EQ(boundary.getStatus().code(), StatusCode::InvalidArgument);
}

/** Whether \p loop visits \p expected, a closed run, in order: from any start point, in the same sense. */
bool
isRotationOf(const pcl::Indices& loop, const pcl::Indices& expected)
{
  const auto first = std::find(expected.begin(), expected.end(), loop.front());
  pcl::Indices turned(first, expected.end());
  turned.insert(turned.end(), expected.begin(), first);
  return loop == turned;
}

TEST(BoundaryLoops, WalkVisitsRingsInOrder)
{
  // A washer: rings of points on two circles round a sunflower pattern, in a shuffled cloud; the order of the rings is known.
  Random random(21);
  constexpr int outer = 300, inner = 90;
  std::vector<Vector3d> points;
  for (const auto& [radius, count] : {std::pair(50.0, outer), std::pair(15.0, inner)})
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * M_PI * (i + 0.2 * random.uniform(-1, 1)) / count;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    }
  for (int i = 0; i < 8000; ++i) {
    const double r = 49.2 * std::sqrt((i + 0.5) / 8000.0), angle = 2.399963229728653 * i;
    if (r > 15.8)
      points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
  }
  const std::vector<std::size_t> order = shuffled(points.size(), 22);
  Cloud::Ptr cloud(new Cloud(static_cast<unsigned>(points.size()), 1));
  std::vector<std::uint32_t> place(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    (*cloud)[i].getVector3fMap() = points[order[i]].cast<float>();
    place[order[i]] = static_cast<std::uint32_t>(i);
  }
  const pcl::Indices rim(place.begin(), place.begin() + outer);
  const pcl::Indices hole(place.rend() - outer - inner, place.rend() - outer); // clockwise: the surface is on the left
  Flags::Ptr flags(new Flags(static_cast<unsigned>(cloud->size()), 1));
  for (Flags::iterator flag = flags->begin(); flag != flags->end(); ++flag)
    flag->boundary_point = order[static_cast<std::size_t>(flag - flags->begin())] < outer + inner;

  BoundaryLoops<pcl::PointXYZ> boundary;
  boundary.setInputCloud(cloud);
  boundary.setLoopMethod(LoopMethod::Walk);
  for (const bool given : {true, false}) {
    boundary.setBoundaryPoints(given ? flags : nullptr);
    std::vector<BoundaryLoop> loops;
    boundary.compute(loops);
    ASSERT_TRUE(boundary.getStatus().ok()) << boundary.getStatus().message();
    ASSERT_EQ(loops.size(), 2u);
    EXPECT_TRUE(isRotationOf(loops[0].indices, rim));
    EXPECT_TRUE(isRotationOf(loops[1].indices, hole));
    EXPECT_NEAR(loops[0].length, 100.0 * M_PI, 2.0); // the outline may be a third of a spacing off
  }
}

TEST(BoundaryLoops, WalkStopsAtCornersBeyondItsTurn)
{
  Cloud::Ptr cloud(new Cloud);
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 40; ++j)
      cloud->emplace_back(static_cast<float>(i), static_cast<float>(j), 0.0f);
  BoundaryLoops<pcl::PointXYZ> boundary;
  boundary.setInputCloud(cloud);
  boundary.setBoundaryPoints(flagsWhere(*cloud, [](const auto& p) { return p.x == 0.0f || p.x == 60.0f || p.y == 0.0f || p.y == 40.0f; }));
  boundary.setLoopMethod(LoopMethod::Walk);
  boundary.setMaxTurn(95.0);
  std::vector<BoundaryLoop> loops;
  boundary.compute(loops);
  ASSERT_TRUE(boundary.getStatus().ok()) << boundary.getStatus().message();
  ASSERT_EQ(loops.size(), 1u);
  ASSERT_EQ(loops[0].points.size(), 200u);
  for (std::size_t i = 0; i < 200; ++i)
    EXPECT_EQ((loops[0].points[i] - loops[0].points[(i + 1) % 200]).norm(), 1.0);
  boundary.setMaxTurn(20.0);
  boundary.compute(loops);
  EXPECT_TRUE(loops.empty());
  for (const char* word : {"the walk along the boundary ends at", "20 degrees", "link half-edges"})
    EXPECT_NE(boundary.getStatus().message().find(word), std::string::npos) << boundary.getStatus().message();
}

TEST(BoundaryLoops, RefusesWithAReason)
{
  Random random(11);
  std::vector<Vector3d> sphere, sheets;
  for (int i = 0; i < 8000; ++i)
    sphere.push_back(50.0 * Vector3d(random.normal(), random.normal(), random.normal()).normalized());
  for (int i = 0; i < 8000; ++i)
    sheets.emplace_back(random.uniform(0, 100), random.uniform(0, 100), i % 2 ? 0.0 : 40.0);
  const Loops closed = loopsOf(toCloud(sphere)), parts = loopsOf(toCloud(sheets));
  EXPECT_FALSE(closed.status.ok());
  EXPECT_NE(closed.status.message().find("closed"), std::string::npos);
  EXPECT_TRUE(closed.loops.empty());
  EXPECT_FALSE(parts.status.ok());
  EXPECT_NE(parts.status.message().find("2 separate parts"), std::string::npos) << parts.status.message();
  EXPECT_FALSE(loopsOf(Cloud::Ptr(new Cloud)).status.ok());
  std::vector<Vector3d> line;
  for (int i = 0; i < 500; ++i)
    line.emplace_back(0.1 * i, 0.0, 0.0);
  EXPECT_FALSE(loopsOf(toCloud(line)).status.ok());
}

TEST(BoundaryLoops, SaysHowFarSeparatePartsAreApart)
{
  std::vector<Vector3d> plates; // with a stripe of 7 mm without points
  for (int x = -40; x <= 47; ++x)
    for (int y = -30; y <= 30; ++y)
      if (x <= 0 || x >= 7)
        plates.emplace_back(x, y, 0.0);
  const Loops parts = loopsOf(toCloud(plates));
  EXPECT_FALSE(parts.status.ok());
  EXPECT_NE(parts.status.message().find("the largest is 7 mm from the next one, at (3.5, "), std::string::npos) << parts.status.message();
  for (int x = 1; x < 7; ++x) // what is between them is scanned, too
    for (int y = -30; y <= 30; ++y)
      plates.emplace_back(x, y, 0.0);
  EXPECT_EQ(loopsOf(toCloud(plates)).loops.size(), 1U);
}

TEST(BoundaryLoops, RefusesARimOfFarSparserPoints)
{
  // Rings of a hundred points, each larger than the one before: the spacing grows with the radius.
  const auto graded = [](double growth) {
    Random random(12);
    std::vector<Vector3d> points;
    for (double r = 1.0; r < 2e5; r *= growth)
      for (int i = 0; i < 100; ++i) {
        const double angle = 2.0 * M_PI * (i + 0.4 * random.uniform(-1.0, 1.0)) / 100.0;
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
      }
    return toCloud(points);
  };
  const auto cloud = graded(1.06);
  const Loops result = loopsOf(cloud);
  EXPECT_EQ(result.status.code(), StatusCode::InvalidInput);
  for (const char* words : {"are isolated", "is disconnected", "setThinning"})
    EXPECT_NE(result.status.message().find(words), std::string::npos) << result.status.message();
  EXPECT_TRUE(result.loops.empty());
  // The same for a graph without points left out.
  std::vector<Eigen::Vector3f> points;
  for (const auto& p : *cloud)
    points.push_back(p.getVector3fMap());
  SurfaceGraph graph;
  ASSERT_TRUE(graph.build(points, {}).ok());
  std::vector<BoundaryLoop> loops;
  const Status raw = findBoundaryLoops(graph, BoundaryOptions(), loops);
  EXPECT_EQ(raw.code(), StatusCode::InvalidInput);
  for (const char* words : {"boundary at (", "mm apart", "times as far as", "setThinning"})
    EXPECT_NE(raw.message().find(words), std::string::npos) << raw.message();
}

} // namespace

} // namespace boundary_loops_test
