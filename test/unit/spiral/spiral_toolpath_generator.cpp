// SPDX-License-Identifier: BSD-3-Clause
// The generator for a PCL user: ends, axes, sides, orders, threads, progress, refusals.
#include "support/sampling.h"

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace spiral_toolpath_generator_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Generator = SpiralToolpathGenerator<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;

constexpr double radius = 80.0, reach = 30.0;

const test::Sampled&
ballPoints()
{
  static const test::Sampled sampled = test::sampleUniform(*test::ball(radius, test::Region({test::circle({0, 0}, reach)})), 4000, 31);
  return sampled;
}

void
setUp(Generator& spiral, const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& cloud)
{
  spiral.setInputCloud(cloud);
  spiral.setMethod(SpiralMethod::Radial); // other methods: constant_scallop, published_generator; the choice: method_choice
  spiral.setToolRadius(6.0);
  spiral.setScallopHeight(0.1);
  spiral.setChordError(0.01);
}

bool
sameBytes(const Path& a, const Path& b)
{
  const auto same = [](const ToolpathPoint& p, const ToolpathPoint& q) {
    return !std::memcmp(p.data, q.data, 12) && !std::memcmp(p.data_n, q.data_n, 12) && !std::memcmp(p.axis, q.axis, 12) &&
           p.arc_length == q.arc_length && p.turn == q.turn;
  };
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same);
}

TEST(SpiralToolpathGenerator, FromTheCentreToTheRim)
{
  const auto cloud = test::toCloud(ballPoints().points);
  cloud->header.frame_id = "part";
  Generator spiral;
  setUp(spiral, cloud);
  spiral.setCenter({2.0, -1.0, 80.0});
  spiral.setStartPoint({0.0, -40.0, 70.0});
  spiral.setAxisSmoothing(0.0); // the exact tilt
  Path path;
  spiral.compute(path);
  ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  const SpiralReport& report = spiral.getReport();
  EXPECT_EQ(path.header.frame_id, "part");
  EXPECT_EQ(report.path_points, path.size());
  EXPECT_EQ(report.used_points, 4000u);
  const Vector3d first = path.front().getVector3fMap().cast<double>(), last = path.back().getVector3fMap().cast<double>();
  EXPECT_NEAR((first.head<2>() - Eigen::Vector2d(2, -1)).norm(), 0.0, 0.05); // along the radius of the ball
  EXPECT_NEAR(last.x(), 0.0, report.spacing);
  EXPECT_NEAR(last.y(), -reach, report.spacing);
  double length = 0.0, smallest_lean = 90.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vector3d p = path[i].getVector3fMap().cast<double>(), n = path[i].getNormalVector3fMap().cast<double>();
    const Vector3d axis = path[i].getAxisVector3fMap().cast<double>();
    EXPECT_NEAR(p.norm(), radius, 0.02);
    EXPECT_GT(n.dot(p.normalized()), std::cos(0.01));
    const double lean = std::acos(std::min(1.0, axis.normalized().dot(n.normalized()))) * 180.0 / M_PI;
    EXPECT_LT(lean, 15.1);
    if (path[i].turn > 0.5 * report.turns && path[i].turn < report.turns - 1.0)
      smallest_lean = std::min(smallest_lean, lean);
    if (i == 0)
      continue;
    EXPECT_GE(path[i].turn, path[i - 1].turn);
    const double step = (p - path[i - 1].getVector3fMap().cast<double>()).norm();
    EXPECT_LE(step, 1.05 * report.largest_allowed_step);
    length += step;
    EXPECT_NEAR(path[i].arc_length, length, 1e-3);
  }
  EXPECT_GT(smallest_lean, 14.9);
  EXPECT_EQ(path.back().turn, static_cast<float>(report.turns));
}

/** Angle swept about the z axis from point to point, radians; counter-clockwise is positive. */
double
winding(const Path& path)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector2d a = path[i - 1].getVector3fMap().cast<double>().head<2>();
    const Eigen::Vector2d b = path[i].getVector3fMap().cast<double>().head<2>();
    sum += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return sum;
}

