// SPDX-License-Identifier: BSD-3-Clause
// Crops, keep-outs and their polygons: against distances and crossings found in other ways.
#include <pcl_spiral/cleaning/part_region.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/polygon_reader.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace part_region_test {

using namespace pcl_spiral;

namespace {

using Corners = std::vector<Eigen::Vector3d>;

/** An L with a slanted end. */
const Corners ell{{0, 0, 0}, {30, 0, 0}, {30, 8, 0}, {12, 10, 0}, {9, 25, 0}, {0, 25, 0}};

/** Sum of the angles under which the sides are seen from \p p: 2 pi inside, 0 outside. */
bool
woundRound(const Corners& corners, const Eigen::Vector3d& p)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d a = (corners[i] - p).head<2>(), b = (corners[(i + 1) % corners.size()] - p).head<2>();
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(sum) > M_PI;
}

/** Distance from many places on the sides; 0 inside. */
double
sampledDistance(const Corners& corners, const Eigen::Vector3d& p)
{
  if (woundRound(corners, p))
    return 0.0;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (int k = 0; k <= 2000; ++k) {
      const Eigen::Vector3d on = corners[i] + (corners[(i + 1) % corners.size()] - corners[i]) * (k / 2000.0);
      least = std::min(least, (on - p).head<2>().norm());
    }
  return least;
}

constexpr double ball = 60.0; // radius of the surface, mm

/** A cap of a ball, with its normals. */
struct Cap {
  pcl::PointCloud<pcl::PointXYZ>::Ptr points{new pcl::PointCloud<pcl::PointXYZ>};
  pcl::PointCloud<pcl::Normal>::Ptr normals{new pcl::PointCloud<pcl::Normal>};

  explicit Cap(int count)
  {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> side(-45.0, 45.0);
    while (static_cast<int>(points->size()) < count) {
      const double x = side(random), y = side(random), z = std::sqrt(std::max(0.0, ball * ball - x * x - y * y));
      points->push_back(pcl::PointXYZ(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)));
      normals->push_back(pcl::Normal(static_cast<float>(x / ball), static_cast<float>(y / ball), static_cast<float>(z / ball)));
    }
  }
};

pcl::Indices
kept(PartRegion<pcl::PointXYZ>& region, const Cap& cap)
{
  region.setInputCloud(cap.points);
  pcl::Indices indices;
  region.filter(indices);
  return indices;
}

} // namespace

TEST(PartRegion, PrismsKnowInsideAndDistance)
{
  const Prism prism(ell, {0.0, 0.0, 2.0});
  ASSERT_EQ(prism.fault(), "");
  std::mt19937 random(3);
  std::uniform_real_distribution<double> side(-15.0, 45.0);
  int inside = 0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d p(side(random), side(random), 100.0 * side(random));
    EXPECT_EQ(prism.contains(p), woundRound(ell, p)) << p.transpose();
    EXPECT_NEAR(prism.distance(p), sampledDistance(ell, p), 1e-3) << p.transpose();
    inside += prism.contains(p);
    const Eigen::Vector3d q(side(random), side(random), 0.0);
    double least = std::numeric_limits<double>::max();
    for (int k = 0; k <= 400; ++k)
      least = std::min(least, prism.distance(p + (q - p) * (k / 400.0)));
    EXPECT_LE(prism.distance(p, q), least + 1e-9) << "no place of the line is nearer";
    EXPECT_NEAR(prism.distance(p, q), least, 0.2) << "steps of up to 0.22 mm";
  }
  EXPECT_GT(inside, 50);
}

TEST(PartRegion, PrismsAlongAnyAxis)
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  Corners turned;
  for (const Eigen::Vector3d& corner : ell)
    turned.push_back(turn * corner + Eigen::Vector3d(5.0, 6.0, 7.0));
  const Eigen::Vector3d area = polygonArea(turned);
  EXPECT_NEAR(area.norm(), polygonArea(ell).norm(), 1e-9);
  const Prism flat(ell, Eigen::Vector3d::UnitZ()), prism(turned, area);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> side(-15.0, 45.0);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3d p(side(random), side(random), side(random));
    EXPECT_NEAR(prism.distance(turn * p + Eigen::Vector3d(5.0, 6.0, 7.0)), flat.distance(p), 1e-9);
  }
}

