// SPDX-License-Identifier: BSD-3-Clause
// A toolpath in a user's PCLVisualizer: actors counted and measured, the picture read back.
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>
#include <pcl_spiral/visualization/add_toolpath.h>
#include <pcl_spiral/visualization/pictures.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <random>

namespace add_toolpath_test {

using namespace pcl_spiral;
using pcl::visualization::PCLVisualizer;

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double sphere = 120.0, rim = 60.0, hole = 6.0; ///< mm

struct DomePath {
  pcl::PointCloud<ToolpathPoint> path;
  SpiralReport report;
  std::vector<RadialLine> lines;
};

/** The path of a dome with a hole in its scan, made once. */
const DomePath&
dome()
{
  static const DomePath made = [] {
    pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-rim, rim);
    while (cloud->size() < 8000) {
      const double x = place(random), y = place(random), z = std::sqrt(sphere * sphere - x * x - y * y);
      if (std::hypot(x, y) < rim && std::hypot(x - 10.0, y - 30.0) > hole)
        cloud->emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
    }
    DomePath result;
    SpiralToolpathGenerator<pcl::PointXYZ> spiral;
    spiral.setInputCloud(cloud);
    spiral.setMethod(SpiralMethod::Radial);
    spiral.setToolRadius(12.0);
    spiral.setScallopHeight(0.2);
    spiral.compute(result.path);
    result.report = spiral.getReport();
    RadialLines<pcl::PointXYZ> radial;
    radial.setInputCloud(cloud);
    radial.compute(result.lines);
    return result;
  }();
  return made;
}

vtkPolyData*
shape(PCLVisualizer& viewer, const std::string& id)
{
  const auto found = viewer.getShapeActorMap()->find(id);
  if (found == viewer.getShapeActorMap()->end())
    return nullptr;
  return vtkPolyData::SafeDownCast(vtkActor::SafeDownCast(found->second)->GetMapper()->GetInput());
}

/** Points of each cell, in the order of the data; a closed cell ends where it began. */
std::vector<std::vector<vtkIdType>>
cells(vtkPolyData* data)
{
  std::vector<std::vector<vtkIdType>> result;
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i) {
    vtkNew<vtkIdList> ids;
    data->GetCellPoints(i, ids);
    result.emplace_back(ids->begin(), ids->end());
  }
  return result;
}

Eigen::Vector3d
place(vtkPolyData* data, vtkIdType i)
{
  return Eigen::Map<const Eigen::Vector3d>(data->GetPoint(i));
}

/** Checks that cell \p ids of \p data runs through exactly these places. */
void
expectLine(vtkPolyData* data, const std::vector<vtkIdType>& ids, const Polyline& places, bool closed)
{
  ASSERT_EQ(ids.size(), places.size() + closed);
  for (std::size_t k = 0; k < ids.size(); ++k)
    ASSERT_EQ(place(data, ids[k]), places[k % places.size()]) << "point " << k;
}

using Pixel = std::array<int, 3>;

Pixel
colorAt(vtkPolyData* data, vtkIdType i)
{
  const double* const color = data->GetPointData()->GetScalars()->GetTuple3(i);
  return {static_cast<int>(color[0]), static_cast<int>(color[1]), static_cast<int>(color[2])};
}

Pixel
pixelOf(const Color& color)
{
  Pixel pixel{};
  std::transform(color.begin(), color.end(), pixel.begin(), [](double c) { return static_cast<int>(std::lround(255.0 * c)); });
  return pixel;
}

class AddToolpath : public testing::Test {
protected:
  void SetUp() override
  {
    if (!displayFault().empty())
      GTEST_SKIP() << "no display here, and PCLVisualizer would end the program";
    viewer_ = std::make_unique<PCLVisualizer>("toolpath");
    viewer_->setSize(800, 800);
    ASSERT_EQ(dome().report.boundaries, 1U);
    ASSERT_FALSE(dome().lines.empty());
  }
  PCLVisualizer& viewer() { return *viewer_; }
  std::size_t shapes() { return viewer_->getShapeActorMap()->size(); }
  /** The picture of the viewer from above: 5 pixels per mm. */
  vtkSmartPointer<vtkImageData> picture(const std::string& file)
  {
    vtkCamera* const camera = viewer_->getRendererCollection()->GetFirstRenderer()->GetActiveCamera();
    camera->SetParallelProjection(1);
    camera->SetParallelScale(80.0);
    viewer_->setCameraPosition(0.0, 0.0, 500.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0);
    viewer_->spinOnce();
    viewer_->saveScreenshot(file);
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
  }

private:
  std::unique_ptr<PCLVisualizer> viewer_;
};

