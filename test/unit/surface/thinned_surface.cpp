// SPDX-License-Identifier: BSD-3-Clause
// Noise and thinning: the remedies that messages name work at the first try, and a thinned cloud that hides the surface is refused.
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl/surface/mls.h>

#include <gtest/gtest.h>

#include <cmath>

namespace thinned_surface_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double radius = 100.0;

SurfacePtr
dome()
{
  return ball(radius, Region({circle({0.0, 0.0}, 40.0)}));
}

struct Made {
  Status status;
  double off = 0.0; ///< farthest contact off the sphere
};

Made
made(const std::vector<Eigen::Vector3d>& points, double sphere, double thinning, double scallop)
{
  SpiralToolpathGenerator<pcl::PointXYZ> generator;
  generator.setInputCloud(toCloud(points));
  generator.setToolRadius(5.0);
  generator.setScallopHeight(scallop);
  generator.setThinning(thinning);
  pcl::PointCloud<ToolpathPoint> path;
  generator.compute(path);
  Made result;
  result.status = generator.getStatus();
  for (const ToolpathPoint& p : path)
    result.off = std::max(result.off, std::abs(p.getVector3fMap().cast<double>().norm() - sphere));
  return result;
}

/** The number after \p words. */
double
numberAfter(const std::string& text, const std::string& words)
{
  const std::size_t at = text.find(words);
  return at == std::string::npos ? 0.0 : std::stod(text.substr(at + words.size()));
}

} // namespace

class NoisyDome : public ::testing::TestWithParam<double> {};

TEST_P(NoisyDome, TheNamedSmoothingWorksAtOnce)
{
  const double noise = GetParam();
  Sampled scan = sampleUniform(*dome(), 20000, 3);
  addNoise(scan, noise, 4);
  const Made refused = made(scan.points, radius, 0.0, 0.1);
  ASSERT_FALSE(refused.status.ok());
  const double search = numberAfter(refused.status.message(), "-radius ");
  ASSERT_GT(search, 0.0) << refused.status.message();
  pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointXYZ> fit;
  fit.setInputCloud(toCloud(scan.points));
  fit.setSearchRadius(search);
  pcl::PointCloud<pcl::PointXYZ> smooth;
  fit.process(smooth);
  std::vector<Eigen::Vector3d> points;
  for (const pcl::PointXYZ& p : smooth)
    points.push_back(p.getVector3fMap().cast<double>());
  const Made smoothed = made(points, radius, 0.0, 0.1);
  ASSERT_TRUE(smoothed.status.ok()) << smoothed.status.message();
  EXPECT_LT(smoothed.off, noise);
}

INSTANTIATE_TEST_SUITE_P(Noise, NoisyDome, ::testing::Values(0.2));

TEST(ThinnedSurface, ThatLiesBesideThePointsIsRefusedWithAnEdgeThatWorks)
{
  const double waves_deep = 1.0;
  const SurfacePtr wavy = waves({{waves_deep, 0.25, 0.0, 0.0}}, Region({rectangle(80.0, 60.0)}));
  const Sampled scan = sampleUniform(*wavy, 30000, 7);
  const double scallop = 0.05;
  const Made coarse = made(scan.points, radius, 8.0, scallop);
  ASSERT_FALSE(coarse.status.ok());
  const std::string message = coarse.status.message();
  EXPECT_NE(message.find("beside the points that were left out, at ("), std::string::npos) << message;
  const double edge = numberAfter(message, "thin to ");
  ASSERT_GT(edge, 0.5) << message;
  const Made finer = made(scan.points, radius, edge, scallop);
  EXPECT_TRUE(finer.status.ok()) << message << " then " << finer.status.message();
  const double higher = numberAfter(message, "set a scallop height above ");
  const Made rougher = made(scan.points, radius, 8.0, 1.05 * higher);
  EXPECT_TRUE(rougher.status.ok()) << message << " then " << rougher.status.message();
}

TEST(ThinnedSurface, OfASmoothDomeKeepsTheSurface)
{
  const Made thinned = made(sampleUniform(*dome(), 60000, 5).points, radius, 1.5, 0.02);
  ASSERT_TRUE(thinned.status.ok()) << thinned.status.message();
  EXPECT_LT(thinned.off, 0.02);
}

} // namespace thinned_surface_test
