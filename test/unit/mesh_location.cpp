// Cutters located on meshes of known surfaces: what is reached, what lifts the cutter, holders, and what is refused.
#include <pcl_spiral/toolpath/cutter_location.h>

#include "support/located.h"
#include "support/plain_mesh.h"
#include "toolpath/mesh_collision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

using Location = CutterLocation<pcl::PointXYZ>;
const Vector3d up = Vector3d::UnitZ(), none = Vector3d::Zero();

template <typename Mesh, typename Change>
Located
onMesh(const Mesh& mesh, const CutterShape& cutter, const DrivePoints& drive, const Change& change)
{
  Location location;
  location.setInputMesh(mesh);
  location.setCutter(cutter);
  location.setDrivePoints(drive);
  change(location);
  Located run;
  location.compute(run.locations);
  run.figures = location.getFigures();
  run.status = location.getStatus();
  EXPECT_TRUE(run.status.ok()) << run.status.message();
  return run;
}

template <typename Mesh>
Located
onMesh(const Mesh& mesh, const CutterShape& cutter, const DrivePoints& drive,
       Evaluation evaluation = Evaluation::FittedSurface)
{
  return onMesh(mesh, cutter, drive, [&](Location& l) { l.setEvaluation(evaluation); });
}

/** z = a cos(k x): its valleys have the radius 1 / (a k^2). */
struct Waves {
  double a, k;

  double height(double x) const { return a * std::cos(k * x); }
  Vector3d at(double x, double y) const { return {x, y, height(x)}; }
  Vector3d
  normal(double x) const
  {
    return Vector3d(a * k * std::sin(k * x), 0.0, 1.0).normalized();
  }
  double
  curvature(double x) const // positive in valleys
  {
    const double slope = a * k * std::sin(k * x);
    return -a * k * k * std::cos(k * x) / std::pow(1.0 + slope * slope, 1.5);
  }
  double
  distance(const Vector3d& p) const
  {
    double best = 1e300;
    for (double x = p.x() - 8.0; x < p.x() + 8.0; x += 0.001)
      best = std::min(best, std::hypot(x - p.x(), height(x) - p.z()));
    return best;
  }
  PlainMesh mesh(double step) const
  {
    return graphMesh([this](double x, double) { return height(x); }, 15.0, step);
  }
};

/** Contacts along x with axes leaning by up to half the cutter's reach. */
DrivePoints
contactsOn(const Waves& waves, double from, double to, std::uint64_t seed)
{
  Random random(seed);
  DrivePoints drive;
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform(from, to), y = random.uniform(-6, 6);
    drive.push_back({waves.at(x, y), leaning(waves.normal(x), 15.0, random), waves.normal(x)});
  }
  return drive;
}

