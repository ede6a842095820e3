// SPDX-License-Identifier: BSD-3-Clause
// Rail and generator from full scans of exact ridges.
#include <pcl_spiral/ridge/ridge_toolpath.h>

#include "support/found_lines.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace ridge_lines_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

const ExactRidge die = dieRidge();
constexpr int along = 1200, across = 52; // 62,400 points, 0.5 mm apart

struct Off {
  double rms = 0.0, largest = 0.0;
};

Off
ofSurface(const RidgeSurface& surface)
{
  Off off;
  int count = 0;
  for (int i = 0; i <= 120; ++i)
    for (int j = 0; j <= 12; ++j) {
      double w = 0.0;
      const double d = offDie(surface.position(surface.rail().length() * i / 120, surface.generator().length() * j / 12), w);
      off.rms += d * d;
      off.largest = std::max(off.largest, d);
      ++count;
    }
  off.rms = std::sqrt(off.rms / count);
  return off;
}

/** Variation of a line across the die from one place of the generator, rms, mm. */
double
wander(const Polyline& line)
{
  double sum = 0.0, squares = 0.0;
  for (const Vector3d& p : line) {
    double w = 0.0;
    offDie(p, w);
    sum += 24.0 * w;
    squares += 576.0 * w * w;
  }
  const double n = static_cast<double>(line.size());
  return std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n)));
}

} // namespace

TEST(RidgeLines, OfANoisyScanAreTheDie)
{
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    Lines lines = linesOf(scanOf(die, along, across, 0.02, seed), roughPointsOfDie(die), 20.0);
    find(lines);
    const Off off = ofSurface(*lines.getRidge());
    EXPECT_LE(off.rms, 0.01) << seed;
    EXPECT_LE(off.largest, 0.05) << seed;
    const ScanRidgeReport& report = lines.getReport();
    EXPECT_GT(lines.getRidge()->rail().length(), 620.0);
    EXPECT_GT(report.reach_left + report.reach_right, 25.0); // of 27.1 in total
    EXPECT_NEAR(report.noise, 0.02, 0.002);
    EXPECT_NEAR(report.misfit, 0.02, 0.002);
    EXPECT_LT(report.largest_misfit, 0.08);
    EXPECT_GT(wander(report.crest), 5.0 * wander(lines.getRail())) << seed; // only the crest
    std::printf("seed %u: off by %.4f rms, %.4f at most; wander %.3f, of the crest alone %.3f; %d rounds\n", static_cast<unsigned>(seed),
                off.rms, off.largest, wander(lines.getRail()), wander(report.crest), report.rounds);
  }
}

TEST(RidgeLines, OfAProfileThatChangesAreSaidWithPlace)
{
  std::vector<Vector3d> scan;
  Random random(3);
  for (int i = 0; i < 600; ++i)
    for (int j = 0; j < 26; ++j) {
      const double t = (i + random.uniform()) / 600, w = (j + random.uniform()) / 26, share = std::max(0.0, (t - 0.6) / 0.4);
      scan.push_back(die.position(t, w) + 4.0 * w * (1.0 - w) * share * die.frame(t).col(2)); // 1 mm higher at t = 1
    }
  Lines lines = linesOf(moved(scan, 0.02, 4), roughPointsOfDie(die), 20.0);
  find(lines);
  const ScanRidgeReport& report = lines.getReport();
  EXPECT_GT(report.largest_misfit, 0.3);
  EXPECT_LT(report.largest_misfit, 1.0);
  EXPECT_GT(report.largest_place.x(), 570.0);
  EXPECT_GT(report.misfit, 0.05);
  ASSERT_FALSE(report.warnings.empty());
  EXPECT_NE(report.warnings.back().text().find("the part differs from the surface that the generator sweeps by 0.0"), std::string::npos)
      << report.warnings.back();
  Lines same = linesOf(coarseDie(), roughPointsOfDie(die), 20.0);
  find(same);
  for (const pcl_spiral::Diagnostic& warning : same.getReport().warnings)
    EXPECT_EQ(warning.text().find("off the surface"), std::string::npos) << warning;
}

