// Rail and generator out of full scans of ridges that are known exactly.
#include <pcl_spiral/ridge/ridge_lines.h>
#include <pcl_spiral/ridge/ridge_toolpath.h>

#include "support/ridge_scans.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

using Lines = RidgeLines<pcl::PointXYZ>;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

const ExactRidge die = dieRidge();
constexpr int along = 1200, across = 52; // 62,400 points, 0.5 mm apart

Lines
linesOf(const std::vector<Vector3d>& scan, const Polyline& rough, double half_width)
{
  Lines lines;
  lines.setInputCloud(toCloud(scan));
  lines.setRoughPoints(rough);
  lines.setHalfWidth(half_width);
  lines.setQuiet(true);
  return lines;
}

void
find(Lines& lines)
{
  Cloud rail, generator;
  lines.compute(rail, generator);
  ASSERT_TRUE(lines.getStatus().ok()) << lines.getStatus().message();
  EXPECT_EQ(rail.size(), lines.getRail().size());
  EXPECT_EQ(generator.size(), lines.getGenerator().size());
}

/** A scan of the die with coarser points, for what does not need all. */
std::vector<Vector3d>
coarse(double noise = 0.02)
{
  return scanOf(die, 600, 26, noise, 5);
}

/** Distance of \p p from the die, with its place across it in \p w. */
double
offDie(const Vector3d& p, double& w)
{
  double least = 1e30;
  for (const double guess : {0.1, 0.4, 0.8}) {
    double t = p.x() / 600.0, at = guess;
    if (const double off = die.distance(p, t, at); off < least) {
      least = off;
      w = at;
    }
  }
  return least;
}

struct Off {
  double rms = 0.0, largest = 0.0;
};

Off
offDie(const RidgeSurface& surface)
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

/** How far a line wanders across the die from one place of the generator, rms, mm. */
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

void
refused(Lines lines, const std::string& words)
{
  Cloud rail, generator;
  lines.compute(rail, generator);
  EXPECT_FALSE(lines.getStatus().ok());
  EXPECT_NE(lines.getStatus().message().find(words), std::string::npos) << "'" << words << "' in: " << lines.getStatus().message();
  EXPECT_TRUE(rail.empty() && generator.empty() && lines.getRail().empty() && !lines.getRidge());
}

} // namespace

TEST(RidgeLines, OfANoisyScanAreTheDie)
{
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    Lines lines = linesOf(scanOf(die, along, across, 0.02, seed), roughPointsOfDie(die), 20.0);
    find(lines);
    const Off off = offDie(*lines.getRidge());
    EXPECT_LE(off.rms, 0.01) << seed;
    EXPECT_LE(off.largest, 0.05) << seed;
    const ScanRidgeReport& report = lines.getReport();
    EXPECT_GT(lines.getRidge()->rail().length(), 620.0);
    EXPECT_GT(report.reach_left + report.reach_right, 25.0); // of 27.1 in all
    EXPECT_NEAR(report.noise, 0.02, 0.002);
    EXPECT_NEAR(report.misfit, 0.02, 0.002);
    EXPECT_LT(report.largest_misfit, 0.08);
    EXPECT_GT(wander(report.crest), 5.0 * wander(lines.getRail())) << seed; // the crest alone
    std::printf("seed %u: off by %.4f rms, %.4f at most; wander %.3f, of the crest alone %.3f; %d rounds\n", static_cast<unsigned>(seed), off.rms,
                off.largest, wander(lines.getRail()), wander(report.crest), report.rounds);
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
  EXPECT_NE(report.warnings.back().find("the part is off the surface that the generator sweeps by 0.0"), std::string::npos) << report.warnings.back();
  Lines same = linesOf(coarse(), roughPointsOfDie(die), 20.0);
  find(same);
  for (const std::string& warning : same.getReport().warnings)
    EXPECT_EQ(warning.find("off the surface"), std::string::npos) << warning;
}

TEST(RidgeLines, StrayPointsDoNotMoveThem)
{
  std::vector<Vector3d> scan = scanOf(die, along, across, 0.02, 7);
  Random random(8);
  for (std::size_t i = 0; i < scan.size(); i += 1000)
    scan[i] += random.uniform(5.0, 20.0) * Vector3d(0.0, random.uniform(-0.5, 0.5), 1.0).normalized();
  Lines lines = linesOf(scan, roughPointsOfDie(die), 20.0);
  find(lines);
  const Off off = offDie(*lines.getRidge());
  EXPECT_LE(off.rms, 0.01);
  EXPECT_LE(off.largest, 0.05);
}

