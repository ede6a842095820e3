// SPDX-License-Identifier: BSD-3-Clause
// A path composed by hand from public classes is byte for byte that of the generator; a user's own stage is in the middle.
#include "support/sampling.h"
#include "support/scratch_folder.h"
#include "support/surfaces.h"

#include <pcl_spiral/core/bspline_fit.h>
#include <pcl_spiral/features/boundary_loops.h>
#include <pcl_spiral/features/centroid_boundary_estimation.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/spiral/gap_bridging.h>
#include <pcl_spiral/spiral/impl/path_size.h>
#include <pcl_spiral/spiral/impl/stage_reports.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/spiral_path.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/surface/mls_projector.h>
#include <pcl_spiral/verify/deviation_estimation.h>

#include <pcl/console/print.h>
#include <pcl/surface/mls.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace stages_compose_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;

SpiralSettings
settings(unsigned int threads = 0)
{
  SpiralSettings s;
  s.method = SpiralMethod::Radial; // the stages of the other method: scallop_stages
  s.tool_radius = 6.0;
  s.scallop_height = 0.05;
  s.chord_error = 0.01;
  s.threads = threads;
  return s;
}

Path
inOneCall(const Cloud::ConstPtr& cloud, const SpiralSettings& s)
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setInputCloud(cloud);
  spiral.setSettings(s);
  Path path;
  spiral.compute(path);
  EXPECT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  return path;
}

/** The data between the stages, and the path, without the generator. */
struct ByHand {
  Surface::ConstPtr scanned, surface;
  std::vector<BoundaryLoop> found, loops;
  RadialLineSet lines;
  SpiralPath path;
};

ByHand
composed(const Cloud::ConstPtr& cloud, const SpiralSettings& s)
{
  ByHand by_hand;
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  scanned.setNumberOfThreads(s.threads);
  scanned.compute(by_hand.scanned);
  EXPECT_TRUE(scanned.getStatus().ok()) << scanned.getStatus().message();

  BoundaryLoops<pcl::PointXYZ> boundaries;
  boundaries.setInputSurface(by_hand.scanned);
  boundaries.setNumberOfThreads(s.threads);
  boundaries.compute(by_hand.found);
  EXPECT_TRUE(boundaries.getStatus().ok()) << boundaries.getStatus().message();

  GapBridging<pcl::PointXYZ> bridging;
  bridging.setInputSurface(by_hand.scanned);
  bridging.setBoundaryLoops(by_hand.found);
  bridging.setNumberOfThreads(s.threads);
  bridging.compute(by_hand.surface, by_hand.loops);
  EXPECT_TRUE(bridging.getStatus().ok()) << bridging.getStatus().message();

  RadialLines<pcl::PointXYZ> radial;
  radial.setInputSurface(by_hand.surface);
  radial.setBoundaryLoops(by_hand.loops);
  radial.setTolerance(lineTolerance(s));
  radial.setFitTolerance(lineFitTolerance(s));
  radial.setNumberOfThreads(s.threads);
  radial.compute(by_hand.lines);
  EXPECT_TRUE(radial.getStatus().ok()) << radial.getStatus().message();

  SpiralTurns turns;
  const double area = surfaceArea(by_hand.surface->graph());
  EXPECT_TRUE(makeTurns(by_hand.lines, by_hand.surface->spacing(), area, s, turns).ok());
  GapReport gaps;
  EXPECT_TRUE(putOnSurface(turns.curve, *by_hand.surface, s, turns.largest_allowed_step, {}, by_hand.path, gaps).ok());
  AxisReport axes;
  pcl_spiral::Diagnostics warnings;
  EXPECT_TRUE(setToolAxes(s, by_hand.path, axes, warnings).ok());
  ToolpathReport figures;
  EXPECT_TRUE(checkPath(by_hand.path, s, turns.largest_allowed_step, {}, figures).ok());
  return by_hand;
}

