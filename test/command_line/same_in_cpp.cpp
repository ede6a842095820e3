// SPDX-License-Identifier: BSD-3-Clause
// What the programs make, C++ users make with the same classes: files are the same byte for byte.
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/mesh_reader.h>
#include <pcl_spiral/io/pass_report_writer.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/io/polygon_reader.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/io/reach_map_writer.h>
#include <pcl_spiral/io/report_writer.h>
#include <pcl_spiral/io/stock_writer.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/io/toolpath_writer.h>
#include <pcl_spiral/planning/drive_planner.h>
#include <pcl_spiral/planning/path_verifier.h>
#include <pcl_spiral/planning/program_planner.h>
#include <pcl_spiral/planning/ridge_planner.h>
#include <pcl_spiral/planning/spiral_planner.h>
#include <pcl_spiral/ridge/ridge_toolpath.h>

#include "run_program.h"
#include "support/ridges.h"
#include "two_domes.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <sstream>

namespace same_in_cpp_test {

namespace {

using namespace pcl_spiral;
using namespace two_domes;
using Arguments = std::vector<std::string>;
using Planner = SpiralPlanner<pcl::PointXYZ>;

const Eigen::Vector3d on_left(-75.0, 0.0, 4.0), on_right(85.0, 10.0, 7.0);

/** A program whose cutting moves lie deeper by \p depth, mm. */
std::string
lowered(const std::string& program, double depth)
{
  std::istringstream lines(program);
  std::ostringstream all;
  all.precision(9);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t z = line.find(" Z"), end = z == std::string::npos ? z : line.find(' ', z + 1);
    if (line.rfind("G1", 0) == 0 && z != std::string::npos)
      all << line.substr(0, z) << " Z" << std::stod(line.substr(z + 2)) - depth << (end == std::string::npos ? "" : line.substr(end));
    else
      all << line;
    all << '\n';
  }
  return all.str();
}

/** Progress that goes from 0 to 1, once. */
struct Progress {
  double last = 0.0;
  bool rises = true;

  bool operator()(double share, const std::string&)
  {
    rises = rises && share >= last && share <= 1.0;
    last = share;
    return true;
  }
};

class SameInCpp : public ::testing::Test {
protected:
  void SetUp() override
  {
    std::ostringstream all;
    all.precision(9);
    for (const Vector3d& p : twoDomes())
      all << p.transpose() << '\n';
    writeText(folder_.path("scan.xyz"), all.str());
    writeText(folder_.path("keep.txt"), "-60 -4\n-52 -4\n-52 4\n-60 4\n");
    writeText(folder_.path("west.txt"), "-105 -40\n-78 -40\n-78 40\n-105 40\n");
    writeText(folder_.path("east.txt"), "-72 -40\n-40 -40\n-40 40\n-72 40\n");
  }

  RunResult run(const char* program, const Arguments& arguments) { return endOf(startProgram(program, arguments, folder_), folder_); }

