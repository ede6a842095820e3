// SPDX-License-Identifier: BSD-3-Clause
// The part chosen in the window of a scan without a path: a lasso becomes a polygon file that contains the points inside it on the screen,
// as VTK projects them, and the point at the mouse gives its place in the file.
#include <pcl_spiral/io/polygon_reader.h>
#include <pcl_spiral/visualization/spiral_viewer.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <random>

namespace viewer_lasso_test {

using namespace pcl_spiral;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

const Vector3d origin(4000.0, 7000.0, 300.0); // metres
const Vector3d high(20.0, -30.0, 60.0);       // a point over all others, mm

/** A hilly scan of 20000 points over 200 by 160 mm, and one point high above. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
scan()
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int i = 0; i < 20000; ++i) {
    const double x = 100.0 * unit(random), y = 80.0 * unit(random);
    cloud->emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(10.0 * std::sin(0.05 * x) * std::cos(0.04 * y)));
  }
  const Eigen::Vector3f p = high.cast<float>();
  cloud->emplace_back(p.x(), p.y(), p.z());
  return cloud;
}

/** By the rule of odd crossings. */
bool
isInside(const std::vector<Vector2d>& polygon, const Vector2d& p)
{
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside;
}

double
sideDistance(const std::vector<Vector2d>& polygon, const Vector2d& p)
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], side = polygon[(i + 1) % polygon.size()] - a;
    least = std::min(least, (a + side * std::clamp((p - a).dot(side) / side.squaredNorm(), 0.0, 1.0) - p).norm());
  }
  return least;
}

class Lasso : public testing::Test {
protected:
  void SetUp() override
  {
    if (!displayFault().empty())
      GTEST_SKIP() << "no display here";
    VerificationScene scene;
    scene.part.title = "hills";
    scene.part.cloud = cloud_;
    scene.part.path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
    viewer_ = std::make_unique<SpiralViewer>(scene);
    viewer_->getInteractor()->GetRenderWindow()->SetSize(960, 720);
    viewer_->setPictureStem(folder_.path("hills"));
    viewer_->setFileCoordinates([](const Vector3d& place) { return Vector3d(place / 1000.0 + origin); });
    viewer_->setChoiceCallback([this](const PartSelection& part) {
      choice_ = part.place.empty() ? part.file + " " + std::to_string(part.points) : part.place;
      return choice_;
    });
    press("r");
  }

  void press(const std::string& key)
  {
    viewer_->getInteractor()->SetKeyEventInformation(0, 0, key[0], 1, key.c_str());
    viewer_->getInteractor()->InvokeEvent(vtkCommand::KeyPressEvent);
  }
  void mouse(unsigned long event, const Vector2d& pixel)
  {
    viewer_->getInteractor()->SetEventInformation(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
    viewer_->getInteractor()->InvokeEvent(event);
  }
  void drag(const std::vector<Vector2d>& pixels)
  {
    mouse(vtkCommand::LeftButtonPressEvent, pixels.front());
    for (std::size_t i = 1; i < pixels.size(); ++i)
      mouse(vtkCommand::MouseMoveEvent, pixels[i]);
    mouse(vtkCommand::LeftButtonReleaseEvent, pixels.back());
  }
  Vector2d onScreen(const Vector3d& place) const
  {
    vtkRenderer* const view = viewer_->getInteractor()->GetRenderWindow()->GetRenderers()->GetFirstRenderer();
    view->SetWorldPoint(place.x(), place.y(), place.z(), 1.0);
    view->WorldToDisplay();
    return {view->GetDisplayPoint()[0], view->GetDisplayPoint()[1]};
  }
  Prism polygon(const std::string& file) const
  {
    ReadOptions options;
    options.unit = LengthUnit::Metre;
    options.origin = origin;
    return readPolygon(folder_.path(file), options);
  }

  /** Draws a lasso in the present view; its file has the points that VTK shows inside it, and no others. */
  void expectRoundTrip(const std::string& file)
  {
    const std::vector<Vector2d> corners{{150, 200}, {400, 180}, {420, 500}, {300, 320}, {200, 520}}; // not convex
    press("l");
    drag(corners);
    ASSERT_TRUE(std::filesystem::exists(folder_.path(file))) << viewer_->getMessage();
    const Prism prism = polygon(file);
    int inside = 0, outside = 0;
    for (const pcl::PointXYZ& p : *cloud_) {
      const Vector3d place = p.getVector3fMap().cast<double>();
      const Vector2d pixel = onScreen(place);
      if (sideDistance(corners, pixel) < 1e-3)
        continue;
      const bool expected = isInside(corners, pixel);
      (expected ? inside : outside)++;
      ASSERT_EQ(prism.contains(place), expected) << pixel.transpose();
    }
    EXPECT_GT(inside, 1000);
    EXPECT_GT(outside, 1000);
    EXPECT_EQ(choice_, folder_.path(file) + " " + std::to_string(inside));
    EXPECT_EQ(choice_, viewer_->getMessage());
  }

  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud_ = scan();
  ScratchFolder folder_;
  std::string choice_;
  std::unique_ptr<SpiralViewer> viewer_;
};

} // namespace

