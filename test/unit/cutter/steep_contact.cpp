// SPDX-License-Identifier: BSD-3-Clause
// Contacts where a height along the axis has no meaning: flanks along walls, and cutters smaller than the gaps
// of the scan.
#include <pcl_spiral/cutter/cutter_location.h>

#include "support/located.h"

#include <gtest/gtest.h>

#include <cmath>

namespace steep_contact_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

/** A wall at x = 10, 60 x 40, with noise. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
wall(double noise)
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  Random random(1);
  for (int i = 0; i < 20000; ++i)
    cloud->emplace_back(10.0 + noise * random.normal(), random.uniform(-30, 30), random.uniform(0, 40));
  return cloud;
}

} // namespace

TEST(SteepContact, AFlankAlongAWallReachesItInSpiteOfNoise)
{
  const Vector3d up = Vector3d::UnitZ(), out = -Vector3d::UnitX();
  const double a = 10.0 * M_PI / 180.0;
  for (const double noise : {0.0, 0.003}) {
    const Located straight =
        located(wall(noise), CutterShape::flatEnd(5.0, 15.0), {{{10.0, 0.0, 15.0}, up, out}, {{10.3, 0.0, 15.0}, up, out}});
    EXPECT_EQ(straight.locations[0].state, LocationState::Reached) << noise;
    EXPECT_EQ(straight.locations[0].basis, LocationBasis::AskedContact);
    EXPECT_LT((straight.locations[0].tip - Vector3d(5.0, 0.0, 15.0)).norm(), 1e-6);
    EXPECT_EQ(straight.locations[1].state, LocationState::Lifted) << "a third of a millimetre into the wall";
    EXPECT_GT(straight.locations[1].lift, 20.0);
    const Located cone = located(wall(noise), CutterShape::taperedBall(5.0, 15.0, 10.0),
                                 {{{10.0, 0.0, 15.0}, Vector3d(-std::sin(a), 0.0, std::cos(a)), out}});
    EXPECT_EQ(cone.locations[0].state, LocationState::Reached) << noise;
  }
}

TEST(SteepContact, ACutterBetweenThePointsStandsOnTheSurface)
{
  const SurfacePtr plane = flat(Region({rectangle(60.0, 60.0)}));
  const auto cloud = toCloud(sampleUniform(*plane, 5000, 2).points); // one point per 0.7 mm^2; the cutter covers 0.03
  const CutterShape cutter = CutterShape::bullNose(0.1, 0.02, 1.0);
  DrivePoints drive = drivePoints(*plane, 200, 20.0, 5.0, true, 3);
  const Located run = located(cloud, cutter, drive);
  EXPECT_EQ(run.figures.count(LocationState::Reached), drive.size());
  EXPECT_GT(run.figures.count(LocationBasis::AskedContact), 150u);
  for (std::size_t i = 0; i < drive.size(); ++i) {
    const CutterContact c = CutterProfile(cutter).locate(drive[i].position, drive[i].normal, drive[i].axis);
    ASSERT_LT((run.locations[i].tip - c.tip).norm(), 1e-4);
  }
  for (DrivePoint& d : drive)
    d.position.z() += 0.5;
  const Located above = located(cloud, cutter, drive);
  EXPECT_EQ(above.figures.count(LocationState::Clear), drive.size());
  for (DrivePoint& d : drive)
    d.position.z() -= 1.0;
  const Located below = located(cloud, cutter, drive);
  EXPECT_EQ(below.figures.count(LocationState::Lifted), drive.size());
  for (std::size_t i = 0; i < drive.size(); ++i)
    ASSERT_NEAR(below.locations[i].lift * drive[i].axis.z(), 0.5, 1e-3);
}

TEST(SteepContact, OffTheScanNothingIsClaimed)
{
  const SurfacePtr plane = flat(Region({rectangle(60.0, 60.0), circle({0, 0}, 6.0)}));
  const Vector3d up = Vector3d::UnitZ();
  const Located run =
      located(toCloud(sampleUniform(*plane, 5000, 4).points), CutterShape::ball(0.1), {{{0, 0, 0}, up, up}, {{40, 0, 0}, up, up}});
  EXPECT_EQ(run.figures.count(LocationState::NoCloud), 2u);
}

TEST(SteepContact, ANoisyScanIsSaidToBeKnownLessWellThanTheTolerance)
{
  const SurfacePtr plane = flat(Region({rectangle(60.0, 60.0)}));
  Sampled sampled = sampleUniform(*plane, 10000, 5);
  addNoise(sampled, 0.1, 6);
  const Vector3d up = Vector3d::UnitZ();
  const Located run = located(toCloud(sampled.points), CutterShape::ball(5.0), {{{0, 0, 0}, up, up}});
  ASSERT_EQ(run.figures.warnings.size(), 1u);
  EXPECT_NE(run.figures.warnings[0].text().find("more than the contact tolerance of 0.01 mm"), std::string::npos);
}

} // namespace steep_contact_test