  /** The program with \p options, and a planner that \p choose sets, refuse alike or write the same. */
  void expectSame(const Arguments& options, const std::function<void(Planner&)>& choose, bool refused = false)
  {
    Arguments arguments{"scan.xyz", "-o", "program.csv", "--tool-radius", "4", "--scallop", "0.05"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const RunResult result = run(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments);
    Planner planner;
    planner.setInputCloud(readCloud(folder_.path("scan.xyz")).cloud);
    planner.setToolRadius(4.0);
    planner.setScallopHeight(0.05);
    planner.setQuiet(true);
    choose(planner);
    pcl::PointCloud<ToolpathPoint> path;
    planner.compute(path);
    ASSERT_EQ(planner.getStatus().ok(), !refused) << planner.getStatus().message();
    ASSERT_EQ(result.code == 0, !refused) << result.err;
    EXPECT_EQ(path.empty(), refused);
    if (refused) {
      for (const Eigen::Vector3d& place : planner.getStatus().diagnostic().places())
        EXPECT_NE(result.err.find(placeText(place)), std::string::npos) << result.err;
      return;
    }
    writeToolpath(folder_.path("cpp.csv"), path, {planner.getToolRadius(), planner.getFeed()});
    EXPECT_EQ(readText(folder_.path("cpp.csv")), readText(folder_.path("program.csv")));
    EXPECT_GT(path.size(), 1000U);
  }

  /** Lines measured on a die, and a scan of it. */
  void writeDie()
  {
    const pcl_spiral::test::ExactRidge die = pcl_spiral::test::dieRidge();
    const auto write = [&](const char* file, const std::vector<Vector3d>& points) {
      std::ostringstream text;
      text.precision(9);
      for (const Vector3d& p : points)
        text << p.transpose() << '\n';
      writeText(folder_.path(file), text.str());
    };
    write("rail.txt", die.railPoints(300));
    write("generator.txt", die.generatorPoints(0.37, 100));
    std::vector<Vector3d> points;
    for (int i = 0; i <= 700; ++i)
      for (int k = 0; k <= 30; ++k)
        points.push_back(die.position(i / 700.0, k / 30.0));
    write("die.xyz", points);
    through_ = {die.position(0.05, 0.5), die.position(0.35, 0.5), die.position(0.65, 0.5), die.position(0.95, 0.5)};
  }

  Prism polygon(const std::string& file) const { return readPolygon(folder_.path(file)); }

  ScratchFolder folder_;
  std::vector<Vector3d> through_; ///< rough points of the ridge of the die
};

} // namespace

TEST_F(SameInCpp, BallClosing)
{
  expectSame({"--crop", "-105,-45,-30,30", "--axis", "0,0,1", "--ball-closing"}, [](Planner& planner) {
    constexpr double all = 1e6;
    planner.setCropBox({Vector3d(-105, -30, -all), Vector3d(-45, 30, all)});
    planner.setFixedAxis(Vector3d::UnitZ());
    planner.setBallClosing(true);
  });
  expectSame(
      {"--keep-out", "keep.txt", "--ball-closing"},
      [this](Planner& planner) {
        planner.addKeepOut(readPolygon(folder_.path("keep.txt")));
        planner.setBallClosing(true);
      },
      true);
  for (const char* option : {"--verify", "--mesh"}) {
    const RunResult refused = run(PCL_SPIRAL_TOOLPATH_PROGRAM,
                                  {"scan.xyz", "-o", "none.csv", "--tool-radius", "4", "--scallop", "0.05", "--ball-closing", option});
    EXPECT_EQ(refused.code, 2) << option;
    EXPECT_NE(refused.err.find(option), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path("none.csv")));
  }
}

TEST_F(SameInCpp, PartAndKeepOut)
{
  expectSame({"--part-at", "-75,0,4", "--keep-out", "keep.txt"}, [this](Planner& planner) {
    planner.setPartAt(on_left);
    planner.addKeepOut(polygon("keep.txt"));
  });
}

TEST_F(SameInCpp, TwoRegionsByPlace)
{
  expectSame({"--part-at", "-75,0,4", "--part-at", "85,10,7"}, [](Planner& planner) {
    planner.addRegion({std::nullopt, on_left, ""});
    planner.addRegion({std::nullopt, on_right, ""});
  });
}

TEST_F(SameInCpp, TwoRegionsInPolygonsOfACropAndAHolder)
{
  expectSame({"--region", "east.txt", "--region", "west.txt", "--crop", "-130,-20,-50,50,-2,50", "--flank-length", "20", "--holder",
              "6,40/20,25,60"},
             [this](Planner& planner) {
               planner.setCropBox({Eigen::Vector3d(-130.0, -50.0, -2.0), Eigen::Vector3d(-20.0, 50.0, 50.0)});
               planner.addRegion({polygon("east.txt"), std::nullopt, "east"});
               planner.addRegion({polygon("west.txt"), std::nullopt, "west"});
               planner.setFlankLength(20.0);
               planner.setHolder({ToolSegment::cylinder(6.0, 40.0, "shank"), {20.0, 25.0, 60.0, "chuck"}});
             });
}

TEST_F(SameInCpp, AHolderThatMeetsTheTowerIsRefusedAtTheSamePlace)
{
  expectSame(
      {"--part-at", "-75,0,4", "--flank-length", "2", "--holder", "90,40"},
      [](Planner& planner) {
        planner.setPartAt(on_left);
        planner.setFlankLength(2.0);
        planner.setHolder({ToolSegment::cylinder(90.0, 40.0, "chuck")});
      },
      true);
}

TEST_F(SameInCpp, APartThatNobodyChoseIsRefusedAlike)
{
  expectSame(
      {}, [](Planner&) {}, true);
}

