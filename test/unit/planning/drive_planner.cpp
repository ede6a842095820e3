// SPDX-License-Identifier: BSD-3-Clause
// DrivePlanner and PathVerifier from C++: what has no meaning is refused and not passed over, defaults judge, the last input counts, and
// nothing is left of an older result.
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/planning/drive_planner.h>
#include <pcl_spiral/planning/path_verifier.h>
#include <pcl_spiral/planning/program_planner.h>
#include <pcl_spiral/planning/spiral_planner.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace drive_planner_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double ball = 100.0, rim = 40.0; // mm

/** A cap of a sphere, its pole in the origin. */
Cloud::Ptr
cap()
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto cloud = pcl::make_shared<Cloud>();
  for (int i = 0; i < 9000; ++i) {
    const double r = rim * std::sqrt(unit(random)), angle = 2.0 * M_PI * unit(random);
    cloud->emplace_back(static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)),
                        static_cast<float>(std::sqrt(ball * ball - r * r) - ball));
  }
  return cloud;
}

/** A square of the same sphere as a mesh. */
SurfaceMesh::ConstPtr
mesh()
{
  constexpr int cells = 20;
  Cloud points;
  pcl::PolygonMesh polygons;
  for (int i = 0; i <= cells; ++i)
    for (int k = 0; k <= cells; ++k) {
      const double x = 2.0 * (i - cells / 2), y = 2.0 * (k - cells / 2);
      points.emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(std::sqrt(ball * ball - x * x - y * y) - ball));
    }
  pcl::toPCLPointCloud2(points, polygons.cloud);
  for (int i = 0; i < cells; ++i)
    for (int k = 0; k < cells; ++k) {
      const pcl::index_t a = i * (cells + 1) + k, b = a + cells + 1;
      for (const pcl::Indices& face : {pcl::Indices{a, b, b + 1}, pcl::Indices{a, b + 1, a + 1}}) {
        polygons.polygons.emplace_back();
        polygons.polygons.back().vertices = face;
      }
    }
  SurfaceMesh::ConstPtr made;
  EXPECT_TRUE(SurfaceMesh::make(polygons, {}, made).ok());
  return made;
}

using Driver = DrivePlanner<pcl::PointXYZ>;
using Verifier = PathVerifier<pcl::PointXYZ>;

void
setTool(Driver& planner)
{
  planner.setCutter(CutterShape::ball(4.0));
  planner.setStepOver(2.0);
  planner.setQuiet(true);
}

pcl::PointCloud<ToolpathPoint>::Ptr
spiral()
{
  SpiralPlanner<pcl::PointXYZ> planner;
  planner.setInputCloud(cap());
  planner.setToolRadius(4.0);
  planner.setScallopHeight(0.05);
  planner.compute();
  EXPECT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  return planner.getPlan().path;
}

} // namespace

TEST(DrivePlanner, PassesOfTheUserTakeThePlaceOfTheDrivePath)
{
  for (const bool on_mesh : {false, true}) {
    Driver planner;
    DrivePath<pcl::PointXYZ> drive;
    on_mesh ? planner.setInputMesh(mesh()) : planner.setInputCloud(cap());
    on_mesh ? drive.setInputMesh(mesh()) : drive.setInputCloud(cap());
    setTool(planner);
    std::vector<ToolPoses> expected, made;
    planner.compute(expected);
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    drive.setSettings(planner.getSettings());
    DrivePasses passes;
    drive.compute(passes);
    planner.setStepOver(7.0); // of no meaning now
    planner.setDrivePasses(passes);
    planner.compute(made);
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    ASSERT_EQ(made.size(), expected.size());
    for (std::size_t i = 0; i < made.size(); ++i) {
      ASSERT_EQ(made[i].size(), expected[i].size());
      for (std::size_t k = 0; k < made[i].size(); ++k)
        EXPECT_EQ(made[i][k].tip, expected[i][k].tip);
    }
    EXPECT_FALSE(planner.getPlan().covers_scan);
    planner.setGougeCheck(false);
    planner.compute(made);
    EXPECT_EQ(planner.getStatus().code(), StatusCode::InvalidArgument);
    EXPECT_TRUE(made.empty());
  }
}

