// SPDX-License-Identifier: BSD-3-Clause
// What smoothing moved: a fold that it took away is found with its height and place, and noise alone is called noise.
#include <pcl_spiral/surface/scanned_surface.h>
#include <pcl_spiral/verify/raw_scan.h>

#include "support/sampling.h"
#include "support/surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace raw_scan_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double spacing = 0.8; // about

Surface::ConstPtr
surfaceOf(const std::vector<Eigen::Vector3d>& points)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(toCloud(points));
  scanned.setQuiet(true);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  EXPECT_TRUE(surface) << scanned.getStatus().message();
  return surface;
}

std::vector<Eigen::Vector3d>
plate(unsigned seed)
{
  return sampleUniform(*flat(Region({circle({0, 0}, 40.0)})), 8000, seed).points;
}

std::vector<Eigen::Vector3f>
floats(const std::vector<Eigen::Vector3d>& points)
{
  std::vector<Eigen::Vector3f> result;
  for (const Eigen::Vector3d& p : points)
    result.push_back(p.cast<float>());
  return result;
}

} // namespace

TEST(RawScan, AFoldThatSmoothingTookIsFoundAtItsPlace)
{
  std::vector<Eigen::Vector3d> raw = plate(1);
  for (Eigen::Vector3d& p : raw)
    p.z() += 2.0 * std::exp(-(p.x() - 10.0) * (p.x() - 10.0) / 18.0); // a rib along y, 2 mm high
  std::vector<Eigen::Vector3f> points = floats(raw);
  points.emplace_back(std::nanf(""), 0.0F, 0.0F);
  points.emplace_back(500.0F, 0.0F, 0.0F);
  const RawScanReport f = compareWithRaw(*surfaceOf(plate(2)), points);
  EXPECT_EQ(f.beside, 1U);
  EXPECT_NEAR(f.largest.value, 2.0, 0.02);
  EXPECT_NEAR(f.mean.value, 2.0, 0.1); // of 25 points, over 4 mm
  EXPECT_NEAR(f.mean.position.x(), 10.0, 1.0);
  EXPECT_NEAR(f.mean.position.z(), f.mean.value, 1e-3);
  EXPECT_NEAR(f.p99, 2.0, 0.1);
  EXPECT_EQ(f.means.size(), f.points);
  const std::string text = smoothingText(f, "raw.pcd").text();
  EXPECT_NE(text.find("the shape was changed there"), std::string::npos) << text;
  EXPECT_NE(text.find("1 point has no smoothed surface near"), std::string::npos) << text;
}

TEST(RawScan, NoiseAloneIsNoise)
{
  constexpr double noise = 0.3 * spacing;
  std::vector<Eigen::Vector3d> raw = plate(3);
  Random random(4);
  for (Eigen::Vector3d& p : raw)
    p.z() += noise * random.normal();
  const RawScanReport f = compareWithRaw(*surfaceOf(plate(5)), floats(raw));
  EXPECT_NEAR(f.noise, noise, 0.05 * noise);
  EXPECT_NEAR(f.p99, 2.576 * noise, 0.1 * noise); // of a normal distribution
  EXPECT_LT(f.mean.value, f.leastMean() * 1.15);  // the largest of 8000 means
}

TEST(RawScan, AShiftOfAllIsNoNoiseAndTheSameScanIsNoChange)
{
  std::vector<Eigen::Vector3d> raw = plate(8);
  const Surface::ConstPtr surface = surfaceOf(raw);
  const RawScanReport same = compareWithRaw(*surface, floats(raw));
  EXPECT_LT(same.mean.value, same.leastMean());
  EXPECT_TRUE(same.others.empty());
  Random random(9);
  for (Eigen::Vector3d& p : raw)
    p.z() += 0.5 + 0.05 * random.normal();
  const RawScanReport shifted = compareWithRaw(*surface, floats(raw));
  EXPECT_NEAR(shifted.noise, 0.05, 0.005);
  EXPECT_GT(shifted.mean.value, 5.0 * shifted.leastMean());
  raw.emplace_back(3.0, 2.0, 90.0);
  const RawScanReport flying = compareWithRaw(*surface, floats(raw));
  EXPECT_EQ(flying.beside, 1U);
  EXPECT_EQ(flying.others.back(), Eigen::Vector3f(3.0F, 2.0F, 90.0F));
}

TEST(RawScan, DoesNotDependOnTheOrderOfThePoints)
{
  std::vector<Eigen::Vector3d> raw = plate(6);
  for (Eigen::Vector3d& p : raw)
    p.z() += 0.5 * std::sin(p.x());
  const Surface::ConstPtr surface = surfaceOf(plate(7));
  const RawScanReport one = compareWithRaw(*surface, floats(raw));
  std::reverse(raw.begin(), raw.end());
  const RawScanReport other = compareWithRaw(*surface, floats(raw));
  EXPECT_EQ(one.mean.position, other.mean.position);
  EXPECT_EQ(one.p99, other.p99);
  EXPECT_EQ(one.largest.value, other.largest.value);
}

} // namespace raw_scan_test