TEST_F(SameInCpp, AMesh)
{
  std::ostringstream obj;
  constexpr int cells = 30;
  for (int i = 0; i <= cells; ++i)
    for (int k = 0; k <= cells; ++k)
      obj << "v " << 2 * i << ' ' << 2 * k << ' ' << 0.004 * (i - 15) * (i - 15) - 0.002 * (k - 12) * (k - 12) << '\n';
  for (int i = 0; i < cells; ++i)
    for (int k = 0; k < cells; ++k) {
      const int a = i * (cells + 1) + k + 1;
      obj << "f " << a << ' ' << a + cells + 1 << ' ' << a + cells + 2 << "\nf " << a << ' ' << a + cells + 2 << ' ' << a + 1 << '\n';
    }
  writeText(folder_.path("part.obj"), obj.str());
  const RunResult result =
      run(PCL_SPIRAL_TOOLPATH_PROGRAM, {"part.obj", "--mesh", "-o", "program.csv", "--tool-radius", "4", "--scallop", "0.05"});
  ASSERT_EQ(result.code, 0) << result.err;
  Planner planner;
  planner.setInputMesh(readMesh(folder_.path("part.obj")).mesh);
  planner.setToolRadius(4.0);
  planner.setScallopHeight(0.05);
  pcl::PointCloud<ToolpathPoint> path;
  planner.compute(path);
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  writeToolpath(folder_.path("cpp.csv"), path, {planner.getToolRadius(), planner.getFeed()});
  EXPECT_EQ(readText(folder_.path("cpp.csv")), readText(folder_.path("program.csv")));
}

TEST_F(SameInCpp, AProgramForATrunnion)
{
  const RunResult result = run(PCL_SPIRAL_TOOLPATH_PROGRAM, {"scan.xyz", "-o", "program.ngc", "--tool-radius", "4", "--scallop", "0.05",
                                                             "--crop", "-130,-20,-50,50,-2,50", "--spindle", "8000"});
  ASSERT_EQ(result.code, 0) << result.err;
  Planner planner;
  planner.setInputCloud(readCloud(folder_.path("scan.xyz")).cloud);
  planner.setCropBox({Eigen::Vector3d(-130.0, -50.0, -2.0), Eigen::Vector3d(-20.0, 50.0, 50.0)});
  planner.setToolRadius(4.0);
  planner.setScallopHeight(0.05);
  pcl::PointCloud<ToolpathPoint> path;
  planner.compute(path);
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  ProgramPlanner programs;
  programs.setInputPlan(planner.getPlan());
  programs.setMachine(xyzacTrunnion());
  MachineProgram program;
  programs.compute(program);
  ASSERT_TRUE(programs.getStatus().ok()) << programs.getStatus().message();
  ProgramHeader header;
  header.title = "scan.xyz";
  header.spindle_speed = 8000.0;
  header.notes = {"cutter radius 4 mm, a ball", "scallop height 0.05 mm, chord error 0.005 mm, feed 1000 mm/min"};
  header.smoothing = planner.getChordError();
  writeLinuxCNC(folder_.path("cpp.ngc"), program, header);
  EXPECT_EQ(readText(folder_.path("cpp.ngc")), readText(folder_.path("program.ngc")));
}

TEST_F(SameInCpp, RobotFramesOfTwoRegions)
{
  const RunResult result = run(PCL_SPIRAL_TOOLPATH_PROGRAM, {"scan.xyz", "-o", "program.yaml", "--tool-radius", "4", "--scallop", "0.05",
                                                             "--part-at", "-75,0,4", "--part-at", "85,10,7"});
  ASSERT_EQ(result.code, 0) << result.err;
  Planner planner;
  planner.setInputCloud(readCloud(folder_.path("scan.xyz")).cloud);
  planner.addRegion({std::nullopt, on_left, ""});
  planner.addRegion({std::nullopt, on_right, ""});
  planner.setToolRadius(4.0);
  planner.setScallopHeight(0.05);
  planner.compute();
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  ProgramPlanner programs;
  programs.setInputPlan(planner.getPlan());
  std::vector<ToolMoves> moves;
  programs.compute(moves);
  ASSERT_TRUE(programs.getStatus().ok()) << programs.getStatus().message();
  writeRobotFrames(folder_.path("cpp.yaml"), moves);
  EXPECT_EQ(readText(folder_.path("cpp.yaml")), readText(folder_.path("program.yaml")));
}

TEST_F(SameInCpp, DriveBesideAKeepOutWithAHolder)
{
  const RunResult result =
      run(PCL_SPIRAL_DRIVE_PROGRAM, {"scan.xyz", "-o", "program.csv", "--tool-radius", "4", "--scallop", "0.1", "--part-at", "-75,0,4",
                                     "--keep-out", "keep.txt", "--flank-length", "30", "--holder", "6,40/20,25,60", "--tolerance", "0.02"});
  ASSERT_EQ(result.code, 0) << result.err;
  DrivePlanner<pcl::PointXYZ> planner;
  planner.setInputCloud(readCloud(folder_.path("scan.xyz")).cloud);
  planner.setPartAt(on_left);
  planner.addKeepOut(polygon("keep.txt"));
  planner.setCutter(CutterShape::ball(4.0, 30.0));
  planner.setScallopHeight(0.1);
  planner.setRows(DriveRows::Kept);
  planner.setHolder({ToolSegment::cylinder(6.0, 40.0, "shank"), {20.0, 25.0, 60.0, "chuck"}});
  PassSettings settings;
  settings.tolerance = 0.02;
  planner.setChordError(0.5 * settings.tolerance);
  planner.setPassSettings(settings);
  std::vector<ToolPoses> passes;
  planner.compute(passes);
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  EXPECT_GT(planner.getPlan().left_out.count(), 0U);
  const PassPath all = joinedPasses(passes);
  writeToolpath(folder_.path("cpp.csv"), all.path, {4.0, 1000.0, all.tips, all.begins});
  EXPECT_EQ(readText(folder_.path("cpp.csv")), readText(folder_.path("program.csv")));
}