void
expectSame(const SpiralPath& by_hand, const Path& path)
{
  ASSERT_GT(path.size(), 500u);
  ASSERT_EQ(by_hand.contacts.size(), path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    ASSERT_EQ(by_hand.contacts[i].cast<float>(), path[i].getVector3fMap()) << i;
    ASSERT_EQ(by_hand.normals[i].cast<float>(), path[i].getNormalVector3fMap()) << i;
    ASSERT_EQ(by_hand.axes[i], path[i].getAxisVector3fMap()) << i;
    ASSERT_EQ(by_hand.arc_lengths[i], path[i].arc_length) << i;
    ASSERT_EQ(by_hand.turns[i], path[i].turn) << i;
    ASSERT_EQ(by_hand.over_gap[i], path[i].over_gap) << i;
  }
}

void
expectSame(const Path& a, const Path& b)
{
  ASSERT_GT(a.size(), 500u);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].getVector3fMap(), b[i].getVector3fMap()) << i;
    ASSERT_EQ(a[i].getAxisVector3fMap(), b[i].getAxisVector3fMap()) << i;
    ASSERT_EQ(a[i].arc_length, b[i].arc_length) << i;
    ASSERT_EQ(a[i].over_gap, b[i].over_gap) << i;
  }
}

/** The generator with all results made by hand. */
Path
continued(const ByHand& by_hand, const SpiralSettings& s)
{
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setSettings(s);
  spiral.setInputSurface(by_hand.surface);
  spiral.setBoundaryLoops(by_hand.loops);
  spiral.setRadialLines(by_hand.lines);
  Path path;
  spiral.compute(path);
  EXPECT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  EXPECT_EQ(spiral.getReport().passes, 0);
  return path;
}

struct Case {
  const char* name;
  Cloud::ConstPtr cloud;
};

/** A dome with outliers and a gap in the data. */
Cloud::Ptr
domeWithGap()
{
  Cloud::Ptr cloud(new Cloud);
  Random random(5);
  for (const Eigen::Vector3d& p : sampleUniform(*spheroidCap(80.0, 45.0), 20000, 4).points)
    if ((p.head<2>() - Eigen::Vector2d(30.0, 10.0)).norm() > 5.0)
      cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()),
                          static_cast<float>(p.z() + (random.uniform() < 5e-4 ? random.uniform(5.0, 15.0) : 0.0)));
  return cloud;
}

Cloud::Ptr
twoPasses()
{
  Sampled first = sampleUniform(*spheroidCap(80.0, 45.0), 9000, 6), second = sampleUniform(*spheroidCap(80.0, 45.0), 9000, 7);
  for (std::size_t i = 0; i < second.points.size(); ++i)
    second.points[i] += 0.02 * second.normals[i];
  first.points.insert(first.points.end(), second.points.begin(), second.points.end());
  return toCloud(first.points);
}

Cloud::Ptr
quickStartScan()
{
  const ScratchFolder folder;
  const std::string file = folder.path("scan.pcd");
  EXPECT_EQ(std::system(("'" PCL_SPIRAL_SIMULATE_SCAN_PROGRAM "' -o '" + file + "' > '" + file + ".said'").c_str()), 0);
  return Cloud::Ptr(new Cloud(*readCloud(file).cloud));
}

std::vector<Case>
cases()
{
  return {{"dome", toCloud(sampleUniform(*spheroidCap(80.0, 45.0), 20000, 1).points)},
          {"annulus", toCloud(sampleUniform(*spheroidCap(80.0, 45.0, 20.0), 20000, 2).points)},
          {"kidney", toCloud(sampleUniform(*kidneyPatch(), 20000, 3).points)},
          {"square", toCloud(sampleUniform(*ball(200.0, Region({rectangle(100.0, 100.0)})), 15000, 8).points)},
          {"dome with echoes and a gap", domeWithGap()},
          {"scan lines", toCloud(sampleScanLines(*spheroidCap(80.0, 45.0), 0.3, 3.0, 9).points)},
          {"two passes", twoPasses()},
          {"quick start", quickStartScan()}};
}

} // namespace

TEST(StagesCompose, ByHandAndInOneCallTheSameBytes)
{
  for (const Case& c : cases())
    for (const unsigned int threads : {1u, 2u}) {
      SCOPED_TRACE(std::string(c.name) + ", threads " + std::to_string(threads));
      const SpiralSettings s = settings(threads);
      const Path path = inOneCall(c.cloud, s);
      const ByHand by_hand = composed(c.cloud, s);
      expectSame(by_hand.path, path);
      expectSame(continued(by_hand, s), path);
    }
}

