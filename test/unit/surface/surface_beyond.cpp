// SPDX-License-Identifier: BSD-3-Clause
// The middle of a surface is cut: the ball rides over what continues beyond it, by brute force over the exact surface, and only that.
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>

namespace surface_beyond_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double half = 18.0, spacing = 0.7, chord_error = 0.02; // mm

struct Scene {
  std::string name;
  std::function<double(double, double)> height;
  double low, high; ///< of x in the crop; y is within 13
  double ball;
  double curvature; ///< the largest beyond the crop where it is convex, 1/mm
  double noise = 0.0;
};

struct CutScan {
  Cloud::Ptr part = std::make_shared<Cloud>();
  std::vector<Eigen::Vector3f> beside;
};

bool
isInside(const Scene& scene, double x, double y)
{
  return x > scene.low && x < scene.high && std::abs(y) < 13.0;
}

CutScan
scanOf(const Scene& scene)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> jitter(-0.3 * spacing, 0.3 * spacing);
  std::normal_distribution<double> normal;
  CutScan scan;
  for (double i = -half; i < half; i += spacing)
    for (double j = -half; j < half; j += spacing) {
      const double x = i + jitter(random), y = j + jitter(random);
      const Eigen::Vector3f p = Vector3d(x, y, scene.height(x, y) + scene.noise * normal(random)).cast<float>();
      if (isInside(scene, x, y))
        scan.part->push_back({p.x(), p.y(), p.z()});
      else
        scan.beside.push_back(p);
    }
  return scan;
}

Surface::ConstPtr
surfaceOf(const Cloud::Ptr& part)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(part);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  return surface;
}

/** How deep the ball is in the exact surface beyond the crop, on a path that knows the patches \p beyond. */
double
deepest(const Scene& scene, const Surface::ConstPtr& surface, const std::vector<SurfacePatch>& beyond)
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputSurface(surface);
  spiral.setSurfaceBeyond(beyond);
  spiral.setToolRadius(scene.ball);
  spiral.setScallopHeight(0.05);
  spiral.setChordError(chord_error);
  pcl::PointCloud<ToolpathPoint> path;
  spiral.compute(path);
  EXPECT_TRUE(spiral.getStatus().ok()) << scene.name << ": " << spiral.getStatus().message();
  double nearest = scene.ball;
  for (double x = -half; x < half; x += 0.25)
    for (double y = -half; y < half; y += 0.25)
      for (std::size_t i = 0; !isInside(scene, x, y) && i < path.size(); ++i) {
        const ToolpathPoint& p = path[i];
        const Vector3d centre = (p.getVector3fMap() + float(scene.ball) * p.getNormalVector3fMap()).cast<double>();
        nearest = std::min(nearest, (centre - Vector3d(x, y, scene.height(x, y))).norm());
      }
  return scene.ball - nearest;
}

const std::function<double(double, double)> wall = [](double x, double) { return 6.0 / (1.0 + std::exp(-(x - 12.0) / 0.9)); };

} // namespace

TEST(SurfaceBeyond, TheBallRidesOverWhatContinues)
{
  const auto valley = [](double x, double) { return std::abs(x) > 8.0 ? std::pow(std::abs(x) - 8.0, 2) / 12.0 : 0.0; };
  const auto corner = [](double x, double y) { return wall(x, 0.0) + wall(y, 0.0); };
  for (const Scene& scene : {Scene{"valley", valley, -9.0, 9.0, 7.0, 0.0}, Scene{"wall", wall, -10.0, 9.5, 4.0, 0.34},
                             Scene{"noisy wall", wall, -10.0, 9.5, 4.0, 0.34, 0.02}, Scene{"corner", corner, -10.0, 9.5, 4.0, 0.34}}) {
    const CutScan scan = scanOf(scene);
    const Surface::ConstPtr surface = surfaceOf(scan.part);
    ASSERT_TRUE(surface) << scene.name;
    const double between = spacing * spacing / 8.0 * (1.0 / scene.ball + scene.curvature); // ball and surface bulge between points
    const double allowed = 3.0 * scene.noise + chord_error + between;
    const double ridden = deepest(scene, surface, surfaceBeyond(*surface, scan.beside, scene.ball)), before = deepest(scene, surface, {});
    std::printf("  %s: %.4f mm deep, %.4f not knowing what is beyond; allowed %.4f\n", scene.name.c_str(), ridden, before, allowed);
    EXPECT_LE(ridden, allowed) << scene.name;
    EXPECT_GT(before, allowed) << scene.name << ": nothing to ride over";
  }
}

TEST(SurfaceBeyond, NothingWhereNoBallTouches)
{
  const Scene dome{"dome", [](double x, double y) { return std::sqrt(1600.0 - x * x - y * y); }, -12.0, 12.0, 6.0, 0.025};
  const CutScan scan = scanOf(dome);
  EXPECT_TRUE(surfaceBeyond(*surfaceOf(scan.part), scan.beside, dome.ball).empty());
}

TEST(SurfaceBeyond, AClampBesideIsNoSurface)
{
  const Scene plate{"plate", [](double x, double) { return x > 11.5 ? 8.0 : 0.0; }, -10.0, 11.0, 4.0, 0.0};
  const CutScan scan = scanOf(plate);
  for (const SurfacePatch& patch : surfaceBeyond(*surfaceOf(scan.part), scan.beside, plate.ball))
    ASSERT_LT(patch.foot.position.z(), 1.0) << patch.foot.position.transpose();
}

} // namespace surface_beyond_test
