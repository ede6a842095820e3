// SPDX-License-Identifier: BSD-3-Clause
// Rows over scans of slopes, domes and waves: cutters with rounded corners reach the rims and leave the scallop height, by an oracle that
// moves the cutter over the exact surface.
#include "support/driven.h"
#include "support/height_field.h"

#include <pcl_spiral/cutter/cutter_location.h>

namespace scallop_any_cutter_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double size = 12.0, tolerance = 1e-3;

/** A plane that falls towards -y. */
class SlopedPlane : public HeightField {
public:
  explicit SlopedPlane(double degrees)
  : HeightField(Region({rectangle(size, size, {0.5 * size, 0.5 * size})})), rise_(std::tan(degrees * M_PI / 180.0))
  {}
  Jet jet(double, double y) const override { return {rise_ * y, 0.0, rise_, 0.0, 0.0, 0.0}; }

private:
  double rise_;
};

std::vector<ToolLocations>
located(const std::vector<Vector3d>& scan, const DrivePasses& passes, const CutterShape& cutter)
{
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(toCloud(scan));
  location.setCutter(cutter);
  location.setDrivePasses(passes);
  location.setPathTolerance(tolerance);
  std::vector<ToolLocations> located;
  location.compute(located);
  EXPECT_TRUE(location.getStatus().ok()) << location.getStatus().message();
  return located;
}

struct Move {
  Vector3d a, b;
};

/** Lowest height that a cutter with a vertical axis cuts at a place, by golden section along each move. */
double
cutHeight(const CutterProfile& cutter, const std::vector<Move>& moves, const Vector2d& at)
{
  constexpr double golden = 0.6180339887498949;
  double lowest = INFINITY;
  for (const Move& move : moves) {
    const auto height = [&](double s) {
      const Vector3d tip = move.a + s * (move.b - move.a);
      const double l = (at - tip.head<2>()).norm();
      return l <= cutter.radius() ? tip.z() + cutter.height(l) : 1e6 + l;
    };
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 22; ++k) {
      const double c = high - golden * (high - low), d = low + golden * (high - low);
      (height(c) < height(d) ? high : low) = height(c) < height(d) ? d : c;
    }
    lowest = std::min({lowest, height(low), height(0.0), height(1.0)});
  }
  return lowest;
}

/** Heights over the exact surface, square to it. */
struct Left {
  double most = 0.0, deepest = 0.0; ///< above and below it
  Vector3d place = Vector3d::Zero();
};

/** What passes leave more than a millimetre inside the rim. */
Left
heightsLeft(const AnalyticSurface& surface, const CutterProfile& cutter, const std::vector<ToolLocations>& passes)
{
  std::vector<Move> moves;
  for (const ToolLocations& pass : passes)
    for (std::size_t i = 0; i + 1 < pass.size(); ++i)
      moves.push_back({pass[i].tip, pass[i + 1].tip});
  const Sampled samples = sampleUniform(surface, 900, 17);
  Left left;
#pragma omp parallel for schedule(dynamic, 16) num_threads(2)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(samples.points.size()); ++i) {
    const Vector3d &x = samples.points[i], &n = samples.normals[i];
    if (surface.rimDistance(x) < 1.0)
      continue;
    std::vector<Move> near;
    for (const Move& move : moves) {
      const Vector2d p = x.head<2>(), a = move.a.head<2>(), d = (move.b - move.a).head<2>();
      const double s = d.squaredNorm() > 0.0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
      const double l = std::max(0.0, (p - a - s * d).norm() - 0.25);
      if (l <= cutter.radius() && std::min(move.a.z(), move.b.z()) + cutter.height(l) < x.z() + 0.2)
        near.push_back(move);
    }
    double low = -0.05, high = 0.2;
    for (int k = 0; k < 11; ++k) {
      const double middle = 0.5 * (low + high);
      const Vector3d at = x + middle * n;
      (cutHeight(cutter, near, at.head<2>()) <= at.z() ? high : low) = middle;
    }
#pragma omp critical
    {
      if (high > left.most)
        left.place = x;
      left.most = std::max(left.most, high);
      left.deepest = std::max(left.deepest, -high);
    }
  }
  return left;
}

void
expectScallop(const char* name, const AnalyticSurface& surface, const std::vector<Vector3d>& scan, const CutterShape& cutter,
              double direction, double height)
{
  const Driven run = driven(scan, [&](Drive& drive) {
    drive.setRows(DriveRows::Kept);
    drive.setCutter(cutter);
    drive.setScallopHeight(height);
    drive.setPlaneDirection(direction);
    drive.setPointSpacing(2.0);
  });
  const Left left = heightsLeft(surface, CutterProfile(cutter), located(scan, run.passes, cutter));
  std::printf("  %s, R %.1f r %.1f flank %.0f, direction %2.0f: %zu rows, %.3f to %.3f mm, leave %.3f h at (%.1f, %.1f), gouge %.4f mm\n",
              name, cutter.radius, cutter.corner_radius, cutter.flank_angle, direction, run.report.rows, run.report.smallest_step,
              run.report.step_over, left.most / height, left.place.x(), left.place.y(), left.deepest);
  EXPECT_LE(left.most, 1.05 * height + tolerance);
  EXPECT_GE(left.most, 0.5 * height);
  EXPECT_LE(left.deepest, 2.0 * tolerance);
  EXPECT_TRUE(run.report.warnings.empty());
}

} // namespace