/** A pocket: floor 20 by 20 at z = 0, walls to z = 20. */
PlainMesh
pocket()
{
  PlainMesh m;
  m.addQuad({-10, -10, 0}, {10, -10, 0}, {10, 10, 0}, {-10, 10, 0});
  m.addQuad({10, -10, 0}, {10, -10, 20}, {10, 10, 20}, {10, 10, 0});
  m.addQuad({-10, 10, 0}, {-10, 10, 20}, {-10, -10, 20}, {-10, -10, 0});
  m.addQuad({-10, -10, 0}, {-10, -10, 20}, {10, -10, 20}, {10, -10, 0});
  m.addQuad({10, 10, 0}, {10, 10, 20}, {-10, 10, 20}, {-10, 10, 0});
  return m;
}

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
      EXPECT_NE(run.figures.warnings.back().find("200 of 200 locations are lifted off the contact asked for, the most"),
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
        continue; // hollow: a flat wider than the corner does not fit
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
  const Located run = onMesh(mesh.polygons(), cutter,
                             {{{0, 0, 0}, up, up}, {{3, -5, 50}, up, none}, {{8, 0, 0}, up, up}, {{6, 0, 0}, up, up}});
  EXPECT_EQ(run.locations[0].state, LocationState::Reached);
  EXPECT_EQ(run.locations[0].tip, Vector3d(0, 0, 0));
  EXPECT_EQ(run.locations[1].state, LocationState::Touching);
  EXPECT_NEAR(run.locations[1].tip.z(), 0.0, 1e-12);
  EXPECT_FALSE(run.locations[1].over_rim);
  EXPECT_EQ(run.locations[2].state, LocationState::Lifted);
  EXPECT_NEAR(run.locations[2].lift, 20.0, 1e-12);
  EXPECT_TRUE(run.locations[2].over_rim);
  EXPECT_EQ(run.locations[2].rim_clearance, 0.0);
  EXPECT_LE(run.locations[3].lift, 20.0); // along the wall: either side of it by rounding
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
                             {{{0, 0, 9}, up, none},         // touching
                              {{0, 0, 0}, up, up},           // reached
                              {{9.5, 0, 0}, up, up},         // lifted by the wall
                              {{0, 0, 5}, up, up},           // clear
                              {{0, 0, 0}, -up, up},          // unreachable: from below
                              {{40, 0, 0}, up, up},          // no mesh
                              {{-10, 0, 10}, up, side},      // the flank along the wall
                              {{-10, 0, 25}, up, side}});    // above the wall
  const LocationState expected[] = {LocationState::Touching,    LocationState::Reached, LocationState::Lifted,
                                    LocationState::Clear,       LocationState::Unreachable, LocationState::NoCloud,
                                    LocationState::Reached,     LocationState::Clear};
  for (std::size_t i = 0; i < run.locations.size(); ++i)
    EXPECT_EQ(run.locations[i].state, expected[i]) << i;
  EXPECT_EQ(run.locations[6].basis, LocationBasis::AskedContact);
  EXPECT_NEAR(run.locations[3].lift, -5.0, 1e-12);
  EXPECT_FALSE(run.locations[5].tip.allFinite());
  EXPECT_NE(run.figures.warnings[0].find("1 of 8 locations have no face of the mesh under the cutter"), std::string::npos);
}

TEST(MeshLocation, AHolderMeetsAWallOfTwoTriangles)
{
  PlainMesh mesh;
  mesh.addQuad({-12, -12, 0}, {12, -12, 0}, {12, 12, 0}, {-12, 12, 0});
  mesh.addQuad({12, -500, -500}, {12, -500, 500}, {12, 500, 500}, {12, 500, -500});
  const auto run = [&](double radius, double clearance) {
    return onMesh(mesh.polygons(), CutterShape::ball(2.0, 10.0), {{{0, 0, 0}, up, up}}, [&](Location& l) {
             l.setHolder({ToolSegment::cylinder(2.0, 20.0, "shank"), ToolSegment{radius - 5.0, radius, 20.0, "chuck"}});
             l.setHolderClearance(clearance);
           }).locations[0].collision;
  };
  EXPECT_FALSE(run(11.9, 0.0).found());
  const HolderCollision deep = run(15.0, 0.0);
  EXPECT_EQ(deep.segment, 1);
  const double expected = 3.0 / std::hypot(1.0, 0.25);
  EXPECT_LE(deep.depth, expected + 1e-9);
  EXPECT_GE(deep.depth, expected - 1e-3);
  EXPECT_NEAR(deep.place.x(), 12.0, 1e-9);
  EXPECT_TRUE(run(11.9, 0.2).found());
}