TEST(RidgeLines, OutliersDoNotMoveThem)
{
  std::vector<Vector3d> scan = scanOf(die, along, across, 0.02, 7);
  Random random(8);
  for (std::size_t i = 0; i < scan.size(); i += 1000)
    scan[i] += random.uniform(5.0, 20.0) * Vector3d(0.0, random.uniform(-0.5, 0.5), 1.0).normalized();
  Lines lines = linesOf(scan, roughPointsOfDie(die), 20.0);
  find(lines);
  const Off off = ofSurface(*lines.getRidge());
  EXPECT_LE(off.rms, 0.01);
  EXPECT_LE(off.largest, 0.05);
}

TEST(RidgeLines, OrderAndThreadsDoNotChangeThem)
{
  const std::vector<Vector3d> scan = coarseDie();
  Lines lines = linesOf(scan, roughPointsOfDie(die), 20.0);
  lines.setNumberOfThreads(1);
  find(lines);
  std::vector<Vector3d> other;
  for (const std::size_t i : shuffled(scan.size(), 3))
    other.push_back(scan[i]);
  Lines shuffled_lines = linesOf(other, roughPointsOfDie(die), 20.0);
  shuffled_lines.setNumberOfThreads(2);
  find(shuffled_lines);
  EXPECT_EQ(lines.getRail(), shuffled_lines.getRail());
  EXPECT_EQ(lines.getGenerator(), shuffled_lines.getGenerator());
}

TEST(RidgeLines, MoveWithTheScanAndTheReference)
{
  const Eigen::Isometry3d motion = randomMotion(11, 100.0);
  std::vector<Vector3d> scan = coarseDie(), rough = roughPointsOfDie(die);
  Lines lines = linesOf(scan, rough, 20.0);
  find(lines);
  for (auto* points : {&scan, &rough})
    for (Vector3d& p : *points)
      p = motion * p;
  Lines moved_lines = linesOf(scan, rough, 20.0);
  moved_lines.setReferenceNormal(motion.linear() * Vector3d::UnitZ());
  moved_lines.setViewPoint(motion * Vector3d(300.0, 0.0, 5000.0));
  find(moved_lines);
  double most = 0.0; // the scan is rounded to single precision after the motion, so cells of points differ slightly
  for (int i = 0; i <= 50; ++i)
    for (int j = 0; j <= 10; ++j) {
      double w = 0.0;
      const RidgeSurface& surface = *moved_lines.getRidge();
      const Vector3d p = motion.inverse() * surface.position(surface.rail().length() * i / 50, surface.generator().length() * j / 10);
      most = std::max(most, offDie(p, w));
    }
  EXPECT_LT(most, 0.05);
  EXPECT_NEAR(lines.getRidge()->report().chord_angle, moved_lines.getRidge()->report().chord_angle, 0.01);
  EXPECT_EQ(lines.getReport().sections, moved_lines.getReport().sections);
}

TEST(RidgeLines, MoveWithAScanThatIsNotRounded)
{
  const auto turned = [](const Vector3d& p) { return Vector3d(p.z(), p.x(), p.y()); };
  std::vector<Vector3d> scan = coarseDie(), rough = roughPointsOfDie(die);
  Lines lines = linesOf(scan, rough, 20.0);
  lines.setViewPoint(Vector3d(300.0, 0.0, 5000.0));
  find(lines);
  for (auto* points : {&scan, &rough})
    for (Vector3d& p : *points)
      p = turned(p);
  Lines turned_lines = linesOf(scan, rough, 20.0);
  turned_lines.setReferenceNormal(Vector3d::UnitX());
  turned_lines.setViewPoint(Vector3d(5000.0, 300.0, 0.0));
  find(turned_lines);
  ASSERT_EQ(lines.getRail().size(), turned_lines.getRail().size());
  double most = 0.0;
  for (std::size_t i = 0; i < lines.getRail().size(); ++i)
    most = std::max(most, (turned(lines.getRail()[i]) - turned_lines.getRail()[i]).norm());
  EXPECT_LT(most, 2e-4); // fits are summed in single precision, in another order
}