TEST(DrivePlanner, TheBallStandsOnTheSphereAndNoWhereElse)
{
  Driver planner;
  planner.setInputCloud(cap());
  setTool(planner);
  std::vector<ToolPoses> passes;
  planner.compute(passes);
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  ASSERT_GT(passes.size(), 20U);
  for (const ToolPoses& pass : passes)
    for (const ToolPose& pose : pass)
      if (pose.contact.head<2>().norm() < rim - 2.0)
        ASSERT_NEAR((pose.tip + 4.0 * pose.axis - Vector3d(0.0, 0.0, -ball)).norm(), ball + 4.0, 0.02) << pose.contact.transpose();
  EXPECT_EQ(planner.getPlan().poseCount(), joinedPasses(passes).path.size());
}

TEST(DrivePlanner, WhatHasNoMeaningForAMeshIsRefused)
{
  const std::vector<std::pair<const char*, std::function<void(Driver&)>>> settings{
      {"setFlipNormals", [](Driver& d) { d.setFlipNormals(true); }},
      {"setViewPoint", [](Driver& d) { d.setViewPoint(Vector3d(0.0, 0.0, 9.0)); }},
      {"setThinning", [](Driver& d) { d.setThinning(1.0); }},
      {"setPartAt", [](Driver& d) { d.setPartAt(Vector3d::Zero()); }},
      {"setLargestPart", [](Driver& d) { d.setLargestPart(true); }},
      {"setLeaveOutStrays", [](Driver& d) { d.setLeaveOutStrays(true); }},
      {"addRegion",
       [](Driver& d) {
         d.addRegion({std::nullopt, Vector3d(0.0, 0.0, 0.0), ""});
       }},
      {"setCropBox", [](Driver& d) {
         d.setCropBox({Vector3d(-9.0, -9.0, -9.0), Vector3d(9.0, 9.0, 9.0)});
       }}};
  for (const auto& [name, set] : settings) {
    Driver planner;
    planner.setInputMesh(mesh());
    setTool(planner);
    std::vector<ToolPoses> passes;
    planner.compute(passes);
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    set(planner);
    planner.compute(passes);
    EXPECT_EQ(planner.getStatus().code(), StatusCode::InvalidArgument) << name;
    EXPECT_NE(planner.getStatus().message().find(name), std::string::npos) << planner.getStatus().message();
    EXPECT_TRUE(passes.empty() && planner.getPlan().passes.empty());
  }
}

TEST(ProgramPlanner, LeadsOverAMeshAreCheckedOrItSaysThatTheyAreNot)
{
  for (const bool samples : {true, false}) {
    Driver planner;
    planner.setInputMesh(mesh());
    setTool(planner);
    EXPECT_TRUE(planner.getSampleMesh());
    planner.setSampleMesh(samples);
    planner.compute();
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    ProgramPlanner programs;
    programs.setInputPlan(planner.getPlan());
    programs.setMachine(xyzacTrunnion());
    std::vector<ToolMoves> moves;
    programs.compute(moves);
    ASSERT_TRUE(programs.getStatus().ok()) << programs.getStatus().message();
    EXPECT_EQ(programs.getWarnings().empty(), samples);
    EXPECT_EQ(moves.size(), planner.getPlan().passes.size());
  }
}

