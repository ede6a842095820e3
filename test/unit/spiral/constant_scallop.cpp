// SPDX-License-Identifier: BSD-3-Clause
// SpiralMethod::ConstantScallop with the generator: material left, direction of travel, refusals.
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include "support/outline_loops.h"
#include "support/path_judge.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <optional>

namespace constant_scallop_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

using Generator = SpiralToolpathGenerator<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;

SurfacePtr
twoHoles()
{
  return flat(Region({rectangle(90.0, 60.0), circle({-20.0, 4.0}, 9.0), circle({21.0, -5.0}, 11.0)}));
}

void
setUp(const AnalyticSurface& part, std::size_t count, Generator& generator)
{
  generator.setInputCloud(toCloud(sampleUniform(part, count, 5).points));
  generator.setMethod(SpiralMethod::ConstantScallop);
  generator.setToolRadius(5.0);
  generator.setScallopHeight(0.1);
  generator.setQuiet(true);
}

CheckedPath
checked(const Path& path)
{
  CheckedPath result;
  for (const auto& p : path) {
    result.contacts.push_back(p.getVector3fMap().cast<double>());
    result.normals.push_back(p.getNormalVector3fMap().cast<double>());
  }
  return result;
}

/** Twice the signed area inside the last tenth of an inward path, or the first tenth of an outward path. */
double
turning(const Path& path)
{
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += path[i - 1].x * path[i].y - path[i].x * path[i - 1].y;
  return sum;
}

/** Distance of a place from the rim of twoHoles. */
double
checkedRim(const ToolpathPoint& p)
{
  return std::min(45.0 - std::abs(p.x), 30.0 - std::abs(p.y));
}

} // namespace

TEST(ConstantScallop, CoversAPartWithTwoHolesInOnePath)
{
  const SurfacePtr part = twoHoles();
  Generator generator;
  setUp(*part, 5000, generator);
  Path path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  JudgeSettings settings;
  settings.tool_radius = 5.0;
  settings.scallop_height = 0.1;
  settings.samples = 50000;
  settings.spacing = generator.getReport().spacing;
  std::vector<Polyline> curves;
  for (const BoundaryLoop& loop : generator.getReport().loops)
    curves.push_back(loop.curve);
  const JudgedReport figures = judgedPath(*part, curves, checked(path), settings);
  EXPECT_EQ(figures.rims_missed, 0u);
  EXPECT_TRUE(figures.crossings.empty());
  EXPECT_EQ(figures.passes(), 1u);
  EXPECT_LT(figures.lengthRatio(), 1.12); // about twelve turns
  EXPECT_NEAR(generator.getReport().least_length, figures.least, 0.02 * figures.least);
}

TEST(ConstantScallop, GoesTheWayAskedFor)
{
  const SurfacePtr part = flat(Region({circle(Vector2d::Zero(), 40.0)}));
  for (const SpiralDirection direction : {SpiralDirection::Inward, SpiralDirection::Outward})
    for (const SpiralSense sense : {SpiralSense::CounterClockwise, SpiralSense::Clockwise}) {
      Generator generator;
      setUp(*part, 2500, generator);
      generator.setDirection(direction);
      generator.setSense(sense);
      Path path;
      generator.compute(path);
      ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
      EXPECT_EQ(turning(path) > 0.0, sense == SpiralSense::CounterClockwise);
      const double first = std::hypot(path.front().x, path.front().y), last = std::hypot(path.back().x, path.back().y);
      EXPECT_EQ(first > last, direction == SpiralDirection::Inward);
      EXPECT_GE(path.back().turn, path.front().turn);
    }
}

