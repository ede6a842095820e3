// SPDX-License-Identifier: BSD-3-Clause
// Text of pictures is inside its view, for figures and names of any length.
#include <pcl_spiral/visualization/pass_picture.h>
#include <pcl_spiral/visualization/pictures.h>
#include <pcl_spiral/visualization/ridge_picture.h>
#include <pcl_spiral/visualization/verification_pictures.h>

#include "support/drawn_texts.h"
#include "support/ridge_scenes.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace picture_words_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

constexpr double radius = 123.4567;

/** Place of a part, and length of its figures and its name. */
struct Kind {
  Vector3d origin = Vector3d::Zero();
  double unit = 1.0; ///< of heights, mm
  std::string title = "part.csv";
};

const std::string long_name = std::string("first_") + std::string(240, 'w') + "_last.csv";
const Kind short_words, long_words{{-393775.0, 368907.0, 12345.0}, 1.23456e-4, long_name},
    large_values{Vector3d::Zero(), 123.456, "part.csv"};

/** On a bowl: faults of every kind, and the largest of them where the part hides them. */
VerificationScene
judgedScene(const Kind& kind)
{
  VerificationScene scene;
  scene.part.title = kind.title;
  scene.part.settings.tool_radius = 12.3456;
  scene.part.settings.scallop_height = 1.23456 * kind.unit;
  scene.part.settings.chord_error = 0.123456 * kind.unit;
  const auto place = [&kind](double r, double angle) -> Vector3d {
    return kind.origin + Vector3d(r * std::cos(angle), r * std::sin(angle), 2.0 * radius * (1.0 - r * r / (radius * radius)));
  };
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  std::mt19937 random(5);
  std::normal_distribution<float> height(1.0f, 0.8f);
  for (int i = 0; i < 8000; ++i) { // a sunflower
    const Eigen::Vector3f p = place(radius * std::sqrt((i + 0.5) / 8000), 2.39996322972865 * i).cast<float>();
    cloud->emplace_back(p.x(), p.y(), p.z());
    scene.stock.push_back(static_cast<float>(kind.unit) * height(random));
    scene.ridges.push_back(static_cast<float>(kind.unit) * height(random));
  }
  scene.stock[5] = static_cast<float>(98.7 * kind.unit);
  const auto path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  for (int i = 0; i <= 12000; ++i) {
    ToolpathPoint point;
    point.getVector3fMap() = place(radius * i / 12000, 0.01 * M_PI * i).cast<float>();
    point.normal_z = 1.0f;
    point.turn = static_cast<float>(i) / 200.0f;
    point.arc_length = 0.1234567f * static_cast<float>(i);
    point.over_gap = i % 500 < 20;
    path->push_back(point);
    scene.deviation.push_back(i % 1000 == 7 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(kind.unit) * height(random));
  }
  scene.part.cloud = cloud;
  scene.part.path = path;
  const Vector3d behind = place(0.9 * radius, M_PI_2);
  scene.deviation_figures.p99 = scene.deviation_figures.rms = 0.5 * kind.unit;
  scene.deviation_figures.max = {3.21 * kind.unit, behind, 11000};
  scene.deviation_figures.beyond_rim = 123456;
  scene.deviation_figures.rim_max = {-43.21 * kind.unit, behind, 11001};
  scene.deviation_figures.in_gaps = 480;
  scene.deviation_figures.gap_max = {54.32 * kind.unit, behind, 11002};
  scene.deviation_figures.fit_noise = scene.removal_figures.fit_noise = 0.00123 * kind.unit;
  scene.removal_figures.limit = 1.36 * kind.unit;
  scene.removal_figures.reach = 98.7 * kind.unit;
  scene.removal_figures.gouge = {3.21 * kind.unit, behind, 11000};
  scene.removal_figures.stock.uncut = 1;
  scene.removal_figures.stock.first_uncut = {98.7 * kind.unit, behind, 5};
  scene.removal_figures.scallop.max = {4.32 * kind.unit, behind, 5};
  return scene;
}

