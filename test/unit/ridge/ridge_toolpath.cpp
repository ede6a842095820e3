// SPDX-License-Identifier: BSD-3-Clause
// Rows over ridges: spots that cover the whole ridge, equal steps, scallops of a ball, and refusals.
#include <pcl_spiral/ridge/ridge_toolpath.h>

#include "support/ridges.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace ridge_toolpath_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
const ExactRidge die = dieRidge();

Cloud::Ptr
cloudOf(const std::vector<Vector3d>& points)
{
  Cloud::Ptr cloud(new Cloud);
  for (const Vector3d& p : points)
    cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  return cloud;
}

RidgeToolpath<pcl::PointXYZ>
overDie()
{
  RidgeToolpath<pcl::PointXYZ> ridge;
  ridge.setInputCloud(cloudOf(die.railPoints(600)));
  ridge.setInputGenerator(cloudOf(die.generatorPoints(0.37, 100)));
  ridge.setQuiet(true);
  return ridge;
}

DrivePasses
rowsOf(RidgeToolpath<pcl::PointXYZ>& ridge)
{
  DrivePasses rows;
  ridge.compute(rows);
  EXPECT_TRUE(ridge.getStatus().ok()) << ridge.getStatus().message();
  return rows;
}

/** Distance of \p p from the nearest of \p rows, as lines between their points. */
double
distanceFromRows(const DrivePasses& rows, const Vector3d& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (const DrivePass& row : rows)
    for (std::size_t i = 1; i < row.points.size(); ++i) {
      const Vector3d &a = row.points[i - 1].position, d = row.points[i].position - a;
      const double f = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (p - a - f * d).norm());
    }
  return least;
}

} // namespace

TEST(RidgeToolpath, SpotsCoverTheWholeRidge)
{
  for (const RidgeDirection direction : {RidgeDirection::AlongRail, RidgeDirection::AcrossRail}) {
    auto ridge = overDie();
    ridge.setSpot(4.0, 0.25);
    ridge.setDirection(direction);
    const DrivePasses rows = rowsOf(ridge);
    for (double t = 0.0; t <= 1.0; t += 0.02)
      for (double w = 0.0; w <= 1.0; w += 0.05)
        EXPECT_LT(distanceFromRows(rows, die.position(t, w)), 2.0) << t << ' ' << w;
    for (std::size_t k = 1; k < rows.size(); ++k)
      for (std::size_t i = 0; i < rows[k].points.size(); i += 20)
        EXPECT_LT(distanceFromRows({rows[k - 1]}, rows[k].points[i].position), 3.0 + 1e-3);
    if (direction == RidgeDirection::AlongRail)
      EXPECT_LE(rows.size(), static_cast<std::size_t>(ridge.getRidge()->generator().length() / 3.0) + 1);
  }
}

TEST(RidgeToolpath, StepsAreEqual)
{
  for (const RidgeDirection direction : {RidgeDirection::AlongRail, RidgeDirection::AcrossRail}) {
    auto ridge = overDie();
    ridge.setStepOver(3.0);
    ridge.setPointSpacing(0.8);
    ridge.setDirection(direction);
    for (const DrivePass& row : rowsOf(ridge)) {
      const double first = (row.points[1].position - row.points[0].position).norm();
      EXPECT_LE(first, 0.8);
      for (std::size_t i = 2; i < row.points.size(); ++i)
        EXPECT_NEAR((row.points[i].position - row.points[i - 1].position).norm(), first, 1e-3 * first);
    }
    ridge.setSteps(RidgeSteps::Stations);
    const DrivePasses stations = rowsOf(ridge);
    for (const DrivePass& row : stations)
      EXPECT_EQ(row.points.size(), stations[0].points.size());
  }
}