/** Not every place of the rim can be reached from the loops inside: then the nearest reachable place is used, with a warning. */
TEST(ConstantScallop, BeginsAtTheRimNearThePlaceAskedFor)
{
  const auto off = [](const std::optional<Vector3d>& asked, const Vector3d& place, bool& warned) {
    Generator generator;
    setUp(*twoHoles(), 5000, generator);
    generator.setDirection(SpiralDirection::Inward);
    if (asked)
      generator.setStartPoint(*asked);
    Path path;
    generator.compute(path);
    EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
    EXPECT_LT(checkedRim(path.front()), 1.0);
    const auto& warnings = generator.getReport().warnings;
    warned = std::any_of(warnings.begin(), warnings.end(),
                         [](const pcl_spiral::Diagnostic& w) { return w.text().find("start point") != std::string::npos; });
    return (path.front().getVector3fMap().cast<double>() - place).norm();
  };
  bool warned = false, unused = false;
  for (const Vector3d& place : {Vector3d(45.0, 10.0, 0.0), Vector3d(-45.0, -12.0, 0.0), Vector3d(5.0, 30.0, 0.0)}) {
    const double found = off(place, place, warned), otherwise = off(std::nullopt, place, unused);
    std::printf("  %.1f mm from the place asked for, %.1f without asking\n", found, otherwise);
    EXPECT_LE(found, otherwise + 1.0);
    EXPECT_EQ(warned, found > 0.05 * 300.0);
  }
}

/** A bridge from the rim's loop to the next. An earlier fault: places beyond the rim pulled the path out of the part. */
TEST(ConstantScallop, NothingIsPulledBeyondTheRim)
{
  const PlaneLoop waist{{-38, -18}, {-8, -18}, {-8, -2}, {8, -2}, {8, -18}, {38, -18},
                        {38, 18},   {8, 18},   {8, 2},   {-8, 2}, {-8, 18}, {-38, 18}};
  Generator generator;
  setUp(*flat(Region({waist})), 4500, generator);
  Path path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  for (const ToolpathPoint& p : path)
    if (std::abs(p.x) > 11.0 && std::abs(p.x) < 35.0) // at straight sides the outline is accurate
      ASSERT_LT(std::abs(p.y), 18.4) << p.x;
}

TEST(ConstantScallop, ThreadsChangeNothing)
{
  const SurfacePtr part = twoHoles();
  Path paths[2];
  for (int i = 0; i < 2; ++i) {
    Generator generator;
    setUp(*part, 4000, generator);
    generator.setNumberOfThreads(i == 0 ? 1 : 3);
    generator.compute(paths[i]);
    ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  }
  ASSERT_EQ(paths[0].size(), paths[1].size());
  for (std::size_t i = 0; i < paths[0].size(); ++i)
    ASSERT_EQ(std::memcmp(paths[0][i].data, paths[1][i].data, 3 * sizeof(float)), 0) << i;
}

TEST(ConstantScallop, HolesAreBridgedWhereOneBoundaryIsAskedFor)
{
  const SurfacePtr part = flat(Region({rectangle(90.0, 60.0), circle({-20.0, 4.0}, 7.0)}));
  Generator generator;
  setUp(*part, 4000, generator);
  generator.setBoundaryMode(BoundaryMode::OneBoundary);
  Path path;
  generator.compute(path);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  EXPECT_GT(generator.getReport().gap_points, 0u);
}

TEST(ConstantScallop, RadialLinesAreRefused)
{
  Generator generator;
  setUp(*twoHoles(), 3000, generator);
  generator.setRadialLines(RadialLineSet());
  Path path;
  generator.compute(path);
  EXPECT_EQ(generator.getStatus().code(), StatusCode::InvalidArgument);
  EXPECT_NE(generator.getStatus().message().find("clearRadialLines"), std::string::npos);
}

TEST(ConstantScallop, IsCancelled)
{
  Generator generator;
  setUp(*twoHoles(), 3000, generator);
  generator.setProgressCallback([](double share, const std::string&) { return share < 0.5; });
  Path path;
  generator.compute(path);
  EXPECT_EQ(generator.getStatus().code(), StatusCode::Cancelled);
  EXPECT_TRUE(path.empty());
}

} // namespace constant_scallop_test