TEST(ScallopAnyCutter, HoldsOnSlopes)
{
  for (const double degrees : {10.0, 30.0, 50.0}) {
    const SlopedPlane slope(degrees);
    const std::vector<Vector3d> scan = sampleUniform(slope, 1500, 3).points;
    for (const double direction : {0.0, 90.0}) {
      expectScallop("slope", slope, scan, CutterShape::ball(4.0), direction, 0.02);
      expectScallop("slope", slope, scan, CutterShape::bullNose(4.0, 1.0), direction, 0.02);
      expectScallop("slope", slope, scan, CutterShape::taperedBall(4.0, 12.0, 8.0), direction, 0.02);
    }
  }
}

TEST(ScallopAnyCutter, HoldsOnADome)
{
  const SurfacePtr dome = ball(20.0, Region({circle({0, 0}, 7.0)}));
  const std::vector<Vector3d> scan = sampleUniform(*dome, 2000, 3).points;
  for (const CutterShape& cutter :
       {CutterShape::ball(4.0), CutterShape::bullNose(4.0, 1.0), CutterShape::taperedBullNose(4.0, 0.8, 6.0, 10.0)})
    expectScallop("dome", *dome, scan, cutter, 20.0, 0.02);
}

TEST(ScallopAnyCutter, HoldsOnWaves)
{
  const SurfacePtr wave = waves({{0.3, 0.2, 0.25, 0.3}}, Region({rectangle(size, size, {0.5 * size, 0.5 * size})}));
  const std::vector<Vector3d> scan = sampleUniform(*wave, 3000, 3).points;
  for (const double direction : {0.0, 31.0})
    for (const CutterShape& cutter : {CutterShape::ball(4.0), CutterShape::bullNose(3.0, 2.0), CutterShape::taperedBall(4.0, 12.0, 8.0)})
      expectScallop("wave", *wave, scan, cutter, direction, 0.02);
}

/** Distance of the outermost contacts from each side of the square, where rows with the plain radius would end R sin(slope) inside. */
TEST(ScallopAnyCutter, ContactsReachTheRimsOfASlope)
{
  constexpr double step = 1.0;
  for (const double degrees : {10.0, 40.0})
    for (const CutterShape& cutter : {CutterShape::ball(5.0), CutterShape::bullNose(6.0, 1.5)})
      for (const double direction : {0.0, 90.0}) {
        const SlopedPlane slope(degrees);
        const std::vector<Vector3d> scan = sampleUniform(slope, 1500, 5).points; // 0.3 mm apart
        const Driven run = driven(scan, [&](Drive& drive) {
          drive.setStepOver(step);
          drive.setCutter(cutter);
          drive.setPlaneDirection(direction);
        });
        double low = INFINITY, farthest = 0.0;
        for (const ToolLocations& pass : located(scan, run.passes, cutter))
          for (const ToolLocation& at : pass) {
            low = std::min(low, at.contact.y());
            farthest = std::max(farthest, -at.contact.y());
          }
        std::printf("  %2.0f degrees, R %.0f r %.1f, direction %2.0f: lowest contact %.3f mm from the rim\n", degrees, cutter.radius,
                    cutter.corner_radius, direction, low);
        EXPECT_LE(low, 0.5 * step + 0.3);
        EXPECT_LE(farthest, 0.01);
      }
}

/** On a dome, every part of the rim is reached. */
TEST(ScallopAnyCutter, ContactsReachTheRimOfADome)
{
  const SurfacePtr dome = ball(20.0, Region({circle({0, 0}, 12.0)}));
  const std::vector<Vector3d> scan = sampleUniform(*dome, 5000, 3).points;
  const Driven run = driven(scan, [](Drive& drive) {
    drive.setStepOver(0.6);
    drive.setCutter(CutterShape::ball(5.0));
  });
  std::vector<double> reached(36, 0.0); // by sectors
  for (const ToolLocations& pass : located(scan, run.passes, CutterShape::ball(5.0)))
    for (const ToolLocation& at : pass) {
      const double turn = std::atan2(at.contact.y(), at.contact.x()) / (2.0 * M_PI) + 0.5;
      double& most = reached[std::min<std::size_t>(35, static_cast<std::size_t>(36.0 * turn))];
      most = std::max(most, at.contact.head<2>().norm());
    }
  const double least = *std::min_element(reached.begin(), reached.end());
  std::printf("  outermost contacts at %.3f mm and more of 12\n", least);
  EXPECT_GE(least, 12.0 - 0.3 - 0.3);
  EXPECT_LE(run.passes.size(), run.report.rows + 2);
}

} // namespace scallop_any_cutter_test
