// SPDX-License-Identifier: BSD-3-Clause
// pcl_spiral_toolpath --mesh from outside: accuracy, messages about the mesh, and refused meshes.
#include <pcl_spiral/io/toolpath_reader.h>

#include "run_program.h"
#include "support/meshes.h"
#include "support/sanitizers.h"
#include "support/solids.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <sstream>

namespace mesh_toolpath_test {

namespace {

using namespace pcl_spiral::test;
using Arguments = std::vector<std::string>;

constexpr double size = 40.0; // mm, of the small landform
constexpr std::size_t cells = 20;

TriangleMesh
hills()
{
  return gridMesh(*landform(size), {size, size}, cells);
}

/** The mesh without the faces with their middle in \p hole. */
TriangleMesh
without(TriangleMesh mesh, const std::function<bool(const Eigen::Vector3d&)>& hole)
{
  const auto middle = [&](const auto& f) {
    return Eigen::Vector3d((mesh.vertices[f[0]] + mesh.vertices[f[1]] + mesh.vertices[f[2]]) / 3.0);
  };
  mesh.faces.erase(std::remove_if(mesh.faces.begin(), mesh.faces.end(), [&](const auto& f) { return hole(middle(f)); }), mesh.faces.end());
  return mesh;
}

TriangleMesh
together(TriangleMesh a, const TriangleMesh& b, const Eigen::Vector3d& shift)
{
  const auto first = static_cast<std::uint32_t>(a.vertices.size());
  for (const Eigen::Vector3d& v : b.vertices)
    a.vertices.push_back(v + shift);
  for (const auto& f : b.faces)
    a.faces.push_back({f[0] + first, f[1] + first, f[2] + first});
  return a;
}

std::string
obj(const TriangleMesh& mesh)
{
  std::ostringstream text;
  text.precision(9);
  for (const Eigen::Vector3d& v : mesh.vertices)
    text << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const auto& f : mesh.faces)
    text << "f " << f[0] + 1 << ' ' << f[1] + 1 << ' ' << f[2] + 1 << '\n';
  return text.str();
}

class MeshToolpath : public ::testing::Test {
protected:
  RunResult run(const std::string& file, Arguments arguments)
  {
    arguments.insert(arguments.begin(), {file, "--mesh", "-o", "a.csv", "-o", "a.json"});
    for (const auto& [option, value] : {std::pair{"--tool-radius", "3"}, std::pair{"--scallop", "0.05"}})
      if (std::find(arguments.begin(), arguments.end(), option) == arguments.end())
        arguments.insert(arguments.end(), {option, value});
    return endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments, folder_), folder_);
  }
  RunResult run(const TriangleMesh& mesh, const Arguments& arguments)
  {
    writeStl(folder_.path("part.stl"), mesh);
    return run("part.stl", arguments);
  }
  /** The run must end with \p code, print all of \p words, and leave no path. */
  void expectRefused(const RunResult& result, int code, const std::vector<std::string>& words)
  {
    EXPECT_EQ(result.code, code) << result.err;
    for (const std::string& word : words)
      EXPECT_NE(result.err.find(word), std::string::npos) << "without '" << word << "': " << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path("a.csv")));
    EXPECT_FALSE(std::filesystem::exists(folder_.path("a.json")));
  }
  void expectText(const std::string& name, const std::string& text, const std::vector<std::string>& words, int code = 1)
  {
    writeText(folder_.path(name), text);
    SCOPED_TRACE(name);
    expectRefused(run(name, {}), code, words);
  }
  nlohmann::json report() const { return nlohmann::json::parse(readText(folder_.path("a.json"))); }
  pcl::PointCloud<pcl_spiral::ToolpathPoint> path() const { return pcl_spiral::readToolpath(folder_.path("a.csv")).path; }
  /** Least distance of a path point from \p place. */
  double distanceFrom(const Eigen::Vector3d& place) const
  {
    double least = 1e300;
    for (const auto& p : path())
      least = std::min(least, (p.getVector3fMap().cast<double>() - place).norm());
    return least;
  }

  ScratchFolder folder_;
};

} // namespace

TEST_F(MeshToolpath, ContactsLieOnTheExactSurface)
{
  const RunResult made = run(gridMesh(*landform(), {100, 100}, 49), {"--tool-radius", "5", "--scallop", "0.01", "--chord-error", "0.001"});
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.err, "");
  std::vector<double> off;
  for (const auto& p : path())
    off.push_back(std::abs(landform()->signedDistance(p.getVector3fMap().cast<double>())));
  std::sort(off.begin(), off.end());
  EXPECT_LE(off[off.size() * 99 / 100], 0.004);
  EXPECT_LE(off.back(), 0.015);
}

