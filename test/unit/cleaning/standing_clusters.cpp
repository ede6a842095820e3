// SPDX-License-Identifier: BSD-3-Clause
// Clusters that stand on a dome are found with their place and height; single echoes go without a word more.
#include "cleaning/standing_clusters.h"

#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>
#include <tuple>

namespace standing_clusters_test {

using namespace pcl_spiral;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double ball = 100.0, rim = 30.0; // mm

Eigen::Vector3d
onDome(double x, double y, double height = 0.0)
{
  const Eigen::Vector3d p(x, y, std::sqrt(ball * ball - x * x - y * y));
  return p * (ball + height) / ball - Eigen::Vector3d(0.0, 0.0, ball);
}

void
add(Cloud& cloud, const Eigen::Vector3d& p)
{
  cloud.push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())));
}

/** A point about every mm, in rows with jitter, with noise. */
Cloud::Ptr
dome(std::uint32_t seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::normal_distribution<double> noise(0.0, 0.01);
  const Cloud::Ptr cloud(new Cloud);
  for (double i = -rim; i <= rim; ++i)
    for (double j = -rim; j <= rim; ++j) {
      const double x = i + jitter(random), y = j + jitter(random);
      if (x * x + y * y < rim * rim)
        add(*cloud, onDome(x, y, noise(random)));
    }
  return cloud;
}

/** What stands on the dome: points a spacing apart, all at one height. */
struct Thing {
  int points;
  double height; ///< over the dome
  double x, y;
  double width() const { return std::sqrt(static_cast<double>(points)); }
};

void
put(Cloud& cloud, const Thing& thing, std::mt19937& random)
{
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  const int side = static_cast<int>(std::ceil(thing.width()));
  for (int i = 0; i < thing.points; ++i)
    add(cloud, onDome(thing.x + i % side - 0.5 * (side - 1) + jitter(random), thing.y + i / side - 0.5 * (side - 1) + jitter(random),
                      thing.height));
}

/** Echoes 0.5 to 10 mm over the dome, none near another or near \p thing. */
void
addEchoes(Cloud& cloud, int count, const Thing& thing, std::mt19937& random)
{
  std::uniform_real_distribution<double> side(-0.65 * rim, 0.65 * rim), height(0.5, 10.0);
  std::vector<Eigen::Vector3d> echoes;
  const auto isApart = [&](const Eigen::Vector3d& echo) {
    return (echo - Eigen::Vector3d(thing.x, thing.y, 0.0)).head<2>().norm() > thing.width() + 4.0;
  };
  while (static_cast<int>(echoes.size()) < count) {
    const Eigen::Vector3d echo = onDome(side(random), side(random), height(random));
    if (isApart(echo) &&
        std::all_of(echoes.begin(), echoes.end(), [&](const Eigen::Vector3d& other) { return (echo - other).norm() > 6.5; }))
      echoes.push_back(echo);
  }
  for (const Eigen::Vector3d& echo : echoes)
    add(cloud, echo);
}

Status
statusOf(const Cloud::ConstPtr& cloud, ClusterHandling handling = ClusterHandling::Refuse, Surface::ConstPtr* made = nullptr)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  scanned.setClusterHandling(handling);
  scanned.setQuiet(true);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  if (made)
    *made = surface;
  return scanned.getStatus();
}

} // namespace

TEST(StandingClusters, AreRefusedWithPlaceSizeAndHeight)
{
  std::uint32_t seed = 0;
  for (const int points : {2, 3, 6, 12, 25, 50})
    for (const double height : {0.5, 2.0, 10.0})
      for (const bool at_rim : {false, true}) {
        const Cloud::Ptr cloud = dome(++seed);
        std::mt19937 random(seed);
        Thing thing{points, height, 3.0, -2.0};
        if (at_rim)
          thing.x = rim - 0.5 * thing.width() - 0.5;
        addEchoes(*cloud, 4, thing, random);
        put(*cloud, thing, random);
        SCOPED_TRACE(std::to_string(points) + " points " + std::to_string(height) + " mm high at x " + std::to_string(thing.x));
        const Status status = statusOf(cloud);
        ASSERT_EQ(status.code(), StatusCode::InvalidInput) << status.message();
        EXPECT_NE(status.message().find(" off the surface: "), std::string::npos) << status.message();
        EXPECT_NE(status.message().find("setClusterHandling"), std::string::npos);
        int count = 0;
        double x = 0.0, y = 0.0, z = 0.0, size = 0.0, high = 0.0;
        const std::string found = status.message().substr(status.message().find(": ") + 2);
        ASSERT_EQ(
            std::sscanf(found.c_str(), "%d points at (%lf, %lf, %lf), %lf mm across and %lf mm high", &count, &x, &y, &z, &size, &high), 6)
            << found;
        EXPECT_LE(count, points + 1) << "one echo may be near";
        EXPECT_LE(size, 1.6 * thing.width() + 1.0) << found;
        const double off = (Eigen::Vector3d(x, y, z) - onDome(thing.x, thing.y, height)).norm();
        if (at_rim && points == 50) { // as wide as its distance from the middle: pieces of it are named
          EXPECT_LT(off, thing.width()) << found;
          continue;
        }
        EXPECT_GE(count, std::max(2, at_rim ? points / 3 : points / 2)) << "its outer rows hang over the rim";
        EXPECT_LT(off, 0.5 + 0.3 * thing.width()) << found;
        EXPECT_NEAR(high, height, 0.1 + 0.03 * height) << found;
      }
}