TEST_F(SameInCpp, DriveRefusesAlike)
{
  const RunResult result = run(PCL_SPIRAL_DRIVE_PROGRAM, {"scan.xyz", "-o", "program.csv", "--tool-radius", "4", "--step-over", "2",
                                                          "--flank-length", "2", "--holder", "90,40", "--part-at", "-75,0,4"});
  EXPECT_EQ(result.code, 1);
  DrivePlanner<pcl::PointXYZ> planner;
  planner.setInputCloud(readCloud(folder_.path("scan.xyz")).cloud);
  planner.setPartAt(on_left);
  planner.setCutter(CutterShape::ball(4.0, 2.0));
  planner.setStepOver(2.0);
  planner.setHolder({ToolSegment::cylinder(90.0, 40.0, "segment 1 of the holder")});
  planner.setQuiet(true);
  std::vector<ToolPoses> passes(3);
  planner.compute(passes);
  EXPECT_FALSE(planner.getStatus().ok());
  EXPECT_TRUE(passes.empty() && planner.getPlan().passes.empty());
  ASSERT_FALSE(planner.getStatus().diagnostic().places().empty());
  for (const Eigen::Vector3d& place : planner.getStatus().diagnostic().places())
    EXPECT_NE(result.err.find(placeText(place)), std::string::npos) << result.err;
}

TEST_F(SameInCpp, TheVerdictOnAPathThroughAKeepOut)
{
  ASSERT_EQ(
      run(PCL_SPIRAL_TOOLPATH_PROGRAM, {"scan.xyz", "-o", "path.csv", "--tool-radius", "4", "--scallop", "0.05", "--part-at", "-75,0,4"})
          .code,
      0);
  for (const bool kept_out : {false, true}) {
    Arguments arguments{"scan.xyz", "path.csv", "--tool-radius", "4",           "--scallop", "0.05",        "--part-at",
                        "-75,0,4",  "-o",       "v.json",        "--max-gouge", "0.02",      "--max-uncut", "0.5"};
    if (kept_out)
      arguments.insert(arguments.end(), {"--keep-out", "keep.txt"});
    const RunResult result = run(PCL_SPIRAL_VERIFY_PROGRAM, arguments);
    PathVerifier<pcl::PointXYZ> verifier;
    verifier.setInputCloud(readCloud(folder_.path("scan.xyz")).cloud);
    verifier.setPartAt(on_left);
    if (kept_out)
      verifier.addKeepOut(polygon("keep.txt"));
    verifier.setInputToolpath(pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(readToolpath(folder_.path("path.csv")).path));
    verifier.setCutter(CutterShape::ball(4.0));
    verifier.setScallopHeight(0.05);
    Limits limits;
    limits.gouge = 0.02;
    limits.uncut = 0.5;
    verifier.setLimits(limits);
    Verification found;
    verifier.compute(found);
    ASSERT_TRUE(verifier.getStatus().ok()) << verifier.getStatus().message();
    EXPECT_EQ(result.code == 0, found.broken.empty()) << result.err << textsOf(found.broken).size();
    EXPECT_EQ(found.broken.empty(), !kept_out);
    const nlohmann::json json = nlohmann::json::parse(readText(folder_.path("v.json")))["paths"][0];
    EXPECT_EQ(json["deviation"]["rms"].get<double>(), found.deviation.rms);
    EXPECT_EQ(json["deviation"]["max"]["value"].get<double>(), found.deviation.max.value);
    EXPECT_EQ(json["material"]["gouge"]["value"].get<double>(), found.removal.gouge.value);
    ASSERT_EQ(json["broken_limits"].size(), found.broken.size());
    for (std::size_t i = 0; i < found.broken.size(); ++i)
      EXPECT_EQ(json["diagnostics"]["broken_limits"][i]["id"], found.broken[i].id());
  }
}