TEST(SpiralToolpathGenerator, SenseIsTheTravelsOutwardAndInward)
{
  for (const double hole : {0.0, 10.0}) { // a dome and a ring
    std::vector<test::PlaneLoop> loops{test::circle({0, 0}, reach)};
    if (hole > 0.0)
      loops.push_back(test::circle({0, 0}, hole));
    const auto cloud = test::toCloud(test::sampleUniform(*test::ball(radius, test::Region(loops)), 4000, 31).points);
    for (const SpiralSense sense : {SpiralSense::CounterClockwise, SpiralSense::Clockwise})
      for (const SpiralDirection direction : {SpiralDirection::Outward, SpiralDirection::Inward}) {
        Generator spiral;
        setUp(spiral, cloud);
        spiral.setSense(sense);
        spiral.setDirection(direction);
        if (hole == 0.0)
          spiral.setCenter({0.0, 0.0, radius});
        Path path;
        spiral.compute(path);
        ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
        const double turns = path.back().turn; // also round the loops
        EXPECT_NEAR(winding(path) / (2.0 * M_PI), sense == SpiralSense::CounterClockwise ? turns : -turns, 0.5);
        const auto fromAxis = [](const ToolpathPoint& p) { return std::hypot(p.x, p.y); };
        const bool outward = direction == SpiralDirection::Outward;
        EXPECT_NEAR(fromAxis(outward ? path.back() : path.front()), reach, 1.0);
        EXPECT_NEAR(fromAxis(outward ? path.front() : path.back()), hole, 1.0);
      }
  }
}

TEST(SpiralToolpathGenerator, TiltIsTheUsersOwn)
{
  for (const double tilt : {0.0, -30.0}) {
    Generator spiral;
    setUp(spiral, test::toCloud(ballPoints().points));
    spiral.setTiltAngle(tilt);
    spiral.setAxisSmoothing(0.0);
    Path path;
    spiral.compute(path);
    ASSERT_TRUE(spiral.getStatus().ok());
    const std::size_t i = path.size() / 2;
    const Eigen::Vector3f n = path[i].getNormalVector3fMap(), axis = path[i].getAxisVector3fMap();
    const Eigen::Vector3f feed = path[i + 1].getVector3fMap() - path[i - 1].getVector3fMap();
    const double side = std::asin(axis.dot(feed.cross(n).normalized())) * 180.0 / M_PI;
    EXPECT_NEAR(side, tilt, 0.2);
  }
}

TEST(SpiralToolpathGenerator, SmoothedAxesStayNearTheTilt)
{
  Generator spiral;
  setUp(spiral, test::toCloud(ballPoints().points));
  Path plain, smooth;
  spiral.setAxisSmoothing(0.0);
  spiral.compute(plain);
  ASSERT_TRUE(spiral.getStatus().ok());
  const double rate = spiral.getReport().largest_axis_rate;
  EXPECT_GT(rate, 5.0) << "up to the limit at the centre";
  spiral.setAxisSmoothing(20.0);
  spiral.compute(smooth);
  ASSERT_TRUE(spiral.getStatus().ok());
  const SpiralReport& report = spiral.getReport();
  EXPECT_LE(report.largest_axis_rate, 10.0 * 1.00001);
  ASSERT_EQ(smooth.size(), plain.size());
  double sum = 0.0, lean = 0.0;
  for (std::size_t i = 0; i < smooth.size(); ++i) {
    const Vector3d axis = smooth[i].getAxisVector3fMap().cast<double>(), n = smooth[i].getNormalVector3fMap().cast<double>();
    EXPECT_EQ(smooth[i].getVector3fMap(), plain[i].getVector3fMap()) << "contacts are not for the axis to move";
    sum += std::acos(std::min(1.0, axis.dot(plain[i].getAxisVector3fMap().cast<double>()))) * 180.0 / M_PI;
    lean = std::max(lean, std::acos(std::min(1.0, axis.dot(n))) * 180.0 / M_PI);
  }
  EXPECT_GT(sum, 0.0);
  EXPECT_LT(sum / static_cast<double>(smooth.size()), 2.0);
  EXPECT_NEAR(report.largest_axis_lean, lean, 0.05);
  EXPECT_LT(lean, 25.0);
}

