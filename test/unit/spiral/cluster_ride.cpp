// SPDX-License-Identifier: BSD-3-Clause
// Paths over a dome on which things stand: the ball rides over them and never cuts into them, by brute force over their points, and cuts
// everything else.
#include "support/ball_turns.h"

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/verify/material_removal.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

namespace cluster_ride_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;

constexpr double sphere = 100.0, rim = 30.0, ball = 6.0, scallop = 0.05; // mm

/** At \p height over the dome, whose top is the origin. */
Vector3d
onDome(double x, double y, double height = 0.0)
{
  const Vector3d p(x, y, std::sqrt(sphere * sphere - x * x - y * y));
  return p * (sphere + height) / sphere - Vector3d(0.0, 0.0, sphere);
}

Vector3d
up(const Vector3d& place)
{
  return (place + Vector3d(0.0, 0.0, sphere)).normalized();
}

/** Points all at one height. */
struct Thing {
  int side; ///< points along each side
  double height, x, y;
  double apart = 1.0; ///< these points; those of the dome are 1 apart
};

struct Scene {
  Cloud::Ptr cloud = std::make_shared<Cloud>();
  std::vector<Vector3d> standing;
  std::vector<Thing> things;
};

/** \p hides: no point of the dome is seen under the things. */
Scene
sceneOf(const std::vector<Thing>& things, double noise, bool hides, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::normal_distribution<double> normal(0.0, 1.0);
  Scene scene;
  scene.things = things;
  const auto add = [&](const Vector3d& p) { scene.cloud->push_back({float(p.x()), float(p.y()), float(p.z())}); };
  const auto isHidden = [&](double x, double y) {
    return hides && std::any_of(things.begin(), things.end(),
                                [&](const Thing& t) { return std::max(std::abs(x - t.x), std::abs(y - t.y)) < 0.5 * t.side; });
  };
  for (double i = -rim; i <= rim; ++i)
    for (double j = -rim; j <= rim; ++j) {
      const double x = i + jitter(random), y = j + jitter(random);
      if (x * x + y * y < rim * rim && !isHidden(x, y))
        add(onDome(x, y, noise * normal(random)));
    }
  for (const Thing& t : things)
    for (int i = 0; i < t.side * t.side; ++i) {
      const double x = t.x + t.apart * (i % t.side - 0.5 * (t.side - 1)), y = t.y + t.apart * (i / t.side - 0.5 * (t.side - 1));
      add(onDome(x + 0.5 * jitter(random), y + 0.5 * jitter(random), t.height));
      scene.standing.push_back(scene.cloud->back().getVector3fMap().cast<double>());
    }
  return scene;
}

struct Made {
  Path::Ptr path = std::make_shared<Path>();
  SpiralReport report;
  Status status;
};

Made
pathOver(const Scene& scene, SpiralMethod method, ClusterHandling clusters, TightHandling tight = TightHandling::Ride,
         unsigned int threads = 2)
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(scene.cloud);
  spiral.setClusterHandling(clusters);
  spiral.setTightHandling(tight);
  spiral.setMethod(method);
  spiral.setToolRadius(ball);
  spiral.setScallopHeight(scallop);
  spiral.setNumberOfThreads(threads);
  spiral.setQuiet(true);
  Made made;
  spiral.compute(*made.path);
  made.report = spiral.getReport();
  made.status = spiral.getStatus();
  return made;
}

/** Places of the ball's centre, close together; not on lifts of the tool. */
std::vector<Vector3d>
wayOf(const Path& path, double step)
{
  std::vector<Vector3d> way;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vector3d begin = test::ballCentre(path[i], ball), end = test::ballCentre(path[i + 1], ball);
    const bool cuts = path[i + 1].arc_length > path[i].arc_length;
    const int pieces = cuts ? std::max(1, static_cast<int>(std::ceil((end - begin).norm() / step))) : 1;
    for (int k = 0; k < pieces; ++k)
      way.push_back(begin + (end - begin) * k / pieces);
  }
  way.push_back(test::ballCentre(path.back(), ball));
  return way;
}

double
nearest(const std::vector<Vector3d>& places, const Vector3d& p)
{
  double least = 1e300;
  for (const Vector3d& place : places)
    least = std::min(least, (place - p).squaredNorm());
  return std::sqrt(least);
}