TEST(StagesCompose, TheSurfaceIsGivenAndTheRestMade)
{
  const SpiralSettings s = settings();
  const auto cloud = domeWithGap();
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setSettings(s);
  spiral.setInputSurface(surface);
  Path path;
  spiral.compute(path);
  ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  expectSame(path, inOneCall(cloud, s));
  EXPECT_GT(surface->graph().triangulation().triangleCount(), 0u) << "what is shared is left as it is";
  EXPECT_GT(spiral.getReport().gap_points, 0u);
  // With a new cloud the surface is dropped.
  spiral.setInputCloud(toCloud(sampleUniform(*spheroidCap(80.0, 45.0), 20000, 1).points));
  spiral.compute(path);
  EXPECT_EQ(spiral.getReport().gap_points, 0u);
  EXPECT_GT(spiral.getReport().passes, 0);
}

TEST(StagesCompose, SettingsOfTheSurfaceThatContradictItAreRefused)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(toCloud(sampleUniform(*spheroidCap(80.0, 45.0), 8000, 1).points));
  Surface::ConstPtr surface;
  scanned.compute(surface);
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setSettings(settings());
  spiral.setInputSurface(surface);
  spiral.setThinning(2.0);
  Path path;
  spiral.compute(path);
  EXPECT_EQ(spiral.getStatus().code(), StatusCode::InvalidArgument);
  EXPECT_NE(spiral.getStatus().message().find("setThinning"), std::string::npos) << spiral.getStatus().message();
  scanned.setThinning(2.0);
  scanned.compute(surface);
  spiral.setInputSurface(surface);
  spiral.compute(path);
  EXPECT_TRUE(spiral.getStatus().ok()) << "the remedy: " << spiral.getStatus().message();
}

TEST(StagesCompose, LoopsFromAUsersFlags)
{
  const auto sampled = sampleUniform(*spheroidCap(80.0, 45.0), 20000, 11);
  const auto cloud = toCloud(sampled.points);
  CentroidBoundaryEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setInputNormals(toNormals(sampled.normals));
  estimation.setKSearch(32);
  pcl::PointCloud<pcl::Boundary>::Ptr flags(new pcl::PointCloud<pcl::Boundary>);
  estimation.compute(*flags);
  BoundaryLoops<pcl::PointXYZ> boundaries;
  boundaries.setInputCloud(cloud);
  boundaries.setBoundaryPoints(flags);
  std::vector<BoundaryLoop> loops;
  boundaries.compute(loops);
  ASSERT_EQ(loops.size(), 1u) << boundaries.getStatus().message();
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setSettings(settings());
  spiral.setInputCloud(cloud);
  spiral.setBoundaryLoops(loops);
  Path path;
  spiral.compute(path);
  ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  expectSame(path, inOneCall(cloud, settings()));
}