TEST(SpiralToolpathGenerator, OrderThreadsAndBadPointsChangeNothing)
{
  Generator spiral;
  setUp(spiral, test::toCloud(ballPoints().points));
  Path path, other;
  spiral.compute(path);
  ASSERT_TRUE(spiral.getStatus().ok());
  spiral.setNumberOfThreads(3);
  spiral.compute(other);
  EXPECT_TRUE(sameBytes(path, other));

  const auto mixed = test::toCloud({});
  for (const std::size_t i : test::shuffled(4000, 32)) {
    const auto& p = ballPoints().points[i];
    mixed->push_back(pcl::PointXYZ(p.x(), p.y(), p.z()));
  }
  mixed->push_back((*mixed)[7]);
  mixed->push_back(pcl::PointXYZ(0, 0, std::numeric_limits<float>::quiet_NaN()));
  const pcl::Indices wanted = [&] {
    pcl::Indices all(mixed->size());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = static_cast<pcl::index_t>(i);
    return all;
  }();
  mixed->push_back(pcl::PointXYZ(0, 0, 500)); // not among the indices
  spiral.setInputCloud(mixed);
  spiral.setIndices(pcl::make_shared<pcl::Indices>(wanted));
  spiral.compute(other);
  ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  EXPECT_TRUE(sameBytes(path, other));
  EXPECT_EQ(spiral.getReport().input_points, 4002u);
  EXPECT_EQ(spiral.getReport().nonfinite_points, 1u);
  EXPECT_EQ(spiral.getReport().duplicate_points, 1u);
}

TEST(SpiralToolpathGenerator, NormalsTellTheSideAndFlipTurnsIt)
{
  const auto outward = test::toNormals(ballPoints().normals), inward = test::toNormals(ballPoints().normals);
  for (auto& n : *inward)
    n.getNormalVector3fMap() *= -1.0f;
  Generator spiral;
  setUp(spiral, test::toCloud(ballPoints().points));
  Path path;
  for (const auto& [normals, flip, side] :
       {std::tuple{outward, false, 1.0f}, std::tuple{inward, false, -1.0f}, std::tuple{outward, true, -1.0f}}) {
    spiral.setInputNormals(normals);
    spiral.setFlipNormals(flip);
    spiral.compute(path);
    ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
    float turned = 0.0f; // seen from the cutter's side, the path runs counter-clockwise
    for (std::size_t i = 0; i < path.size(); ++i) {
      ASSERT_GT(side * path[i].getNormalVector3fMap().dot(path[i].getVector3fMap()), 0.99f * radius);
      if (i > 0)
        turned += path[i - 1].x * path[i].y - path[i - 1].y * path[i].x;
    }
    EXPECT_GT(side * turned, 0.0f);
  }
  // From inside the ball, the hollow has the radius of the ball.
  spiral.setToolRadius(radius + 1.0);
  spiral.setTightHandling(TightHandling::Refuse);
  spiral.compute(path);
  EXPECT_EQ(spiral.getStatus().code(), StatusCode::Failed);
  EXPECT_NE(spiral.getStatus().message().find("smaller tool"), std::string::npos) << spiral.getStatus().message();
  EXPECT_TRUE(path.empty());
}

TEST(SpiralToolpathGenerator, WarnsWhereTheSurfaceTurnsTheAxisTooFast)
{
  // On a ball of radius r the normal turns 180 / (pi r) degrees per mm.
  const double by_surface = 180.0 / M_PI / radius;
  for (const double share : {0.5, 20.0}) {
    SpiralSettings settings;
    settings.tool_radius = 6.0;
    settings.scallop_height = 0.1;
    settings.max_axis_rate = share * by_surface;
    Generator spiral;
    spiral.setInputCloud(test::toCloud(ballPoints().points));
    spiral.setSettings(settings);
    Path path;
    spiral.compute(path);
    ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
    bool warned = false;
    for (const pcl_spiral::Diagnostic& warning : spiral.getReport().warnings)
      warned = warned || warning.text().find("axis rate") != std::string::npos;
    EXPECT_EQ(warned, share < 1.0);
  }
}

