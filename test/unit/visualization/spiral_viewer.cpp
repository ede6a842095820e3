// SPDX-License-Identifier: BSD-3-Clause
// The viewer used as by a user: keys and clicks sent to its window, frames read back.
#include <pcl_spiral/visualization/spiral_viewer.h>

#include "support/scratch_folder.h"
#include "support/window_frame.h"

#include <pcl/conversions.h>

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <memory>

namespace spiral_viewer_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
constexpr double radius = 100.0, height = 20.0;
constexpr int column_room = 434; ///< pixels, of the text on the right

/** A paraboloid of radius 100 mm. */
Eigen::Vector3d
place(double r, double angle)
{
  return {r * std::cos(angle), r * std::sin(angle), height * (1.0 - r * r / (radius * radius))};
}

/** A part cut well except at one place: deviations within a micrometre, ridges of 9 to 10 um. */
VerificationScene
scene(int reference_points = 20000, int turns = 60, int steps_a_turn = 200)
{
  VerificationScene result;
  result.part.title = "paraboloid";
  result.part.settings.tool_radius = 10.0;
  result.part.settings.scallop_height = 0.01;
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int i = 0; i < reference_points; ++i) { // a sunflower
    const Eigen::Vector3f p = place(radius * std::sqrt((i + 0.5) / reference_points), 2.39996322972865 * i).cast<float>();
    cloud->emplace_back(p.x(), p.y(), p.z());
    result.stock.push_back(0.004f + 0.003f * static_cast<float>(std::sin(0.01 * i)));
    result.ridges.push_back(p.head<2>().norm() > 98.0f ? nothing : 0.0095f + 0.0005f * static_cast<float>(std::sin(0.02 * i)));
  }
  auto path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  const int steps = turns * steps_a_turn;
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector3d p = place(radius * i / steps, 2.0 * M_PI * i / steps_a_turn);
    const Eigen::Vector3f normal = Eigen::Vector3d(2.0 * height * p.x(), 2.0 * height * p.y(), radius * radius).normalized().cast<float>();
    ToolpathPoint point;
    point.getVector3fMap() = p.cast<float>();
    point.getNormalVector3fMap() = normal;
    point.getAxisVector3fMap() = normal;
    point.turn = static_cast<float>(i) / static_cast<float>(steps_a_turn);
    if (!path->empty())
      point.arc_length = path->back().arc_length + (point.getVector3fMap() - path->back().getVector3fMap()).norm();
    path->push_back(point);
    result.deviation.push_back(0.001f * static_cast<float>(std::sin(0.03 * i)));
  }
  BoundaryLoop rim;
  for (int i = 0; i < 200; ++i)
    rim.points.push_back(place(radius, 2.0 * M_PI * i / 200.0));
  rim.curve = rim.points;
  result.part.report.loops.push_back(rim);
  result.part.report.used_points = cloud->size();
  result.part.cloud = cloud;
  result.part.path = path;
  const std::size_t worst = static_cast<std::size_t>(steps) / 2;
  result.deviation[worst] = 0.02f;
  result.deviation_figures.p99 = 0.001;
  result.deviation_figures.max = {0.02, (*path)[worst].getVector3fMap().cast<double>(), worst};
  result.removal_figures.limit = 0.0152;
  result.removal_figures.reach = 0.2;
  result.removal_figures.scallop.max = {0.01, place(50.0, 1.0), worst / 2};
  return result;
}

std::function<bool(const Pixel&)>
like(double r, double g, double b)
{
  return [=](const Pixel& p) { return std::abs(p[0] - 255 * r) < 6 && std::abs(p[1] - 255 * g) < 6 && std::abs(p[2] - 255 * b) < 6; };
}

const auto is_white = like(1.0, 1.0, 1.0), is_rim = like(0.80, 0.11, 0.13), is_over = like(0.85, 0.0, 0.75),
           is_gouge = like(0.84, 0.04, 0.07), is_bar = like(0.128, 0.567, 0.551);

bool
isCutter(const Pixel& p)
{
  return p[0] > p[2] + 60 && p[1] > p[2] + 25 && p[0] > p[1] + 15;
}

bool
isDark(const Pixel& p)
{
  return p[0] < 120 && p[1] < 120 && p[2] < 120;
}

