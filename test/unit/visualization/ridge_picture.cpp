// SPDX-License-Identifier: BSD-3-Clause
// The picture of the lines of a ridge: lines and frames at their places, text inside the sheet.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/visualization/pictures.h>
#include <pcl_spiral/visualization/ridge_picture.h>

#include "support/ridge_scenes.h"
#include "support/scratch_folder.h"
#include "visualization/canvas.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include <Eigen/Dense>

#include <cmath>
#include <cstdlib>

namespace ridge_picture_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr int inset_left = Canvas::words_left, inset_low = 50, inset_high = 350; ///< of the lower enlarged view, without its text

bool
isRailColor(const Pixel& p)
{
  return p[0] > 220 && p[1] > 90 && p[1] < 140 && p[2] < 40;
}
bool
isGeneratorColor(const Pixel& p)
{
  return p[0] > 160 && p[0] < 220 && p[1] < 60 && p[2] > 150;
}
bool
isRed(const Pixel& p)
{
  return p[0] > 190 && p[1] < 50 && p[2] < 50;
}
bool
isGreen(const Pixel& p)
{
  return p[0] < 40 && p[1] > 130 && p[2] < 70;
}
bool
isBlue(const Pixel& p)
{
  return p[0] < 60 && p[1] < 90 && p[2] > 200;
}

/** Direction of an arrow in degrees, from 0 to 180: the main direction of the pixels of its colour in the lower enlarged view. */
double
directionOf(vtkImageData* image, const Matches& matches)
{
  std::vector<Vector2d> places;
  Vector2d middle = Vector2d::Zero();
  for (int y = inset_low; y < inset_high; ++y)
    for (int x = inset_left; x < inset_left + Canvas::inset_size; ++x)
      if (matches(at(image, x, y))) {
        places.emplace_back(x, y);
        middle += places.back();
      }
  EXPECT_GT(places.size(), 100u);
  middle /= static_cast<double>(places.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vector2d& p : places)
    spread += (p - middle) * (p - middle).transpose();
  const Vector2d along = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1);
  const double angle = std::atan2(along.y(), along.x()) / degree;
  return angle < 0.0 ? angle + 180.0 : angle;
}

} // namespace

TEST(RidgePicture, ShowsLinesAndFrames)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  for (const RidgeScene& scene : {dieScene(), ringScene(), helixScene()}) {
    writeRidgeLines(folder.path("a.png"), scene);
    const auto counts = colorsOf(folder.path("a.png"), 0, part_end);
    for (const auto& [matches, least] :
         {std::make_pair(isRailColor, 400u), {isGeneratorColor, 60u}, {isRed, 300u}, {isGreen, 300u}, {isBlue, 300u}})
      EXPECT_GT(countOf(counts, matches), least);
    EXPECT_GT(share(counts, isGray), 0.015) << "the ridge";
    EXPECT_GT(counts.size(), 1000u) << "is shaded";
    expectWordsInside(folder.path("a.png"));
  }
}

TEST(RidgePicture, TheEnlargedGeneratorHasItsAngle)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  writeRidgeLines(folder.path("a.png"), ringScene());
  auto image = readPicture(folder.path("a.png"));
  EXPECT_NEAR(directionOf(image, isGreen), 20.0, 1.0) << "the chord on a level rail: theta";
  EXPECT_NEAR(directionOf(image, isBlue), 110.0, 1.0);
  writeRidgeLines(folder.path("b.png"), helixScene());
  image = readPicture(folder.path("b.png"));
  const double psi = std::asin(std::sin(-15.0 * degree) / std::cos(20.0 * degree)) / degree;
  EXPECT_NEAR(directionOf(image, isGeneratorColor), 180.0 + psi, 1.0) << "points on a straight generator";
  EXPECT_NEAR(directionOf(image, isBlue), 90.0 + psi, 1.0);
}

TEST(RidgePicture, AScanIsDrawnBehindTheLines)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  RidgeScene scene = ringScene();
  const auto is_scan = [](const Pixel& p) { return p[2] - p[0] > 40 && p[2] - p[0] < 80 && p[2] > 190; };
  writeRidgeLines(folder.path("a.png"), scene);
  EXPECT_LT(countOf(colorsOf(folder.path("a.png"), 0, part_end), is_scan), 3000u);
  const auto scan = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (double u = 0.0; u < scene.ridge->rail().length(); u += 1.0)
    for (double v = 0.0; v < scene.ridge->generator().length(); v += 1.0) {
      const Vector3d p = scene.ridge->position(u, v) + 0.02 * scene.ridge->normal(u, v);
      scan->push_back(pcl::PointXYZ(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())));
    }
  scan->push_back(pcl::PointXYZ(NAN, NAN, NAN));
  scene.scan = scan;
  writeRidgeLines(folder.path("b.png"), scene);
  const auto counts = colorsOf(folder.path("b.png"), 0, part_end);
  EXPECT_GT(countOf(counts, is_scan), 10000u);
  EXPECT_GT(countOf(counts, isGeneratorColor), 60u);
}

TEST(RidgePicture, WordsOfLongFiguresStayInsideTheSheet)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  const auto stretched = [](Polyline points) {
    for (Vector3d& p : points)
      p *= 11.11;
    return points;
  };
  const ExactRidge exact = dieRidge();
  RidgeScene scene = sceneOf(stretched(moved(exact.railPoints(300), 0.2, 1)), stretched(moved(exact.generatorPoints(0.37, 60), 0.2, 2)));
  scene.scan = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(1000000, 1, pcl::PointXYZ(3000.0f, 100.0f, 100.0f));
  writeRidgeLines(folder.path("a.png"), scene);
  expectWordsInside(folder.path("a.png"));
  writeRidgeNormals(folder.path("b.png"), scene);
  expectWordsInside(folder.path("b.png"));
}

TEST(RidgePicture, TheSameSceneGivesTheSameBytes)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  for (const auto write : {writeRidgeLines, writeRidgeNormals}) {
    write(folder.path("a.png"), dieScene());
    write(folder.path("b.png"), dieScene());
    EXPECT_EQ(readText(folder.path("a.png")), readText(folder.path("b.png")));
  }
}

TEST(RidgePicture, WhatCannotBeDrawnIsRefused)
{
  const RidgeScene scene = ringScene();
  for (const auto write : {writeRidgeLines, writeRidgeNormals})
    EXPECT_THROW(write("a.png", RidgeScene()), std::invalid_argument);
  RidgeScene bare = scene;
  bare.rail.clear();
  EXPECT_THROW(writeRidgeLines("a.png", bare), std::invalid_argument);
  const char* const display = std::getenv("DISPLAY");
  const std::string kept = display ? display : "";
  ::unsetenv("DISPLAY");
  for (const auto write : {writeRidgeLines, writeRidgeNormals})
    EXPECT_THROW(write("a.png", scene), std::runtime_error);
  if (!display)
    GTEST_SKIP() << "no display here";
  ::setenv("DISPLAY", kept.c_str(), 1);
  for (const auto write : {writeRidgeLines, writeRidgeNormals})
    EXPECT_THROW(write("nowhere/a.png", scene), FileError);
}

} // namespace ridge_picture_test
