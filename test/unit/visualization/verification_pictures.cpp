// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a verification: planted faults are visible at their places, and nowhere else.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/visualization/verification_pictures.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>

namespace verification_pictures_test {

using namespace pcl_spiral;

namespace {

constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
constexpr double radius = 100.0, height = 20.0;
constexpr int map_end = 1170; ///< column of pixels; the part and its axes are left of it

/** A paraboloid of radius 100 mm. */
Eigen::Vector3d
place(double r, double angle)
{
  return {r * std::cos(angle), r * std::sin(angle), height * (1.0 - r * r / (radius * radius))};
}

/** Position of a place: seen from 35 degrees off +z towards -y; the width of the part's box fills 886 pixels,
 * round column 595 and row 580. */
Eigen::Vector2d
pixel(const Eigen::Vector3d& p)
{
  const double tilt = 35.0 * M_PI / 180.0, scale = 886.0 / (2.0 * radius);
  return {595.0 + scale * p.x(), 580.0 + scale * (std::cos(tilt) * p.y() + std::sin(tilt) * (p.z() - 0.5 * height))};
}

/** A part cut well: deviations within a micrometre, ridges of 9 to 10 um. */
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
    ToolpathPoint point;
    point.getVector3fMap() = p.cast<float>();
    point.getNormalVector3fMap() = Eigen::Vector3d(2.0 * height * p.x(), 2.0 * height * p.y(), radius * radius).normalized().cast<float>();
    point.turn = static_cast<float>(i) / static_cast<float>(steps_a_turn);
    if (!path->empty())
      point.arc_length = path->back().arc_length + (point.getVector3fMap() - path->back().getVector3fMap()).norm();
    path->push_back(point);
    result.deviation.push_back(0.001f * static_cast<float>(std::sin(0.03 * i)));
  }
  BoundaryLoop rim;
  for (int i = 0; i < 200; ++i)
    rim.points.push_back(place(radius, 2.0 * M_PI * i / 200.0));
  result.part.report.loops.push_back(rim);
  result.part.cloud = cloud;
  result.part.path = path;
  result.deviation_figures.p99 = 0.001;
  result.deviation_figures.max.value = 0.001;
  result.removal_figures.limit = 0.0152;
  result.removal_figures.reach = 0.2;
  result.removal_figures.scallop.max.value = 0.01;
  result.removal_figures.scallop.max.position = place(0.0, 0.0);
  return result;
}

std::size_t
nearest(const VerificationScene& scene, const Eigen::Vector3d& p)
{
  std::size_t best = 0;
  for (std::size_t i = 0; i < scene.part.cloud->size(); ++i) {
    const auto off = [&](std::size_t k) { return ((*scene.part.cloud)[k].getVector3fMap().cast<double>() - p).norm(); };
    best = off(i) < off(best) ? i : best;
  }
  return best;
}

using Pixel = std::array<int, 3>;
using Matches = std::function<bool(const Pixel&)>;

/** Pixels of a colour in some columns of a picture: their number, and their middle from the lower left corner. */
struct Found {
  std::size_t count = 0;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
};

Found
find(const std::string& file, const Matches& matches, int first = 0, int last = map_end)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* const image = reader->GetOutput();
  int size[3];
  image->GetDimensions(size);
  EXPECT_EQ(size[0], 1600);
  EXPECT_EQ(size[1], 1200);
  Found found;
  for (int y = 0; y < size[1]; ++y)
    for (int x = first; x < std::min(last, size[0]); ++x) {
      const auto* const p = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
      if (!matches({p[0], p[1], p[2]}))
        continue;
      ++found.count;
      found.middle += Eigen::Vector2d(x + 0.5, y + 0.5);
    }
  if (found.count > 0)
    found.middle /= static_cast<double>(found.count);
  return found;
}

Matches
like(double r, double g, double b)
{
  return [=](const Pixel& p) { return std::abs(p[0] - 255 * r) < 6 && std::abs(p[1] - 255 * g) < 6 && std::abs(p[2] - 255 * b) < 6; };
}

const Matches is_gouge = like(0.84, 0.04, 0.07), is_uncut = like(0.93, 0.16, 0.88), is_above = like(1.0, 0.55, 0.0),
              is_over = like(0.85, 0.0, 0.75), is_under = like(0.0, 0.40, 0.20), is_white = like(1.0, 1.0, 1.0);

std::string
bytes(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

class VerificationPicture : public testing::Test {
protected:
  void SetUp() override
  {
    if (!displayProblem().empty())
      GTEST_SKIP() << "no display here";
  }
  ScratchFolder folder;
  const std::string file = folder.path("a.png");
};

} // namespace

TEST_F(VerificationPicture, FarPathPointsAreSeenWhereTheyAre)
{
  VerificationScene with = scene();
  VerificationPictures(with).writeDeviation(file);
  EXPECT_EQ(find(file, is_over).count, 0U);
  EXPECT_EQ(find(file, is_under).count, 0U);
  EXPECT_LT(find(file, is_white, 0, 1600).count, 1600U * 1200U * 3 / 4);
  const std::size_t out = 6030, in = 9145;
  with.deviation[out] = 0.02f;
  with.deviation[in] = -0.02f;
  with.deviation_figures.max = {0.02, (*with.part.path)[out].getVector3fMap().cast<double>(), out};
  VerificationPictures(with).writeDeviation(file);
  for (const auto& [index, matches] : {std::pair(out, is_over), std::pair(in, is_under)}) {
    const Found found = find(file, matches);
    EXPECT_GE(found.count, 16U);
    EXPECT_LE(found.count, 200U);
    const Eigen::Vector2d at = pixel((*with.part.path)[index].getVector3fMap().cast<double>());
    EXPECT_LT((found.middle - at).norm(), 2.5) << found.middle.transpose() << " for " << at.transpose();
  }
  EXPECT_GT(find(file, is_over, 1170, 1600).count, 200U) << "in the legend and enlarged";
}

