// SPDX-License-Identifier: BSD-3-Clause
// Scenes and time series, read back by VTK's own readers.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/scene_writer.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <vtkCell.h>
#include <vtkCompositeDataIterator.h>
#include <vtkFieldData.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

namespace scene_files_test {

using namespace pcl_spiral;

namespace {

/** A strip of six places with stock, under a path of two passes. */
CutScene
strip()
{
  CutScene scene;
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector3f normal = Eigen::Vector3f(0.1f * static_cast<float>(i), 0.0f, 1.0f).normalized();
    const float height = 0.01f * static_cast<float>(i - 1);
    scene.stock.normals.push_back(normal);
    scene.stock.stock.push_back(height);
    scene.stock.places.push_back(Eigen::Vector3f(static_cast<float>(i / 2), static_cast<float>(i % 2), 5.0f) + height * normal);
  }
  scene.stock.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
  scene.limit = 0.025;
  scene.gouge = 0.005;
  auto path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  for (int i = 0; i < 6; ++i) {
    ToolpathPoint point;
    point.getVector3fMap() = Eigen::Vector3f(static_cast<float>(i % 3), i < 3 ? 0.0f : 1.0f, 5.0f);
    point.arc_length = i < 3 ? i : i - 1; // a lift from the third to the fourth
    path->push_back(point);
  }
  scene.path = path;
  return scene;
}

std::vector<vtkSmartPointer<vtkPolyData>>
readGltf(const std::string& file)
{
  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  std::vector<vtkSmartPointer<vtkPolyData>> found;
  const auto blocks = vtkSmartPointer<vtkCompositeDataIterator>::Take(reader->GetOutput()->NewIterator());
  for (blocks->InitTraversal(); !blocks->IsDoneWithTraversal(); blocks->GoToNextItem())
    found.emplace_back(vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject()));
  return found;
}

std::string
bytesOf(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

/** The two chunks of a .glb. */
struct Glb {
  explicit Glb(const std::string& bytes)
  {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 12, sizeof(length));
    document = nlohmann::json::parse(bytes.substr(20, length));
    data = bytes.substr(28 + length);
  }
  std::vector<float> values(std::size_t accessor, std::size_t width) const
  {
    const auto& described = document.at("accessors").at(accessor);
    const auto& view = document.at("bufferViews").at(described.at("bufferView").get<std::size_t>());
    std::vector<float> found(width * described.at("count").get<std::size_t>());
    EXPECT_EQ(described.at("componentType"), 5126);
    EXPECT_EQ(view.at("byteLength"), sizeof(float) * found.size());
    std::memcpy(found.data(), data.data() + view.at("byteOffset").get<std::size_t>(), sizeof(float) * found.size());
    return found;
  }

  nlohmann::json document;
  std::string data;
};

Eigen::Vector3d
inMillimetres(vtkPolyData* data, vtkIdType i)
{
  const double* const p = data->GetPoint(i);
  return 1e3 * Eigen::Vector3d(p[0], -p[2], p[1]);
}

} // namespace

TEST(SceneFiles, VtksReaderFindsPartPathAndStock)
{
  const ScratchFolder folder;
  const CutScene scene = strip();
  for (const char* name : {"cut.gltf", "cut.glb"}) {
    writeScene(folder.path(name), scene);
    const auto found = readGltf(folder.path(name));
    ASSERT_EQ(found.size(), 3U) << name;
    vtkPolyData *const part = found[0], *const path = found[1], *const stock = found[2];
    ASSERT_TRUE(part && path && stock);
    ASSERT_EQ(part->GetNumberOfPoints(), 6);
    ASSERT_EQ(stock->GetNumberOfPoints(), 6);
    EXPECT_EQ(part->GetNumberOfCells(), 4);
    EXPECT_EQ(stock->GetNumberOfCells(), 4);
    EXPECT_EQ(path->GetNumberOfPoints(), 6);
    EXPECT_EQ(path->GetNumberOfCells(), 4) << "two moves a pass, and none for the lift";
    for (vtkIdType i = 0; i < 6; ++i) {
      const Eigen::Vector3d top = scene.stock.places[i].cast<double>();
      const Eigen::Vector3d foot = top - scene.stock.stock[i] * scene.stock.normals[i].cast<double>();
      EXPECT_LT((inMillimetres(stock, i) - top).norm(), 1e-5);
      EXPECT_LT((inMillimetres(part, i) - foot).norm(), 1e-5);
      EXPECT_LT((inMillimetres(path, i) - (*scene.path)[i].getVector3fMap().cast<double>()).norm(), 1e-5);
      const double* const n = stock->GetPointData()->GetNormals()->GetTuple3(i);
      EXPECT_LT((Eigen::Vector3d(n[0], -n[2], n[1]) - scene.stock.normals[i].cast<double>()).norm(), 1e-5);
    }
    vtkIdType corners[3] = {stock->GetCell(1)->GetPointId(0), stock->GetCell(1)->GetPointId(1), stock->GetCell(1)->GetPointId(2)};
    EXPECT_EQ(corners[0], 1);
    EXPECT_EQ(corners[1], 2);
    EXPECT_EQ(corners[2], 3);
  }
}

TEST(SceneFiles, TheSameSceneGivesTheSameBytesAndAnEmptyOneIsRefused)
{
  const ScratchFolder folder;
  writeScene(folder.path("a.glb"), strip());
  writeScene(folder.path("b.glb"), strip());
  const std::string a = bytesOf(folder.path("a.glb"));
  EXPECT_EQ(a, bytesOf(folder.path("b.glb")));
  EXPECT_EQ(a.size() % 4, 0U);
  CutScene bare = strip();
  bare.stock.triangles.clear();
  EXPECT_THROW(writeScene(folder.path("c.glb"), bare), FileError);
  CutScene still = strip();
  still.path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  EXPECT_THROW(writeScene(folder.path("c.gltf"), still), FileError);
}