TEST(MeshLocation, HoldersAgainstSamplesOfEveryFacet)
{
  Random random(3);
  const HolderProfile holder({ToolSegment::cylinder(3.0, 8.0, "shank"), {6.0, 12.0, 6.0, "nut"}, {12.0, 8.0, 10.0, "chuck"}}, 5.0,
                             2.0, 0.3);
  constexpr double tolerance = 0.01, precision = 1e-3;
  constexpr int n = 300;
  std::size_t found = 0;
  for (int i = 0; i < 300; ++i) {
    PatchCell cell;
    for (int k = 0; k < 3; ++k)
      cell.corners.col(k) = Vector3d(random.uniform(-40, 40), random.uniform(-40, 40), random.uniform(-15, 40));
    for (int k = 0; k < 3; ++k)
      cell.bows.col(k) = i % 2 * Vector3d(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4));
    const AxisFrame frame({1.0, -1.0, 0.0}, leaning(up, 40.0, random));
    const double tip = random.uniform(-3.0, 3.0);
    const auto depthAt = [&](const Vector3d& p, int& segment) {
      double depth = 0.0;
      segment = holder.inside(frame.across(p).norm(), frame.along(p) - tip, depth);
      return segment < 0 ? 0.0 : depth;
    };
    const HolderCollision c = findCollision(PatchTree({cell}), holder, frame, tip, tolerance, 1e-4);
    double sampled = 0.0;
    int segment = -1;
    for (int u = 0; u <= n; ++u)
      for (int v = 0; u + v <= n; ++v)
        sampled = std::max(sampled, depthAt(cell.position(Vector3d(n - u - v, u, v) / n), segment));
    found += c.found();
    ASSERT_LE(sampled, (c.found() ? c.depth : tolerance) + precision + 1e-9) << i;
    if (c.found()) {
      ASSERT_NEAR(depthAt(c.place, segment), c.depth, 1e-6) << i;
      EXPECT_EQ(segment, c.segment);
    }
  }
  EXPECT_GT(found, 60u);
}

TEST(MeshLocation, AxesAreTiltedAndMovesBisectedAsOnClouds)
{
  const PlainMesh mesh = pocket();
  const Located tilted = onMesh(mesh.polygons(), CutterShape::ball(2.0, 30.0), {{{0, 0, 0}, {0.9, 0, 1}, up}}, [](Location& l) {
    l.setMaxRetilt(40.0);
  });
  EXPECT_EQ(tilted.locations[0].state, LocationState::Reached);
  EXPECT_GT(tilted.locations[0].retilt, 1.0);
  const Waves waves{2.0, 0.3};
  DrivePoints line;
  for (double x = -8.0; x <= 8.0; x += 4.0)
    line.push_back({waves.at(x, 0.0), up, none});
  const Located bisected = onMesh(waves.mesh(0.5).polygons(), CutterShape::ball(3.0), line, [](Location& l) {
    l.setPathTolerance(0.01);
  });
  EXPECT_GT(bisected.locations.size(), 4 * line.size());
}

TEST(MeshLocation, ThreadsAndComputingAgainChangeNothingAndMotionMovesAll)
{
  const Waves waves{2.0, 0.3};
  const PlainMesh plain = waves.mesh(0.5);
  DrivePoints drive = contactsOn(waves, -10.0, 10.0, 4);
  for (std::size_t i = 0; i < drive.size(); i += 2)
    drive[i].normal.setZero();
  Location location;
  location.setInputMesh(plain.polygons());
  location.setCutter(all_kinds[5]);
  location.setDrivePoints(drive);
  ToolLocations one, again;
  location.setNumberOfThreads(1);
  location.compute(one);
  ASSERT_EQ(one.size(), drive.size());
  location.setNumberOfThreads(2);
  location.compute(again);
  Location other;
  other.setInputMesh(location.getInputMesh());
  other.setCutter(all_kinds[5]);
  other.setDrivePoints(drive);
  ToolLocations third;
  other.compute(third);
  const Eigen::Isometry3d motion = randomMotion(5, 100.0);
  PlainMesh moved = plain;
  for (Vector3d& p : moved.corners)
    p = motion * p.cast<float>().cast<double>();
  DrivePoints led;
  for (const DrivePoint& d : drive)
    led.push_back({motion * d.position, motion.linear() * d.axis, motion.linear() * d.normal});
  const Located away = onMesh(moved.polygons(), all_kinds[5], led);
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].tip, again[i].tip);
    ASSERT_EQ(one[i].tip, third[i].tip);
    ASSERT_LT((motion * one[i].tip - away.locations[i].tip).norm(), 1e-3) << i;
    EXPECT_EQ(one[i].state, away.locations[i].state) << i;
  }
}