TEST_F(SameInCpp, ReportsStockAndReach)
{
  ASSERT_EQ(run(PCL_SPIRAL_TOOLPATH_PROGRAM, {"scan.xyz", "-o", "path.json", "-o", "path.html", "--tool-radius", "4", "--scallop", "0.05",
                                              "--part-at", "-75,0,4", "--stock", "left.ply", "--reach", "reach.csv"})
                .code,
            0);
  const Scan scan = readCloud(folder_.path("scan.xyz"));
  Planner planner;
  planner.setInputCloud(scan.cloud);
  planner.setPartAt(on_left);
  planner.setToolRadius(4.0);
  planner.setScallopHeight(0.05);
  planner.setKeepSurface(true);
  planner.setTrustNormals(false); // as the programs, which read them from files
  pcl::PointCloud<ToolpathPoint> path;
  planner.compute(path);
  PathVerifier<pcl::PointXYZ> verifier;
  verifier.setInputCloud(scan.cloud);
  verifier.setPartAt(on_left);
  verifier.setInputToolpath(pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(path));
  verifier.setCutter(CutterShape::ball(4.0));
  Verification found;
  verifier.compute(found);
  ASSERT_TRUE(verifier.getStatus().ok()) << verifier.getStatus().message();
  RunFiles files;
  files.scan = "scan.xyz";
  files.outputs = {"path.json", "path.html", "reach.csv", "left.ply"};
  const RunReport report = reportOf(planner.getPlan(), {found});
  writeReportJSON(folder_.path("cpp.json"), files, report);
  writeReportHTML(folder_.path("cpp.html"), {"scan.xyz", "", ""}, files, report);
  writeReachMap(folder_.path("cpp.csv"), reachMap(planner.getPlan()));
  writeStock(folder_.path("cpp.ply"), stockMesh(*verifier.getReferenceSurface(), verifier.getHeights().stock));
  const auto json = [this](const std::string& file) { return nlohmann::json::parse(readText(folder_.path(file))); };
  const nlohmann::json by_program = json("path.json"), by_cpp = json("cpp.json");
  for (const char* part : {"units", "input", "settings", "surface", "loops", "holes", "path", "not_reached"})
    EXPECT_EQ(by_program[part], by_cpp[part]) << part;
  for (const char* part : {"deviation", "material", "motion"}) {
    nlohmann::json one = by_program["verification"][part], other = by_cpp["verification"][part];
    one.erase("seconds");
    other.erase("seconds");
    EXPECT_EQ(one, other) << part;
  }
  EXPECT_NE(readText(folder_.path("cpp.html")).find("Toolpath"), std::string::npos);
  EXPECT_EQ(readText(folder_.path("cpp.csv")), readText(folder_.path("reach.csv")));
  EXPECT_EQ(readText(folder_.path("cpp.ply")), readText(folder_.path("left.ply")));
}

TEST_F(SameInCpp, AReportOfPasses)
{
  ASSERT_EQ(run(PCL_SPIRAL_DRIVE_PROGRAM,
                {"scan.xyz", "-o", "path.json", "-o", "path.html", "--tool-radius", "4", "--step-over", "2", "--part-at", "-75,0,4"})
                .code,
            0);
  DrivePlanner<pcl::PointXYZ> planner;
  planner.setInputCloud(readCloud(folder_.path("scan.xyz")).cloud);
  planner.setPartAt(on_left);
  planner.setTrustNormals(false);
  planner.setStepOver(2.0);
  DriveRun made;
  made.tool.cutter = CutterShape::ball(4.0);
  planner.setCutter(made.tool.cutter);
  planner.setPassSettings(made.tool);
  planner.setChordError(0.5 * made.tool.tolerance); // as the program, which leaves the other half to the moves between locations
  planner.compute();
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  made.drive = planner.getSettings();
  RunFiles files;
  files.scan = "scan.xyz";
  writeDriveReportJSON(folder_.path("cpp.json"), files, made, planner.getPlan());
  writeDriveReportHTML(folder_.path("cpp.html"), {"scan.xyz", "", ""}, files, made, planner.getPlan(), {});
  nlohmann::json by_program = nlohmann::json::parse(readText(folder_.path("path.json"))),
                 by_cpp = nlohmann::json::parse(readText(folder_.path("cpp.json")));
  for (const char* part : {"options", "stages", "warnings", "diagnostics"}) { // options of the program, times, and its words
    by_program.erase(part);
    by_cpp.erase(part);
  }
  EXPECT_EQ(by_program, by_cpp) << nlohmann::json::diff(by_program, by_cpp).dump(1);
  EXPECT_NE(readText(folder_.path("cpp.html")).find("Passes over a scanned surface"), std::string::npos);
}