Pixel
at(vtkImageData* image, int x, int y)
{
  const auto* const p = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
  return {p[0], p[1], p[2]};
}

} // namespace

TEST_F(AddToolpath, EveryPointOfPathLoopsAndLinesIsInOneOfThreeActors)
{
  const DomePath& made = dome();
  ASSERT_TRUE(addToolpath(viewer(), made.path, made.report.loops, made.lines));
  EXPECT_EQ(shapes(), 3U);

  vtkPolyData* const path = shape(viewer(), "toolpath_path");
  ASSERT_TRUE(path);
  ASSERT_EQ(path->GetNumberOfPoints(), static_cast<vtkIdType>(made.path.size()));
  Polyline contacts;
  for (const ToolpathPoint& point : made.path)
    contacts.push_back(point.getVector3fMap().cast<double>());
  ASSERT_EQ(path->GetNumberOfCells(), 1);
  expectLine(path, cells(path)[0], contacts, false);
  Eigen::Vector3d low = contacts[0], high = contacts[0];
  for (const Eigen::Vector3d& p : contacts) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(path->GetBounds()[2 * axis], low[axis]);
    EXPECT_EQ(path->GetBounds()[2 * axis + 1], high[axis]);
  }

  vtkPolyData* const loops = shape(viewer(), "toolpath_loops");
  ASSERT_TRUE(loops);
  ASSERT_EQ(made.report.loops.size(), 2U) << "the rim and the hole in the scan";
  ASSERT_EQ(loops->GetNumberOfCells(), 2);
  for (std::size_t i = 0; i < 2; ++i) {
    expectLine(loops, cells(loops)[i], made.report.loops[i].curve, true);
    EXPECT_EQ(colorAt(loops, cells(loops)[i][0]), pixelOf(loopColor(made.report.loops[i].type)));
  }

  vtkPolyData* const lines = shape(viewer(), "toolpath_lines");
  ASSERT_TRUE(lines);
  ASSERT_EQ(lines->GetNumberOfCells(), static_cast<vtkIdType>(made.lines.size()));
  for (std::size_t i = 0; i < made.lines.size(); ++i) {
    Polyline feet;
    for (const SurfaceFoot& foot : made.lines[i].feet)
      feet.push_back(foot.position);
    expectLine(lines, cells(lines)[i], feet, false);
  }
}

TEST_F(AddToolpath, ThePathIsColouredByTurnAndOverGaps)
{
  const DomePath& made = dome();
  addToolpath(viewer(), made.path);
  EXPECT_EQ(shapes(), 1U);
  vtkPolyData* const path = shape(viewer(), "toolpath_path");
  ASSERT_TRUE(path);
  double last = 0.0;
  for (const ToolpathPoint& point : made.path)
    last = std::max<double>(last, point.turn);
  std::size_t over_gap = 0;
  for (std::size_t i = 0; i < made.path.size(); ++i) {
    over_gap += made.path[i].over_gap;
    const Color color = made.path[i].over_gap ? loopColor(LoopType::ScanGap) : turnColor(made.path[i].turn / last);
    ASSERT_EQ(colorAt(path, static_cast<vtkIdType>(i)), pixelOf(color)) << "point " << i;
  }
  EXPECT_GT(over_gap, 10U);
  EXPECT_NE(pixelOf(turnColor(0.0)), pixelOf(turnColor(1.0)));

  pcl::PointCloud<pcl::PointXYZ> bare; // a type without turns
  for (const ToolpathPoint& point : made.path)
    bare.emplace_back(point.x, point.y, point.z);
  ASSERT_TRUE(addToolpath(viewer(), bare));
  vtkPolyData* const plain = shape(viewer(), "toolpath_path");
  EXPECT_EQ(plain->GetNumberOfPoints(), static_cast<vtkIdType>(made.path.size()));
  for (vtkIdType i = 0; i < plain->GetNumberOfPoints(); ++i)
    ASSERT_EQ(colorAt(plain, i), pixelOf(turnColor(0.0)));
}