TEST(RidgeToolpath, RowsRunToAndFroWithNormalsOfTheSurface)
{
  auto ridge = overDie();
  ridge.setStepOver(3.0);
  ridge.setStandOff(10.0);
  ridge.setRunIn(5.0);
  ridge.setRunOut(3.0);
  ridge.setLeadAngle(10.0);
  const DrivePasses rows = rowsOf(ridge);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const DrivePoints& points = rows[k].points;
    EXPECT_EQ(points.back().position.x() > points.front().position.x(), k % 2 == 0);
    for (std::size_t i = 40; i + 40 < points.size(); i += 50) {
      double t = points[i].position.x() / 600.0, w = (k + 0.5) / rows.size();
      EXPECT_LT(die.distance(points[i].position - 10.0 * points[i].normal, t, w), 2e-3);
      EXPECT_LT((points[i].normal - die.normal(t, w)).norm(), 1e-3);
      EXPECT_NEAR(points[i].axis.dot(points[i].normal), std::cos(10.0 * M_PI / 180.0), 1e-4);
      EXPECT_GT(points[i].axis.dot(points[i + 1].position - points[i].position), 0.0);
    }
    const Vector3d in = points[1].position - points[0].position, after = points[2].position - points[1].position;
    EXPECT_LT(in.cross(after).norm(), 1e-9); // straight
    EXPECT_EQ(points[0].normal, points[1].normal);
  }
}

TEST(RidgeToolpath, ABallLeavesNoHigherRidgesThanAsked)
{
  const double radius = 6.0, height = 0.02;
  for (const RidgeDirection direction : {RidgeDirection::AlongRail, RidgeDirection::AcrossRail}) {
    auto ridge = overDie();
    ridge.setToolRadius(radius);
    ridge.setScallopHeight(height);
    ridge.setPointSpacing(0.2);
    ridge.setDirection(direction);
    const DrivePasses rows = rowsOf(ridge);
    double largest = 0.0;
    std::size_t above = 0, count = 0;
    for (double t = 0.1; t < 0.9; t += 0.0437)
      for (double w = 0.05; w < 0.95; w += 0.0031) { // height left above a place: from the surface out along the normal
        const Vector3d p = die.position(t, w), n = die.normal(t, w);
        double left = 1.0;
        for (const DrivePass& row : rows)
          for (const DrivePoint& point : row.points) {
            const Vector3d c = point.position + radius * point.normal - p;
            const double middle = c.dot(n), inside = radius * radius - (c - middle * n).squaredNorm();
            if (inside > 0.0)
              left = std::min(left, middle - std::sqrt(inside));
          }
        largest = std::max(largest, left);
        above += left > 1.02 * height + 0.001;
        ++count;
      }
    EXPECT_LE(above, count / 1000);
    EXPECT_GT(largest, 0.8 * height); // and the rows are not much closer than needed
  }
}

TEST(RidgeToolpath, IsTheSameForAnyNumberOfThreads)
{
  auto one = overDie(), three = overDie();
  one.setStepOver(2.0);
  three.setStepOver(2.0);
  one.setNumberOfThreads(1);
  three.setNumberOfThreads(3);
  const DrivePasses a = rowsOf(one), b = rowsOf(three);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    for (std::size_t i = 0; i < a[k].points.size(); ++i) {
      EXPECT_EQ(a[k].points[i].position, b[k].points[i].position);
      EXPECT_EQ(a[k].points[i].normal, b[k].points[i].normal);
    }
}

