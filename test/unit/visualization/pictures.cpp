// SPDX-License-Identifier: BSD-3-Clause
// Pictures: drawn if there is a display, otherwise refused with the remedy.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/visualization/pictures.h>

#include "support/picture_pixels.h"
#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <random>

namespace pictures_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

constexpr int lines_end = 1170; ///< column of pixels; the part and its axes are left of it

/** A paraboloid of radius 100 mm, its rim, twelve lines and a spiral that ends at an angle of the rim. */
struct Paraboloid {
  double depth = 40.0;
  int turns = 50;
  double end_angle = 0.0;

  Eigen::Vector3d place(double r, double angle) const { return {r * std::cos(angle), r * std::sin(angle), depth * (1.0 - 1e-4 * r * r)}; }
};

PictureScene
scene(const Paraboloid& part = {})
{
  PictureScene result;
  result.title = "paraboloid";
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  auto path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3d p = part.place(100.0 * std::sqrt(unit(random)), 2.0 * M_PI * unit(random));
    cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  }
  const int steps = 200 * part.turns;
  for (int i = 0; i <= steps; ++i) {
    const double turn = 0.005 * i;
    const Eigen::Vector3d p = part.place(100.0 * i / steps, 2.0 * M_PI * turn + part.end_angle);
    ToolpathPoint point;
    point.getVector3fMap() = p.cast<float>();
    point.getNormalVector3fMap() = Eigen::Vector3d(2e-4 * part.depth * p.x(), 2e-4 * part.depth * p.y(), 1.0).normalized().cast<float>();
    point.turn = static_cast<float>(turn);
    if (!path->empty())
      point.arc_length = path->back().arc_length + (point.getVector3fMap() - path->back().getVector3fMap()).norm();
    path->push_back(point);
  }
  BoundaryLoop rim;
  for (int i = 0; i < 200; ++i)
    rim.curve.push_back(part.place(100.0, 2.0 * M_PI * i / 200.0));
  result.report.loops.push_back(rim);
  for (int i = 0; i < 12; ++i)
    result.report.radial_lines.push_back({part.place(0.0, 0.0), part.place(50.0, M_PI * i / 6.0), part.place(100.0, M_PI * i / 6.0)});
  result.report.centre = part.place(0.0, 0.0);
  result.report.boundaries = 1;
  result.report.turns = static_cast<std::size_t>(part.turns);
  result.report.smallest_step_over = result.report.largest_step_over = 100.0 / part.turns;
  result.cloud = cloud;
  result.path = path;
  return result;
}

bool
isRed(const Pixel& p)
{
  return p[0] > 150 && p[1] < 70 && p[2] < 70;
}

bool
isGreen(const Pixel& p)
{
  return p[0] < 60 && p[1] > 150 && p[2] < 80;
}

} // namespace

TEST(Pictures, ShowSurfaceLinesAndSpiral)
{
  if (!displayProblem().empty()) {
    std::printf("no display here, so no picture is drawn; the error is tested instead\n");
    const ScratchFolder folder;
    EXPECT_THROW(SpiralPictures(scene()).writeSpiral(folder.path("a.png")), std::runtime_error);
    EXPECT_EQ(folder.count(), 0U);
    return;
  }
  const ScratchFolder folder;
  PictureScene with = scene();
  const SpiralPictures pictures(with);
  pictures.writeSpiral(folder.path("spiral.png"));
  pictures.writeLines(folder.path("lines.png"));
  for (const char* name : {"spiral.png", "lines.png"}) {
    const auto counts = colorsOf(folder.path(name));
    EXPECT_GT(counts.size(), 1000U) << name << " is shaded";
    EXPECT_GT(share(counts, isWhite), 0.30) << name;
    EXPECT_LT(share(counts, isWhite), 0.75) << name << ": the part fills its place";
  }
  // the rim is red: it is visible with the loops, and not without them
  const double rim = share(colorsOf(folder.path("lines.png")), isRed);
  with.report.loops.clear();
  SpiralPictures(with).writeLines(folder.path("bare.png"));
  EXPECT_GT(rim, 0.002);
  EXPECT_LT(share(colorsOf(folder.path("bare.png")), isRed), 0.5 * rim);
  EXPECT_THROW(pictures.writeLines(folder.path("nowhere/a.png")), FileError);
}

