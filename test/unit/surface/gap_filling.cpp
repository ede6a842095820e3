// SPDX-License-Identifier: BSD-3-Clause
// Gaps in spheres: the added points are on the sphere, fill the gap, and stay in it.
#include "support/sampling.h"

#include "surface/gap_filling.h"
#include <pcl_spiral/features/impl/boundary_loops_engine.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <gtest/gtest.h>

namespace gap_filling_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;

constexpr double radius = 150.0, gap_radius = 8.0;
const Eigen::Vector2d gap_centre(10.0, 5.0);

class GapInASphere : public ::testing::TestWithParam<int> {
protected:
  void SetUp() override
  {
    if (GetParam() > 0)
      motion_ = test::randomMotion(GetParam(), 100.0);
    const test::Region region({test::circle({0, 0}, 60.0), test::circle(gap_centre, gap_radius)});
    const auto sampled = test::sampleUniform(*test::ball(radius, region), 8000, 21);
    for (std::size_t i = 0; i < sampled.points.size(); ++i) {
      points_.push_back((motion_ * sampled.points[i]).cast<float>());
      options_.given_normals.push_back((motion_.linear() * sampled.normals[i]).cast<float>());
    }
    ASSERT_TRUE(graph_.build(points_, options_).ok());
    ASSERT_TRUE(findBoundaryLoops(graph_, BoundaryOptions(), loops_).ok());
    ASSERT_EQ(loops_.size(), 2u);
    ASSERT_EQ(loops_[1].type, LoopType::ScanGap);
    fill_ = fillGap(graph_, loops_[1].points);
  }

  Eigen::Isometry3d motion_ = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector3f> points_;
  SurfaceGraphOptions options_;
  SurfaceGraph graph_;
  std::vector<BoundaryLoop> loops_;
  GapFill fill_;
};

TEST_P(GapInASphere, PatchIsTheSphere)
{
  ASSERT_FALSE(fill_.points.empty());
  double worst = 0.0, farthest = 0.0;
  for (const Eigen::Vector3f& q : fill_.points) {
    const Vector3d p = motion_.inverse() * q.cast<double>();
    worst = std::max(worst, std::abs(p.norm() - radius));
    farthest = std::max(farthest, (p.head<2>() - gap_centre).norm());
  }
  std::printf("  %zu points, largest distance to the sphere %.5f mm, residual %.5f mm, spacing %.2f mm\n", fill_.points.size(), worst,
              fill_.residual, graph_.spacing());
  // The fit reaches 23 mm from the centre: (23 mm)^4 / (8 r^3) = 0.010 is the first term a cubic does not have.
  EXPECT_LT(worst, 0.005);
  EXPECT_LT(fill_.residual, 0.003);
  EXPECT_LT(farthest, gap_radius + graph_.spacing());
  EXPECT_NEAR(fill_.width, 2.0 * gap_radius + graph_.spacing(), 1.5 * graph_.spacing());
  EXPECT_LT(((motion_.inverse() * fill_.centre).head<2>() - gap_centre).norm(), graph_.spacing());
}

TEST_P(GapInASphere, NothingStaysOpen)
{
  std::vector<Eigen::Vector3f> all = points_;
  all.insert(all.end(), fill_.points.begin(), fill_.points.end());
  const auto sphere = test::ball(radius, test::Region({test::circle(gap_centre, gap_radius)}));
  double emptiest = 0.0;
  for (const Vector3d& p : test::sampleUniform(*sphere, 300, 22).points) {
    const Eigen::Vector3f at = (motion_ * p).cast<float>();
    float nearest = 1e30f;
    for (const Eigen::Vector3f& q : all)
      nearest = std::min(nearest, (q - at).norm());
    emptiest = std::max(emptiest, static_cast<double>(nearest));
  }
  EXPECT_LT(emptiest, 2.0 * graph_.spacing());
  options_.given_normals.resize(all.size(), Eigen::Vector3f::Zero());
  SurfaceGraph filled;
  ASSERT_TRUE(filled.build(all, options_).ok());
  ASSERT_TRUE(findBoundaryLoops(filled, BoundaryOptions(), loops_).ok());
  EXPECT_EQ(loops_.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Frames, GapInASphere, ::testing::Values(0, 5));

TEST(GapFilling, NothingToFitGivesNothing)
{
  std::vector<Eigen::Vector3f> points;
  for (const Vector3d& p : test::sampleUniform(*test::flat(test::Region({test::circle({0, 0}, 10.0)})), 200, 23).points)
    points.push_back(p.cast<float>());
  SurfaceGraph graph;
  ASSERT_TRUE(graph.build(points, {}).ok());
  EXPECT_TRUE(fillGap(graph, {}).points.empty());
  EXPECT_TRUE(fillGap(graph, {Vector3d(0, 0, 0), Vector3d(1, 0, 0)}).points.empty());
  EXPECT_TRUE(fillGap(graph, {Vector3d(900, 0, 0), Vector3d(901, 0, 0), Vector3d(901, 1, 0)}).points.empty());
}

TEST(AddPoints, GivesNoSurfaceWhereItFails)
{
  const auto cloud = test::toCloud(test::sampleUniform(*test::ball(radius, test::Region({test::circle({0, 0}, 60.0)})), 8000, 21).points);
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  Surface::ConstPtr surface, result;
  scanned.compute(surface);
  ASSERT_TRUE(surface);
  std::vector<Eigen::Vector3f> scattered; // not a single sheet
  test::Random random(3);
  for (int i = 0; i < 16000; ++i) {
    const double x = random.uniform(-40, 40), y = random.uniform(-40, 40);
    scattered.push_back(Vector3d(x, y, std::sqrt(radius * radius - x * x - y * y) + random.uniform(-4, 4)).cast<float>());
  }
  const Status status = addPoints(surface, scattered, result);
  EXPECT_FALSE(status.ok());
  EXPECT_FALSE(result);
}

} // namespace

} // namespace gap_filling_test