/** The ridge of a roof on a grid, one point wide: an edge is neither taken off nor left out. */
TEST(StandingClusters, ALineOfPointsIsCalledAnEdge)
{
  for (const double slope : {30.0, 40.0, 45.0}) {
    const double fall = std::tan(slope * M_PI / 180.0);
    const Cloud::Ptr roof(new Cloud);
    for (int i = -40; i <= 40; ++i)
      for (int j = -40; j <= 40; ++j)
        add(*roof, Eigen::Vector3d(i, j, -fall * std::abs(i)));
    const Status status = statusOf(roof);
    ASSERT_EQ(status.code(), StatusCode::InvalidInput) << slope;
    const std::string& message = status.message();
    EXPECT_NE(message.find("points in one line are an edge of the part that has too few points, or a wire"), std::string::npos) << message;
    EXPECT_NE(message.find("ride over it (setClusterHandling(ClusterHandling::Ride))"), std::string::npos) << message;
    EXPECT_EQ(message.find("leave the points out"), std::string::npos) << message;
    EXPECT_TRUE(statusOf(roof, ClusterHandling::Ride).ok());
  }
}

TEST(StandingClusters, AThingThatHidesTheSurfaceIsOneClusterOfAllItsPoints)
{
  // Its middle is far from all that is seen of the dome.
  for (const double height : {8.0, 12.0}) {
    const Cloud::Ptr cloud(new Cloud);
    const Cloud::Ptr whole = dome(3);
    for (const pcl::PointXYZ& p : *whole)
      if (std::max(std::abs(p.x - 2.0f), std::abs(p.y)) > 4.0f)
        cloud->push_back(p);
    std::mt19937 random(3);
    put(*cloud, {49, height, 2.0, 0.0}, random);
    Surface::ConstPtr surface;
    ASSERT_TRUE(statusOf(cloud, ClusterHandling::Ride, &surface).ok());
    std::size_t points = 0, hiding = 0;
    for (const StandingCluster& cluster : surface->clusters()) {
      points += cluster.indices.size();
      hiding += cluster.hides_surface;
      EXPECT_EQ(cluster.positions.size(), cluster.indices.size());
    }
    EXPECT_EQ(points, 49U) << height;
    EXPECT_GE(hiding, 1U);
    const std::string said = statusOf(cloud).message();
    const std::size_t at = said.find("with a ball of radius ");
    ASSERT_NE(at, std::string::npos) << said;
    const double radius = std::atof(said.c_str() + at + std::strlen("with a ball of radius "));
    EXPECT_TRUE(checkRideHeight(surface->clusters(), radius).ok()) << said;
    EXPECT_FALSE(checkRideHeight(surface->clusters(), radius - 0.2).ok()) << said;
  }
}

TEST(StandingClusters, ALastPointFartherFromTheOthersBelongsToThem)
{
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    const Cloud::Ptr cloud = dome(seed);
    std::mt19937 random(seed);
    put(*cloud, {3, 4.0, 2.0, 0.0}, random);
    add(*cloud, onDome(4.9, 0.5, 4.5)); // alone it looks like a single echo
    Surface::ConstPtr surface;
    ASSERT_TRUE(statusOf(cloud, ClusterHandling::Ride, &surface).ok());
    ASSERT_EQ(surface->clusters().size(), 1U) << seed;
    EXPECT_EQ(surface->clusters().front().positions.size(), 4U) << seed;
    EXPECT_NEAR(surface->clusters().front().height, 4.5, 0.1) << seed;
  }
}

/** The crown of a tree over a plane, its leaves at random four spacings apart in the mean: a ball that rides over it must know all. */
TEST(StandingClusters, TheLeavesOfATreeBelongToIt)
{
  constexpr int leaves = 58, seeds = 10, side = 60;
  constexpr double crown = 14.0, middle = 18.0;
  int missed = 0;
  for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
    const Cloud::Ptr cloud(new Cloud);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    for (int i = -side; i <= side; ++i)
      for (int j = -side; j <= side; ++j)
        add(*cloud, Eigen::Vector3d(i + 0.3 * share(random), j + 0.3 * share(random), 0.01 * share(random)));
    for (int i = 0; i < leaves;) {
      const Eigen::Vector3d leaf(share(random), share(random), share(random));
      if (leaf.norm() > 1.0)
        continue;
      add(*cloud, crown * leaf + Eigen::Vector3d(0.0, 0.0, middle));
      ++i;
    }
    Surface::ConstPtr surface;
    ASSERT_TRUE(statusOf(cloud, ClusterHandling::Ride, &surface).ok());
    missed += leaves - static_cast<int>(surface->riddenPoints().size());
  }
  EXPECT_LE(missed, seeds * leaves / 200);
}