TEST_F(AddToolpath, EmptyPartsAreLeftOutAndPointsThatAreNotFiniteSkipped)
{
  const pcl::PointCloud<ToolpathPoint> none;
  EXPECT_FALSE(addToolpath(viewer(), none));
  EXPECT_FALSE(addToolpath(viewer(), none, {BoundaryLoop()}, std::vector<Polyline>(3)));
  EXPECT_EQ(shapes(), 0U);

  BoundaryLoop loop;
  loop.type = LoopType::Inner;
  loop.points = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {nothing, 0.0, 0.0}, {0.0, 2.0, 0.0}};
  const Polyline line = {{nothing, nothing, nothing}, {0.0, 0.0, 3.0}, {0.0, 0.0, 4.0}};
  const Polyline lone = {{nothing, 0.0, 0.0}, {7.0, 7.0, 7.0}};
  ASSERT_TRUE(addToolpath(viewer(), none, {loop}, std::vector<Polyline>{line, lone}));
  EXPECT_EQ(shapes(), 2U);
  vtkPolyData* const loops = shape(viewer(), "toolpath_loops");
  ASSERT_TRUE(loops);
  expectLine(loops, cells(loops).at(0), {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}}, true);
  EXPECT_EQ(colorAt(loops, 0), pixelOf(loopColor(LoopType::Inner)));
  vtkPolyData* const lines = shape(viewer(), "toolpath_lines");
  ASSERT_TRUE(lines);
  ASSERT_EQ(lines->GetNumberOfCells(), 1);
  expectLine(lines, cells(lines)[0], {{0.0, 0.0, 3.0}, {0.0, 0.0, 4.0}}, false);

  pcl::PointCloud<ToolpathPoint> path = dome().path;
  path[3].y = static_cast<float>(nothing);
  path[5].turn = static_cast<float>(nothing);
  ASSERT_TRUE(addToolpath(viewer(), path));
  EXPECT_EQ(shapes(), 1U) << "what was shown before is gone";
  EXPECT_EQ(shape(viewer(), "toolpath_path")->GetNumberOfPoints(), static_cast<vtkIdType>(path.size()) - 1);
  EXPECT_EQ(shape(viewer(), "toolpath_path")->GetNumberOfCells(), 1);
}

TEST_F(AddToolpath, TheSameIdReplacesAndRemoveTakesAwayItsOwnAlone)
{
  const DomePath& made = dome();
  addToolpath(viewer(), made.path, made.report.loops, made.report.radial_lines);
  addToolpath(viewer(), made.path, made.report.loops, made.lines, "other");
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>(5, 1));
  viewer().addPointCloud<pcl::PointXYZ>(cloud, "toolpath");
  EXPECT_EQ(shapes(), 6U);

  pcl::PointCloud<ToolpathPoint> half = made.path;
  half.resize(half.size() / 2);
  addToolpath(viewer(), half, made.report.loops);
  EXPECT_EQ(shapes(), 5U);
  EXPECT_EQ(shape(viewer(), "toolpath_path")->GetNumberOfPoints(), static_cast<vtkIdType>(half.size()));
  EXPECT_EQ(shape(viewer(), "other_path")->GetNumberOfPoints(), static_cast<vtkIdType>(made.path.size()));
  EXPECT_EQ(viewer().getRendererCollection()->GetFirstRenderer()->GetActors()->GetNumberOfItems(), 6)
      << "nothing stays behind that has no name: five shapes and the cloud";

  removeToolpath(viewer());
  EXPECT_EQ(shapes(), 3U);
  EXPECT_FALSE(shape(viewer(), "toolpath_path"));
  removeToolpath(viewer());
  removeToolpath(viewer(), "other");
  EXPECT_EQ(shapes(), 0U);
  EXPECT_TRUE(viewer().contains("toolpath")) << "a cloud of that name is not ours";
}