class Viewer : public testing::Test {
protected:
  static void TearDownTestSuite() { shared_.reset(); }
  void SetUp() override
  {
    if (!displayFault().empty())
      GTEST_SKIP() << "no display here";
  }
  /** In a small window, fast to draw even without a graphics card. */
  std::unique_ptr<SpiralViewer> open(const VerificationScene& shown) const
  {
    auto viewer = std::make_unique<SpiralViewer>(shown);
    viewer->getInteractor()->GetRenderWindow()->SetSize(960, 720);
    press(*viewer, "r");
    return viewer;
  }
  /** Viewer of scene(); opening a window takes a second without a graphics card. */
  SpiralViewer& shared() const
  {
    if (!shared_)
      shared_ = open(scene());
    press(*shared_, "r");
    return *shared_;
  }
  void press(SpiralViewer& viewer, const std::string& key) const
  {
    vtkRenderWindowInteractor* const interactor = viewer.getInteractor();
    interactor->SetKeyEventInformation(0, 0, key.size() == 1 ? key[0] : '\0', 1, key.c_str());
    interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    interactor->InvokeEvent(vtkCommand::CharEvent);
    interactor->InvokeEvent(vtkCommand::KeyReleaseEvent);
  }
  void drag(SpiralViewer& viewer, int from_x, int from_y, int to_x, int to_y) const
  {
    vtkRenderWindowInteractor* const interactor = viewer.getInteractor();
    interactor->SetEventInformation(from_x, from_y);
    interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    interactor->SetEventInformation(to_x, to_y);
    if (from_x != to_x || from_y != to_y)
      interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
    interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  }
  Frame frame(SpiralViewer& viewer) const { return Frame(viewer.getInteractor()->GetRenderWindow()); }

private:
  static std::unique_ptr<SpiralViewer> shared_;
};

std::unique_ptr<SpiralViewer> Viewer::shared_;

} // namespace

TEST_F(Viewer, AMeshIsDrawnWithItsOwnFaces)
{
  VerificationScene with = scene(2000, 10);
  pcl::PolygonMesh plate; // wider than the path, level
  pcl::PointCloud<pcl::PointXYZ> corners;
  for (const float x : {-150.0f, 150.0f})
    for (const float y : {-150.0f, 150.0f})
      corners.emplace_back(x, y, -1.0f);
  pcl::toPCLPointCloud2(corners, plate.cloud);
  plate.polygons.resize(2);
  plate.polygons[0].vertices = {0, 2, 3};
  plate.polygons[1].vertices = {0, 3, 1};
  ASSERT_TRUE(SurfaceMesh::make(plate, {}, with.part.mesh).ok());
  with.part.report.spacing = 2.0;
  const auto viewer = open(with);
  const auto levels = [&] { // pixels of one shade, as on a level face
    const Frame frame(viewer->getInteractor()->GetRenderWindow());
    std::map<Pixel, std::size_t> shades;
    for (int y = 0; y < frame.height(); ++y)
      for (int x = 0; x < frame.width() - column_room; ++x)
        if (const Pixel p = frame.at(x, y); !is_white(p))
          ++shades[p];
    std::size_t largest = 0;
    for (const auto& [shade, count] : shades)
      largest = std::max(largest, count);
    return largest;
  };
  for (const char* page : {"2", "3", "4"}) {
    press(*viewer, page);
    EXPECT_GT(levels(), 10000U) << page;
  }
  press(*viewer, "1"); // by height, along the path's mean normal
  const Frame heights(viewer->getInteractor()->GetRenderWindow());
  const auto is_colored = [](const Pixel& p) { return std::max({p[0], p[1], p[2]}) - std::min({p[0], p[1], p[2]}) > 40; };
  const auto is_drawn = [](const Pixel& p) { return !is_white(p); };
  const int last = heights.width() - column_room;
  const auto colored = static_cast<double>(heights.count(is_colored, 0, last, 0, heights.height()));
  EXPECT_GT(colored, 0.8 * static_cast<double>(heights.count(is_drawn, 0, last, 0, heights.height()))) << "all over";
}

