// SPDX-License-Identifier: BSD-3-Clause
// Deviation of path points from a raw cloud: faults found at their places, separated from noise; behaviour of the class.
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/verify/deviation_estimation.h>

#include "support/passes.h"
#include "support/reference.h"
#include "support/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace deviation_estimation_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr double degree = 0.017453292519943295;

SurfacePtr
saddle()
{
  return quadric(200.0, -150.0, Region({circle({0, 0}, 40.0)}));
}

CheckedPath
passes(const AnalyticSurface& surface)
{
  std::vector<double> us;
  for (int i = -10; i <= 10; ++i)
    us.push_back(2.0 * i);
  return straightPasses(surface, us, 25.0, 2.0);
}

struct Measured {
  pcl::PointCloud<pcl::PointXYZI> points;
  DeviationReport figures;
  Status status;
};

Measured
measured(const Sampled& scan, const CheckedPath& path, double chord_error = 0.005, int threads = 0)
{
  DeviationEstimation<pcl::PointXYZ> deviation;
  deviation.setInputCloud(toCloud(scan.points));
  deviation.setInputToolpath(toolpath(path));
  deviation.setChordError(chord_error);
  deviation.setNumberOfThreads(threads);
  Measured result;
  deviation.compute(result.points);
  result.figures = deviation.getReport();
  result.status = deviation.getStatus();
  return result;
}

} // namespace

TEST(DeviationEstimation, AnotherPartIsAskedForOnlyWhereMostPointsHaveNoSurface)
{
  const SurfacePtr part = saddle();
  const Sampled scan = sampleUniform(*part, 30000, 5);
  for (const double share : {0.2, 0.8}) {
    CheckedPath path = passes(*part);
    const auto lifted = static_cast<std::size_t>(share * static_cast<double>(path.size()));
    for (std::size_t i = 0; i < lifted; ++i)
      path.contacts[i].z() += 500.0;
    const Measured m = measured(scan, path);
    ASSERT_TRUE(m.status.ok()) << m.status.message();
    EXPECT_EQ(m.figures.unmeasured, lifted);
    std::string said;
    for (const pcl_spiral::Diagnostic& warning : m.figures.warnings)
      said += warning.text();
    EXPECT_EQ(said.find("another part") != std::string::npos, share > 0.5) << said;
    EXPECT_EQ(said.find("cannot be judged there") != std::string::npos, share < 0.5) << said;
  }
}

TEST(DeviationEstimation, HalfASpacingBeyondTheRimIsTheRimWhereTheOutermostPointsAreSparse)
{
  constexpr double side = 40.0;
  constexpr int count = 3000;
  const double half_spacing = 0.5 * side / std::sqrt(count);
  std::size_t above = 0;
  for (int seed = 15; seed <= 20; ++seed) {
    Random random(seed);
    std::vector<Eigen::Vector3d> scan;
    for (int i = 0; i < count; ++i)
      scan.emplace_back(random.uniform(0.0, side), random.uniform(0.0, side), 0.0);
    BoundaryLoops<pcl::PointXYZ> boundary;
    boundary.setInputCloud(toCloud(scan));
    std::vector<BoundaryLoop> loops;
    boundary.compute(loops);
    ASSERT_TRUE(boundary.getStatus().ok()) << boundary.getStatus().message();
    CheckedPath path;
    const Polyline& rim = loops.front().curve;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Eigen::Vector3d way = (rim[(i + 1) % rim.size()] - rim[i]).normalized();
      path.contacts.push_back(0.5 * (rim[i] + rim[(i + 1) % rim.size()]) + 0.95 * half_spacing * way.cross(Eigen::Vector3d::UnitZ()));
      path.normals.push_back(Eigen::Vector3d::UnitZ());
    }
    EXPECT_EQ(measured({scan, {}}, path).figures.unmeasured, 0U) << seed;
    for (Eigen::Vector3d& contact : path.contacts)
      contact.z() += 0.8 * half_spacing;
    above += measured({scan, {}}, path).figures.unmeasured;
  }
  EXPECT_GT(above, 0U) << "over the rim is not at it";
}