/** The same part with loops of every kind, many lines and many loops. */
PictureScene
plannedScene(const Kind& kind, bool loops)
{
  PictureScene scene = judgedScene(kind).part;
  SpiralReport& report = scene.report;
  for (const LoopType type : {LoopType::Outer, LoopType::Inner, LoopType::Inner, LoopType::ScanGap, LoopType::ScanGap}) {
    BoundaryLoop loop;
    loop.type = type;
    for (int i = 0; i < 100; ++i)
      loop.curve.push_back(kind.origin + 99.0 * radius * Vector3d(std::cos(0.0628 * i), std::sin(0.0628 * i), 0.0));
    report.loops.push_back(loop);
  }
  const Polyline line{kind.origin, kind.origin + Vector3d(radius, 0.0, 0.0)};
  (loops ? report.scallop_lines : report.radial_lines).assign(123456, line);
  report.finger_axes.assign(12345, line);
  report.boundaries = 1;
  report.centre = kind.origin + Vector3d(0.0, 0.0, -radius);
  report.turns = 1234567;
  report.used_points = 123456789;
  report.spacing = report.noise = 1.23456e-4;
  report.path_length = 1.23456789e9;
  report.smallest_step_over = 1.23456e-4;
  report.largest_step_over = 1.34567;
  return scene;
}

PassScene
passScene(const Kind& kind)
{
  const PictureScene part = plannedScene(kind, false);
  PassScene scene;
  scene.title = kind.title;
  scene.cloud = part.cloud;
  scene.path = part.path;
  scene.cutter = CutterShape::taperedBullNose(12.3456, 1.23456, 20.0, 7.65432);
  scene.step_over = 1.23456 * kind.unit;
  return scene;
}

MachineProgram
program(const Kind& kind)
{
  MachineProgram result;
  result.machine = xyzacTrunnion();
  result.machine.name = kind.title;
  for (int i = 0; i < 200; ++i) {
    ProgramBlock block;
    block.angles = {1e6 / kind.unit * i, 0.01 * kind.unit * i};
    block.arc_length = 1e5 * i;
    block.minutes = kind.unit;
    result.blocks.push_back(block);
  }
  result.report.poles.emplace_back();
  result.report.poles.back().end = 2e6;
  result.report.poles.back().largest_change = 1.23456e-4;
  result.report.unwound_at.assign(123456, 1.5e7);
  result.report.first_travel = 1.2345e9;
  result.report.largest_turn = 1.23456e-4;
  return result;
}

RidgeScene
ridgeScene(const Kind& kind)
{
  const auto moved_out = [&kind](Polyline points) {
    for (Vector3d& p : points)
      p = 11.11 * p + kind.origin;
    return points;
  };
  const ExactRidge exact = dieRidge();
  RidgeScene scene = sceneOf(moved_out(moved(exact.railPoints(300), 0.2, 1)), moved_out(moved(exact.generatorPoints(0.37, 60), 0.2, 2)));
  scene.title = kind.title;
  const Vector3d place = scene.rail[150];
  scene.scan = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(
      1000000, 1, pcl::PointXYZ(static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z())));
  return scene;
}

/** Every text of a picture is whole, and large enough to be read. */
template <typename Write>
void
expectWordsInside(const std::string& picture, const Write& write)
{
  SCOPED_TRACE(picture);
  const ScratchFolder folder;
  const std::vector<DrawnText> texts = NotedTexts::during([&] { write(folder.path("a.png")); });
  EXPECT_GE(texts.size(), 8U);
  for (const DrawnText& text : texts) {
    EXPECT_TRUE(text.view.contains(text.box)) << "'" << text.words << "' from " << text.box.min().transpose() << " to "
                                              << text.box.max().transpose() << " in " << text.view.sizes().transpose();
    EXPECT_GE(text.font_size, 12) << text.words;
  }
}