TEST(RidgeLines, OrderAndThreadsDoNotChangeThem)
{
  const std::vector<Vector3d> scan = coarse();
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
  std::vector<Vector3d> scan = coarse(), rough = roughPointsOfDie(die);
  Lines lines = linesOf(scan, rough, 20.0);
  find(lines);
  for (auto* points : {&scan, &rough})
    for (Vector3d& p : *points)
      p = motion * p;
  Lines moved_lines = linesOf(scan, rough, 20.0);
  moved_lines.setReferenceNormal(motion.linear() * Vector3d::UnitZ());
  moved_lines.setViewPoint(motion * Vector3d(300.0, 0.0, 5000.0));
  find(moved_lines);
  double most = 0.0; // the scan is rounded to single precision after the motion, so that cells of points differ a little
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
  std::vector<Vector3d> scan = coarse(), rough = roughPointsOfDie(die);
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
  Lines lines = linesOf(coarse(), roughPointsOfDie(die), 10.0);
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

TEST(RidgeLines, RefuseWhatIsNoRidge)
{
  const std::vector<Vector3d> scan = coarse();
  const Polyline rough = roughPointsOfDie(die);
  refused(linesOf({}, rough, 20.0), "the input cloud is missing or empty");
  refused(linesOf(std::vector<Vector3d>(100, Vector3d::Constant(NAN)), rough, 20.0), "none of the 100 points is finite");
  refused(linesOf(scan, {rough[0]}, 20.0), "there are 1 rough points; a ridge takes two or more");
  Lines ring = linesOf(scan, {rough[0], rough[1]}, 20.0);
  ring.setClosed(true);
  refused(ring, "a closed ridge takes three");
  refused(linesOf(scan, {rough[0], rough[0]}, 20.0), "rough points 0 and 1 are both at (");
  refused(linesOf(scan, {rough[0], Vector3d::Constant(NAN)}, 20.0), "rough point 1 is not finite");
  refused(linesOf(scan, rough, 0.0), "the half width is 0 mm");
  Polyline off = rough;
  off[4].z() += 60.0;
  refused(linesOf(scan, off, 20.0), "rough point 4 at ");
  Lines level = linesOf(scan, rough, 20.0);
  level.setReferenceNormal(Vector3d::UnitX());
  refused(level, "take a reference normal across the ridge (setReferenceNormal)");
}

TEST(RidgeLines, OfAHollowAreThoseOfTheOtherSide)
{
  const ExactRidge hollow{[](double t) { return Vector3d(200.0 * t, 0.0, 0.0); }, [](double w) { return Vector3d(0.0, 60.0 * w, -40.0 * w * (1.0 - w)); }};
  Lines lines = linesOf(scanOf(hollow, 200, 60, 0.02, 1), {Vector3d(20.0, 32.0, -10.0), Vector3d(180.0, 29.0, -10.0)}, 10.0);
  refused(lines, "there is no crest between the rough points at (");
  lines.setFlipNormals(true); // the remedy
  find(lines);
  EXPECT_LT(lines.getRidge()->normal(50.0, 0.5 * lines.getRidge()->generator().length()).z(), 0.0);
  EXPECT_LT(lines.getReport().largest_misfit, 0.1);
  EXPECT_TRUE(lines.getReport().warnings.empty());
}

TEST(RidgeLines, RefuseAFlatScanAndABandBesideIt)
{
  const ExactRidge plate{[](double t) { return Vector3d(200.0 * t, 0.0, 0.0); }, [](double w) { return Vector3d(0.0, 60.0 * w, 0.0); }};
  const std::vector<Vector3d> flat = scanOf(plate, 200, 60, 0.02, 1);
  refused(linesOf(flat, {Vector3d(20.0, 30.0, 0.0), Vector3d(180.0, 30.0, 0.0)}, 10.0), "there is no crest between the rough points at (");
  Polyline rim;
  for (const double t : {0.1, 0.2, 0.3, 0.4})
    rim.push_back(die.position(t, 0.3));
  std::vector<Vector3d> half; // a scan that ends at the crest
  for (const Vector3d& p : coarse()) {
    double w = 0.0;
    offDie(p, w);
    if (w > 0.3)
      half.push_back(p);
  }
  refused(linesOf(half, rim, 12.0), "the band of the ridge runs off the scan at (");
}

TEST(RidgeLines, RoundsThatDoNotEndAreSaid)
{
  Lines lines = linesOf(coarse(), roughPointsOfDie(die), 20.0);
  lines.setMaximumIterations(2);
  refused(lines, "after 2 rounds the rail at (");
  lines.setMaximumIterations(60); // the remedy
  find(lines);
}

TEST(RidgeLines, MayBeCancelled)
{
  Lines lines = linesOf(coarse(), roughPointsOfDie(die), 20.0);
  double last = 0.0;
  lines.setProgressCallback([&](double share, const std::string& stage) {
    EXPECT_GE(share, last);
    last = share;
    return stage != "sections";
  });
  Cloud rail, generator;
  lines.compute(rail, generator);
  EXPECT_EQ(lines.getStatus().code(), StatusCode::Cancelled);
  EXPECT_TRUE(rail.empty());
}