TEST_F(SameInCpp, TheJudgementOfAProgram)
{
  const Arguments cutter{"--tool-radius", "4", "--scallop", "0.05"}, part{"--part-at", "-75,0,4"};
  Arguments make{"scan.xyz", "-o", "path.ngc", "--machine", PCL_SPIRAL_MACHINES_DIR "/xyzac.yaml"};
  Arguments verify{"scan.xyz", "path.ngc", "-o", "v.json", "--max-gouge", "0.02", "--machine", PCL_SPIRAL_MACHINES_DIR "/xyzac.yaml"};
  for (Arguments* arguments : {&make, &verify})
    for (const Arguments* more : {&cutter, &part})
      arguments->insert(arguments->end(), more->begin(), more->end());
  ASSERT_EQ(run(PCL_SPIRAL_TOOLPATH_PROGRAM, make).code, 0);
  const std::string text = readText(folder_.path("path.ngc"));
  for (const bool deeper : {false, true}) {
    if (deeper)
      writeText(folder_.path("path.ngc"), lowered(text, 0.1));
    const RunResult result = run(PCL_SPIRAL_VERIFY_PROGRAM, verify);
    PathVerifier<pcl::PointXYZ> verifier;
    verifier.setInputCloud(readCloud(folder_.path("scan.xyz")).cloud);
    verifier.setPartAt(on_left);
    verifier.setInputProgram(readProgram(folder_.path("path.ngc"), readMachine(PCL_SPIRAL_MACHINES_DIR "/xyzac.yaml")));
    verifier.setCutter(CutterShape::ball(4.0));
    Limits limits;
    limits.gouge = 0.02;
    verifier.setLimits(limits);
    Verification found;
    verifier.compute(found);
    ASSERT_TRUE(verifier.getStatus().ok()) << verifier.getStatus().message();
    EXPECT_EQ(result.code == 0, found.broken.empty()) << result.err;
    EXPECT_EQ(found.broken.empty(), !deeper);
    const nlohmann::json json = nlohmann::json::parse(readText(folder_.path("v.json")))["paths"][0];
    EXPECT_EQ(json["program"]["blocks"].get<std::size_t>(), found.program->blocks);
    EXPECT_EQ(json["program"]["passes"].get<std::size_t>(), found.program->passes);
    EXPECT_EQ(json["deviation"]["rms"].get<double>(), found.deviation.rms);
    EXPECT_EQ(json["material"]["gouge"]["value"].get<double>(), found.removal.gouge.value);
    EXPECT_EQ(json["deviation"]["points"].get<std::size_t>(), verifier.getJudgedPath()->size());
    ProgramFile unread = *verifier.getInputProgram(); // as a program that was just made: no text
    unread.lines.clear();
    verifier.setInputProgram(unread);
    Progress progress;
    verifier.setProgressCallback(std::ref(progress));
    Verification again;
    verifier.compute(again);
    EXPECT_EQ(again.removal.gouge.value, found.removal.gouge.value);
    ASSERT_EQ(again.program->lines.size(), found.program->lines.size());
    EXPECT_LE(again.program->lines.back(), again.program->blocks) << "blocks are counted";
    EXPECT_TRUE(progress.rises && progress.last > 0.9) << progress.last;
    unread.lines = {1, 2};
    verifier.setInputProgram(unread);
    verifier.compute(again);
    EXPECT_EQ(verifier.getStatus().code(), StatusCode::InvalidInput);
    verifier.setInputProgram(ProgramFile());
    verifier.compute(again);
    EXPECT_NE(verifier.getStatus().message().find("the program is empty"), std::string::npos);
  }
}