TEST(StagesCompose, AUsersOwnRadialLines)
{
  // Meridians of a sphere, by formula: not made by RadialLines.
  constexpr double radius = 150.0, reach = 0.5; // rad from the pole
  constexpr int count = 60, stations = 41;
  const auto cloud = toCloud(sampleUniform(*ball(radius, Region({circle({0, 0}, radius * std::sin(reach))})), 20000, 12).points);
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  ASSERT_TRUE(surface);
  const auto at = [](double polar, double azimuth) {
    return Eigen::Vector3d(radius * std::sin(polar) * std::cos(azimuth), radius * std::sin(polar) * std::sin(azimuth),
                           radius * std::cos(polar));
  };
  RadialLineSet set;
  for (int i = 0; i < count; ++i) {
    RadialLine line;
    Polyline points;
    for (int k = 0; k < stations; ++k) {
      points.push_back(at(reach * k / (stations - 1), 2.0 * M_PI * i / count));
      line.feet.push_back(surface->fit().project(points.back()));
    }
    line.feet.front().position = points.front();
    line.curve = fitBSpline(points, {})->curve;
    line.rim_share = line.turn_share = static_cast<double>(i) / count;
    set.lines.push_back(line);
    set.rim.push_back(points.back());
  }
  set.centre = at(0.0, 0.0);
  SpiralToolpathGenerator<pcl::PointXYZ> spiral;
  spiral.setSettings(settings());
  spiral.setInputSurface(surface);
  spiral.setRadialLines(set);
  Path path;
  spiral.compute(path);
  ASSERT_TRUE(spiral.getStatus().ok()) << spiral.getStatus().message();
  double worst = 0.0;
  for (const ToolpathPoint& p : path)
    worst = std::max(worst, std::abs(p.getVector3fMap().cast<double>().norm() - radius));
  EXPECT_LT(worst, 2e-3);
  EXPECT_GT(spiral.getReport().turns, 10u);

  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const auto refused = [&](const RadialLineSet& wrong, const char* what) {
    spiral.setRadialLines(wrong);
    spiral.compute(path);
    EXPECT_TRUE(path.empty());
    EXPECT_EQ(spiral.getStatus().code(), StatusCode::InvalidInput);
    EXPECT_NE(spiral.getStatus().message().find(what), std::string::npos) << spiral.getStatus().message();
  };
  RadialLineSet wrong = set;
  wrong.lines[3].feet[20].valid = false;
  refused(wrong, "leaves the scanned surface");
  wrong = set;
  std::swap(wrong.lines[3], wrong.lines[4]);
  refused(wrong, "shares");
  wrong = set;
  wrong.rim.clear();
  refused(wrong, "rim");
  wrong = set;
  wrong.lines.resize(2);
  refused(wrong, "three");
  wrong = set;
  wrong.rim_corners.push_back(count);
  refused(wrong, "corner");
}

TEST(StagesCompose, PclsOwnProjectionInPlaceOfOurs)
{
  const auto cloud = toCloud(sampleUniform(*spheroidCap(80.0, 45.0), 20000, 13).points);
  pcl::PointCloud<pcl::PointNormal> theirs, ours;
  pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointNormal> mls;
  mls.setSearchRadius(3.0);
  mls.setPolynomialOrder(2);
  MLSProjector<pcl::PointXYZ, pcl::PointNormal> projector;
  projector.setSearchRadius(3.0);
  projector.setPolynomialOrder(2);
  const auto smoothed = [&](pcl::CloudSurfaceProcessing<pcl::PointXYZ, pcl::PointNormal>& stage, pcl::PointCloud<pcl::PointNormal>& out) {
    stage.setInputCloud(cloud);
    stage.process(out);
  };
  smoothed(mls, theirs);
  smoothed(projector, ours);
  ASSERT_EQ(ours.size(), cloud->size()) << projector.getStatus().message();
  ASSERT_GT(theirs.size(), cloud->size() / 2);
  for (const auto* out : {&theirs, &ours}) { // each is used before the generator
    Cloud::Ptr points(new Cloud);
    for (const pcl::PointNormal& p : *out)
      points->emplace_back(p.x, p.y, p.z);
    EXPECT_GT(inOneCall(points, settings()).size(), 500u);
  }
}

TEST(StagesCompose, TheJudgeTakesThePlannersSurface)
{
  const auto cloud = toCloud(sampleUniform(*spheroidCap(80.0, 45.0), 20000, 1).points);
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(cloud);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  const auto path = pcl::make_shared<Path>(inOneCall(cloud, settings()));
  pcl::PointCloud<pcl::PointXYZI> of_cloud, of_surface;
  DeviationEstimation<pcl::PointXYZ> deviation;
  deviation.setInputToolpath(path);
  deviation.setInputCloud(cloud);
  deviation.compute(of_cloud);
  deviation.setInputSurface(surface);
  deviation.compute(of_surface);
  ASSERT_EQ(of_cloud.size(), path->size());
  ASSERT_EQ(of_cloud.size(), of_surface.size());
  for (std::size_t i = 0; i < of_cloud.size(); ++i)
    EXPECT_EQ(of_cloud[i].intensity, of_surface[i].intensity);
}

} // namespace stages_compose_test
