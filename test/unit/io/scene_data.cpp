// SPDX-License-Identifier: BSD-3-Clause
// What a page gets of part and path: numbers come back within their rounding, and what is thinned stays as near as is said.
#include "io/report/packed_array.h"
#include "io/report/scene_builder.h"
#include "io/report/scene_frames.h"
#include "io/report/scene_html.h"
#include "io/report/scene_json.h"
#include "io/report/scene_part.h"
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/planning/pass_plan.h>

#include "support/base64_bytes.h"

#include <gtest/gtest.h>
#include <pcl/PolygonMesh.h>
#include <pcl/conversions.h>

#include <Eigen/Geometry>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>

namespace scene_data_test {

namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using pcl_spiral::test::decoded;

/** What the script of the page makes of a packed array. */
std::vector<double>
unpacked(const nlohmann::ordered_json& array)
{
  const std::string bytes = decoded(array.at("data"));
  std::vector<std::uint16_t> numbers(bytes.size() / 2);
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  const std::vector<double> low = array.at("low"), step = array.at("step");
  std::vector<double> values;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    values.push_back(numbers[i] == array.at("none") ? std::nan("") : low[i % low.size()] + step[i % low.size()] * numbers[i]);
  return values;
}

/** A square of places with heights of a wave, and the stock of each. */
ScenePart
wave(int cells)
{
  ScenePart part;
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-0.01f, 0.05f);
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const float x = 100.0f * i / cells, y = 100.0f * j / cells;
      part.places.emplace_back(x, y, 3.0f * std::sin(x / 9.0f));
      part.normals.emplace_back(0.0f, 0.0f, 1.0f);
      part.stock.push_back(unit(random));
    }
  const auto at = [cells](int i, int j) { return static_cast<std::uint32_t>(i * (cells + 1) + j); };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      part.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      part.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return part;
}

/** A spiral with a change of the axis. */
std::vector<SceneFrame>
spiral(int count)
{
  std::vector<SceneFrame> frames;
  for (int i = 0; i < count; ++i) {
    const double turn = 40.0 * i / count, angle = 2.0 * M_PI * turn;
    SceneFrame frame;
    frame.time = 0.1 * i;
    frame.tip = Vector3d(turn * std::cos(angle), turn * std::sin(angle), 0.0);
    frame.axis = Vector3d(0.2 * std::cos(angle), 0.2 * std::sin(angle), 1.0).normalized();
    frame.contact = frame.tip;
    frame.turn = turn;
    frame.move = i % (count / 4) == 7 ? SceneMove::Air : SceneMove::Cut;
    frames.push_back(frame);
  }
  return frames;
}

} // namespace

TEST(SceneData, WithoutThreeJsAPageSaysWhyThereIsNo3D)
{
  ReportScene scene;
  scene.part = wave(3);
  scene.frames = spiral(8);
  const std::string file = (std::filesystem::temp_directory_path() / ("scene_data_" + std::to_string(::getpid()) + ".html")).string();
  const auto textWith = [&](const char* three) {
    HtmlPage page("title", "subtitle");
    addScene(&scene, page, three);
    page.write(file, ReportPage{"title", "made by a test", ""});
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    std::filesystem::remove(file);
    return text.str();
  };
  const std::string without = textWith(""), with = textWith("var THREE = {};");
  EXPECT_NE(without.find("pictures alone: the program was built without three.js"), std::string::npos);
  EXPECT_EQ(without.find("<canvas"), std::string::npos);
  EXPECT_EQ(without.find("scene-data"), std::string::npos);
  EXPECT_EQ(with.find("pictures alone"), std::string::npos);
  EXPECT_NE(with.find("<canvas"), std::string::npos);
}

TEST(SceneData, NumbersComeBackWithinHalfAStep)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-300.0, 900.0);
  std::vector<double> values;
  for (int i = 0; i < 3000; ++i)
    values.push_back(i % 3 == 2 ? 0.001 * unit(random) : unit(random)); // a component with a small range is known better
  values[17] = std::nan("");
  const nlohmann::ordered_json packed = packedValues(values, 3);
  const std::vector<double> back = unpacked(packed);
  ASSERT_EQ(back.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i == 17)
      EXPECT_TRUE(std::isnan(back[i]));
    else
      EXPECT_NEAR(back[i], values[i], (i % 3 == 2 ? 1.2 : 1200.0) / 131068.0 * 1.0001);
  EXPECT_EQ(unpacked(packedValues({5.0, 5.0}, 1)), (std::vector<double>{5.0, 5.0})) << "one value, no range";
}

