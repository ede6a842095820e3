// SPDX-License-Identifier: BSD-3-Clause
// The largest ball that reaches a place, and where a larger one rests, against parts in closed form.
#include "surface/empty_spheres.h"

#include "support/tight_parts.h"

#include <pcl_spiral/surface/impl/ball_reach.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <omp.h>
#include <random>

namespace ball_reach_test {

namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

Surface::ConstPtr
surfaceOf(const pcl::PointCloud<pcl::PointXYZ>::Ptr& cloud)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  EXPECT_TRUE(scanned.getStatus().ok()) << scanned.getStatus().message();
  return surface;
}

BallReach
reachOf(const Surface& surface, double radius)
{
  return BallReach(surface.graph(), surface.fit(), radius, reachTolerance(surface.fit(), 0.0005));
}

/** The deepest that balls over the unreached points, and their places, are in the true surface. */
double
deepest(const TightPart& part, const BallReach& reach)
{
  double depth = 0.0;
  for (const UnreachedPoint& point : reach.unreached()) {
    if (part.half_width > 0.0 && std::abs(reach.position(point.index).y()) > part.half_width - 1.0)
      continue; // it may slide over the end of the part
    const Vector3d centre = reach.centre(reach.position(point.index), reach.normal(point.index));
    if (!centre.allFinite())
      return reach.radius();
    depth = std::max(depth, reach.radius() - part.distance(centre));
  }
  return depth;
}

TEST(BallReach, RestsInAValley)
{
  for (const double noise : {0.0, 0.01})
    for (const double slope : {0.4, 0.7, 1.2}) {
      const double fillet = 3.0, ball = 6.0, half_width = 5.0;
      const TightPart part = valley(slope, fillet, 20.0 * std::cos(slope) + 4.0, half_width);
      const auto surface = surfaceOf(part.scan(0.4, noise, 3));
      const BallReach reach = reachOf(*surface, ball);
      const double error = 0.01 + 3.0 * noise;
      double area = 0.0, off = 0.0, least = ball, sideways = 0.0;
      const auto heights = reach.heightsLeft();
      float highest = 0.0f;
      for (std::size_t k = 0; k < reach.unreached().size(); ++k) {
        const UnreachedPoint& point = reach.unreached()[k];
        const Vector3d foot = reach.position(point.index), centre = reach.centre(foot, reach.normal(point.index));
        least = std::min<double>(least, point.reach);
        if (std::abs(foot.y()) > half_width - 2.0)
          continue;
        area += point.area;
        highest = std::max(highest, heights[k]);
        off = std::max(off, std::abs(centre.z() - valleyCentre(slope, fillet, ball)));
        sideways = std::max(sideways, std::abs(centre.x()));
        // Height in closed form: distance of the foot from the resting ball.
        const double left = std::hypot(foot.x(), foot.z() - valleyCentre(slope, fillet, ball)) - ball;
        EXPECT_NEAR(heights[k], left, 3.0 * error) << foot.transpose();
      }
      const double unreached = 2.0 * (fillet * slope + (ball - fillet) * std::tan(slope)) * (2.0 * half_width - 4.0);
      std::printf("  noise %g, slope %g: centre off by %.4f, area %.1f of %.1f, smallest ball %.3f, highest %.4f\n", noise, slope, off,
                  area, unreached, least, highest);
      EXPECT_LT(sideways, 0.1);
      EXPECT_LT(off, 3.0 * error / std::cos(slope));
      EXPECT_NEAR(highest, (ball - fillet) * (1.0 / std::cos(slope) - 1.0), 3.0 * error);
      EXPECT_NEAR(area, unreached, 0.15 * unreached);
      EXPECT_LT(least, 1.02 * fillet);
      EXPECT_GT(least, 0.87 * fillet); // the fits round the ends of the fillet: never too large a ball is named
      EXPECT_LT(deepest(part, reach), reach.tolerance() + error);
    }
}

