// SPDX-License-Identifier: BSD-3-Clause
// The class DrivePath: changes that must not change its output, and refusals.
#include "support/driven.h"

#include <Eigen/Geometry>

#include <limits>
#include <string>

namespace drive_path_class_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

std::vector<Vector3d>
someColumn(std::size_t count)
{
  Random random(1);
  std::vector<Vector3d> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double z = random.uniform(-15.0, 15.0), a = random.uniform(0.0, 2.0 * M_PI), r = 12.0 + 0.01 * z * z;
    points.emplace_back(r * std::cos(a), r * std::sin(a), z);
  }
  return points;
}

void
refused(const std::vector<Vector3d>& points, const std::function<void(Drive&)>& set, const std::string& words)
{
  const Driven run = driven(points, set, false);
  EXPECT_NE(run.status.message().find(words), std::string::npos) << run.status.message();
  EXPECT_TRUE(run.passes.empty());
}

} // namespace

TEST(DrivePath, OrderOfTheCloudAndThreadsChangeNothing)
{
  const std::vector<Vector3d> patch = sampleUniform(*quadric(90.0, -60.0, Region({circle({0, 0}, 20.0)})), 5000, 2).points;
  const std::vector<Vector3d> column = someColumn(5000);
  for (const DriveKind kind : {DriveKind::Planes, DriveKind::Helix, DriveKind::Rings, DriveKind::BoundaryOffset})
    for (const DriveAxisMode mode : {DriveAxisMode::Fixed, DriveAxisMode::LocalPlane, DriveAxisMode::Surface}) {
      const auto set = [&](Drive& drive) {
        drive.setKind(kind);
        drive.setStepOver(2.3);
        drive.setAxisMode(mode);
      };
      const std::vector<Vector3d>& points = kind == DriveKind::Helix || kind == DriveKind::Rings ? column : patch;
      const Driven one = driven(points, [&](Drive& drive) {
        set(drive);
        drive.setNumberOfThreads(1);
      });
      const Driven three = driven(points, [&](Drive& drive) {
        set(drive);
        drive.setNumberOfThreads(3);
      });
      std::vector<Vector3d> mixed;
      for (const std::size_t i : shuffled(points.size(), 3))
        mixed.push_back(points[i]);
      const Driven other = driven(mixed, set);
      EXPECT_EQ(difference(one.passes, three.passes), 0.0);
      EXPECT_LT(difference(one.passes, other.passes), 1e-6);
      EXPECT_GT(one.report.points, 100u);
    }
}

TEST(DrivePath, KeptAndLinkedRowsAreTheSameForAnyOrderAndThreads)
{
  const std::vector<Vector3d> patch = sampleUniform(*quadric(90.0, -60.0, Region({circle({0, 0}, 20.0)})), 9000, 2).points;
  const auto set = [](unsigned int threads, double height) {
    return [=](Drive& drive) {
      drive.setRows(DriveRows::Kept);
      drive.setToolRadius(5.0);
      drive.setScallopHeight(height);
      drive.setLinkRows(true);
      drive.setNumberOfThreads(threads);
    };
  };
  for (const double height : {0.01, 0.1}) { // the cloud denser than half a step, or not
    const Driven one = driven(patch, set(1, height)), three = driven(patch, set(3, height));
    EXPECT_EQ(difference(one.passes, three.passes), 0.0);
    EXPECT_GT(one.report.links, 10U);
    std::vector<Vector3d> mixed;
    for (const std::size_t i : shuffled(patch.size(), 3))
      mixed.push_back(patch[i]);
    EXPECT_LT(difference(one.passes, driven(mixed, set(2, height)).passes), 1e-6);
  }
}