TEST_F(Viewer, EveryKeyShowsItsOwnView)
{
  SpiralViewer& viewer = shared();
  std::vector<Frame> frames;
  for (int page = 1; page <= 5; ++page) {
    press(viewer, std::to_string(page));
    EXPECT_EQ(static_cast<int>(viewer.getPage()), page);
    frames.push_back(frame(viewer));
    const Frame& shown = frames.back();
    EXPECT_LT(shown.count(is_white), 0.95 * shown.width() * shown.height()) << page;
    // title, and keys in the column at the right
    EXPECT_GT(shown.count(isDark, 30, 600, shown.height() - 60, shown.height()), 500U) << page;
    EXPECT_GT(shown.count(isDark, shown.width() - column_room, shown.width(), 0, 300), 2000U) << page;
    for (int before = 0; before < page - 1; ++before)
      EXPECT_GT(shown.difference(frames[before]), 0.02) << page << " and " << before + 1;
  }
  const int split = frames[0].width() - column_room;
  const auto in_view = [&](int page, const auto& matches) {
    return frames[page - 1].count(matches, 0, split, 0, frames[page - 1].height());
  };
  EXPECT_GT(in_view(1, is_rim), 1000U);
  EXPECT_EQ(in_view(2, is_rim), 0U);
  EXPECT_GE(in_view(3, is_over), 16U) << "the one far point";
  EXPECT_EQ(in_view(4, is_gouge), 0U);
  EXPECT_GT(in_view(5, is_bar), 2000U);
}

TEST_F(Viewer, TheListOfKeysGoesAndComes)
{
  SpiralViewer& viewer = shared();
  const auto words = [&](int low, int high) {
    const Frame shown = frame(viewer);
    return shown.count(isDark, shown.width() - column_room, shown.width(), low, high);
  };
  const std::size_t listed = words(95, 200);
  EXPECT_GT(listed, 500U);
  press(viewer, "h");
  EXPECT_EQ(words(95, 200), 0U);
  EXPECT_GT(words(60, 95), 50U) << "how to get it back";
  press(viewer, "h");
  EXPECT_EQ(words(95, 200), listed);
}

TEST_F(Viewer, KeysGoToTheWorstPlacesAndBack)
{
  VerificationScene with = scene();
  with.stock[1234] = -0.05f;
  with.removal_figures.gouge = {0.05, (*with.part.cloud)[1234].getVector3fMap().cast<double>(), 77};
  const auto opened = open(with);
  SpiralViewer& viewer = *opened;
  press(viewer, "3");
  const Frame whole = frame(viewer);
  press(viewer, "d");
  EXPECT_EQ(viewer.getChosenPoint(), with.deviation_figures.max.index);
  EXPECT_NE(viewer.getMessage().find("0.0200 mm"), std::string::npos) << viewer.getMessage();
  const Frame near = frame(viewer);
  const int middle_x = (near.width() - column_room) / 2, middle_y = near.height() / 2;
  EXPECT_GE(near.count(is_over, middle_x - 15, middle_x + 15, middle_y - 15, middle_y + 15), 10U);
  press(viewer, "g");
  EXPECT_EQ(viewer.getPage(), ViewerPage::Stock);
  EXPECT_EQ(viewer.getChosenPoint(), 77U);
  EXPECT_GE(frame(viewer).count(is_gouge, middle_x - 15, middle_x + 15, middle_y - 15, middle_y + 15), 10U);
  press(viewer, "s");
  EXPECT_NE(viewer.getMessage().find("scallop: 0.0100 mm"), std::string::npos) << viewer.getMessage();
  // unchanged except for the message and the chosen point
  press(viewer, "3");
  press(viewer, "r");
  EXPECT_LT(frame(viewer).difference(whole), 0.02);
  EXPECT_GT(near.difference(whole), 0.2);

  SpiralViewer& without = shared();
  press(without, "g");
  EXPECT_EQ(without.getMessage(), "there is no gouge");
}

TEST_F(Viewer, AClickChoosesThePointThatIsSeenThere)
{
  const VerificationScene with = scene();
  SpiralViewer& viewer = shared();
  press(viewer, "d"); // seen along the normal there, the worst point in the middle
  const std::size_t worst = with.deviation_figures.max.index;
  press(viewer, "Right");
  EXPECT_EQ(viewer.getChosenPoint(), worst + 1);
  press(viewer, "Up");
  EXPECT_EQ(viewer.getChosenPoint(), worst + 201);
  press(viewer, "Down");
  press(viewer, "Left");
  const Frame shown = frame(viewer);
  const int x = (shown.width() - column_room) / 2, y = shown.height() / 2;
  press(viewer, "Right");
  press(viewer, "Right");
  drag(viewer, x, y, x, y);
  EXPECT_EQ(viewer.getChosenPoint(), worst);
  press(viewer, "r");
  drag(viewer, 5, 5, 5, 5);
  EXPECT_EQ(viewer.getChosenPoint(), worst);
  EXPECT_NE(viewer.getMessage().find("no visible point of the path"), std::string::npos);
}

