// SPDX-License-Identifier: BSD-3-Clause
// Scans and rough points that are not a ridge, with the remedies from the messages.
#include "support/found_lines.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ridge_lines_refused_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
const ExactRidge die = dieRidge();

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

TEST(RidgeLines, RefuseWhatIsNoRidge)
{
  const std::vector<Vector3d> scan = coarseDie();
  const Polyline rough = roughPointsOfDie(die);
  refused(linesOf({}, rough, 20.0), "the input cloud is missing or empty");
  refused(linesOf(std::vector<Vector3d>(100, Vector3d::Constant(NAN)), rough, 20.0), "none of the 100 points is finite");
  refused(linesOf(scan, {rough[0]}, 20.0), "there are 1 rough points; a ridge needs two or more");
  Lines ring = linesOf(scan, {rough[0], rough[1]}, 20.0);
  ring.setClosed(true);
  refused(ring, "a closed ridge needs three");
  refused(linesOf(scan, {rough[0], rough[0]}, 20.0), "rough points 0 and 1 are both at (");
  refused(linesOf(scan, {rough[0], Vector3d::Constant(NAN)}, 20.0), "rough point 1 is not finite");
  refused(linesOf(scan, rough, 0.0), "the half width is 0 mm");
  Polyline off = rough;
  off[4].z() += 60.0;
  refused(linesOf(scan, off, 20.0), "rough point 4 at ");
  Lines level = linesOf(scan, rough, 20.0);
  level.setReferenceNormal(Vector3d::UnitX());
  refused(level, "set a reference normal across the ridge (setReferenceNormal)");
}

TEST(RidgeLines, OfAHollowAreThoseOfTheOtherSide)
{
  const ExactRidge hollow{[](double t) { return Vector3d(200.0 * t, 0.0, 0.0); },
                          [](double w) { return Vector3d(0.0, 60.0 * w, -40.0 * w * (1.0 - w)); }};
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
  for (const Vector3d& p : coarseDie()) {
    double w = 0.0;
    offDie(p, w);
    if (w > 0.3)
      half.push_back(p);
  }
  refused(linesOf(half, rim, 12.0), "the band of the ridge leaves the scan at (");
}

TEST(RidgeLines, RoundsThatDoNotEndAreSaid)
{
  Lines lines = linesOf(coarseDie(), roughPointsOfDie(die), 20.0);
  lines.setMaximumIterations(2);
  refused(lines, "after 2 rounds the rail at (");
  lines.setMaximumIterations(60); // the remedy
  find(lines);
}

TEST(RidgeLines, MayBeCancelled)
{
  Lines lines = linesOf(coarseDie(), roughPointsOfDie(die), 20.0);
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

} // namespace ridge_lines_refused_test