TEST(DeviationEstimation, APathOnTheSurfaceHasNone)
{
  const SurfacePtr surface = saddle();
  const CheckedPath path = passes(*surface);
  const Measured m = measured(sampleUniform(*surface, 20000, 1), path);
  ASSERT_TRUE(m.status.ok()) << m.status.message();
  EXPECT_EQ(m.figures.measured, path.size());
  EXPECT_LT(std::abs(m.figures.max.value), 2e-4);
  EXPECT_LT(m.figures.rms, 5e-5);
  EXPECT_LT(m.figures.normal_error.value, 0.1);
  EXPECT_EQ(m.figures.opposed, 0u);
  EXPECT_TRUE(m.figures.warnings.empty());
}

TEST(DeviationEstimation, KnownOffsetsComeBackWithTheirSign)
{
  const SurfacePtr surface = saddle();
  CheckedPath path = passes(*surface);
  Random random(2);
  std::vector<double> offsets;
  double squares = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    offsets.push_back(0.05 * random.normal());
    squares += offsets[i] * offsets[i];
    path.contacts[i] += offsets[i] * path.normals[i];
  }
  const Measured m = measured(sampleUniform(*surface, 20000, 1), path);
  ASSERT_EQ(m.points.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i)
    EXPECT_NEAR(m.points[i].intensity, offsets[i], 3e-4);
  EXPECT_NEAR(m.figures.rms, std::sqrt(squares / static_cast<double>(path.size())), 1e-4);
}

TEST(DeviationEstimation, OnePointOffIsFound)
{
  const SurfacePtr surface = saddle();
  CheckedPath path = passes(*surface);
  path.contacts[300] -= 0.02 * path.normals[300];
  const Measured m = measured(sampleUniform(*surface, 20000, 1), path);
  EXPECT_NEAR(m.figures.max.value, -0.02, 2e-4);
  EXPECT_EQ(m.figures.max.index, 300u);
  EXPECT_LT((m.figures.max.position - path.contacts[300]).norm(), 1e-5);
}

TEST(DeviationEstimation, OneNormalOffIsFound)
{
  const SurfacePtr surface = saddle();
  CheckedPath path = passes(*surface);
  const Eigen::Vector3d side = path.normals[222].unitOrthogonal();
  path.normals[222] = std::cos(5 * degree) * path.normals[222] + std::sin(5 * degree) * side;
  const Measured m = measured(sampleUniform(*surface, 20000, 1), path);
  EXPECT_NEAR(m.figures.normal_error.value, 5.0, 0.05);
  EXPECT_EQ(m.figures.normal_error.index, 222u);
  EXPECT_NEAR(m.figures.motion.normal_change.value, 5.0, 1.0);
}

TEST(DeviationEstimation, ReversedNormalsAreReportedWithTheirPlace)
{
  const SurfacePtr surface = saddle();
  CheckedPath path = passes(*surface);
  path.normals[123] *= -1.0;
  Measured m = measured(sampleUniform(*surface, 20000, 1), path);
  EXPECT_EQ(m.figures.opposed, 1u);
  EXPECT_EQ(m.figures.first_opposed.index, 123u);
  EXPECT_EQ(m.figures.inward_axes, 1u); // the axis is on the side of the normal
  EXPECT_EQ(m.figures.warnings.size(), 2u);
  path.normals[123] *= -1.0;
  for (Eigen::Vector3d& n : path.normals)
    n = -n;
  m = measured(sampleUniform(*surface, 20000, 1), path);
  EXPECT_EQ(m.figures.opposed, path.size());
  ASSERT_EQ(m.figures.warnings.size(), 1u);
  EXPECT_NE(m.figures.warnings[0].text().find("reversed"), std::string::npos);
}