/** How far a ball over \p foot must be lifted along the normal to stay \p room away from all points. */
double
liftOver(const std::vector<Vector3d>& standing, const Vector3d& foot, double room = 0.0)
{
  const Vector3d n = up(foot);
  double lift = 0.0;
  for (const Vector3d& p : standing) {
    const double along = (p - foot).dot(n), across = (p - foot - along * n).norm();
    if (const double reach = ball + room; across < reach)
      lift = std::max(lift, along + std::sqrt(reach * reach - across * across) - ball);
  }
  return lift;
}

double
deepest(const std::vector<Vector3d>& standing, const Path& path)
{
  const std::vector<Vector3d> way = wayOf(path, 0.05);
  double depth = 0.0;
  for (const Vector3d& p : standing)
    depth = std::max(depth, ball - nearest(way, p));
  return depth;
}

/** The posts under the points are closed, too: what is seen from above stands on something. */
double
deepestInPosts(const std::vector<Vector3d>& standing, const Path& path)
{
  std::vector<Vector3d> posts;
  for (const Vector3d& top : standing) {
    const double height = (top + Vector3d(0.0, 0.0, sphere)).norm() - sphere;
    for (double down = 0.3; down < height - 0.2; down += 0.3)
      posts.push_back(top - down * up(top));
  }
  return posts.empty() ? 0.0 : deepest(posts, path);
}

/** Every place of the dome is cut, and not cut into, where neither the ball over it nor one a step-over beside it is lifted. */
void
expectAllElseCut(const Scene& scene, const Path& path, double noise)
{
  constexpr double step_over = 1.55, rim_band = 3.0;
  const std::vector<Vector3d> way = wayOf(path, 0.3);
  int counted = 0;
  double most = 0.0;
  for (double x = -rim; x <= rim; x += 1.3)
    for (double y = -rim; y <= rim; y += 1.3) {
      if (std::hypot(x, y) > rim - rim_band)
        continue;
      const Vector3d q = onDome(x, y);
      bool lifted = liftOver(scene.standing, q) > 0.0;
      for (int k = 0; k < 12 && !lifted; ++k)
        lifted = liftOver(scene.standing,
                          onDome(x + 1.2 * step_over * std::cos(k * M_PI / 6.0), y + 1.2 * step_over * std::sin(k * M_PI / 6.0))) > 0.0;
      if (lifted)
        continue;
      ++counted;
      const double left = nearest(way, q) - ball;
      most = std::max(most, left);
      EXPECT_LT(left, 1.1 * scallop + 2.0 * noise + 0.01) << "not cut: " << q.transpose();
      EXPECT_GT(left, -0.02 - 3.0 * noise) << "gouged: " << q.transpose();
    }
  EXPECT_GT(counted, 300);
  std::printf("  %d places elsewhere, up to %.4f mm left\n", counted, most);
}

class ClusterRide : public ::testing::TestWithParam<SpiralMethod> {};

TEST_P(ClusterRide, NeverCutsIntoAThingAndCutsAllElse)
{
  const std::vector<Thing> low{{3, 0.6, -14.0, 6.0}, {3, 5.4, 6.0, -4.0}, {4, 2.0, 4.0, 17.0}};
  const std::vector<Thing> high{{3, 10.0, 1.0, 2.0}, {2, 16.0, -15.0, -9.0}};
  unsigned int seed = 0;
  for (const auto& things : {low, high})
    for (const double noise : {0.0, 0.01}) {
      const Scene scene = sceneOf(things, noise, false, ++seed);
      SCOPED_TRACE(std::to_string(things.front().height) + " mm high, noise " + std::to_string(noise));
      const Made made = pathOver(scene, GetParam(), ClusterHandling::Ride);
      ASSERT_TRUE(made.status.ok()) << made.status.message();
      const double depth = deepest(scene.standing, *made.path);
      double lift = 0.0;
      for (const ToolpathPoint& point : *made.path)
        lift = std::max<double>(lift, point.lift);
      std::printf("  deepest in a point %.5f, in a post %.4f, lift up to %.3f, %zu places, %.1f mm lifted\n", depth,
                  deepestInPosts(scene.standing, *made.path), lift, made.report.tight_places.size(), made.report.lifted_length);
      EXPECT_LE(depth, 1e-4);
      EXPECT_EQ(test::ballTurns(*made.path, ball), 0U);
      EXPECT_LT(deepestInPosts(scene.standing, *made.path), 0.02 * ball);
      expectAllElseCut(scene, *made.path, noise);
    }
}