TEST(PartRegion, PrismsKnowTheirWidth)
{
  EXPECT_NEAR(Prism(ell, Eigen::Vector3d::UnitZ()).width(), std::hypot(30.0, 25.0), 1e-12);
}

TEST(PartRegion, PolygonsWithFaults)
{
  const auto fault = [](const Corners& corners) { return Prism(corners, Eigen::Vector3d::UnitZ()).fault(); };
  EXPECT_NE(fault({}).text().find("0 different corners"), std::string::npos);
  EXPECT_NE(fault({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}}).text().find("2 different corners"), std::string::npos);
  EXPECT_NE(fault({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}).text().find("no area"), std::string::npos);
  EXPECT_NE(fault({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}).text().find("crosses"), std::string::npos);
  EXPECT_EQ(fault({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 0, 0}}), "") << "closed in its file";
}

TEST(PartRegion, CropsByBoxAndPolygon)
{
  const Cap cap(4000);
  PartRegion<pcl::PointXYZ> region(true);
  region.setCropBox({Eigen::Vector3d(-10, -20, 0), Eigen::Vector3d(30, 9, 59)});
  region.setCrop(Prism(ell, Eigen::Vector3d::UnitZ()));
  const pcl::Indices indices = kept(region, cap);
  pcl::Indices expected, removed;
  for (int i = 0; i < static_cast<int>(cap.points->size()); ++i) {
    const Eigen::Vector3d p = (*cap.points)[i].getVector3fMap().cast<double>();
    const bool in_box = p.x() >= -10 && p.x() <= 30 && p.y() >= -20 && p.y() <= 9 && p.z() <= 59;
    (in_box && woundRound(ell, p) ? expected : removed).push_back(i);
  }
  EXPECT_GT(expected.size(), 50U);
  EXPECT_EQ(indices, expected);
  EXPECT_EQ(*region.getRemovedIndices(), removed);
  EXPECT_EQ(region.getReport().cropped, removed.size());
}

TEST(PartRegion, TheBallStaysOutOfKeepOuts)
{
  constexpr double radius = 7.0, margin = 0.5;
  const Cap cap(6000);
  for (const bool with_normals : {true, false}) {
    PartRegion<pcl::PointXYZ> region;
    region.addKeepOut(Prism(ell, Eigen::Vector3d::UnitZ()));
    const Corners other{{-40, -40, 0}, {-20, -40, 0}, {-30, -20, 0}};
    region.addKeepOut(Prism(other, Eigen::Vector3d::UnitZ()));
    region.setToolRadius(radius);
    region.setMargin(margin);
    if (with_normals)
      region.setInputNormals(cap.normals);
    const pcl::Indices indices = kept(region, cap);
    std::vector<bool> is_kept(cap.points->size(), false);
    for (const auto i : indices)
      is_kept[static_cast<std::size_t>(i)] = true;
    std::size_t in = 0;
    for (std::size_t i = 0; i < cap.points->size(); ++i) {
      const Eigen::Vector3d p = (*cap.points)[i].getVector3fMap().cast<double>();
      const Eigen::Vector3d centre = with_normals ? Eigen::Vector3d(p * (ball + radius) / ball) : p;
      const double least = margin + (with_normals ? 1.0 : 2.0) * radius;
      const double distance = std::min(sampledDistance(ell, centre), sampledDistance(other, centre));
      if (std::abs(distance - least) > 0.01) {
        EXPECT_EQ(is_kept[i], distance > least) << p.transpose() << " at " << distance;
      }
      in += woundRound(ell, p) || woundRound(other, p);
    }
    EXPECT_EQ(region.getReport().kept_out, in);
    EXPECT_EQ(region.getReport().kept_out + region.getReport().too_close + indices.size(), cap.points->size());
  }
}

TEST(PartRegion, RefusesWhatItCannotUse)
{
  const Cap cap(100);
  const auto message = [&](const auto& set) {
    PartRegion<pcl::PointXYZ> region;
    set(region);
    EXPECT_TRUE(kept(region, cap).empty());
    EXPECT_FALSE(region.getStatus().ok());
    return region.getStatus().message();
  };
  const Prism line({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}, Eigen::Vector3d::UnitZ());
  EXPECT_NE(message([&](auto& r) { r.setCrop(line); }).find("polygon of the crop"), std::string::npos);
  EXPECT_NE(message([&](auto& r) { r.addKeepOut(line); }).find("polygon of a keep-out"), std::string::npos);
  EXPECT_NE(message([&](auto& r) { r.setToolRadius(-1.0); }).find("setToolRadius"), std::string::npos);
  EXPECT_NE(message([&](auto& r) { r.setMargin(std::nan("")); }).find("setMargin"), std::string::npos);
  EXPECT_NE(message([&](auto& r) { r.setInputNormals(Cap(99).normals); }).find("99 normals for 100 points"), std::string::npos);
}