TEST(SceneFiles, TheStockHasItsHeightsAndColours)
{
  const ScratchFolder folder;
  const CutScene scene = strip();
  writeScene(folder.path("cut.glb"), scene);
  const Glb glb(bytesOf(folder.path("cut.glb")));
  const auto& attributes = glb.document.at("meshes").at(2).at("primitives").at(0).at("attributes");
  EXPECT_EQ(glb.values(attributes.at("_STOCK"), 1), scene.stock.stock);
  const std::vector<float> colors = glb.values(attributes.at("COLOR_0"), 3);
  ASSERT_EQ(colors.size(), 18U);
  const auto color = [&](std::size_t i) { return Eigen::Map<const Eigen::Vector3f>(&colors[3 * i]); };
  EXPECT_GT(color(0).x(), 20.0f * color(0).y()) << "a gouge of 10 um is red";
  EXPECT_LT(color(1).y(), color(2).y()) << "brighter with its height";
  EXPECT_LT(color(2).y(), color(3).y());
  EXPECT_EQ(color(4), color(5)) << "30 and 40 um are above the limit";
  EXPECT_GT(color(4).x(), 3.0f * color(4).y());
  EXPECT_NE(color(0), color(4));
  CutScene tolerant = scene;
  tolerant.gouge = 0.02;
  writeScene(folder.path("tolerant.glb"), tolerant);
  const Glb other(bytesOf(folder.path("tolerant.glb")));
  const std::vector<float> milder =
      other.values(other.document.at("meshes").at(2).at("primitives").at(0).at("attributes").at("COLOR_0"), 3);
  EXPECT_LT(milder[0], milder[1]) << "10 um are no gouge where 20 um are allowed";
}

TEST(SceneFiles, PassesOfOnePointAreLeftOutAndAShiftIsNamed)
{
  const ScratchFolder folder;
  CutScene scene = strip();
  writeScene(folder.path("plain.glb"), scene);
  EXPECT_FALSE(Glb(bytesOf(folder.path("plain.glb"))).document.at("asset").contains("extras"));
  auto path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(*scene.path);
  ToolpathPoint alone;
  alone.getVector3fMap() = Eigen::Vector3f(0.0f, 9.0f, 5.0f);
  alone.arc_length = path->back().arc_length; // a lift to it
  path->push_back(alone);
  scene.path = path;
  scene.shift = {393775000.0, 3689071000.0, 0.5};
  writeScene(folder.path("cut.glb"), scene);
  const auto document = Glb(bytesOf(folder.path("cut.glb"))).document;
  EXPECT_EQ(document.at("asset").at("extras").at("shift_mm"), nlohmann::json({393775000.0, 3689071000.0, 0.5}));
  const auto& line = document.at("meshes").at(1).at("primitives").at(0);
  EXPECT_EQ(document.at("accessors").at(line.at("attributes").at("POSITION").get<std::size_t>()).at("count"), 6);
  EXPECT_EQ(document.at("accessors").at(line.at("indices").get<std::size_t>()).at("count"), 8);
  auto points = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  points->push_back((*scene.path)[0]);
  scene.path = points;
  EXPECT_THROW(writeScene(folder.path("points.glb"), scene), FileError);
}

TEST(SceneFiles, AMomentHasItsHeightsAndTheTool)
{
  const ScratchFolder folder;
  const CutScene scene = strip();
  CutMoment moment;
  moment.heights.assign(6, 0.3f);
  moment.tip = {1.0, 2.0, 3.0};
  moment.axis = {0.0, 0.6, 0.8};
  const Eigen::Vector3d origin(1e6, 2e6, 30.0);
  writeMoment(folder.path("cut_00.vtp"), scene.stock, moment, 50.0, origin);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(folder.path("cut_00.vtp").c_str());
  reader->Update();
  vtkPolyData* const data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), 8);
  EXPECT_EQ(data->GetNumberOfPolys(), 4);
  EXPECT_EQ(data->GetNumberOfLines(), 1);
  for (vtkIdType i = 0; i < 6; ++i) {
    const Eigen::Vector3d n = scene.stock.normals[i].cast<double>();
    const Eigen::Vector3d place = scene.stock.places[i].cast<double>() + (0.3 - scene.stock.stock[i]) * n + origin;
    EXPECT_LT((Eigen::Map<const Eigen::Vector3d>(data->GetPoint(i)) - place).norm(), 1e-5);
    EXPECT_FLOAT_EQ(static_cast<float>(data->GetPointData()->GetScalars()->GetTuple1(i)), 0.3f);
  }
  EXPECT_LT((Eigen::Map<const Eigen::Vector3d>(data->GetPoint(7)) - (moment.tip + 50.0 * moment.axis + origin)).norm(), 1e-8);
}

TEST(SceneFiles, ASeriesNamesItsMoments)
{
  const ScratchFolder folder;
  writeSeries(folder.path("cut.pvd"), {"a&b_00.vtp", "a&b_01.vtp"}, {0.0, 1.5});
  std::ifstream in(folder.path("cut.pvd"));
  const std::string text(std::istreambuf_iterator<char>(in), {});
  EXPECT_NE(text.find("<DataSet timestep=\"1.500000\" part=\"0\" file=\"a&amp;b_01.vtp\"/>"), std::string::npos) << text;
}

} // namespace scene_files_test