TEST(BallReach, PassesThroughNoVoidBetweenThePoints)
{
  const double slope = 0.7, ball = 1.0, clear = 1.1;
  const TightPart part = valley(slope, 0.9, 14.0, 8.0);
  for (unsigned int seed = 1; seed <= 3; ++seed) {
    auto cloud = part.scan(0.4, 0.0, seed);
    const auto isInVoid = [&](const pcl::PointXYZ& p) { return std::hypot(p.x, p.y) < clear; };
    cloud->points.erase(std::remove_if(cloud->points.begin(), cloud->points.end(), isInVoid), cloud->points.end());
    cloud->width = static_cast<std::uint32_t>(cloud->points.size());
    const auto surface = surfaceOf(cloud);
    const BallReach reach = reachOf(*surface, ball);
    std::vector<Vector3d> places;
    for (double x = -0.6; x <= 0.6; x += 0.1)
      for (double y = -0.6; y <= 0.6; y += 0.1)
        places.emplace_back(x, y, 0.3 * x * x);
    std::vector<SurfaceFoot> feet;
    surface->fit().project(places, feet, 4);
    double nearest = 1e9;
    std::size_t valid = 0;
    for (const SurfaceFoot& foot : feet) {
      if (!foot.valid)
        continue;
      ++valid;
      const Vector3d centre = reach.centre(foot.position, foot.normal);
      ASSERT_TRUE(centre.allFinite());
      for (const SurfaceFoot& other : feet)
        if (other.valid)
          nearest = std::min(nearest, (centre - other.position).norm());
    }
    EXPECT_GT(valid, 100U);
    EXPECT_GT(nearest, ball - reach.tolerance() - 0.05);
    EXPECT_LT(nearest, ball + 0.05);
  }
}

TEST(BallReach, RestsOnTheRimOfAPit)
{
  const double pit = 4.0, rim = 1.5;
  const TightPart part = pittedPlane(pit, rim, 25.0);
  const auto surface = surfaceOf(part.scan(0.3, 0.0, 5));
  EXPECT_TRUE(reachOf(*surface, 3.2).unreached().empty());
  for (const double ball : {5.0, 8.0}) {
    const BallReach reach = reachOf(*surface, ball);
    ASSERT_GT(reach.unreached().size(), 100U);
    double off = 0.0, sideways = 0.0;
    for (const UnreachedPoint& point : reach.unreached()) {
      const Vector3d foot = reach.position(point.index), centre = reach.centre(foot, reach.normal(point.index));
      if (std::hypot(foot.x(), foot.y()) > 0.8 * pit)
        continue;
      off = std::max(off, std::abs(centre.z() - pitCentre(pit, rim, ball)));
      sideways = std::max(sideways, std::hypot(centre.x(), centre.y()));
      EXPECT_NEAR(point.reach, pit, 0.07 * pit);
    }
    std::printf("  ball %g: centre off by %.4f, %.4f sideways\n", ball, off, sideways);
    EXPECT_LT(off, 0.03);
    EXPECT_LT(sideways, 0.03);
    EXPECT_LT(deepest(part, reach), reach.tolerance() + 0.01);
  }
}

