// SPDX-License-Identifier: BSD-3-Clause
// Cutter locations on meshes of known surfaces: contacts reached, and places that lift the cutter.
#include <pcl_spiral/cutter/cutter_location.h>

#include "support/located_on_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mesh_location_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

/** A bore of the radius 10 about z, to z = 40, seen from inside, over a floor at z = 0. */
PlainMesh
bore(int sectors)
{
  PlainMesh m;
  const auto at = [&](int i, double z) {
    const double phi = 2.0 * M_PI * i / sectors;
    return Vector3d(10.0 * std::cos(phi), 10.0 * std::sin(phi), z);
  };
  for (int i = 0; i < sectors; ++i) {
    m.addQuad(at(i, 0), at(i, 40), at(i + 1, 40), at(i + 1, 0));
    m.addQuad(Vector3d::Zero(), at(i, 0), at(i + 1, 0), at(i + 1, 0));
  }
  return m;
}

} // namespace

TEST(MeshLocation, InAValleyNarrowerThanTheBallItIsLiftedAndGougesNoMoreThanTheMeshIsOff)
{
  const Waves waves{2.0, 0.6}; // radius of the valleys 1.39
  const double bottom = M_PI / waves.k, R = 3.0;
  for (const double step : {0.6, 0.3, 0.15}) {
    const double e = 2.0 * 0.36 * step * step / 8.0;
    const DrivePoints drive = contactsOn(waves, bottom - 0.8, bottom + 0.8, 1);
    for (const Evaluation evaluation : {Evaluation::FittedSurface, Evaluation::Points}) {
      const Located run = onMesh(waves.mesh(step).polygons(), CutterShape::ball(R, 10.0), drive, evaluation);
      EXPECT_EQ(run.figures.count(LocationState::Lifted), drive.size());
      for (std::size_t i = 0; i < drive.size(); ++i) {
        const ToolLocation& l = run.locations[i];
        ASSERT_GT(l.lift, 0.1);
        ASSERT_GE(waves.distance(l.tip + R * l.axis), R - (e + 0.002)) << step << ' ' << i;
        ASSERT_LE(waves.distance(l.tip + R * l.axis), R + e + 0.002) << step << ' ' << i;
      }
      ASSERT_FALSE(run.figures.warnings.empty());
      EXPECT_NE(run.figures.warnings.back().text().find("200 of 200 locations are lifted off their given contact, the most by"),
                std::string::npos);
    }
  }
}

TEST(MeshLocation, GentleContactsAreReachedAtTheExactOffset)
{
  const Waves waves{2.0, 0.3}; // radius of the valleys 5.6
  for (const CutterShape& cutter : {CutterShape::ball(3.0, 10.0), CutterShape::bullNose(3.0, 2.0, 10.0)}) {
    const DrivePoints drive = contactsOn(waves, -10.0, 10.0, 2);
    const Located run = onMesh(waves.mesh(0.25).polygons(), cutter, drive);
    std::size_t gentle = 0;
    for (std::size_t i = 0; i < drive.size(); ++i) {
      const CutterContact c = CutterProfile(cutter).locate(drive[i].position, drive[i].normal, drive[i].axis);
      if (waves.curvature(drive[i].position.x()) * 3.0 > (cutter.corner_radius < 3.0 ? 0.0 : 0.9))
        continue; // hollow: a flat end wider than the corner does not fit
      ++gentle;
      EXPECT_EQ(run.locations[i].state, LocationState::Reached) << i << ' ' << run.locations[i].lift;
      ASSERT_LT((run.locations[i].tip - c.tip).norm(), 1e-3) << i;
      EXPECT_LT((run.locations[i].contact - drive[i].position).norm(), 0.2);
      EXPECT_GT(run.locations[i].normal.dot(drive[i].normal), 0.999);
    }
    EXPECT_GT(gentle, 80u);
  }
}

TEST(MeshLocation, HollowsLieBehindTheirFacets)
{
  const Waves waves{-8.0, 0.1}; // a valley of the radius 12.5 at 0
  const DrivePoints drive{{waves.at(0.5, 0.5), up, none}};
  const PlainMesh mesh = waves.mesh(2.0);
  const Located curved = onMesh(mesh.polygons(), CutterShape::ball(6.0), drive);
  const Located facets = onMesh(mesh.polygons(), CutterShape::ball(6.0), drive, Evaluation::Points);
  double exact = -1e300; // of the ball over x = 0.5
  for (double x = -5.0; x < 6.0; x += 1e-4)
    exact = std::max(exact, waves.height(x) - CutterProfile(CutterShape::ball(6.0)).height(std::abs(x - 0.5)));
  EXPECT_NEAR(curved.locations[0].tip.z(), exact, 1e-3);
  EXPECT_GT(facets.locations[0].tip.z(), exact + 0.01) << "held by the chord";
}

