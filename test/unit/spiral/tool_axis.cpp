// SPDX-License-Identifier: BSD-3-Clause
#include "core/tilted_axes.h"
#include <pcl_spiral/spiral/tool_axis.h>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace tool_axis_test {

using namespace pcl_spiral;
using Eigen::Vector3d;

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

struct TestPath {
  Polyline points;
  std::vector<Vector3d> normals;
};

/** An Archimedean spiral of pitch 1 mm projected onto a sphere of radius 200, from the pole. */
TestPath
sphereSpiral(double step, double end_radius)
{
  TestPath path;
  for (double angle = 0.0, r = 0.0; r < end_radius; angle += step / std::max(r, 0.2)) {
    r = angle / (2 * M_PI);
    const Vector3d n = Vector3d(r * std::cos(angle), r * std::sin(angle), std::sqrt(200.0 * 200.0 - r * r)) / 200.0;
    path.normals.push_back(n);
    path.points.push_back(200.0 * n);
  }
  return path;
}

double
angleBetween(const Vector3d& a, const Vector3d& b)
{
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

pcl::PointCloud<ToolpathPoint>::Ptr
toCloud(const TestPath& path)
{
  pcl::PointCloud<ToolpathPoint>::Ptr cloud(new pcl::PointCloud<ToolpathPoint>);
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    ToolpathPoint p;
    p.getVector3fMap() = path.points[i].cast<float>();
    p.getNormalVector3fMap() = path.normals[i].cast<float>();
    p.arc_length = static_cast<double>(i);
    cloud->push_back(p);
  }
  return cloud;
}

} // namespace

TEST(TiltedAxis, IsTheProductOfRotations)
{
  std::mt19937 random(1);
  std::normal_distribution<double> value;
  for (int i = 0; i < 100; ++i) {
    const Vector3d n = Vector3d(value(random), value(random), value(random)).normalized();
    const Vector3d f = n.unitOrthogonal();
    const double side = 0.5 * value(random), lead = 0.5 * value(random);
    const Vector3d expected = Eigen::AngleAxisd(side, f) * (Eigen::AngleAxisd(lead, Vector3d(n.cross(f))) * n);
    EXPECT_LT((tiltedAxis(n, f, side, lead) - expected).norm(), 1e-14);
    EXPECT_NEAR(std::cos(angleBetween(tiltedAxis(n, f, side, lead), n)), std::cos(side) * std::cos(lead), 1e-14);
  }
  const Vector3d x = Vector3d::UnitX(), z = Vector3d::UnitZ();
  EXPECT_LT(tiltedAxis(z, x, 15 * degree, 0.0).y(), 0.0) << "right of travel";
  EXPECT_GT(tiltedAxis(z, x, 0.0, 10 * degree).x(), 0.0) << "forward";
  EXPECT_EQ(tiltedAxis(z, Vector3d::Zero(), 0.3, 0.1), z);
}

TEST(FeedDirections, SecondOrderOnAnEllipseUnevenlySampled)
{
  std::vector<double> worst;
  for (double step : {0.02, 0.01}) {
    Polyline points;
    std::vector<double> angles;
    for (double a = 0.0; a < 3.0; a += step * (1.5 + std::sin(7 * a))) {
      angles.push_back(a);
      points.emplace_back(3.0 * std::cos(a), std::sin(a), 0.0);
    }
    const auto feeds = feedDirections(points, {points.size(), Vector3d::UnitZ()});
    worst.push_back(0.0);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Vector3d tangent = Vector3d(-3.0 * std::sin(angles[i]), std::cos(angles[i]), 0).normalized();
      worst.back() = std::max(worst.back(), (feeds[i] - tangent).norm());
    }
  }
  EXPECT_LT(worst[0], 5e-3);
  EXPECT_GT(worst[0] / worst[1], 3.5);
}

TEST(FeedDirections, RepeatedPointsShareOne)
{
  const Vector3d a(0, 0, 0), b(1, 0, 0), c(1, 1, 0);
  const std::vector<Vector3d> up(5, Vector3d::UnitZ());
  const auto feeds = feedDirections({a, b, b, b, c}, up);
  EXPECT_LT((feeds[1] - Vector3d(1, 1, 0).normalized()).norm(), 1e-15);
  EXPECT_EQ(feeds[1], feeds[3]);
  for (const Vector3d& f : feedDirections({a, a, a, a, a}, up))
    EXPECT_EQ(f, Vector3d::Zero());
  EXPECT_THROW(feedDirections({a, b}, up), std::invalid_argument);
}

TEST(TiltedAxes, LeanByBothAnglesEverywhere)
{
  const TestPath path = sphereSpiral(0.3, 9.0);
  const auto axes = tiltedAxes(path.points, path.normals, 15 * degree, 5 * degree);
  for (std::size_t i = 0; i < axes.size(); ++i)
    EXPECT_NEAR(axes[i].dot(path.normals[i]), std::cos(15 * degree) * std::cos(5 * degree), 1e-14);
  EXPECT_THROW(tiltedAxes(path.points, path.normals, 90 * degree, 0.0), std::invalid_argument);
  EXPECT_THROW(tiltedAxes(path.points, {Vector3d::UnitZ()}, 0.1, 0.0), std::invalid_argument);
}