TEST(SceneData, AThinnedPartIsNearAndKeepsTheWorstStock)
{
  const ScenePart whole = wave(120);
  ScenePart thin = whole;
  const double apart = thinPart(4000, thin);
  EXPECT_GT(apart, 0.0);
  ASSERT_LE(thin.places.size(), 4000U);
  EXPECT_GT(thin.places.size(), 1500U);
  ASSERT_EQ(thin.stock.size(), thin.places.size());
  float deepest = 0.0f;
  for (std::size_t i = 0; i < whole.places.size(); ++i) {
    deepest = std::min(deepest, whole.stock[i]);
    float nearest = std::numeric_limits<float>::infinity();
    for (const Eigen::Vector3f& p : thin.places)
      nearest = std::min(nearest, (p - whole.places[i]).norm());
    ASSERT_LE(nearest, apart);
  }
  EXPECT_EQ(*std::min_element(thin.stock.begin(), thin.stock.end()), deepest);
  double area = 0.0;
  for (const auto& [a, b, c] : thin.triangles) {
    const Eigen::Vector3f across = (thin.places[b] - thin.places[a]).cross(thin.places[c] - thin.places[a]);
    area += 0.5 * across.z();
  }
  EXPECT_NEAR(area, 1e4, 300.0) << "seen from above: no triangle is lost or turned, but at the rim";
}

TEST(SceneData, AMeshIsCutIntoPiecesThatMeet)
{
  pcl::PolygonMesh faces;
  pcl::PointCloud<pcl::PointXYZ> corners;
  for (const auto& [x, y] : {std::pair{0.0f, 0.0f}, {100.0f, 0.0f}, {100.0f, 37.0f}, {0.0f, 37.0f}, {160.0f, 20.0f}})
    corners.emplace_back(x, y, 0.0f);
  pcl::toPCLPointCloud2(corners, faces.cloud);
  for (const auto& face : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}, {1, 4, 2}}) {
    faces.polygons.emplace_back();
    faces.polygons.back().vertices.assign(face.begin(), face.end());
  }
  SurfaceMesh::ConstPtr mesh;
  ASSERT_TRUE(SurfaceMesh::make(faces, {}, mesh).ok());
  ScenePart part;
  addMesh(*mesh, 20000, part);
  double area = 0.0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : part.triangles) {
    const Eigen::Vector3f across = (part.places[t[1]] - part.places[t[0]]).cross(part.places[t[2]] - part.places[t[0]]);
    EXPECT_GT(across.z(), 0.0f) << "a piece without area, or turned";
    area += 0.5 * across.z();
    for (int i = 0; i < 3; ++i) {
      ++edges[std::minmax(t[i], t[(i + 1) % 3])];
      EXPECT_LT((part.places[t[i]] - part.places[t[(i + 1) % 3]]).norm(), 2.0f);
    }
  }
  EXPECT_NEAR(area, 100.0 * 37.0 + 0.5 * 60.0 * 37.0, 0.1);
  double rim = 0.0;
  for (const auto& [edge, count] : edges)
    if (count == 1)
      rim += (part.places[edge.first] - part.places[edge.second]).norm();
  EXPECT_NEAR(rim, 100.0 + 37.0 + 100.0 + std::hypot(60.0, 20.0) + std::hypot(60.0, 17.0), 0.01) << "open edges at the rim alone";
}

TEST(SceneData, ThinnedMovesAreAsNearAsIsSaid)
{
  const std::vector<SceneFrame> whole = spiral(20000);
  std::vector<SceneFrame> thin = whole;
  const double off = thinFrames(3000, thin);
  EXPECT_LE(thin.size(), 3000U);
  EXPECT_GT(off, 0.0);
  EXPECT_LT(off, 0.5);
  std::size_t at = 0, air = 0;
  for (const SceneFrame& frame : whole) {
    while (thin[at + 1].time < frame.time)
      ++at;
    const double share = (frame.time - thin[at].time) / (thin[at + 1].time - thin[at].time);
    ASSERT_LE((thin[at].tip + share * (thin[at + 1].tip - thin[at].tip) - frame.tip).norm(), off * (1.0 + 1e-9)) << frame.time;
  }
  for (const SceneFrame& frame : thin)
    air += frame.move == SceneMove::Air;
  EXPECT_EQ(air, 4U) << "moves of other kinds stay";
  EXPECT_EQ(thin.back().time, whole.back().time);
}

TEST(SceneData, APlaceIsCutWhenTheNearestContactIsReached)
{
  ScenePart part = wave(20);
  const std::vector<SceneFrame> frames = spiral(4000);
  passPlaces(frames, 5.0, part);
  ASSERT_EQ(part.cut_at.size(), part.places.size());
  EXPECT_TRUE(part.deviation.size() == part.places.size());
  int passed = 0;
  for (std::size_t i = 0; i < part.places.size(); ++i) {
    double nearest = std::numeric_limits<double>::infinity(), when = nearest;
    for (const SceneFrame& frame : frames)
      if (const double d = (frame.contact - part.places[i].cast<double>()).norm(); frame.move == SceneMove::Cut && d < nearest) {
        nearest = d;
        when = frame.time;
      }
    if (nearest < 4.999)
      EXPECT_NEAR(part.cut_at[i], when, 0.11) << i;
    else if (nearest > 5.001)
      EXPECT_TRUE(std::isinf(part.cut_at[i])) << i;
    passed += nearest < 5.0;
  }
  EXPECT_GT(passed, 20);
}