/** A post seen from above, from \p low to \p high: its top alone is seen. It hides the dome. */
struct Post {
  Vector3d low, high;
  double half;
  bool covers(const Vector3d& p) const { return std::max(std::abs(p.x() - low.x()), std::abs(p.y() - low.y())) < half; }
};

/** Of the normal, which leans by 13 degrees there, \p post knows nothing. */
Post
postOn(double height)
{
  const Vector3d foot = onDome(-18.0, 14.0);
  return {foot - Vector3d(0.0, 0.0, 2.0), foot + Vector3d(0.0, 0.0, height), 3.0};
}

Scene
sceneOf(const Post& post)
{
  Scene scene;
  const Scene bare = sceneOf({}, 0.0, false, 3);
  for (const pcl::PointXYZ& p : *bare.cloud)
    if (!post.covers(p.getVector3fMap().cast<double>()))
      scene.cloud->push_back(p);
  for (double x = -post.half; x <= post.half; ++x)
    for (double y = -post.half; y <= post.half; ++y)
      scene.cloud->push_back({float(post.low.x() + x), float(post.low.y() + y), float(post.high.z())});
  return scene;
}

TEST_P(ClusterRide, HighThingsWhoseSidesAreNotSeenAreRefused)
{
  for (const double height : {9.0, 16.0}) {
    const Status status = pathOver(sceneOf(postOn(height)), GetParam(), ClusterHandling::Ride).status;
    EXPECT_EQ(status.code(), StatusCode::InvalidInput) << height;
    EXPECT_NE(status.message().find("only its top is seen"), std::string::npos) << status.message();
  }
}

TEST_P(ClusterRide, ReportsWhatStays)
{
  const Scene scene = sceneOf({{3, 5.4, 6.0, -4.0}, {4, 2.0, -13.0, 9.0}}, 0.0, false, 5);
  const Made made = pathOver(scene, GetParam(), ClusterHandling::Ride);
  ASSERT_TRUE(made.status.ok()) << made.status.message();
  double highest = 0.0;
  for (const ToolpathPoint& point : *made.path)
    highest = std::max<double>(highest, point.lift);
  constexpr double room = 0.5; // half a point spacing
  EXPECT_NEAR(highest, 5.4 + room, 0.1) << "a turn runs over the thing";
  EXPECT_NEAR(made.report.largest_lift, highest, 1e-4);
  ASSERT_EQ(made.report.tight_places.size(), scene.things.size());
  EXPECT_EQ(made.report.fitting_radius, ball) << "the dome itself has no hollow";
  for (std::size_t k = 0; k < scene.things.size(); ++k) {
    const Thing& thing = scene.things[k];
    const TightPlace& place = made.report.tight_places[k];
    double area = 0.0;
    constexpr double cell = 0.1;
    const Scene alone = sceneOf({thing}, 0.0, false, 5);
    for (double x = thing.x - 10.0; x < thing.x + 10.0; x += cell)
      for (double y = thing.y - 10.0; y < thing.y + 10.0; y += cell)
        if (liftOver(alone.standing, onDome(x, y), room) > scallop)
          area += cell * cell / up(onDome(x, y)).z();
    std::printf("  %.3f of %.3f mm high, %.1f of %.1f mm2\n", place.height, thing.height, place.area, area);
    EXPECT_TRUE(place.under_cluster);
    EXPECT_NEAR(place.height, thing.height + room, 0.1);
    EXPECT_NEAR(place.area, area, 0.1 * area);
    EXPECT_LT((place.place - onDome(thing.x, thing.y)).norm(), thing.side);
  }
  const auto& warnings = made.report.warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const pcl_spiral::Diagnostic& text) {
    return text.text().find("the ball rides over clusters of points at 2 places: it stays above the surface there and leaves up to 5.9") ==
           0;
  }));
}

TEST_P(ClusterRide, EdgesBesideTheLastPointsAreNotCut)
{
  for (const double apart : {1.0, 1.6}) { // a thing of which fewer points are seen than of the dome
    const Scene scene = sceneOf({{3, 5.4, 6.0, -4.0, apart}, {4, 2.0, -13.0, 9.0, apart}}, 0.0, false, 5);
    std::vector<Vector3d> edges;
    for (const Vector3d& p : scene.standing)
      for (const double x : {-0.3, 0.3})
        for (const double y : {-0.3, 0.3})
          edges.emplace_back(p.x() + apart * x, p.y() + apart * y, p.z());
    const Made made = pathOver(scene, GetParam(), ClusterHandling::Ride);
    ASSERT_TRUE(made.status.ok()) << made.status.message();
    EXPECT_LT(deepest(edges, *made.path), 0.01) << apart;
  }
}