TEST(MeshLocation, WhatIsSetLastCounts)
{
  PlainMesh high, low;
  high.addQuad({-9, -9, 5}, {9, -9, 5}, {9, 9, 5}, {-9, 9, 5});
  low.addQuad({-9, -9, 1}, {9, -9, 1}, {9, 9, 1}, {-9, 9, 1});
  const auto cloud = toCloud(sampleUniform(*flat(Region({rectangle(20.0, 20.0)})), 2000, 6).points);
  Location location;
  location.setCutter(CutterShape::ball(2.0));
  location.setDrivePoints({{{0, 0, 9}, up, none}});
  const auto height = [&] {
    ToolLocations locations;
    location.compute(locations);
    EXPECT_TRUE(location.getStatus().ok()) << location.getStatus().message();
    return locations.empty() ? -99.0 : locations[0].tip.z();
  };
  location.setInputCloud(cloud);
  EXPECT_NEAR(height(), 0.0, 1e-3);
  location.setInputMesh(high.polygons());
  EXPECT_NEAR(height(), 5.0, 1e-9);
  location.setInputMesh(low.surface());
  EXPECT_NEAR(height(), 1.0, 1e-9);
  EXPECT_EQ(location.getInputMesh()->faceCount(), 2u);
  location.setInputCloud(cloud);
  EXPECT_NEAR(height(), 0.0, 1e-3);
  EXPECT_EQ(location.getInputMesh(), nullptr);
}

TEST(MeshLocation, MeshesAndSettingsThatCannotBeAreNamed)
{
  const auto fails = [&](const char* says, auto change) {
    Location location;
    location.setInputMesh(pocket().polygons());
    location.setCutter(CutterShape::ball(2.0));
    location.setDrivePoints({{none, up, up}});
    location.setQuiet(true);
    change(location);
    ToolLocations locations(3);
    location.compute(locations);
    EXPECT_FALSE(location.getStatus().ok()) << says;
    EXPECT_NE(location.getStatus().message().find(says), std::string::npos) << location.getStatus().message();
    EXPECT_TRUE(locations.empty());
  };
  fails("has no gaps between points: set the evaluation", [](Location& l) { l.setEvaluation(Evaluation::PointsAndBound); });
  fails("input mesh is missing", [](Location& l) { l.setInputMesh(pcl::PolygonMesh::ConstPtr()); });
  fails("input mesh is missing", [](Location& l) { l.setInputMesh(SurfaceMesh::ConstPtr()); });
  fails("no ", [](Location& l) { l.setInputMesh(pcl::PolygonMesh::ConstPtr(new pcl::PolygonMesh)); });
  fails("not finite", [](Location& l) {
    PlainMesh mesh = pocket();
    mesh.corners[2].y() = std::numeric_limits<double>::quiet_NaN();
    l.setInputMesh(mesh.polygons());
  });
  fails("setThinning was called beside setInputMesh", [](Location& l) { l.setThinning(0.5); });
  fails("setFlipNormals was called beside setInputMesh", [](Location& l) { l.setFlipNormals(true); });
  fails("setInputNormals was called beside", [](Location& l) {
    l.setInputNormals(pcl::PointCloud<pcl::Normal>::Ptr(new pcl::PointCloud<pcl::Normal>(5, 1)));
  });
  fails("radius is 0 mm", [](Location& l) { l.setCutter(CutterShape()); });
  fails("threads is 4294967295", [](Location& l) { l.setNumberOfThreads(-1); });
  fails("cancelled", [](Location& l) {
    l.setProgressCallback([](double, const std::string& s) { return s != "locations"; });
  });
}