TEST(DeviationEstimation, NoiseIsMeasuredAndWhatItHidesIsSaid)
{
  const double sigma = 0.02;
  const SurfacePtr surface = saddle();
  const CheckedPath path = passes(*surface);
  Sampled scan = sampleUniform(*surface, 40000, 1);
  addNoise(scan, sigma, 7);
  const Measured m = measured(scan, path, 0.005);
  EXPECT_NEAR(m.figures.noise, sigma, 0.05 * sigma);
  // The path is on the exact surface: all its deviation is noise of the fit, as predicted.
  EXPECT_NEAR(m.figures.rms, m.figures.fit_noise, 0.25 * m.figures.fit_noise);
  ASSERT_EQ(m.figures.warnings.size(), 1u);
  EXPECT_NE(m.figures.warnings[0].text().find("chord error asked for, 0.005"), std::string::npos);
  EXPECT_NE(m.figures.warnings[0].text().find("cannot show"), std::string::npos);
  EXPECT_TRUE(measured(scan, path, 0.05).figures.warnings.empty());
}

TEST(DeviationEstimation, AFalseEchoIsNoDeviation)
{
  const double sigma = 0.02;
  const SurfacePtr surface = saddle();
  const CheckedPath path = passes(*surface);
  Sampled scan = sampleUniform(*surface, 40000, 1);
  addNoise(scan, sigma, 7);
  const Measured clean = measured(scan, path);
  Random random(3);
  for (std::size_t i = 0; i < scan.points.size(); i += 1 + random.below(200)) // 1 %, 0.2 to 5 mm off
    scan.points[i] += random.uniform(0.2, 5.0) * scan.normals[i];
  const Measured dirty = measured(scan, path);
  EXPECT_LT(std::abs(dirty.figures.max.value), 1.25 * std::abs(clean.figures.max.value));
  EXPECT_LT(dirty.figures.rms, 1.1 * clean.figures.rms);
}

TEST(DeviationEstimation, AGapOfTheScanIsNotJudged)
{
  const SurfacePtr surface = saddle();
  Sampled scan = sampleUniform(*surface, 40000, 1);
  const Eigen::Vector3d middle = surface->lift({4.0, 5.0});
  Sampled seen;
  for (std::size_t i = 0; i < scan.points.size(); ++i)
    if ((scan.points[i] - middle).norm() > 2.4) {
      seen.points.push_back(scan.points[i]);
      seen.normals.push_back(scan.normals[i]);
    }
  CheckedPath path = passes(*surface);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < path.size(); ++i)
    if ((path.contacts[i] - middle).norm() < 2.1) {
      path.contacts[i] -= 0.05 * path.normals[i];
      ++inside;
    }
  ASSERT_GT(inside, 2u);
  const Measured m = measured(seen, path);
  EXPECT_EQ(m.figures.in_gaps, inside);
  EXPECT_LE(m.figures.in_gaps, 4 * inside);
  EXPECT_NEAR(m.figures.gap_max.value, -0.05, 0.005);
  EXPECT_LT(std::abs(m.figures.max.value), 0.002);
  ASSERT_EQ(m.figures.warnings.size(), 1u);
  EXPECT_NE(m.figures.warnings[0].text().find("gaps of the scan"), std::string::npos);
  const Measured whole = measured(scan, path); // if the scan shows the place, the fault counts
  EXPECT_EQ(whole.figures.in_gaps, 0u);
  EXPECT_NEAR(whole.figures.max.value, -0.05, 0.005);
}