TEST_F(Viewer, ADragTurnsThePart)
{
  SpiralViewer& viewer = shared();
  press(viewer, "2");
  const Frame before = frame(viewer);
  const auto chosen = viewer.getChosenPoint();
  drag(viewer, 200, 300, 320, 360);
  EXPECT_GT(frame(viewer).difference(before), 0.03);
  EXPECT_EQ(viewer.getChosenPoint(), chosen) << "a drag is no click";
}

TEST_F(Viewer, TheCutterStandsAtTheChosenPoint)
{
  SpiralViewer& viewer = shared();
  press(viewer, "2");
  const std::size_t before = frame(viewer).count(isCutter);
  press(viewer, "c");
  EXPECT_TRUE(viewer.getChosenPoint());
  EXPECT_GT(frame(viewer).count(isCutter), before + 500);
  press(viewer, "c");
  EXPECT_EQ(frame(viewer).count(isCutter), before);
}

TEST_F(Viewer, EveryTurnIsMoreThanThoseThatStandApart)
{
  const auto opened = open(scene(20000, 600, 100));
  SpiralViewer& viewer = *opened;
  press(viewer, "2");
  const auto gray = [](const Pixel& p) { return std::abs(p[0] - p[2]) < 25 && p[0] > 100 && p[0] < 245; };
  const auto surface = [&] {
    const Frame shown = frame(viewer);
    return shown.count(gray, 0, shown.width() - column_room, 200, shown.height() - 200);
  };
  const std::size_t apart = surface();
  press(viewer, "t");
  EXPECT_LT(surface(), apart / 4) << "lines cover the surface";
  press(viewer, "t");
  EXPECT_EQ(surface(), apart);
}

TEST_F(Viewer, SavedViewsReplaceNothing)
{
  const ScratchFolder folder;
  SpiralViewer& viewer = shared();
  viewer.setPictureStem(folder.path("part"));
  press(viewer, "p");
  EXPECT_NE(viewer.getMessage().find("part_1.png"), std::string::npos);
  press(viewer, "3");
  press(viewer, "p");
  EXPECT_TRUE(std::filesystem::exists(folder.path("part_1.png")));
  EXPECT_TRUE(std::filesystem::exists(folder.path("part_2.png")));
  EXPECT_GT(std::filesystem::file_size(folder.path("part_2.png")), 20000U);
  viewer.setPictureStem(folder.path("nowhere/part"));
  press(viewer, "p");
  EXPECT_NE(viewer.getMessage().find("cannot be written"), std::string::npos) << viewer.getMessage();
}

TEST_F(Viewer, WithoutStockTheRemedyIsShown)
{
  VerificationScene with = scene();
  with.stock.clear();
  with.ridges.clear();
  with.part.settings.tool_radius = 0.0;
  const auto opened = open(with);
  SpiralViewer& viewer = *opened;
  viewer.setRemedy("give --tool-radius");
  for (const char* key : {"4", "5", "s", "g", "c"}) {
    press(viewer, key);
    const Frame shown = frame(viewer);
    EXPECT_GT(shown.count(isDark, 0, shown.width() - column_room, 280, 400), 200U) << key;
  }
}

TEST_F(Viewer, RunsOnWhenAnotherIsGone)
{
  SpiralViewer& viewer = shared();
  open(scene(1000, 3, 20)).reset();
  int asked = 0;
  viewer.setCloseRequest([&] { return ++asked == 3; });
  viewer.run();
  EXPECT_EQ(asked, 3);
}

TEST_F(Viewer, ClosesByKeyAndOnRequest)
{
  SpiralViewer& viewer = shared();
  int asked = 0;
  viewer.setCloseRequest([&] { return ++asked == 3; });
  viewer.run();
  EXPECT_EQ(asked, 3);
  viewer.setCloseRequest([&] {
    press(viewer, "q");
    return false;
  });
  viewer.run();
}

TEST(SpiralViewer, WithoutADisplayRefuses)
{
  const char* const before = std::getenv("DISPLAY");
  const std::string kept = before ? before : "";
  ::unsetenv("DISPLAY");
  EXPECT_THROW(SpiralViewer{scene(100, 3, 20)}, std::runtime_error);
  if (before)
    ::setenv("DISPLAY", kept.c_str(), 1);
}

} // namespace spiral_viewer_test