TEST_F(MeshToolpath, JudgedByTheMeshAsTheReportsSay)
{
  const RunResult result = run(hills(), {"--verify", "-o", "a.vtp"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_NE(result.out.find("mesh            part.stl: 800 faces, 441 vertices"), std::string::npos) << result.out;
  EXPECT_EQ(result.out.find("found in it"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("samples of"), std::string::npos) << result.out;
  const nlohmann::json json = report();
  EXPECT_EQ(json.at("mesh").at("faces"), 800);
  EXPECT_EQ(json.at("mesh").at("boundaries"), 1);
  EXPECT_EQ(json.at("mesh").at("turned_faces").at("count"), 0);
  EXPECT_EQ(json.at("settings").at("flip_normals"), false);
  EXPECT_LT(std::abs(json.at("verification").at("deviation").at("max").at("value").get<double>()), 0.005) << json.at("verification");
}

TEST_F(MeshToolpath, TheSideIsTheMeshs)
{
  TriangleMesh below = hills();
  for (auto& f : below.faces)
    std::swap(f[1], f[2]);
  RunResult result = run(below, {});
  ASSERT_EQ(result.code, 0);
  EXPECT_NE(result.err.find("point down, along -z, so the cutter comes from below: give --flip-normals"), std::string::npos) << result.err;
  EXPECT_LT(path()[100].normal_z, 0.0F);
  result = run(below, {"--flip-normals", "--verify"});
  ASSERT_EQ(result.code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_GT(path()[100].normal_z, 0.0F);
  EXPECT_EQ(report().at("settings").at("flip_normals"), true);
}

TEST_F(MeshToolpath, WhatWasMendedIsSaid)
{
  TriangleMesh mesh = hills();
  std::swap(mesh.faces[100][1], mesh.faces[100][2]);
  mesh.faces.push_back(mesh.faces[7]);
  RunResult result = run(mesh, {});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.out.find("found in it     1 repeated faces left out (first at ("), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("1 faces turned (first at ("), std::string::npos) << result.out;
  EXPECT_EQ(report().at("mesh").at("repeated_faces").at("count"), 1);
  EXPECT_EQ(report().at("mesh").at("turned_faces").at("first").size(), 3u);
  result = run(mesh, {"-o", "a.html"});
  if (result.err.find("display") != std::string::npos)
    GTEST_SKIP() << "no display for the pictures of the .html";
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(readText(folder_.path("a.html")).find("1 faces turned"), std::string::npos);
}

TEST_F(MeshToolpath, HolesAreHolesOfThePart)
{
  const auto square = [](double half) {
    return [half](const Eigen::Vector3d& p) { return std::max(std::abs(p.x() - 20.0), std::abs(p.y() - 20.0)) < half; };
  };
  const Eigen::Vector3d middle = landform(size)->lift({20.0, 20.0});
  RunResult result = run(without(hills(), square(4.0)), {});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err.find("scan"), std::string::npos) << result.err;
  EXPECT_GT(distanceFrom(middle), 3.5) << "the path runs round the hole";
  EXPECT_EQ(report().at("holes").at(0).at("path"), "around");
  result = run(without(hills(), square(2.0)), {"--holes", "over", "--tool-radius", "1"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err.find("scan"), std::string::npos) << result.err;
  EXPECT_LT(distanceFrom(middle), 1.5);
  // One cell, less than a step-over wide: the path runs over it, except with --hole-size.
  const TriangleMesh narrow =
      without(hills(), [](const Eigen::Vector3d& p) { return std::max(std::abs(p.x() - 21.0), std::abs(p.y() - 21.0)) < 1.0; });
  result = run(narrow, {"--scallop", "0.5"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err.find("scan"), std::string::npos) << result.err;
  EXPECT_EQ(report().at("holes").at(0).at("path"), "over") << result.err;
  result = run(narrow, {"--scallop", "0.5", "--hole-size", "1.5"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(report().at("holes").at(0).at("path"), "around") << result.err;
  EXPECT_EQ(report().at("settings").at("hole_size"), 1.5);
}

TEST_F(MeshToolpath, CreasesInsideAreWarnedOf)
{
  TriangleMesh roof = gridMesh(*flat(landform(size)->region()), {size, size}, cells);
  for (Eigen::Vector3d& v : roof.vertices)
    v.z() = -0.6 * std::abs(v.x() - 20.0); // bent by 62 degrees
  const RunResult result = run(roof, {});
  ASSERT_EQ(result.code, 0) << result.err;
  for (const char* words : {"has 40 mm of creases (20 edges), the first at (20, ", "as if they were rounded"})
    EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  EXPECT_EQ(report().at("mesh").at("crease_edges").at("count"), 20);
}

TEST_F(MeshToolpath, SeveralParts)
{
  const TriangleMesh two = together(hills(), gridMesh(*landform(20.0), {20, 20}, 10), {80.0, 0.0, 0.0});
  expectRefused(run(two, {}), 1, {"the mesh has 2 separate parts", "mm2 at (", "--largest"});
  const RunResult result = run(two, {"--largest", "--verify"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_NE(result.err.find("kept only the largest of 2 separate parts"), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("uncut           0 %"), std::string::npos) << "the part left out is not asked for: " << result.out;
}

TEST_F(MeshToolpath, ClosedMeshes)
{
  expectRefused(run(icoSphere(20.0, 4), {}), 1,
                {"part.stl", "from (-", "to (", "is closed", "keep only the side", "pcl_spiral_drive --mesh"});
}

TEST_F(MeshToolpath, ARoughMeshIsSampledLessClosely)
{
  TriangleMesh rough = hills();
  std::mt19937 random(1);
  for (Eigen::Vector3d& v : rough.vertices)
    v.z() += std::uniform_real_distribution<double>(-0.3, 0.3)(random);
  expectRefused(run(rough, {"--tight", "refuse"}), 1,
                {"is hollow with radius", "(--sample-spacing)", "samples are 0.", "vertices of the mesh 1.9"});
  EXPECT_EQ(run("part.stl", {"--tight", "refuse", "--sample-spacing", "1.9"}).code, 0);
}

TEST_F(MeshToolpath, MeshesThatCannotBe)
{
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  expectText("points.ply", header + "end_header\n0 0 0\n1 0 0\n0 1 0\n", {"points.ply", "no faces", "leave --mesh out"});
  expectText("empty.stl", "", {"empty.stl", "empty"});
  expectText("nan.ply", header + faces + "end_header\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", {"nan.ply", "not a place"});
  expectText("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", {"index.obj", "vertex 9"});
  expectText("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", {"flat.obj", "area"});
  writeStl(folder_.path("whole.stl"), hills());
  const std::string whole = readText(folder_.path("whole.stl"));
  expectText("cut.stl", whole.substr(0, whole.size() / 2), {"cut.stl"});
  expectText("points.xyz", "0 0 0\n1 0 0\n0 1 0\n", {"points.xyz", ".stl .obj and .ply", "leave --mesh out"}, 2);
}

TEST_F(MeshToolpath, Metres)
{
  TriangleMesh small = hills();
  for (Eigen::Vector3d& v : small.vertices)
    v *= 0.001;
  writeText(folder_.path("metres.obj"), obj(small));
  expectRefused(run("metres.obj", {}), 1, {"mm across", "--units m"});
  const RunResult result = run("metres.obj", {"--units", "m"});
  ASSERT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.err, "");
}

TEST_F(MeshToolpath, OptionsOfScansAlone)
{
  writeStl(folder_.path("part.stl"), hills());
  for (const Arguments& option : {Arguments{"--outliers", "16,3"}, {"--thin", "1"}, {"--view-point", "0,0,9"}, {"--columns", "x,y,z"}})
    expectRefused(run("part.stl", option), 2, {option[0] + " belongs to scans", "leave one of the two out"});
  expectRefused(run("part.stl", {"--sample-spacing", "-1"}), 2, {"--sample-spacing -1", "above 0 mm"});
  expectRefused(run("part.stl", {"--sample-spacing", "1e-7"}), 2, {"part.stl", "--sample-spacing"});
  expectRefused(
      endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM,
                         {"part.stl", "--sample-spacing", "1", "-o", "a.csv", "--tool-radius", "3", "--scallop", "0.05"}, folder_),
            folder_),
      2, {"add --mesh to use the faces"});
}

TEST_F(MeshToolpath, QuietAndEndedFromOutside)
{
  EXPECT_EQ(run(hills(), {"--quiet"}).out, "");
  const std::string before = readText(folder_.path("a.csv"));
  const pid_t process = startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM,
                                     {"part.stl", "--mesh", "-o", "a.csv", "--tool-radius", "3", "--scallop", "0.00001"}, folder_);
  ASSERT_TRUE(waitUntilCaught(process, SIGINT));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  ASSERT_EQ(::kill(process, SIGINT), 0);
  EXPECT_EQ(endOf(process, folder_).code, 1);
  EXPECT_EQ(readText(folder_.path("a.csv")), before);
}

TEST_F(MeshToolpath, TheSameForAnyNumberOfThreads)
{
  ASSERT_EQ(run(hills(), {"--threads", "1"}).code, 0);
  const std::string alone = readText(folder_.path("a.csv"));
  ASSERT_EQ(run(hills(), {"--threads", "2"}).code, 0);
  EXPECT_EQ(readText(folder_.path("a.csv")), alone);
}

} // namespace mesh_toolpath_test