TEST_F(AddToolpath, AViewportOfItsOwn)
{
  int left = 0, right = 0;
  viewer().createViewPort(0.0, 0.0, 0.5, 1.0, left);
  viewer().createViewPort(0.5, 0.0, 1.0, 1.0, right);
  addToolpath(viewer(), dome().path, dome().report.loops, dome().lines, "toolpath", right);
  std::vector<int> actors;
  auto* const renderers = viewer().getRendererCollection().Get();
  renderers->InitTraversal();
  while (vtkRenderer* const renderer = renderers->GetNextItem())
    actors.push_back(renderer->GetActors()->GetNumberOfItems());
  ASSERT_GT(actors.size(), static_cast<std::size_t>(right));
  EXPECT_EQ(actors[left], 0);
  EXPECT_EQ(actors[right], 3);
  removeToolpath(viewer());
  EXPECT_EQ(shapes(), 0U);
}

TEST_F(AddToolpath, ThePictureShowsTheSpiral)
{
  const ScratchFolder folder;
  const DomePath& made = dome();
  const auto black = [](const Pixel& p) { return p[0] + p[1] + p[2] < 60; };
  addToolpath(viewer(), made.path);
  const auto spiral = picture(folder.path("spiral.png"));
  int width[3];
  spiral->GetDimensions(width);
  ASSERT_EQ(width[0], 800);
  // to the left from the centre, away from the gap, every turn is crossed once
  int crossed = 0;
  for (int x = 399; x > 0; --x)
    crossed += black(at(spiral, x, 400)) && !black(at(spiral, x - 1, 400));
  EXPECT_NEAR(crossed, static_cast<int>(made.report.turns), 1);

  addToolpath(viewer(), pcl::PointCloud<ToolpathPoint>(), made.report.loops);
  const auto loops = picture(folder.path("loops.png"));
  const Pixel red = pixelOf(loopColor(LoopType::Outer)), magenta = pixelOf(loopColor(LoopType::ScanGap));
  double red_reach = 0.0;
  std::size_t reds = 0, magentas = 0;
  for (int y = 0; y < 800; ++y)
    for (int x = 0; x < 800; ++x) {
      magentas += at(loops, x, y) == magenta;
      reds += at(loops, x, y) == red;
      if (at(loops, x, y) == red)
        red_reach = std::max(red_reach, std::hypot(x - 399.5, y - 399.5) / 5.0);
    }
  EXPECT_NEAR(red_reach, rim, 2.0) << "mm";
  EXPECT_GT(static_cast<double>(reds), 2.0 * 10.0 * M_PI * rim) << "three pixels wide, not dimmed by light";
  EXPECT_GT(static_cast<double>(magentas), 2.0 * 10.0 * M_PI * hole);

  addToolpath(viewer(), pcl::PointCloud<ToolpathPoint>(), {}, made.lines);
  const auto lines = picture(folder.path("lines.png"));
  std::size_t crossed_pixels = 0; // of a square of 60 mm round the centre; every line leaves it
  for (int i = 0; i < 800; ++i)
    for (const auto& [x, y] : {std::pair(i, 250), {i, 549}, {250, i}, {549, i}})
      crossed_pixels += i >= 250 && i < 550 && !black(at(lines, x, y));
  EXPECT_GE(crossed_pixels, made.lines.size());
}

TEST(ShowToolpathExample, EndsByItself)
{
  const bool display = displayFault().empty();
  const ScratchFolder folder;
  const std::string program = "'" PCL_SPIRAL_EXAMPLES_DIR "/example_show_toolpath' 0.5 >/dev/null 2>" + folder.path("said");
  EXPECT_EQ(WEXITSTATUS(std::system(program.c_str())), display ? 0 : 1);
  EXPECT_EQ(WEXITSTATUS(std::system(("env -u DISPLAY " + program).c_str())), 1);
  EXPECT_NE(readText(folder.path("said")).find("DISPLAY is not set; run it under 'xvfb-run -a'"), std::string::npos);
}

} // namespace add_toolpath_test