TEST(RidgeLines, OfNarrowBandsAndGapsSettle)
{
  const std::vector<Vector3d> scan = scanOf(die, along, across, 0.02, 1);
  Polyline gap;
  for (const Vector3d& p : scan)
    if (std::abs(p.x() - 300.0) > 10.0)
      gap.push_back(p);
  const std::pair<std::vector<Vector3d>, double> cases[] = {{scan, 4.0}, {scan, 8.0}, {gap, 20.0}};
  for (const auto& [points, half_width] : cases) {
    Lines lines = linesOf(points, roughPointsOfDie(die), half_width);
    find(lines);
    const Off off = ofSurface(*lines.getRidge());
    EXPECT_LE(off.rms, 0.01) << half_width;
    EXPECT_LE(off.largest, 0.05) << half_width;
    EXPECT_LT(lines.getReport().rounds, 20);
  }
}

/** Where a rail climbs, its turn rolls its frame, which looks like a shift of the sections. */
TEST(RidgeLines, OfAHelixSettle)
{
  const auto profile = [](double w) { return Vector3d(0.0, 30.0 * w, 24.0 * w * (1.0 - w)); };
  const ExactRidge helix = helixRidge(100.0, 20.0 * M_PI / 180.0, profile, -15.0 * M_PI / 180.0);
  Polyline rough;
  for (int k = 0; k <= 12; ++k)
    rough.push_back(helix.position(0.02 + 0.08 * k, 0.5));
  Lines lines = linesOf(scanOf(helix, 1000, 50, 0.02, 1), rough, 14.0);
  find(lines);
  const RidgeSurface& surface = *lines.getRidge();
  double most = 0.0;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 10; ++j)
      most = std::max(most, helix.distance(surface.position(surface.rail().length() * i / 60, surface.generator().length() * j / 10)));
  EXPECT_LT(most, 0.05);
}

TEST(RidgeLines, OfARingAreClosed)
{
  const auto profile = [](double w) { return Vector3d(0.0, 30.0 * w, 24.0 * w * (1.0 - w)); };
  const ExactRidge ring = ringRidge(120.0, profile, -10.0 * M_PI / 180.0);
  Polyline rough;
  for (const double t : {0.02, 0.37, 0.69})
    rough.push_back(ring.position(t, 0.5) + Vector3d(2.0, -1.0, 0.0));
  Lines lines = linesOf(scanOf(ring, 600, 30, 0.02, 3), rough, 12.0);
  lines.setClosed(true);
  find(lines);
  const RidgeSurface& surface = *lines.getRidge();
  EXPECT_TRUE(surface.rail().closed());
  double most = 0.0;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j <= 10; ++j)
      most = std::max(most, ring.distance(surface.position(surface.rail().length() * i / 60, surface.generator().length() * j / 10)));
  EXPECT_LT(most, 0.05);
}

TEST(RidgeLines, GoStraightToRows)
{
  Lines lines = linesOf(coarseDie(), roughPointsOfDie(die), 10.0);
  Cloud::Ptr rail(new Cloud), generator(new Cloud);
  lines.compute(*rail, *generator);
  RidgeToolpath<pcl::PointXYZ> rows;
  rows.setInputCloud(rail);
  rows.setInputGenerator(generator);
  rows.setFlipNormals(lines.getRidge()->settings().flip);
  rows.setStepOver(2.0);
  DrivePasses passes;
  rows.compute(passes);
  ASSERT_TRUE(rows.getStatus().ok()) << rows.getStatus().message();
  for (const DrivePass& row : passes)
    for (std::size_t i = 0; i < row.points.size(); i += 20) {
      double w = 0.0;
      EXPECT_LT(offDie(row.points[i].position, w), 0.05);
      EXPECT_GT(row.points[i].normal.z(), 0.0);
    }
}

} // namespace ridge_lines_test