TEST(DrivePath, MovesWithThePart)
{
  const std::vector<Vector3d> patch = sampleUniform(*quadric(90.0, -60.0, Region({rectangle(40.0, 30.0)})), 9000, 4).points;
  const Driven still = driven(patch, [](Drive& drive) { drive.setStepOver(2.3); });
  const Eigen::Isometry3d motion = randomMotion(5, 20.0);
  std::vector<Vector3d> moved;
  for (const Vector3d& p : patch)
    moved.push_back(motion * p);
  const Driven run = driven(moved, [&](Drive& drive) {
    drive.setStepOver(2.3);
    drive.setAxis(motion.linear().col(2));
    drive.setPlaneDirection(Vector3d(motion.linear().col(0)));
  });
  ASSERT_EQ(run.passes.size(), still.passes.size());
  EXPECT_NEAR(run.report.length, still.report.length, 1.0);
  for (std::size_t k = 0; k < run.passes.size(); ++k)
    for (const bool last : {false, true}) {
      const auto &a = run.passes[k].points, &b = still.passes[k].points;
      EXPECT_LT(((last ? a.back() : a.front()).position - motion * (last ? b.back() : b.front()).position).norm(), 0.5);
    }
}

TEST(DrivePath, RefusesWhatCannotBe)
{
  const std::vector<Vector3d> plate = sampleUniform(*flat(Region({rectangle(20.0, 10.0)})), 1000, 6).points;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto step = [](Drive& drive) { drive.setStepOver(1.0); };
  refused({}, step, "missing or empty");
  refused({plate.begin(), plate.begin() + 49}, step, "49 usable points");
  refused(std::vector<Vector3d>(200, Vector3d::Ones()), step, "1 usable points");
  refused(
      plate, [](Drive&) {}, "the step-over is 0 mm");
  refused(
      plate, [&](Drive& d) { d.setStepOver(nan); }, "step-over");
  refused(
      plate,
      [](Drive& d) {
        d.setStepOver(1.0);
        d.setPointSpacing(-2.0);
      },
      "spacing of drive points is -2 mm");
  refused(
      plate,
      [](Drive& d) {
        d.setStepOver(1.0);
        d.setAxis(Vector3d::Zero());
      },
      "no direction");
  refused(
      plate,
      [](Drive& d) {
        d.setStepOver(1.0);
        d.setPlaneDirection(Vector3d(0, 0, -3));
      },
      "parallel to the tool axis");
  refused(
      plate,
      [&](Drive& d) {
        d.setStepOver(1.0);
        d.setPlaneDirection(nan);
      },
      "the direction of the passes is nan degrees: it must be a number");
  refused(
      plate,
      [](Drive& d) {
        d.setStepOver(1.0);
        d.setNumberOfThreads(-1);
      },
      "threads");
  refused(
      plate, [](Drive& d) { d.setStepOver(1e-7); }, "too large");
  refused(
      plate,
      [](Drive& d) {
        d.setStepOver(1e-300);
        d.setPointSpacing(1e-300);
      },
      "too large");
  refused(
      plate, [](Drive& d) { d.setKind(DriveKind::Curve); }, "setCurve");
  refused(
      plate,
      [](Drive& d) {
        d.setKind(DriveKind::Curve);
        d.setCurve({{0, 0, 0}, {1, 0, 0}});
        d.setPointSpacing(1e-9);
      },
      "too large");
  refused(
      plate,
      [](Drive& d) {
        d.setKind(DriveKind::Curve);
        d.setCurve({{0, 0, 500}, {1, 0, 500}, {2, 0, 500}});
        d.setCylinder({{0, 0, 500}, {1, 0, 0}, 0.0, 1.0});
        d.setAxisMode(DriveAxisMode::Cylinder);
      },
      "lies on the axis of the drive cylinder");
  const auto kept = [](double radius, double height, DriveKind kind, DriveAxisMode mode) {
    return [=](Drive& d) {
      d.setStepOver(1.0);
      d.setRows(DriveRows::Kept);
      d.setToolRadius(radius);
      d.setScallopHeight(height);
      d.setKind(kind);
      d.setAxisMode(mode);
    };
  };
  refused(plate, kept(0.0, 0.01, DriveKind::Planes, DriveAxisMode::Fixed), "the cutter's radius is 0 mm");
  refused(plate, kept(nan, 0.01, DriveKind::Planes, DriveAxisMode::Fixed), "setScallopHeight");
  refused(plate, kept(3.0, 3.0, DriveKind::Planes, DriveAxisMode::Fixed), "the height above 0 and below the radius");
  refused(plate, kept(3.0, nan, DriveKind::Planes, DriveAxisMode::Fixed), "setScallopHeight");
  refused(plate, kept(3.0, 0.01, DriveKind::BoundaryOffset, DriveAxisMode::Fixed), "only section planes can keep rows");
  refused(plate, kept(3.0, 0.01, DriveKind::Planes, DriveAxisMode::Cylinder), "not to a cylinder");
  refused(plate, kept(3.0, 1e-15, DriveKind::Planes, DriveAxisMode::Fixed), "raise the scallop height");
  const auto linked = [](DriveKind kind, bool zigzag) {
    return [=](Drive& d) {
      d.setStepOver(1.0);
      d.setLinkRows(true);
      d.setKind(kind);
      d.setZigzag(zigzag);
    };
  };
  refused(plate, linked(DriveKind::BoundaryOffset, true), "planes can be linked");
  refused(plate, linked(DriveKind::Planes, false), "back and forth");
  const std::vector<Vector3d> column = someColumn(3000);
  const auto rings = [](const DriveCylinder& cylinder) {
    return [cylinder](Drive& d) {
      d.setKind(DriveKind::Rings);
      d.setStepOver(1.0);
      d.setCylinder(cylinder);
    };
  };
  refused(column, rings({{0, 0, 0}, {0, 0, 0}, 0.0, 1.0}), "no length");
  refused(column, rings({{0, 0, 0}, {0, 0, 1}, 5.0, 4.0}), "last end above the first");
  refused(column, rings({{0, 0, 0}, {0, 0, 1}, 50.0, 60.0}), "no point of the part");
  Drive empty;
  DrivePasses passes(3);
  empty.compute(passes);
  EXPECT_EQ(empty.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_TRUE(passes.empty());
}

TEST(DrivePath, CanBeCancelledAtEachStage)
{
  const std::vector<Vector3d> plate = sampleUniform(*flat(Region({rectangle(20.0, 10.0)})), 1000, 7).points;
  int stages = 0;
  driven(plate, [&](Drive& d) {
    d.setStepOver(1.0);
    d.setProgressCallback([&](double, const std::string&) { return ++stages > 0; });
  });
  EXPECT_GE(stages, 3);
  for (int stop = 1; stop <= stages; ++stop) {
    int calls = 0;
    const Driven run = driven(
        plate,
        [&](Drive& d) {
          d.setStepOver(1.0);
          d.setProgressCallback([&](double, const std::string&) { return ++calls < stop; });
        },
        false);
    EXPECT_EQ(run.status.code(), StatusCode::Cancelled);
    EXPECT_TRUE(run.passes.empty());
  }
}

TEST(DrivePath, TakesIndicesAndOtherPointTypes)
{
  const std::vector<Vector3d> plate = sampleUniform(*flat(Region({rectangle(20.0, 10.0)})), 2000, 8).points;
  pcl::PointCloud<pcl::PointNormal>::Ptr cloud(new pcl::PointCloud<pcl::PointNormal>);
  pcl::IndicesPtr left(new pcl::Indices);
  for (const Vector3d& p : plate) {
    pcl::PointNormal q;
    q.getVector3fMap() = p.cast<float>();
    if (p.x() < 0.0)
      left->push_back(static_cast<int>(cloud->size()));
    cloud->push_back(q);
  }
  DrivePath<pcl::PointNormal> drive;
  drive.setInputCloud(cloud);
  drive.setIndices(left);
  drive.setStepOver(1.0);
  DrivePasses passes;
  drive.compute(passes);
  ASSERT_TRUE(drive.getStatus().ok());
  for (const DrivePass& pass : passes)
    for (const DrivePoint& p : pass.points)
      EXPECT_LT(p.position.x(), 0.0);
  left->push_back(5000);
  drive.compute(passes);
  EXPECT_NE(drive.getStatus().message().find("outside the cloud"), std::string::npos);
}

} // namespace drive_path_class_test