TEST_F(VerificationPicture, MovesThatCrossACloseUpAreDrawn)
{
  // Four chords per turn: their middles are visible in the enlarged view, their ends are 60 mm away.
  VerificationScene with = scene(20000, 60, 4);
  with.removal_figures.scallop.max.position = place(60.0, M_PI / 4.0);
  VerificationPictures(with).writeStock(file);
  EXPECT_GT(find(file, like(0.05, 0.05, 0.08), map_end, 1600).count, 1500U) << "several lines of 380 pixels";
}

TEST_F(VerificationPicture, GougesAndUncutPlacesAreSeenWhereTheyAre)
{
  VerificationScene with = scene();
  VerificationPictures(with).writeStock(file);
  for (const Matches& matches : {is_gouge, is_uncut, is_above})
    EXPECT_EQ(find(file, matches).count, 0U);
  const std::size_t gouge = nearest(with, place(60.0, 0.5)), uncut = nearest(with, place(70.0, 3.6)),
                    high = nearest(with, place(50.0, 5.0));
  with.stock[gouge] = -0.012f;
  with.stock[uncut] = 0.2f;
  with.ridges[uncut] = nothing;
  with.ridges[high] = 0.03f;
  VerificationPictures(with).writeStock(file);
  for (const auto& [index, matches] : {std::pair(gouge, is_gouge), {uncut, is_uncut}, {high, is_above}}) {
    const Found found = find(file, matches);
    EXPECT_GE(found.count, 16U);
    EXPECT_LE(found.count, 200U);
    const Eigen::Vector2d at = pixel((*with.part.cloud)[index].getVector3fMap().cast<double>());
    EXPECT_LT((found.middle - at).norm(), 2.5) << found.middle.transpose() << " for " << at.transpose();
  }
}

TEST_F(VerificationPicture, AGougeAmongManyPointsStaysVisible)
{
  VerificationScene with = scene(200000, 500, 1000);
  with.stock[100000] = -0.02f;
  with.deviation[250000] = 0.02f;
  const VerificationPictures pictures(with);
  pictures.writeStock(file);
  pictures.writeDeviation(folder.path("b.png"));
  pictures.writeHistogram(folder.path("c.png"));
  EXPECT_GE(find(file, is_gouge).count, 16U);
  EXPECT_GE(find(folder.path("b.png"), is_over).count, 16U);
}

TEST_F(VerificationPicture, TheHistogramShowsHowManyAndTheLimit)
{
  VerificationScene with = scene();
  VerificationPictures(with).writeHistogram(file);
  const Matches is_bar = like(0.128, 0.567, 0.551), is_limit = like(0.84, 0.04, 0.07), is_asked = like(0.10, 0.22, 0.66);
  const Found bars = find(file, is_bar), limit = find(file, is_limit), asked = find(file, is_asked);
  EXPECT_EQ(find(file, is_above).count, 0U);
  EXPECT_GT(bars.count, 2000U);
  EXPECT_GT(limit.count, 800U);
  // the lines are in proportion: zero is at column 130
  EXPECT_NEAR((asked.middle.x() - 130.0) / (limit.middle.x() - 130.0), 0.01 / 0.0152, 0.005);
  EXPECT_NEAR((bars.middle.x() - 130.0) / (limit.middle.x() - 130.0), 0.0095 / 0.0152, 0.04);
  with.ridges[77] = 0.03f; // one in twenty thousand
  VerificationPictures(with).writeHistogram(file);
  EXPECT_GT(find(file, is_above).count, 200U);
}

TEST_F(VerificationPicture, TheSameSceneGivesTheSameBytes)
{
  const std::string again = folder.path("b.png");
  for (const auto write :
       {&VerificationPictures::writeDeviation, &VerificationPictures::writeStock, &VerificationPictures::writeHistogram}) {
    (VerificationPictures(scene()).*write)(file);
    (VerificationPictures(scene()).*write)(again);
    EXPECT_GT(bytes(file).size(), 10000U);
    EXPECT_TRUE(bytes(file) == bytes(again));
  }
}

TEST_F(VerificationPicture, AFileThatCannotBeWrittenIsNamed)
{
  EXPECT_THROW(VerificationPictures(scene()).writeStock(folder.path("nowhere/a.png")), FileError);
}

TEST(VerificationPictures, RefuseValuesThatAreNotOneAPoint)
{
  VerificationScene with = scene();
  with.stock.pop_back();
  EXPECT_THROW(VerificationPictures{with}, std::invalid_argument);
  with = scene();
  with.deviation.push_back(0.0f);
  EXPECT_THROW(VerificationPictures{with}, std::invalid_argument);
  with = scene();
  with.part.path.reset();
  EXPECT_THROW(VerificationPictures{with}, std::invalid_argument);
  with = scene();
  with.stock.clear();
  with.ridges.clear();
  EXPECT_THROW(VerificationPictures(with).writeStock("a.png"), std::logic_error);
  EXPECT_THROW(VerificationPictures(with).writeHistogram("a.png"), std::logic_error);
}

} // namespace verification_pictures_test