class PictureWords : public testing::TestWithParam<const Kind*> {
protected:
  void SetUp() override
  {
    if (!displayProblem().empty())
      GTEST_SKIP() << "no display here";
  }
  const Kind& kind = *GetParam();
};

} // namespace

TEST_P(PictureWords, OfTheSpiralAreInside)
{
  const SpiralPictures pictures(plannedScene(kind, false)), loops(plannedScene(kind, true));
  expectWordsInside("spiral", [&](const std::string& file) { pictures.writeSpiral(file); });
  expectWordsInside("lines", [&](const std::string& file) { pictures.writeLines(file); });
  expectWordsInside("loops", [&](const std::string& file) { loops.writeLines(file); });
}

TEST_P(PictureWords, OfTheVerificationAreInside)
{
  const VerificationPictures pictures(judgedScene(kind));
  expectWordsInside("deviation", [&](const std::string& file) { pictures.writeDeviation(file); });
  expectWordsInside("stock", [&](const std::string& file) { pictures.writeStock(file); });
  expectWordsInside("histogram", [&](const std::string& file) { pictures.writeHistogram(file); });
}

TEST_P(PictureWords, OfAHistogramWhoseLimitIsFarAreInside)
{
  VerificationScene scene = judgedScene(kind);
  scene.part.settings.scallop_height = 0.01 * scene.removal_figures.limit;
  const VerificationPictures pictures(scene);
  expectWordsInside("histogram", [&](const std::string& file) { pictures.writeHistogram(file); });
}

TEST_P(PictureWords, OfPassesAndTheirMachineAreInside)
{
  expectWordsInside("passes", [&](const std::string& file) { writePasses(file, passScene(kind)); });
  expectWordsInside("rotary axes", [&](const std::string& file) { writeRotaryAngles(file, kind.title, program(kind)); });
}

TEST_P(PictureWords, OfARidgeAreInside)
{
  expectWordsInside("lines", [&](const std::string& file) { writeRidgeLines(file, ridgeScene(kind)); });
  expectWordsInside("normals", [&](const std::string& file) { writeRidgeNormals(file, ridgeScene(kind)); });
}

INSTANTIATE_TEST_SUITE_P(, PictureWords, testing::Values(&short_words, &long_words, &large_values));

TEST(PictureTitle, KeepsBothEndsOfALongName)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  const VerificationPictures pictures(judgedScene(long_words));
  const auto texts = NotedTexts::during([&] { pictures.writeStock(folder.path("a.png")); });
  const auto is_title = [](const DrawnText& text) { return text.words.rfind("first_www", 0) == 0; };
  const auto title = std::find_if(texts.begin(), texts.end(), is_title);
  ASSERT_NE(title, texts.end());
  EXPECT_NE(title->words.find("www..."), std::string::npos) << title->words;
  EXPECT_NE(title->words.find("_last.csv: stock left on the scan"), std::string::npos) << title->words;
}

TEST(DeviationLegend, SaysWhichPointsTheLargestIsOf)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  VerificationScene scene = judgedScene(short_words);
  const auto drawn = [&folder](const VerificationScene& shown) {
    std::string words;
    for (const DrawnText& text : NotedTexts::during([&] { VerificationPictures(shown).writeDeviation(folder.path("a.png")); }))
      words += text.words + "\n";
    return words;
  };
  const std::string words = drawn(scene);
  for (const char* part :
       {"largest of the judged points, +3.21000 mm", "beyond the rim: up to -43.2 mm, not judged", "over gaps: up to +54.3 mm, not judged"})
    EXPECT_NE(words.find(part), std::string::npos) << part << " in\n" << words;
  scene.deviation_figures.rim_max.value = -3.2; // below the largest: no contradiction, no entry
  EXPECT_EQ(drawn(scene).find("beyond the rim"), std::string::npos);
}

} // namespace picture_words_test