TEST(MeshLocation, AFlatEndStandsOnAFloorAndIsLiftedOverAWall)
{
  const PlainMesh mesh = pocket();
  const CutterShape cutter = CutterShape::flatEnd(4.0, 30.0);
  const Located run =
      onMesh(mesh.polygons(), cutter, {{{0, 0, 0}, up, up}, {{3, -5, 50}, up, none}, {{8, 0, 0}, up, up}, {{6, 0, 0}, up, up}});
  EXPECT_EQ(run.locations[0].state, LocationState::Reached);
  EXPECT_EQ(run.locations[0].tip, Vector3d(0, 0, 0));
  EXPECT_EQ(run.locations[1].state, LocationState::Touching);
  EXPECT_NEAR(run.locations[1].tip.z(), 0.0, 1e-12);
  EXPECT_FALSE(run.locations[1].over_rim);
  EXPECT_EQ(run.locations[2].state, LocationState::Lifted);
  EXPECT_NEAR(run.locations[2].lift, 20.0, 1e-12);
  EXPECT_TRUE(run.locations[2].over_rim);
  EXPECT_EQ(run.locations[2].rim_clearance, 0.0);
  EXPECT_LE(run.locations[3].lift, 20.0); // along the wall: on either side by rounding
}

TEST(MeshLocation, FlanksReachTheWallOfABoreThatIsTakenForRound)
{
  DrivePoints drive;
  for (int i = 0; i < 96; ++i) {
    const double phi = 2.0 * M_PI * (i + 0.37) / 96;
    const Vector3d out(std::cos(phi), std::sin(phi), 0.0);
    drive.push_back({10.0 * out + 20.0 * up, up, -out});
  }
  const CutterShape cutter = CutterShape::flatEnd(5.0, 15.0);
  const Located round = onMesh(bore(48).polygons(), cutter, drive);
  EXPECT_EQ(round.figures.count(LocationState::Reached), drive.size());
  EXPECT_EQ(round.figures.count(LocationBasis::AskedContact), drive.size());
  for (std::size_t i = 0; i < drive.size(); ++i)
    ASSERT_LT((round.locations[i].tip - 0.5 * (drive[i].position - 20.0 * up) - 20.0 * up).norm(), 1e-9);
  const Located facets = onMesh(bore(48).polygons(), cutter, drive, Evaluation::Points);
  EXPECT_GT(facets.figures.count(LocationState::Lifted), 50u) << "the facets lie up to 0.021 mm within the bore";
  const Located wide = onMesh(bore(48).polygons(), CutterShape::flatEnd(10.1, 15.0), drive);
  EXPECT_EQ(wide.figures.count(LocationState::Lifted), drive.size());
}

TEST(MeshLocation, EveryState)
{
  const PlainMesh mesh = pocket();
  const Vector3d side(1, 0, 0);
  const Located run = onMesh(mesh.polygons(), CutterShape::ball(2.0, 10.0),
                             {{{0, 0, 9}, up, none},      // touching
                              {{0, 0, 0}, up, up},        // reached
                              {{9.5, 0, 0}, up, up},      // lifted by the wall
                              {{0, 0, 5}, up, up},        // clear
                              {{0, 0, 0}, -up, up},       // unreachable: from below
                              {{40, 0, 0}, up, up},       // no mesh
                              {{-10, 0, 10}, up, side},   // the flank along the wall
                              {{-10, 0, 25}, up, side}}); // above the wall
  const LocationState expected[] = {LocationState::Touching,    LocationState::Reached, LocationState::Lifted,  LocationState::Clear,
                                    LocationState::Unreachable, LocationState::NoCloud, LocationState::Reached, LocationState::Clear};
  for (std::size_t i = 0; i < run.locations.size(); ++i)
    EXPECT_EQ(run.locations[i].state, expected[i]) << i;
  EXPECT_EQ(run.locations[6].basis, LocationBasis::AskedContact);
  EXPECT_NEAR(run.locations[3].lift, -5.0, 1e-12);
  EXPECT_FALSE(run.locations[5].tip.allFinite());
  EXPECT_NE(run.figures.warnings[0].text().find("1 of 8 locations have no face of the mesh under the cutter"), std::string::npos);
}

} // namespace mesh_location_test