TEST(PolygonReader, ReadsCornersInTheUnitOfTheScan)
{
  const ScratchFolder folder;
  const std::string file = folder.path("p.csv");
  writeText(file, "# a clamp\nx,y\n10,20\n 12, 20\n12,21\n\n10,21\n");
  ReadOptions read;
  read.unit = LengthUnit::Metre;
  read.origin = {10.0, 20.0, 3.0};
  const Prism prism = readPolygon(file, read);
  EXPECT_EQ(prism.axis(), Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(prism.contains({1000.0, 500.0, -1e6}));
  EXPECT_NEAR(prism.distance({-250.0, 500.0, 0.0}), 250.0, 1e-9);
  writeText(file, "0;0;0\n0;4;3\n-5;4;3\n-5;0;0\n");
  const Eigen::Vector3d axis = readPolygon(file).axis();
  EXPECT_NEAR(std::abs(axis.dot(Eigen::Vector3d(0.0, -0.6, 0.8))), 1.0, 1e-12) << "three coordinates: the mean normal";
}

TEST(PolygonReader, RefusesWithTheLine)
{
  const ScratchFolder folder;
  const auto refused = [&](const std::string& text, const std::string& words) {
    const std::string file = folder.path("p.txt");
    writeText(file, text);
    try {
      readPolygon(file);
      FAIL() << text;
    }
    catch (const FileError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  refused("0 0\n1 0\n1\n", "line 3: 1 numbers");
  refused("0 0\n1 zero\n", "line 2: 'zero' is not a number");
  refused("0 0\n1 0 5\n", "line 2: some corners have a z");
  refused("0 0\n1 0\n", "2 different corners");
  refused("0 0\n2 2\n2 0\n0 2\n", "crosses");
  refused("0 0\n1 nan\n", "line 2");
}

TEST(PartRegion, AShankThatLeansAnyWayStaysClearOfAnObstacle)
{
  constexpr double radius = 4.0, length = 40.0, lean = 17.0;
  const Eigen::Vector3d obstacle(0.0, 0.0, 12.0);
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (int i = 0; i < 400; ++i) {
    cloud->emplace_back(0.05f * static_cast<float>(i), 0.0f, 0.0f);
    normals->emplace_back(0.0f, 0.0f, 1.0f);
  }
  PartRegion<pcl::PointXYZ> region;
  region.setInputCloud(cloud);
  region.setInputNormals(normals);
  region.setToolRadius(radius);
  region.setShank(length, lean);
  region.setObstacles({obstacle.cast<float>()});
  pcl::Indices kept;
  region.filter(kept);
  ASSERT_TRUE(region.getStatus().ok());
  EXPECT_EQ(region.getReport().too_close, cloud->size() - kept.size());
  const auto clearance = [&](double x) { // of the shank that leans towards the obstacle by any angle up to the lean
    double least = 1e30;
    for (double angle = -lean; angle <= lean; angle += 0.5)
      for (double s = 0.0; s <= length; s += 0.02) {
        const double by = angle * 3.14159265358979 / 180.0;
        const Eigen::Vector3d place(x + s * std::sin(by), 0.0, radius + s * std::cos(by));
        least = std::min(least, (place - obstacle).norm() - radius);
      }
    return least;
  };
  std::vector<bool> is_kept(cloud->size(), false);
  for (const auto i : kept)
    is_kept[static_cast<std::size_t>(i)] = true;
  for (std::size_t i = 0; i < cloud->size(); i += 5) {
    const double clear = clearance((*cloud)[i].x);
    if (is_kept[i])
      EXPECT_GE(clear, 0.0) << (*cloud)[i].x;
    else
      EXPECT_LT(clear, 0.5) << "left out for nothing: " << (*cloud)[i].x;
  }
  region.setShank(length, 90.0);
  region.filter(kept);
  EXPECT_NE(region.getStatus().message().find("(setShank)"), std::string::npos);
}

} // namespace part_region_test