TEST(SpiralToolpathGenerator, RefusesACentreOfARing)
{
  const auto region = test::Region({test::circle({0, 0}, reach), test::circle({0, 0}, 10.0)});
  Generator spiral;
  setUp(spiral, test::toCloud(test::sampleUniform(*test::ball(radius, region), 4000, 31).points));
  spiral.setCenter({0, 0, 80});
  Path path;
  spiral.compute(path);
  EXPECT_EQ(spiral.getStatus().code(), StatusCode::InvalidArgument);
  EXPECT_NE(spiral.getStatus().message().find("two boundaries"), std::string::npos);
  EXPECT_TRUE(path.empty());
}

TEST(SpiralToolpathGenerator, ProgressGrowsAndCancels)
{
  Generator spiral;
  setUp(spiral, test::toCloud(ballPoints().points));
  std::vector<double> shares;
  spiral.setProgressCallback([&](double share, const std::string& stage) {
    EXPECT_FALSE(stage.empty());
    shares.push_back(share);
    return true;
  });
  Path path;
  spiral.compute(path);
  ASSERT_TRUE(spiral.getStatus().ok());
  ASSERT_GT(shares.size(), 5u);
  EXPECT_GE(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  for (const std::size_t stop : {std::size_t(1), shares.size() / 2, shares.size()}) {
    std::size_t calls = 0;
    spiral.setProgressCallback([&](double, const std::string&) { return ++calls < stop; });
    spiral.compute(path);
    EXPECT_EQ(spiral.getStatus().code(), StatusCode::Cancelled);
    EXPECT_TRUE(path.empty());
    EXPECT_EQ(calls, stop); // no call after it returned false
  }
}

TEST(SpiralToolpathGenerator, RefusesWithAnEmptyPath)
{
  const auto cloud = test::toCloud(ballPoints().points);
  const auto refused = [](Generator& spiral, StatusCode code, const std::string& word) {
    Path path;
    path.resize(7);
    spiral.compute(path);
    EXPECT_EQ(spiral.getStatus().code(), code) << word;
    EXPECT_NE(spiral.getStatus().message().find(word), std::string::npos) << spiral.getStatus().message();
    EXPECT_TRUE(path.empty()) << word;
  };
  Generator fresh;
  EXPECT_EQ(fresh.getStatus().code(), StatusCode::NotComputed);
  refused(fresh, StatusCode::InvalidArgument, "tool radius");
  fresh.setToolRadius(6.0);
  refused(fresh, StatusCode::InvalidArgument, "scallop height");
  fresh.setScallopHeight(0.1);
  refused(fresh, StatusCode::InvalidInput, "setInputCloud");
  fresh.setInputCloud(test::toCloud({}));
  refused(fresh, StatusCode::InvalidInput, "empty");
  fresh.setInputCloud(test::toCloud(std::vector<Vector3d>(60, Vector3d::Constant(std::nan("")))));
  refused(fresh, StatusCode::InvalidInput, "finite");
  fresh.setInputCloud(test::toCloud({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  refused(fresh, StatusCode::InvalidInput, "50");

  const auto with = [&](const std::function<void(Generator&)>& change, StatusCode code, const std::string& word) {
    Generator spiral;
    setUp(spiral, cloud);
    change(spiral);
    refused(spiral, code, word);
  };
  const auto argument = StatusCode::InvalidArgument;
  with([](Generator& g) { g.setScallopHeight(6.0); }, argument, "below the tool radius, which is 6 mm");
  with([](Generator& g) { g.setChordError(-0.01); }, argument, "chord error");
  with([](Generator& g) { g.setTiltAngle(90.0); }, argument, "tilt");
  with([](Generator& g) { g.setToolRadius(std::nan("")); }, argument, "tool radius");
  with([](Generator& g) { g.setNumberOfThreads(-1); }, argument, "threads");
  with([](Generator& g) { g.setCenter({0, 0, 120}); }, argument, "centre");
  with([](Generator& g) { g.setInputNormals(test::toNormals({Vector3d(0, 0, 1)})); }, StatusCode::InvalidInput, "normals");
  with([](Generator& g) { g.setBoundaryMode(BoundaryMode::TwoBoundaries); }, argument, "two boundaries");
  with([](Generator& g) { g.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{3, 4000})); }, StatusCode::InvalidInput, "4000");
}

} // namespace

} // namespace spiral_toolpath_generator_test