TEST(StandingClusters, PointsFarApartInOnePlaceAreOneToo)
{
  // Each three to five spacings from the next: alone they look like single echoes.
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const Cloud::Ptr cloud = dome(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> height(3.0, 6.0), jitter(-0.5, 0.5);
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {3.5, 0.0}, {0.0, 3.5}, {3.5, 3.5}, {7.0, 1.7}})
      add(*cloud, onDome(x - 5.0 + jitter(random), y + 4.0 + jitter(random), height(random)));
    const Status status = statusOf(cloud);
    EXPECT_EQ(status.code(), StatusCode::InvalidInput) << seed;
    EXPECT_NE(status.message().find("5 points at ("), std::string::npos) << status.message();
  }
}

TEST(StandingClusters, AreLeftOutIfAskedFor)
{
  for (const double height : {0.5, 2.0, 10.0}) {
    const Cloud::Ptr cloud = dome(7);
    const std::size_t honest = cloud->size();
    std::mt19937 random(7);
    put(*cloud, {20, height, -4.0, 5.0}, random);
    Surface::ConstPtr surface;
    ASSERT_TRUE(statusOf(cloud, ClusterHandling::LeaveOut, &surface).ok());
    std::size_t stayed = 0;
    for (std::size_t i = 0; i < surface->size(); ++i)
      stayed += surface->sourceIndex(i) >= honest;
    EXPECT_LE(stayed, 2U) << height;
    EXPECT_GE(surface->size() + 10, honest) << "the dome stays";
    const auto& warnings = surface->warnings();
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const pcl_spiral::Diagnostic& w) {
      return w.text().find("stands off the surface: ") != std::string::npos && w.text().find("a path may go through") != std::string::npos;
    }));
  }
}

TEST(StandingClusters, SingleEchoesGoAsBefore)
{
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    const Cloud::Ptr cloud = dome(seed);
    std::mt19937 random(seed);
    const std::size_t honest = cloud->size();
    addEchoes(*cloud, 12, {0, 0.0, 1000.0, 0.0}, random); // no thing
    Surface::ConstPtr surface;
    ASSERT_TRUE(statusOf(cloud, ClusterHandling::Refuse, &surface).ok()) << seed;
    std::size_t stayed = 0;
    for (std::size_t i = 0; i < surface->size(); ++i)
      stayed += surface->sourceIndex(i) >= honest;
    EXPECT_EQ(stayed, 0U) << seed;
  }
}

TEST(StandingClusters, EchoesThatFlyAtRandomAreNoCluster)
{
  int refused = 0;
  for (std::uint32_t seed = 1; seed <= 16; ++seed) {
    const Cloud::Ptr cloud = dome(seed);
    std::mt19937 random(100 + seed);
    std::uniform_real_distribution<double> side(-0.65 * rim, 0.65 * rim), height(-20.0, 20.0);
    for (int i = 0; i < 10 + 2 * static_cast<int>(seed); ++i)
      add(*cloud, onDome(side(random), side(random), height(random)));
    refused += !statusOf(cloud).ok();
  }
  EXPECT_LE(refused, 1) << "of 16 scans: two echoes that meet by chance look like a thing of two points";
}

TEST(StandingClusters, TheDoorHasOneAndOtherScansHaveNone)
{
  std::string folder = "../shared/data/";
  for (int up = 0; up < 3 && !std::filesystem::exists(folder); ++up)
    folder = "../" + folder;
  if (!std::filesystem::exists(folder))
    GTEST_SKIP() << "there is no folder of real scans";
  for (const auto& [name, unit, clusters] : {std::tuple("door_window_frame", LengthUnit::Metre, 1),
                                             {"wok_scan", LengthUnit::Metre, 0},
                                             {"noether_raw_panel", LengthUnit::Metre, 0},
                                             {"vase_fluted_outer_annulus", LengthUnit::Millimetre, 0},
                                             {"owl", LengthUnit::Millimetre, 0},
                                             {"demosthenes", LengthUnit::Millimetre, 0},
                                             {"jug_belly_annulus", LengthUnit::Millimetre, 0}}) {
    const std::string file = folder + name + ".ply";
    ReadOptions read;
    read.unit = unit;
    const Status status = statusOf(readCloud(file, read).cloud);
    EXPECT_EQ(status.ok(), clusters == 0) << name << ": " << status.message();
    if (clusters > 0) {
      EXPECT_NE(status.message().find("6 points at (1575, 2050, "), std::string::npos) << status.message();
    }
  }
}

} // namespace standing_clusters_test