TEST_F(SameInCpp, TheJudgementOfTwoRegions)
{
  const Arguments regions{"--region",      "east.txt", "--region",  "west.txt", "--crop", "-130,-20,-50,50,-2,50",
                          "--tool-radius", "4",        "--scallop", "0.05"};
  Arguments make{"scan.xyz", "-o", "path.csv", "--stock", "made.ply"},
      verify{"scan.xyz", "path.csv", "-o", "v.json", "--stock", "left.ply"};
  for (Arguments* arguments : {&make, &verify})
    arguments->insert(arguments->end(), regions.begin(), regions.end());
  ASSERT_EQ(run(PCL_SPIRAL_TOOLPATH_PROGRAM, make).code, 0);
  run(PCL_SPIRAL_VERIFY_PROGRAM, verify);
  const ToolpathFile read = readToolpath(folder_.path("path.csv"));
  PathVerifier<pcl::PointXYZ> verifier;
  verifier.setInputCloud(readCloud(folder_.path("scan.xyz")).cloud);
  verifier.setCropBox({Eigen::Vector3d(-130.0, -50.0, -2.0), Eigen::Vector3d(-20.0, 50.0, 50.0)});
  verifier.addRegion({polygon("east.txt"), std::nullopt, ""});
  verifier.addRegion({polygon("west.txt"), std::nullopt, ""});
  verifier.setInputToolpath(pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(read.path));
  Polyline tips = read.tips;
  tips[5].z() += 0.5;
  verifier.setInputTips(tips);
  verifier.setCutter(CutterShape::ball(4.0));
  Progress progress;
  verifier.setProgressCallback(std::ref(progress));
  Verification one;
  verifier.compute(one);
  EXPECT_FALSE(verifier.getStatus().ok()); // each region has its own
  std::vector<Verification> found;
  verifier.compute(found);
  ASSERT_TRUE(verifier.getStatus().ok()) << verifier.getStatus().message();
  EXPECT_TRUE(progress.rises && progress.last > 0.9) << "progress goes from 0 to 1, once; at the end " << progress.last;
  const nlohmann::json json = nlohmann::json::parse(readText(folder_.path("v.json")))["paths"];
  ASSERT_EQ(found.size(), 2U);
  StockMesh left;
  for (std::size_t i = 0; i < 2; ++i)
    append(stockMesh(*verifier.getReferenceSurface(i), verifier.getHeights(i).stock), left);
  writeStock(folder_.path("cpp.ply"), left);
  EXPECT_EQ(readText(folder_.path("cpp.ply")), readText(folder_.path("left.ply"))) << "of both regions";
  EXPECT_EQ(readText(folder_.path("cpp.ply")).size(), readText(folder_.path("made.ply")).size()) << "by the planner's own judge";
  EXPECT_EQ(found[0].tips_off + found[1].tips_off, 1U) << "of the region that the tip is in";
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(verifier.getJudgedPath(0)->size() + verifier.getJudgedPath(1)->size(), read.path.size());
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(json[i]["deviation"]["max"]["value"].get<double>(), found[i].deviation.max.value);
    EXPECT_EQ(json[i]["material"]["scallop"]["max"]["value"].get<double>(), found[i].removal.scallop.max.value);
    EXPECT_EQ(json[i]["motion"]["length"].get<double>(), found[i].removal.path_length);
  }
}

TEST_F(SameInCpp, TipsWithoutContacts)
{
  ASSERT_EQ(
      run(PCL_SPIRAL_TOOLPATH_PROGRAM, {"scan.xyz", "-o", "path.csv", "--tool-radius", "4", "--scallop", "0.05", "--part-at", "-75,0,4"})
          .code,
      0);
  const ToolpathFile made = readToolpath(folder_.path("path.csv"));
  std::ostringstream tips;
  tips.precision(12);
  tips << "tip_x,tip_y,tip_z,axis_x,axis_y,axis_z\n";
  for (std::size_t i = 0; i < made.path.size(); ++i)
    tips << made.tips[i].x() << ',' << made.tips[i].y() << ',' << made.tips[i].z() << ',' << made.path[i].axis_x << ','
         << made.path[i].axis_y << ',' << made.path[i].axis_z << '\n';
  writeText(folder_.path("tips.csv"), tips.str());
  const ToolpathFile read = readToolpath(folder_.path("tips.csv"));
  ASSERT_FALSE(read.has_contacts);
  PathVerifier<pcl::PointXYZ> verifier;
  verifier.setInputCloud(readCloud(folder_.path("scan.xyz")).cloud);
  verifier.setPartAt(on_left);
  verifier.setInputToolpath(pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(read.path));
  verifier.setInputTips(read.tips);
  verifier.setHasContacts(false);
  verifier.setCutter(CutterShape::ball(4.0));
  Verification found;
  verifier.compute(found);
  ASSERT_TRUE(verifier.getStatus().ok()) << verifier.getStatus().message();
  double farthest = 0.0; // of the contacts that were found from the surface at those of the planner
  for (std::size_t i = 0; i < made.path.size(); ++i) {
    const Eigen::Vector3f apart = verifier.getJudgedPath()->points[i].getVector3fMap() - made.path[i].getVector3fMap();
    farthest = std::max<double>(farthest, std::abs(apart.dot(made.path[i].getNormalVector3fMap())));
  }
  EXPECT_LT(farthest, 0.002);
  const std::size_t judged = found.deviation.points;
  verifier.addKeepOut(polygon("keep.txt")); // the tool leans as that of the contacts, and as many points are left to it
  verifier.compute(found);
  ASSERT_TRUE(verifier.getStatus().ok()) << verifier.getStatus().message();
  EXPECT_EQ(found.deviation.points, judged);
  const std::size_t beside_tips = verifier.getReferenceSurface()->scanned().size();
  verifier.setHasContacts(true);
  verifier.setInputToolpath(pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(made.path));
  verifier.compute(found);
  EXPECT_NEAR(static_cast<double>(verifier.getReferenceSurface()->scanned().size()), static_cast<double>(beside_tips), 20.0);
  verifier.clearPart();
  verifier.setHasContacts(false);
  verifier.setInputTips({});
  verifier.compute(found);
  EXPECT_EQ(verifier.getStatus().code(), StatusCode::InvalidInput) << "no tips";
  verifier.setHasContacts(true); // the tips are not those of the ball at the contacts
  Polyline off = made.tips;
  off[7] += Eigen::Vector3d(0.0, 0.0, 0.5);
  verifier.setInputToolpath(pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(made.path));
  verifier.setInputTips(off);
  verifier.compute(found);
  ASSERT_TRUE(verifier.getStatus().ok()) << verifier.getStatus().message();
  EXPECT_EQ(found.tips_off, 1U);
  EXPECT_EQ(found.tip_error.index, 7U);
  EXPECT_NEAR(found.tip_error.value, 0.5, 1e-5);
}