TEST(Pictures, DenseTurnsStandApartAndAreCountableEnlarged)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  for (const int turns : {50, 500, 1500}) {
    SpiralPictures(scene({40.0, turns})).writeSpiral(folder.path("spiral.png"));
    // across the part, through its middle: gray between the lines, and lines between the gray
    const auto image = readPicture(folder.path("spiral.png"));
    int gray = 0, lines = 0;
    bool on_gray = false;
    for (int x = 200; x < 1000; ++x) {
      const bool is_gray = isGray(at(image, x, 560));
      gray += is_gray;
      lines += on_gray && !is_gray;
      on_gray = is_gray;
    }
    EXPECT_GT(gray, 250) << turns << " turns: not a solid block";
    EXPECT_GT(lines, 60) << turns << " turns";
    // the start enlarged: sixteen pitches across, so eight lines from its middle to its edge
    int crossed = 0;
    on_gray = false;
    for (int x = 1395; x < 1575; ++x) {
      const bool is_gray = isGray(at(image, x, 615));
      crossed += on_gray && !is_gray;
      on_gray = is_gray;
    }
    EXPECT_NEAR(crossed, 7, 1) << turns << " turns: every one is there";
  }
}

TEST(Pictures, StartAndEndAreMarkedAndWhatThePartHidesIsARing)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  // pixels; smoothing removes 0.3 at each edge
  const double disc = M_PI * 7.7 * 7.7, ring = disc - M_PI * 4.8 * 4.8;
  const auto count = [](const std::map<Pixel, std::size_t>& counts, bool (*matches)(const Pixel&)) {
    double sum = 0.0;
    for (const auto& [pixel, n] : counts)
      sum += matches(pixel) ? static_cast<double>(n) : 0.0;
    return sum;
  };
  // steeper than the view: the far side of the rim is hidden
  for (const bool far : {false, true}) {
    SpiralPictures(scene({250.0, 60, far ? M_PI_2 : -M_PI_2})).writeSpiral(folder.path("spiral.png"));
    const auto main = colorsOf(folder.path("spiral.png"), 0, lines_end);
    EXPECT_NEAR(count(main, isRed), far ? ring : disc, 20.0);
    EXPECT_NEAR(count(main, isGreen), disc, 20.0);
    const auto side = colorsOf(folder.path("spiral.png"), lines_end); // of the legend and the enlarged view
    EXPECT_NEAR(count(side, isRed), far ? ring + disc : 2.0 * disc, 40.0);
    EXPECT_NEAR(count(side, isGreen), 2.0 * disc, 40.0);
  }
}

/** Bytes of the picture of the spiral under \p title. */
std::string
pictureTitled(const std::string& title)
{
  const ScratchFolder folder;
  PictureScene titled = scene();
  titled.title = title;
  SpiralPictures(titled).writeSpiral(folder.path("a.png"));
  return readText(folder.path("a.png"));
}

bool
isOrange(const Pixel& p)
{
  return p[0] > 190 && p[1] > 60 && p[1] < 110 && p[2] < 40;
}

TEST(Pictures, KeepOutsAreDrawnAtTheirPlace)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  const auto orange = [&](double half) { // pixels of a keep-out about the middle
    PictureScene drawn = scene();
    if (half > 0.0)
      drawn.keep_outs.emplace_back(
          std::vector<Eigen::Vector3d>{{-half, -half, 0.0}, {half, -half, 0.0}, {half, half, 0.0}, {-half, half, 0.0}},
          Eigen::Vector3d::UnitZ());
    const SpiralPictures pictures(drawn);
    pictures.writeLines(folder.path("lines.png"));
    pictures.writeSpiral(folder.path("spiral.png"));
    const auto count = [&](const std::string& name) {
      std::size_t sum = 0;
      for (const auto& [pixel, n] : colorsOf(folder.path(name), 0, lines_end))
        sum += isOrange(pixel) ? n : 0;
      return static_cast<double>(sum);
    };
    return std::array<double, 2>{count("lines.png"), count("spiral.png")};
  };
  const auto none = orange(0.0), small = orange(20.0), large = orange(40.0);
  for (const int picture : {0, 1}) {
    EXPECT_LT(none[picture], 20.0);
    EXPECT_GT(small[picture], 1000.0);
    EXPECT_NEAR(large[picture] / small[picture], 2.0, 0.15) << "twice as long";
  }
}

TEST(Pictures, AreTheSameEveryTime)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const std::string bytes = pictureTitled("paraboloid");
  EXPECT_GT(bytes.size(), 10000U);
  EXPECT_TRUE(bytes == pictureTitled("paraboloid"));
}

TEST(Pictures, ATitleThatIsNoTextIsDrawnWithSignsInPlaceOfItsBytes)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const std::string bytes = pictureTitled("sc\xFF\xC3\x01n");
  EXPECT_TRUE(bytes == pictureTitled("sc???n"));
  EXPECT_FALSE(bytes == pictureTitled("scn"));
}

TEST(Pictures, WithoutADisplayTheRemedyIsNamed)
{
  const char* const before = std::getenv("DISPLAY");
  const std::string kept = before ? before : "";
  ::unsetenv("DISPLAY");
  EXPECT_NE(displayProblem().find("xvfb-run -a"), std::string::npos) << displayProblem();
  if (before)
    ::setenv("DISPLAY", kept.c_str(), 1);
}

} // namespace pictures_test