TEST_F(Lasso, TheFileContainsThePointsInsideOnTheScreen)
{
  expectRoundTrip("hills_lasso_1.txt");
  const Vector2d before = onScreen(high);
  drag({{300, 300}, {330, 320}, {420, 380}});
  EXPECT_GT((onScreen(high) - before).norm(), 5.0) << "the view turns after the lasso";
  expectRoundTrip("hills_lasso_2.txt");
}

TEST_F(Lasso, SeenAlongZThePolygonStandsOnZ)
{
  press("z");
  expectRoundTrip("hills_lasso_1.txt");
  EXPECT_NEAR(std::abs(polygon("hills_lasso_1.txt").axis().z()), 1.0, 1e-12);
}

TEST_F(Lasso, ThePointAtTheMouseIsThePlaceInTheFile)
{
  const std::string place = "4000.02,6999.97,300.06";
  press("z");
  mouse(vtkCommand::MouseMoveEvent, onScreen(high));
  press("a");
  EXPECT_EQ(choice_, place);
  EXPECT_EQ(viewer_->getMessage(), place);
  choice_.clear();
  drag({onScreen(high), onScreen(high)});
  EXPECT_EQ(choice_, place) << "a click does the same without a path";
  ASSERT_TRUE(viewer_->getChosenPlace());
  EXPECT_LT((*viewer_->getChosenPlace() - high).norm(), 1e-4);
  choice_.clear();
  mouse(vtkCommand::MouseMoveEvent, {2, 2});
  press("a");
  EXPECT_EQ(choice_, "");
  EXPECT_NE(viewer_->getMessage().find("no point of the scan"), std::string::npos);
}

TEST_F(Lasso, ALassoThatCrossesItselfIsDrawnAgain)
{
  press("l");
  drag({{200, 200}, {400, 400}, {400, 200}, {200, 400}});
  EXPECT_NE(viewer_->getMessage().find("draw it again"), std::string::npos) << viewer_->getMessage();
  EXPECT_FALSE(std::filesystem::exists(folder_.path("hills_lasso_1.txt")));
  drag({{200, 200}, {400, 200}, {400, 400}});
  EXPECT_TRUE(std::filesystem::exists(folder_.path("hills_lasso_1.txt"))) << viewer_->getMessage();
}

TEST_F(Lasso, WithoutAPathItsKeysSaySo)
{
  for (const char* key : {"2", "3", "4", "5", "t", "d", "s", "g", "c", "Right", "Left", "Up", "Down"}) {
    press(key);
    EXPECT_NE(viewer_->getMessage().find("there is no path"), std::string::npos) << key;
    EXPECT_EQ(viewer_->getPage(), ViewerPage::Boundaries);
  }
}

} // namespace viewer_lasso_test