TEST(ProgramPlanner, WithoutAPathThereIsNoProgramAndNoMoves)
{
  ProgramPlanner programs;
  programs.setQuiet(true);
  programs.setMachine(xyzacTrunnion());
  SpiralPlanner<pcl::PointXYZ> failed;
  failed.setQuiet(true);
  failed.compute();
  programs.setInputPlan(failed.getPlan());
  MachineProgram program;
  programs.compute(program);
  EXPECT_NE(programs.getStatus().message().find("setInputPlan"), std::string::npos) << programs.getStatus().message();
  std::vector<ToolMoves> moves(2);
  programs.compute(moves);
  EXPECT_EQ(programs.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_TRUE(moves.empty());
}

TEST(ProgramPlanner, AFeedThatIsNoneIsAFaultOfTheGenerator)
{
  Driver planner;
  planner.setInputCloud(cap());
  setTool(planner);
  planner.compute();
  ASSERT_TRUE(planner.getStatus().ok());
  ProgramPlanner programs;
  programs.setQuiet(true);
  programs.setInputPlan(planner.getPlan());
  programs.setMachine(xyzacTrunnion());
  ProgramSettings settings;
  settings.feed = 0.0;
  programs.setSettings(settings);
  MachineProgram program;
  programs.compute(program);
  EXPECT_FALSE(programs.getStatus().ok());
  EXPECT_TRUE(programs.isMachineFault());
  settings.feed = 1000.0;
  settings.clear_box.extend(Vector3d(0.0, 0.0, 200.0)); // of a thing that was not scanned
  programs.setSettings(settings);
  programs.compute(program);
  ASSERT_TRUE(programs.getStatus().ok()) << programs.getStatus().message();
  EXPECT_FALSE(programs.isMachineFault());
  EXPECT_GT(linksOf(program).height, 200.0);
}

TEST(ProgramPlanner, RapidsOfPassesCrossAboveWhatStandsBesideAChosenPart)
{
  const Cloud::Ptr scan = cap();
  for (double x = 55.0; x <= 65.0; x += 1.0) // a post beside the cap
    for (double y = -5.0; y <= 5.0; y += 1.0)
      scan->emplace_back(static_cast<float>(x), static_cast<float>(y), 80.0f);
  scan->emplace_back(0.0f, 90.0f, 500.0f); // a false echo
  for (const bool crop : {false, true}) {
    Driver planner;
    planner.setInputCloud(scan);
    setTool(planner);
    if (crop)
      planner.setCropBox(Eigen::AlignedBox3d(Vector3d(-50.0, -50.0, -50.0), Vector3d(50.0, 50.0, 50.0)));
    else
      planner.setLargestPart(true);
    planner.compute();
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    ProgramPlanner programs;
    programs.setQuiet(true);
    programs.setInputPlan(planner.getPlan());
    programs.setMachine(xyzacTrunnion());
    MachineProgram program;
    programs.compute(program);
    ASSERT_TRUE(programs.getStatus().ok()) << programs.getStatus().message();
    EXPECT_NEAR(linksOf(program).height, 130.0, 0.5) << crop; // rapid_height above the post
  }
}

TEST(ProgramPlanner, LinksAreLookedAtWithProgressAndCanBeCancelled)
{
  Driver planner;
  planner.setInputCloud(cap());
  setTool(planner);
  planner.compute();
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  ProgramPlanner programs;
  programs.setQuiet(true);
  programs.setInputPlan(planner.getPlan());
  programs.setMachine(xyzacTrunnion());
  MachineProgram program;
  for (const double stay_down : {0.0, 60.0}) {
    ProgramSettings settings;
    settings.stay_down = stay_down;
    programs.setSettings(settings);
    int searches = 0;
    programs.setProgressCallback([&searches](double share, const std::string& stage) {
      searches += share == 0.0 && stage == "leads";
      return true;
    });
    programs.compute(program);
    ASSERT_TRUE(programs.getStatus().ok()) << programs.getStatus().message();
    EXPECT_EQ(searches, stay_down > 0.0 ? 2 : 1) << "leads, and before them the links";
  }
  EXPECT_GT(program.report.links, 0U);
  programs.setProgressCallback([](double, const std::string&) { return false; });
  programs.compute(program);
  EXPECT_EQ(programs.getStatus().code(), StatusCode::Cancelled);
  EXPECT_TRUE(program.blocks.empty());
}

TEST(DrivePlanner, ACutterThatIsNoneIsRefused)
{
  Driver planner;
  planner.setInputCloud(cap());
  planner.setQuiet(true);
  std::vector<ToolPoses> passes;
  planner.compute(passes);
  EXPECT_NE(planner.getStatus().message().find("setCutter"), std::string::npos) << planner.getStatus().message();
  CutterShape wrong = CutterShape::ball(4.0);
  wrong.corner_radius = 5.0;
  planner.setCutter(wrong);
  planner.setScallopHeight(0.05);
  planner.compute(passes);
  EXPECT_EQ(planner.getStatus().code(), StatusCode::InvalidArgument) << planner.getStatus().message();
  planner.setCutter(CutterShape::ball(4.0));
  planner.setScallopHeight(0.05); // the step-over follows
  planner.compute(passes);
  EXPECT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  EXPECT_GT(passes.size(), 20U);
}

TEST(PathVerifier, JudgesByItsDefaultsAndFindsAGouge)
{
  Verifier verifier;
  verifier.setInputCloud(cap());
  verifier.setCutter(CutterShape::ball(4.0));
  verifier.setQuiet(true);
  const auto path = spiral();
  verifier.setInputToolpath(path);
  Limits limits;
  limits.gouge = 0.02;
  verifier.setLimits(limits);
  Verification found;
  verifier.compute(found);
  ASSERT_TRUE(verifier.getStatus().ok()) << verifier.getStatus().message();
  EXPECT_TRUE(found.broken.empty());
  EXPECT_LT(std::abs(found.deviation.max.value), 0.02);
  EXPECT_EQ(verifier.getHeights().deviation.size(), path->size());

  for (ToolpathPoint& p : *path)
    p.z -= 0.1f;
  verifier.compute(found);
  ASSERT_TRUE(verifier.getStatus().ok());
  EXPECT_FALSE(found.broken.empty()) << "a tenth of a millimetre deep";

  verifier.setThinning(1.0);
  verifier.compute(found);
  EXPECT_NE(verifier.getStatus().message().find("setThinning"), std::string::npos) << verifier.getStatus().message();
  EXPECT_TRUE(found.broken.empty() && found.deviation.points == 0 && !verifier.getReferenceSurface() &&
              verifier.getHeights().deviation.empty());
}

TEST(PathVerifier, TheLastInputCounts)
{
  Verifier verifier;
  verifier.setInputMesh(mesh());
  verifier.setInputCloud(cap());
  verifier.setCutter(CutterShape::ball(4.0));
  verifier.setInputToolpath(spiral());
  Verification found;
  verifier.compute(found);
  ASSERT_TRUE(verifier.getStatus().ok()) << verifier.getStatus().message();
  EXPECT_FALSE(verifier.getReferenceSurface()->mesh()) << "the scan was set last";
  EXPECT_EQ(found.deviation.unmeasured, 0U);
  verifier.setInputMesh(mesh());
  verifier.compute(found);
  ASSERT_TRUE(verifier.getStatus().ok()) << verifier.getStatus().message();
  EXPECT_TRUE(verifier.getReferenceSurface()->mesh());
  EXPECT_GT(found.deviation.unmeasured, 0U) << "the mesh is smaller than the path";
}

TEST(ProgramPlanner, RefusesAThingOverTheLeadAndSaysWhere)
{
  const Cloud::Ptr cloud = cap();
  SpiralPlanner<pcl::PointXYZ> planner;
  planner.setInputCloud(cloud);
  planner.setToolRadius(4.0);
  planner.setScallopHeight(0.05);
  planner.compute();
  ASSERT_TRUE(planner.getStatus().ok());
  SpiralPlan plan = planner.getPlan();
  ProgramPlanner programs;
  programs.setInputPlan(plan);
  programs.setMachine(xyzacTrunnion());
  MachineProgram program;
  programs.compute(program);
  ASSERT_TRUE(programs.getStatus().ok()) << programs.getStatus().message();
  EXPECT_GT(program.blocks.size(), 1000U);

  const ToolpathPoint& first = plan.path->front();
  const Vector3d over = first.getVector3fMap().cast<double>() + 60.0 * first.getAxisVector3fMap().cast<double>();
  const auto with_beam = pcl::make_shared<Cloud>(*cloud);
  for (double x = -6.0; x <= 6.0; x += 0.5)
    for (double y = -6.0; y <= 6.0; y += 0.5)
      with_beam->emplace_back(static_cast<float>(over.x() + x), static_cast<float>(over.y() + y), static_cast<float>(over.z()));
  plan.whole = with_beam;
  programs.setInputPlan(plan);
  programs.compute(program);
  EXPECT_EQ(programs.getStatus().code(), StatusCode::Failed);
  EXPECT_FALSE(programs.isMachineFault());
  EXPECT_TRUE(program.blocks.empty());
  ASSERT_FALSE(programs.getStatus().diagnostic().places().empty());
  EXPECT_LT((programs.getStatus().diagnostic().places().front() - over).norm(), 12.0);
  plan.tool.accepted = true;
  programs.setInputPlan(plan);
  programs.compute(program);
  EXPECT_TRUE(programs.getStatus().ok());
  EXPECT_FALSE(programs.getWarnings().empty());
}

} // namespace drive_planner_test