TEST(BallReach, FindsGroovesNarrowerThanAFewSpacings)
{
  // The ball meets the sides of such grooves nearer than 2.5 spacings to its foot, and nothing farther away.
  const double height = 1.6, length = 8.0, spacing = 1.7;
  const auto ripples = [&](double x) { return std::abs(x) < 1.5 * length ? -height * std::cos(2.0 * M_PI * x / length) : height; };
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> off(-0.35 * spacing, 0.35 * spacing);
  for (double x = -30.0; x < 30.0; x += spacing)
    for (double y = -12.0; y < 12.0; y += spacing) {
      const double at = x + off(random);
      cloud->push_back({static_cast<float>(at), static_cast<float>(y + off(random)), static_cast<float>(ripples(at))});
    }
  const auto surface = surfaceOf(cloud);
  for (const double ball : {4.0, 6.0}) {
    const BallReach reach = reachOf(*surface, ball);
    double depth = 0.0, unknown = 0.0;
    for (std::size_t i = 0; i < reach.size(); ++i) {
      const Vector3d foot = reach.position(i);
      if (std::abs(foot.y()) > 6.0 || std::abs(foot.x()) > 20.0)
        continue;
      const bool tight = reach.isNearUnreached(foot, 6.0 * spacing);
      const Vector3d centre = tight ? reach.centre(foot, reach.normal(i)) : Vector3d(foot + ball * reach.normal(i));
      for (double x = centre.x() - ball; x < centre.x() + ball; x += 0.01)
        depth = std::max(depth, ball - std::hypot(x - centre.x(), ripples(x) - centre.z()));
      unknown = std::max(unknown, std::abs(foot.z() - ripples(foot.x())));
    }
    std::printf("  ball %g: %zu points not reached, deepest %.3f; the fit is off by up to %.3f, tolerance %.3f\n", ball,
                reach.unreached().size(), depth, unknown, reach.tolerance());
    EXPECT_LT(depth, 1.2 * (reach.tolerance() + unknown));
  }
}

TEST(BallReach, LiesBesideASphereOnAPlane)
{
  const double sphere = 10.0, fillet = 1.0, ball = 4.0;
  const TightPart part = ballOnPlane(sphere, fillet, 24.0);
  const auto surface = surfaceOf(part.scan(0.35, 0.0, 7));
  const BallReach reach = reachOf(*surface, ball);
  ASSERT_GT(reach.unreached().size(), 100U);
  double off = 0.0;
  for (const UnreachedPoint& point : reach.unreached()) {
    const Vector3d foot = reach.position(point.index), centre = reach.centre(foot, reach.normal(point.index));
    off = std::max(off, std::hypot(std::hypot(centre.x(), centre.y()) - besideSphere(sphere, ball), centre.z() - ball));
  }
  std::printf("  centre off by %.4f\n", off);
  EXPECT_LT(off, 0.05);
  EXPECT_LT(deepest(part, reach), reach.tolerance() + 0.01);
}