TEST(SceneData, AProgramIsAtEachPointOfItsPathWhenItIsReached)
{
  constexpr double radius = 3.0, spacing = 0.5;
  std::vector<ToolPoses> passes(3);
  for (std::size_t pass = 0; pass < passes.size(); ++pass)
    for (int i = 0; i < 80; ++i) {
      ToolPose pose;
      pose.contact = Vector3d(spacing * i, 4.0 * static_cast<double>(pass), 0.02 * i);
      pose.axis = Vector3d(0.003 * i, 0.1, 1.0).normalized();
      pose.tip = pose.contact + radius * pose.normal - radius * pose.axis;
      passes[pass].push_back(pose);
    }
  MachineProgramGenerator generator;
  generator.setMachine(xyzacTrunnion());
  generator.setQuiet(true);
  generator.setInputPasses(passes);
  MachineProgram program;
  generator.compute(program);
  ASSERT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  const PassPath joined = joinedPasses(passes);
  const ShownPath path{pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(joined.path), joined.tips, joined.begins, 1000.0, {}, {}};
  const ShownProgram shown = shownProgram(program, nullptr, path);
  const std::vector<SceneFrame> frames = framesOf(shown, path);
  ASSERT_EQ(shown.reached.size(), joined.tips.size());
  ASSERT_EQ(frames.size(), program.blocks.size());
  for (std::size_t i = 0; i < joined.tips.size(); ++i) {
    const auto frame = std::lower_bound(frames.begin(), frames.end(), shown.reached[i] - 1e-9,
                                        [](const SceneFrame& f, double time) { return f.time < time; });
    ASSERT_NE(frame, frames.end());
    EXPECT_LT((frame->tip - joined.tips[i]).norm(), 1.5 * spacing) << i;
  }
  for (const SceneFrame& frame : frames)
    if (frame.move == SceneMove::Cut)
      EXPECT_LT((frame.contact + radius * Vector3d::UnitZ() - radius * frame.axis - frame.tip).norm(), 1.5 * spacing) << frame.number;
}

TEST(SceneData, TurnsAndPassesAreCountedFromOne)
{
  auto rows = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  auto turns = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  for (int i = 0; i < 300; ++i) {
    ToolpathPoint point;
    point.getVector3fMap() = Eigen::Vector3f(static_cast<float>(i % 100), static_cast<float>(i / 100), 0.0f);
    point.getNormalVector3fMap() = Eigen::Vector3f::UnitZ();
    point.arc_length = i;
    point.turn = static_cast<float>(i / 100);
    rows->push_back(point);
    point.turn = 0.12f * static_cast<float>(i); // 35.88 at the end
    turns->push_back(point);
  }
  const auto countsOf = [](const ShownPath& path) {
    SceneBuilder builder(CutterShape::ball(3.0), {});
    builder.addPath(path);
    const auto json = nlohmann::json::parse(sceneJson(*builder.build()));
    return std::make_pair(json.at("turnWord").get<std::string>(), json.at("turns").get<int>());
  };
  EXPECT_EQ(countsOf({rows, {}, {100, 200}, 1000.0, {}, {}}), std::make_pair(std::string("Pass"), 3));
  EXPECT_EQ(countsOf({turns, {}, {}, 1000.0, {}, {}}), std::make_pair(std::string("Turn"), 36));
}

TEST(SceneData, StandsInAPage)
{
  ReportScene scene;
  scene.part = wave(4);
  scene.frames = spiral(40);
  scene.cutter = CutterShape::bullNose(4.0, 1.0, 12.0);
  scene.holder = {ToolSegment::cylinder(4.0, 30.0, "a < b & c")};
  scene.turn_word = "</script>";
  const std::string text = sceneJson(scene);
  EXPECT_EQ(text.find_first_of("<&"), std::string::npos);
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json.at("turnWord"), "</script>");
  const auto& cutter = json.at("tool").at(0).at("profile");
  const CutterProfile profile(scene.cutter);
  for (std::size_t i = 1; i + 1 < cutter.size(); ++i)
    EXPECT_NEAR(profile.radiusAt(cutter[i][1].get<double>() + 1e-12), cutter[i][0].get<double>(), 1e-4) << cutter[i];
}

} // namespace scene_data_test