TEST(RidgeToolpath, RingsOfRowsAreClosed)
{
  const ExactRidge exact = ringRidge(
      50.0, [](double w) { return Vector3d(0.0, 20.0 * w, 12.0 * w * (1.0 - w)); }, 0.0);
  RidgeToolpath<pcl::PointXYZ> ridge;
  std::vector<Vector3d> rail = exact.railPoints(315);
  rail.pop_back();
  ridge.setInputCloud(cloudOf(rail));
  ridge.setInputGenerator(cloudOf(exact.generatorPoints(0.2, 80)));
  ridge.setStepOver(4.0);
  ridge.setRunIn(5.0);
  ridge.setLeadAngle(20.0);
  for (const DrivePass& row : rowsOf(ridge)) {
    EXPECT_TRUE(row.closed);
    for (std::size_t i = 0; i < row.points.size(); ++i) { // the axis has the same lead all round, also over the seam
      const DrivePoint &p = row.points[i], &q = row.points[row.points.size() / 2];
      const auto lead = [](const DrivePoint& at) { return at.axis.dot(Vector3d::UnitZ().cross(at.position).normalized()); };
      EXPECT_NEAR(lead(p), lead(q), 1e-4);
    }
    const double step = (row.points[1].position - row.points[0].position).norm();
    EXPECT_NEAR((row.points.back().position - row.points.front().position).norm(), step, 1e-3 * step);
  }
  ridge.setDirection(RidgeDirection::AcrossRail);
  const DrivePasses spokes = rowsOf(ridge);
  EXPECT_EQ(spokes.size(), static_cast<std::size_t>(std::ceil(100.0 * M_PI / 4.0)));
  EXPECT_FALSE(spokes[0].closed);
}

TEST(RidgeToolpath, RefusesWhatCannotBe)
{
  const auto refused = [](const std::function<void(RidgeToolpath<pcl::PointXYZ>&)>& set, const std::string& words) {
    auto ridge = overDie();
    ridge.setStepOver(2.0);
    set(ridge);
    DrivePasses rows(3);
    ridge.compute(rows);
    EXPECT_FALSE(ridge.getStatus().ok());
    EXPECT_TRUE(rows.empty());
    EXPECT_NE(ridge.getStatus().message().find(words), std::string::npos) << "'" << words << "' in: " << ridge.getStatus().message();
  };
  using Ridge = RidgeToolpath<pcl::PointXYZ>;
  refused([](Ridge& r) { r.setInputCloud(Cloud::Ptr(new Cloud)); }, "the rail is missing or empty");
  refused([](Ridge& r) { r.setInputGenerator(nullptr); }, "the generator is missing or empty");
  refused([](Ridge& r) { r.setStepOver(0.0); }, "no setting defines how far rows are apart");
  refused([](Ridge& r) { r.setSpot(4.0, 0.0); }, "more than one setting defines");
  refused([](Ridge& r) { r.setScallopHeight(0.02); }, "more than one setting defines");
  refused(
      [](Ridge& r) {
        r.setStepOver(0.0);
        r.setScallopHeight(0.02);
      },
      "below the tool radius, 0 mm");
  refused(
      [](Ridge& r) {
        r.setStepOver(0.0);
        r.setSpot(4.0, 1.0);
      },
      "the overlap is 1");
  refused(
      [](Ridge& r) {
        r.setStepOver(0.0);
        r.setToolRadius(6.0);
        r.setScallopHeight(6.0);
      },
      "the scallop height is 6");
  refused([](Ridge& r) { r.setPointSpacing(0.0); }, "the spacing of points is 0");
  refused([](Ridge& r) { r.setLeadAngle(90.0); }, "the lead angle is 90 degrees");
  refused([](Ridge& r) { r.setRunIn(-1.0); }, "run-in");
  refused([](Ridge& r) { r.setRunOut(1e12); }, "run-out");
  refused([](Ridge& r) { r.setStepOver(std::numeric_limits<double>::infinity()); }, "step-over");
  refused([](Ridge& r) { r.setPointSpacing(1e-6); }, "raise the spacing of points");
  refused([](Ridge& r) { r.setReferenceNormal(Vector3d::Zero()); }, "has no direction");
  refused([](Ridge& r) { r.setNumberOfThreads(static_cast<unsigned int>(-1)); }, "number of threads");
  refused(
      [](Ridge& r) {
        r.setFlipNormals(true);
        r.setStepOver(0.0);
        r.setToolRadius(60.0);
        r.setScallopHeight(0.02);
      },
      "the ridge is hollow with radius");
}

} // namespace ridge_toolpath_test