/** A roof with planes that fall by \p slope, degrees, on either side of x = 0, its edge rounded to a radius \p fillet, scanned at random
 *  places of a lattice. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
roof(double slope, double fillet, double spacing, double noise)
{
  const double angle = slope * M_PI / 180.0;
  const auto height = [&](double x) {
    return std::abs(x) < fillet * std::sin(angle) ? std::sqrt(fillet * fillet - x * x) - fillet / std::cos(angle)
                                                  : -std::abs(x) * std::tan(angle);
  };
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::mt19937 random(5);
  std::uniform_real_distribution<double> shift(-0.3 * spacing, 0.3 * spacing);
  std::normal_distribution<double> error(0.0, 1.0);
  for (double u = -15.0; u < 15.0; u += spacing)
    for (double v = -15.0; v < 15.0; v += spacing) {
      const double x = (u + shift(random)) * std::cos(angle), y = v + shift(random);
      cloud->push_back(pcl::PointXYZ(static_cast<float>(x), static_cast<float>(y), static_cast<float>(height(x) + noise * error(random))));
    }
  return cloud;
}

TEST(BallReach, LooksCloselyWhereverTheBallDoesNotReachAll)
{
  for (const double spacing : {0.3, 0.6})
    for (const double slope : {0.3, 0.7, 1.2})
      for (const double share : {0.9, 0.97, 1.3}) { // fillet over ball
        const double ball = 4.0, fillet = share * ball;
        const auto surface = surfaceOf(valley(slope, fillet, 14.0, 6.0).scan(spacing, 0.0, 3));
        const BallReach reach = reachOf(*surface, ball);
        EXPECT_EQ(reach.unreached().empty(), share > 1.0) << slope << " " << share << " " << spacing;
      }
}

/** What is cut off and not reached is the same whether all points are fitted, as with an obstacle, or only where it may be needed. */
/** \p count points of a bowl of \p radius, up to 70 degrees from its bottom. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
bowl(std::size_t count, double radius)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.399963229728653 * static_cast<double>(i); // the golden angle: even by area
    const double z = -1.0 + 0.658 * (static_cast<double>(i) + 0.5) / static_cast<double>(count), r = std::sqrt(1.0 - z * z);
    cloud->push_back(pcl::PointXYZ(static_cast<float>(radius * r * std::cos(angle)), static_cast<float>(radius * r * std::sin(angle)),
                                   static_cast<float>(radius * z)));
  }
  return cloud;
}

TEST(BallReach, LooksAtFewPointsWhereTheBallSurelyReachesTooFew)
{
  const auto surface = surfaceOf(bowl(20000, 20.0));
  const auto reachOf = [&surface](double radius, double least) {
    return BallReach(surface->graph(), surface->fit(), radius, reachTolerance(surface->fit(), 0.0005), {}, {}, least);
  };
  const BallReach few = reachOf(25.0, 0.5);
  EXPECT_LT(few.looked(), 6000u);
  EXPECT_GT(few.looked(), 4000u);
  EXPECT_EQ(few.unreached().size(), few.looked());
  for (const UnreachedPoint& point : few.unreached())
    ASSERT_NEAR(point.reach, 20.0, 0.6) << point.index;
  for (const BallReach& all : {reachOf(15.0, 0.5), reachOf(25.0, 0.0)})
    EXPECT_EQ(all.looked(), surface->size());
}

/** Points in rows of a power of two: the order of the graph halves them down to the same places of each wave. */
TEST(BallReach, PatternsOfThePointsDoNotMisleadTheFewLookedAt)
{
  constexpr int side = 256, period = 12;
  pcl::PointCloud<pcl::PointXYZ>::Ptr waves(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      waves->push_back(pcl::PointXYZ(0.5f * static_cast<float>(i), 0.5f * static_cast<float>(j),
                                     static_cast<float>(0.3 * std::sin(2.0 * M_PI * i / period))));
  const auto surface = surfaceOf(waves);
  const double tolerance = reachTolerance(surface->fit(), 0.0005);
  const BallReach all(surface->graph(), surface->fit(), 8.0, tolerance);
  const double missed = static_cast<double>(all.unreached().size()) / static_cast<double>(all.size());
  EXPECT_GT(missed, 0.35);
  for (const double least : {0.95 - missed, 1.05 - missed}) {
    const BallReach some(surface->graph(), surface->fit(), 8.0, tolerance, {}, {}, least);
    EXPECT_EQ(some.looked() == some.size(), least < 1.0 - missed) << missed;
    EXPECT_NEAR(static_cast<double>(some.unreached().size()) / static_cast<double>(some.looked()), missed, 0.04);
  }
}

TEST(BallReach, CountsAllPointsCutOffAtTheEdgeOfARoof)
{
  std::size_t most = 0;
  const auto compare = [&most](double slope, double fillet, double noise, double ball) {
    const auto surface = surfaceOf(roof(slope, fillet, 0.5, noise));
    const double tolerance = reachTolerance(surface->fit(), 0.0005);
    const BallReach quick(surface->graph(), surface->fit(), ball, tolerance);
    const BallObstacles far{{Eigen::Vector3f(0.0f, 0.0f, 100.0f)}, 0.1};
    const BallReach all(surface->graph(), surface->fit(), ball, tolerance, far);
    std::printf("  slope %g, fillet %g, noise %g: %zu of %zu, highest %.4f, least %.4f; unreached %zu of %zu\n", slope, fillet, noise,
                quick.missed().count, all.missed().count, all.missed().height, all.missed().least, quick.unreached().size(),
                all.unreached().size());
    if (noise == 0.0)
      EXPECT_EQ(quick.missed().count, all.missed().count);
    EXPECT_GE(all.missed().count, quick.missed().count); // with all heights, edges in noise are found, too
    if (quick.missed().count > 0) {                      // but these are lower
      EXPECT_NEAR(quick.missed().height, all.missed().height, 1e-6);
      EXPECT_EQ(quick.missed().place, all.missed().place);
    }
    most = std::max(most, all.missed().count);
  };
  for (const double noise : {0.0, 0.002, 0.01}) {
    for (const double slope : {4.0, 6.0, 8.0, 12.0, 20.0, 30.0, 45.0})
      compare(slope, 0.0, noise, 0.6);
    for (const double fillet : {0.25, 0.375, 0.5, 1.0, 2.0})
      for (const double slope : {30.0, 45.0, fillet < 1.0 ? 50.0 : 60.0})
        for (const double ball : {0.3, 0.6})
          compare(slope, fillet, noise, ball);
  }
  EXPECT_GT(most, 30u);
}

/** Against every pair of points. */
TEST(BallReach, KnowsWhichSpheresAreEmpty)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> side(-30.0, 30.0), lean(-0.05, 0.05), noise(-0.02, 0.02);
  std::vector<Eigen::Vector3f> places;
  for (int i = 0; i < 3000; ++i) {
    const double x = side(random), y = side(random);
    places.push_back(Vector3d(x, y, 2.0 * std::sin(0.2 * x) * std::cos(0.15 * y) + noise(random)).cast<float>());
  }
  const PointBlocks points(places);
  std::vector<Eigen::Vector3f> normals;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d p = points.position(i);
    normals.push_back(Vector3d(lean(random) - 0.4 * std::cos(0.2 * p.x()) * std::cos(0.15 * p.y()),
                               lean(random) + 0.3 * std::sin(0.2 * p.x()) * std::sin(0.15 * p.y()), 1.0)
                          .normalized()
                          .cast<float>());
  }
  std::uniform_real_distribution<float> asked(0.0f, 0.1f);
  for (const double radius : {3.0, 12.0, 18.0})
    for (const float least : {-0.001f, 0.02f, 0.1f}) {
      std::vector<float> depths;
      for (std::size_t i = 0; i < points.size(); ++i)
        depths.push_back(i % 50 == 0 ? -0.05f * static_cast<float>(radius) : least + asked(random) * static_cast<float>(radius));
      const std::vector<std::uint8_t> empty = emptySpheres(points, normals, radius, depths);
      std::size_t share = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3d centre = points.position(i) + radius * normals[i].cast<double>();
        double deepest = -radius; // over what is asked
        for (std::size_t k = 0; k < points.size(); ++k)
          deepest = std::max(deepest, 0.5 * (radius - (points.position(k) - centre).squaredNorm() / radius) - depths[k]);
        share += empty[i];
        if (empty[i])
          EXPECT_LE(deepest, 1e-5 * radius);
        else
          EXPECT_GE(deepest, -1e-5 * radius);
      }
      EXPECT_GT(share, 0u) << "radius " << radius << ", at least " << least;
      if (least < 0.1f)
        EXPECT_LT(share, points.size()) << "radius " << radius << ", at least " << least;
    }
}

TEST(BallReach, IsTheSameForAnyNumberOfThreads)
{
  const TightPart part = valley(0.7, 3.0, 15.0, 8.0);
  const auto surface = surfaceOf(part.scan(0.4, 0.01, 3));
  std::vector<float> first;
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    const BallReach reach = reachOf(*surface, 6.0);
    std::vector<float> found = reach.heightsLeft();
    for (const UnreachedPoint& point : reach.unreached())
      found.insert(found.end(), {static_cast<float>(point.index), point.reach, point.area});
    if (first.empty())
      first = found;
    EXPECT_EQ(found, first);
  }
}

} // namespace

} // namespace ball_reach_test