TEST(DeviationEstimation, SeesWhatAPlannersFitHasSmoothedAway)
{
  // Waves of 0.2 mm, 15 mm long; the path is on wide quadratic fits to the same points, which flatten the waves.
  const auto height = [](double x) { return 0.2 * std::sin(2.0 * M_PI * x / 15.0); };
  Random random(2);
  Sampled scan;
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 10000; ++i) {
    const double x = random.uniform(-50.0, 50.0);
    scan.points.emplace_back(x, random.uniform(-50.0, 50.0), height(x));
    points.push_back(scan.points.back().cast<float>());
  }
  SurfaceGraph graph;
  ASSERT_TRUE(graph.build(points, SurfaceGraphOptions()).ok());
  const MlsSurface smoothed(graph, 96);
  CheckedPath path;
  double largest = 0.0;
  for (double y = -30.0; y <= 30.0; y += 5.0)
    for (double x = -30.0; x <= 30.0; x += 0.5) {
      const SurfaceFoot foot = smoothed.project(Eigen::Vector3d(x, y, height(x)));
      ASSERT_TRUE(foot.valid);
      path.contacts.push_back(foot.position);
      path.normals.push_back(foot.normal);
      largest = std::max(largest, std::abs(foot.position.z() - height(foot.position.x())));
    }
  EXPECT_GT(largest, 0.004);
  EXPECT_NEAR(std::abs(measured(scan, path).figures.max.value), largest, 0.1 * largest);
}

TEST(DeviationEstimation, MotionFiguresNameThePlace)
{
  CheckedPath line;
  for (int i = 0; i < 20; ++i) {
    line.contacts.push_back({i < 10 ? 1.0 * i : 9.0, i < 10 ? 0.0 : i - 9.0, 0.0});
    line.normals.push_back(Eigen::Vector3d::UnitZ());
  }
  line.contacts[15].y() += 0.5;
  CutterPath path = cutterPath(line);
  path.axes.assign(20, Eigen::Vector3d::UnitZ());
  path.axes[4] = Eigen::Vector3d(std::sin(3 * degree), 0.0, std::cos(3 * degree));
  const PathMotion motion = pathMotion(path);
  EXPECT_NEAR(motion.length, 19.0, 1e-12);
  EXPECT_NEAR(motion.gap.value, 1.5, 1e-12);
  EXPECT_EQ(motion.gap.index, 14u);
  EXPECT_NEAR(motion.turn.value, 90.0, 1e-9);
  EXPECT_EQ(motion.turn.index, 9u);
  EXPECT_NEAR(motion.axis_change.value, 3.0, 1e-9);
  EXPECT_EQ(motion.axis_change.index, 3u);
}

TEST(DeviationEstimation, ThreadsChangeNothingAndBadInputIsNamed)
{
  const SurfacePtr surface = saddle();
  const CheckedPath path = passes(*surface);
  const Sampled scan = sampleUniform(*surface, 5000, 1);
  const Measured one = measured(scan, path, 0.005, 1), two = measured(scan, path, 0.005, 2);
  for (std::size_t i = 0; i < path.size(); ++i)
    ASSERT_EQ(one.points[i].intensity, two.points[i].intensity);

  DeviationEstimation<pcl::PointXYZ> deviation;
  pcl::PointCloud<pcl::PointXYZI> out;
  deviation.compute(out);
  EXPECT_EQ(deviation.getStatus().code(), StatusCode::InvalidInput);
  deviation.setInputCloud(toCloud(scan.points));
  deviation.compute(out);
  EXPECT_NE(deviation.getStatus().message().find("setInputToolpath"), std::string::npos);
  auto broken = toolpath(path);
  (*broken)[17].z = std::numeric_limits<float>::quiet_NaN();
  deviation.setInputToolpath(broken);
  deviation.compute(out);
  EXPECT_NE(deviation.getStatus().message().find("point 17"), std::string::npos);
  auto elsewhere = toolpath(path);
  for (ToolpathPoint& p : *elsewhere)
    p.x += 1000.0f;
  deviation.setInputToolpath(elsewhere);
  deviation.compute(out);
  EXPECT_FALSE(deviation.getStatus().ok());
  EXPECT_TRUE(out.empty());
  deviation.setInputToolpath(toolpath(path));
  deviation.setProgressCallback([](double, const std::string&) { return false; });
  deviation.compute(out);
  EXPECT_EQ(deviation.getStatus().code(), StatusCode::Cancelled);
}

} // namespace deviation_estimation_test