TEST_P(ClusterRide, AThingLeftOutIsCutAway)
{
  const Scene scene = sceneOf({{3, 5.4, 6.0, -4.0}}, 0.01, false, 7);
  const Made made = pathOver(scene, GetParam(), ClusterHandling::LeaveOut);
  ASSERT_TRUE(made.status.ok()) << made.status.message();
  EXPECT_GT(deepest(scene.standing, *made.path), 4.0);
  EXPECT_FALSE(pathOver(scene, GetParam(), ClusterHandling::Refuse).status.ok());
}

TEST_P(ClusterRide, IsJudgedByWhatItMustRideOver)
{
  const Scene scene = sceneOf({{3, 5.4, 6.0, -4.0}, {4, 2.0, -13.0, 9.0}}, 0.005, false, 9);
  const Made made = pathOver(scene, GetParam(), ClusterHandling::Ride);
  ASSERT_TRUE(made.status.ok()) << made.status.message();
  MaterialRemoval<pcl::PointXYZ> removal;
  removal.setInputCloud(scene.cloud);
  removal.setClusterHandling(ClusterHandling::Ride);
  removal.setInputToolpath(made.path);
  removal.setToolRadius(ball);
  removal.setScallopHeight(scallop);
  pcl::PointCloud<pcl::PointXYZI> stock;
  removal.compute(stock);
  ASSERT_TRUE(removal.getStatus().ok()) << removal.getStatus().message();
  const RemovalReport& r = removal.getReport();
  std::printf("  gouge %.4f, scallop p99 %.4f max %.4f, uncut %zu, under things %zu up to %.3f\n", r.gouge.value, r.scallop.p99,
              r.scallop.max.value, r.stock.uncut + r.rim.uncut, r.unreached.samples, r.unreached.max.value);
  EXPECT_LT(r.gouge.value, 0.02);
  EXPECT_LT(r.scallop.p99, 1.1 * scallop);
  EXPECT_LT(r.scallop.max.value, 1.6 * scallop);
  EXPECT_EQ(r.stock.uncut + r.rim.uncut, 0U);
  EXPECT_GT(r.unreached.samples, 100U);
  EXPECT_TRUE(std::any_of(r.warnings.begin(), r.warnings.end(), [](const pcl_spiral::Diagnostic& text) {
    return text.text().find("2 clusters of points stand off the surface: ") == 0 &&
           text.text().find("the ball must ride over") != std::string::npos;
  }));
}

INSTANTIATE_TEST_SUITE_P(Methods, ClusterRide, ::testing::Values(SpiralMethod::Radial, SpiralMethod::ConstantScallop));

TEST(ClusterRideOf, SettingsThatDoNotLiftAreRefused)
{
  const Scene scene = sceneOf({{3, 5.4, 6.0, -4.0}}, 0.01, false, 7);
  const Made tight = pathOver(scene, SpiralMethod::Radial, ClusterHandling::Ride, TightHandling::Refuse);
  EXPECT_EQ(tight.status.code(), StatusCode::InvalidArgument);
  EXPECT_NE(tight.status.message().find("setTightHandling"), std::string::npos) << tight.status.message();
  const Made published = pathOver(scene, SpiralMethod::Published, ClusterHandling::Ride);
  EXPECT_EQ(published.status.code(), StatusCode::InvalidArgument);
  EXPECT_NE(published.status.message().find("setMethod"), std::string::npos) << published.status.message();
}

TEST(ClusterRideOf, TheSameForAnyNumberOfThreads)
{
  const Scene scene = sceneOf({{3, 5.4, 6.0, -4.0}, {2, 16.0, -15.0, -9.0}}, 0.01, false, 3);
  const Made one = pathOver(scene, SpiralMethod::Radial, ClusterHandling::Ride, TightHandling::Ride, 1);
  const Made two = pathOver(scene, SpiralMethod::Radial, ClusterHandling::Ride, TightHandling::Ride, 2);
  ASSERT_EQ(one.path->size(), two.path->size());
  for (std::size_t i = 0; i < one.path->size(); ++i) {
    ASSERT_EQ((*one.path)[i].getVector3fMap(), (*two.path)[i].getVector3fMap()) << i;
    ASSERT_EQ((*one.path)[i].lift, (*two.path)[i].lift) << i;
  }
}

} // namespace

} // namespace cluster_ride_test