TEST_F(SameInCpp, ABeamOnARidge)
{
  writeDie();
  const RunResult result = run(PCL_SPIRAL_RIDGE_PROGRAM, {"rail.txt", "generator.txt", "-o", "program.6d", "--spot", "4", "--overlap",
                                                          "0.25", "--stand-off", "150", "--origin", "0,0,0"});
  ASSERT_EQ(result.code, 0) << result.err;
  RidgeToolpath<pcl::PointXYZ> ridge;
  ridge.setInputCloud(readCloud(folder_.path("rail.txt")).cloud);
  ridge.setInputGenerator(readCloud(folder_.path("generator.txt")).cloud);
  ridge.setSpot(4.0, 0.25);
  ridge.setStandOff(150.0);
  DrivePasses rows;
  ridge.compute(rows);
  ASSERT_TRUE(ridge.getStatus().ok()) << ridge.getStatus().message();
  writePoseVectors(folder_.path("cpp.6d"), beamPasses(rows, ridge.getStandOff()));
  EXPECT_EQ(readText(folder_.path("cpp.6d")), readText(folder_.path("program.6d")));
}

TEST_F(SameInCpp, ACutterOnARidge)
{
  writeDie();
  std::ostringstream through;
  for (const Vector3d& p : through_)
    through << (through.tellp() > 0 ? "/" : "") << p.x() << ',' << p.y() << ',' << p.z();
  for (const bool in_scan : {false, true}) {
    Arguments arguments =
        in_scan ? Arguments{"--scan", "die.xyz", "--through", through.str(), "--half-width", "9"} : Arguments{"rail.txt", "generator.txt"};
    for (const char* word : {"-o", "program.csv", "-o", "program.yaml", "--tool-radius", "6", "--step-over", "3", "--flank-length", "30",
                             "--holder", "7,40/20,25,60", "--accept-collisions", "--origin", "0,0,0"})
      arguments.emplace_back(word);
    const RunResult result = run(PCL_SPIRAL_RIDGE_PROGRAM, arguments);
    ASSERT_EQ(result.code, 0) << result.err;

    RidgePlanner<pcl::PointXYZ> planner;
    if (in_scan) {
      planner.setInputCloud(readCloud(folder_.path("die.xyz")).cloud);
      std::vector<Vector3d> read;
      std::string number;
      for (std::istringstream text(through.str()); std::getline(text, number, '/');) {
        Vector3d p;
        std::sscanf(number.c_str(), "%lf,%lf,%lf", &p.x(), &p.y(), &p.z());
        read.push_back(p);
      }
      planner.setRoughPoints(read);
      planner.setHalfWidth(9.0);
    }
    else {
      const auto lineOf = [this](const char* file) {
        const Scan scan = readCloud(folder_.path(file));
        Polyline line;
        for (const pcl::PointXYZ& p : *scan.cloud)
          line.push_back(p.getVector3fMap().cast<double>());
        return line;
      };
      planner.setMeasuredLines(lineOf("rail.txt"), lineOf("generator.txt"));
    }
    PassSettings tool;
    tool.cutter = CutterShape::ball(6.0);
    tool.cutter.flank_length = 30.0;
    tool.holder = {{7.0, 7.0, 40.0, "segment 1 of the holder"}, {20.0, 25.0, 60.0, "segment 2 of the holder"}};
    tool.accept_collisions = true;
    planner.setPassSettings(tool);
    RidgeRowSettings rows;
    rows.step_over = 3.0;
    rows.chord_error = 0.5 * tool.tolerance;
    planner.setRowSettings(rows);
    std::vector<ToolPoses> passes;
    planner.compute(passes);
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    const PassPath joined = joinedPasses(passes);
    writeToolpath(folder_.path("cpp.csv"), joined.path, {6.0, 1000.0, joined.tips, joined.begins});
    EXPECT_EQ(readText(folder_.path("cpp.csv")), readText(folder_.path("program.csv"))) << in_scan;
    EXPECT_GT(joined.path.size(), 300U);
  }
}

} // namespace same_in_cpp_test