TEST(TiltedAxes, SameFromEitherEnd)
{
  TestPath path = sphereSpiral(0.3, 9.0);
  const auto forward = tiltedAxes(path.points, path.normals, 15 * degree, 7 * degree);
  std::reverse(path.points.begin(), path.points.end());
  std::reverse(path.normals.begin(), path.normals.end());
  const auto back = tiltedAxes(path.points, path.normals, -15 * degree, -7 * degree);
  for (std::size_t i = 0; i < forward.size(); ++i)
    EXPECT_LT((forward[i] - back[forward.size() - 1 - i]).norm(), 1e-12) << i;
}

TEST(ToolAxisClass, EdgeOfTheSurfaceIsCountedNotHidden)
{
  TestPath path; // over a sharp ridge: the normal jumps by 60 degrees within 1 mm
  for (int i = -20; i <= 20; ++i) {
    path.points.emplace_back(0.5 * i, 0.0, -0.3 * std::abs(i));
    path.normals.emplace_back(Vector3d((i > 0 ? 1.0 : -1.0) * 0.5, 0.0, std::sqrt(0.75)));
  }
  ToolAxis tool_axis;
  tool_axis.setInputPath(toCloud(path));
  pcl::PointCloud<ToolpathPoint> out;
  tool_axis.compute(out);
  ASSERT_TRUE(tool_axis.getStatus().ok()) << tool_axis.getStatus().message();
  EXPECT_EQ(tool_axis.getExceededMoves(), 1u);
  EXPECT_LE(tool_axis.getField().getLargestAxisRate(), 10.0 * 1.00001);
  EXPECT_GT(tool_axis.getField().getLargestDeviation(), 20.0) << "half of the jump, less what the slope takes";
  EXPECT_GT(tool_axis.getField().getDeviatingPoints(), 3u);
  EXPECT_LT(tool_axis.getField().getLargestLean(), 60.0);
}

TEST(ToolAxisClass, SetsAxesAndReports)
{
  const auto path = toCloud(sphereSpiral(0.4, 10.0));
  ToolAxis tool_axis;
  EXPECT_EQ(tool_axis.getStatus().code(), StatusCode::NotComputed);
  tool_axis.setInputPath(path);
  tool_axis.setTiltAngle(-20.0);
  tool_axis.setMaxAxisRate(6.0);
  tool_axis.setAxisSmoothing(0.0);
  pcl::PointCloud<ToolpathPoint> out;
  tool_axis.compute(out);
  ASSERT_TRUE(tool_axis.getStatus().ok()) << tool_axis.getStatus().message();
  ASSERT_EQ(out.size(), path->size());
  EXPECT_EQ(out[7].arc_length, 7.0);
  EXPECT_EQ(out.back().getVector3fMap(), path->back().getVector3fMap());
  EXPECT_NEAR(out.back().getAxisVector3fMap().dot(out.back().getNormalVector3fMap()), std::cos(20 * degree), 1e-5);
  EXPECT_LE(tool_axis.getField().getLargestAxisRate(), 6.0 * 1.001);
  EXPECT_GT(tool_axis.getField().getDeviatingPoints(), 0u);
  tool_axis.compute(*path); // in place
  EXPECT_EQ(path->back().getAxisVector3fMap(), out.back().getAxisVector3fMap());
}

TEST(ToolAxisClass, SaysWhatIsWrong)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  ToolAxis tool_axis;
  pcl::PointCloud<ToolpathPoint> out;
  auto code = [&](const pcl::PointCloud<ToolpathPoint>::Ptr& path) {
    out.resize(3);
    tool_axis.setInputPath(path);
    tool_axis.compute(out);
    EXPECT_TRUE(out.empty());
    return tool_axis.getStatus().code();
  };
  const auto good = toCloud(sphereSpiral(0.4, 3.0));
  EXPECT_EQ(code(nullptr), StatusCode::InvalidInput);
  EXPECT_EQ(code(toCloud({{Vector3d::Zero()}, {Vector3d::UnitZ()}})), StatusCode::InvalidInput);
  auto bad = toCloud(sphereSpiral(0.4, 3.0));
  (*bad)[5].x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(code(bad), StatusCode::InvalidInput);
  EXPECT_NE(tool_axis.getStatus().message().find("point 5"), std::string::npos);
  bad = toCloud(sphereSpiral(0.4, 3.0));
  (*bad)[6].getNormalVector3fMap().setZero();
  EXPECT_EQ(code(bad), StatusCode::InvalidInput);
  tool_axis.setTiltAngle(90.0);
  EXPECT_EQ(code(good), StatusCode::InvalidArgument);
  tool_axis.setTiltAngle(15.0);
  tool_axis.setAxisSmoothing(-1.0);
  EXPECT_EQ(code(good), StatusCode::InvalidArgument);
  tool_axis.setAxisSmoothing(0.0);
  tool_axis.setMaxAxisRate(-1.0);
  EXPECT_EQ(code(good), StatusCode::InvalidArgument);
}

} // namespace tool_axis_test
