// Pictures: drawn where there is a display, refused with the remedy where there is none.
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/visualization/pictures.h>

#include "support/scratch_folder.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <random>

using namespace pcl_spiral;

namespace {

/** A paraboloid of radius 100 mm, its rim, twelve lines and a spiral of 50 turns. */
PictureScene
scene()
{
  const auto place = [](double r, double angle) {
    return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), 40.0 - 0.004 * r * r);
  };
  PictureScene result;
  result.title = "paraboloid";
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  auto path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3d p = place(100.0 * std::sqrt(unit(random)), 2.0 * M_PI * unit(random));
    cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  }
  for (int i = 0; i <= 10000; ++i) {
    const double turn = 0.005 * i;
    const Eigen::Vector3d p = place(2.0 * turn, 2.0 * M_PI * turn);
    ToolpathPoint point;
    point.getVector3fMap() = p.cast<float>();
    point.getNormalVector3fMap() =
        Eigen::Vector3d(0.008 * p.x(), 0.008 * p.y(), 1.0).normalized().cast<float>();
    point.turn = static_cast<float>(turn);
    if (!path->empty())
      point.arc_length =
          path->back().arc_length + (point.getVector3fMap() - path->back().getVector3fMap()).norm();
    path->push_back(point);
  }
  BoundaryLoop rim;
  for (int i = 0; i < 200; ++i)
    rim.curve.push_back(place(100.0, 2.0 * M_PI * i / 200.0));
  result.report.loops.push_back(rim);
  for (int i = 0; i < 12; ++i)
    result.report.radial_lines.push_back(
        {place(0.0, 0.0), place(50.0, M_PI * i / 6.0), place(100.0, M_PI * i / 6.0)});
  result.report.centre = place(0.0, 0.0);
  result.report.boundaries = 1;
  result.report.turns = 50;
  result.report.smallest_step_over = result.report.largest_step_over = 2.0;
  result.cloud = cloud;
  result.path = path;
  return result;
}

using Pixel = std::array<int, 3>;

/** How often each colour occurs in a picture. */
std::map<Pixel, std::size_t>
colors(const std::string& file)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* const image = reader->GetOutput();
  int size[3];
  image->GetDimensions(size);
  EXPECT_EQ(size[0], 1600);
  EXPECT_EQ(size[1], 1200);
  std::map<Pixel, std::size_t> counts;
  for (int y = 0; y < size[1]; ++y)
    for (int x = 0; x < size[0]; ++x) {
      const auto* const at = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
      ++counts[{at[0], at[1], at[2]}];
    }
  return counts;
}

template <typename Matches>
double
share(const std::map<Pixel, std::size_t>& counts, Matches matches)
{
  double all = 0.0, matching = 0.0;
  for (const auto& [pixel, count] : counts) {
    all += static_cast<double>(count);
    matching += matches(pixel) ? static_cast<double>(count) : 0.0;
  }
  return matching / all;
}

bool
isWhite(const Pixel& p)
{
  return p[0] == 255 && p[1] == 255 && p[2] == 255;
}

bool
isRed(const Pixel& p)
{
  return p[0] > 150 && p[1] < 70 && p[2] < 70;
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
    const auto counts = colors(folder.path(name));
    EXPECT_GT(counts.size(), 1000U) << name << " is shaded";
    EXPECT_GT(share(counts, isWhite), 0.30) << name;
    EXPECT_LT(share(counts, isWhite), 0.75) << name << ": the part fills its place";
  }
  // the rim is red: it is there with the loops, and gone without them
  const double rim = share(colors(folder.path("lines.png")), isRed);
  with.report.loops.clear();
  SpiralPictures(with).writeLines(folder.path("bare.png"));
  EXPECT_GT(rim, 0.002);
  EXPECT_LT(share(colors(folder.path("bare.png")), isRed), 0.5 * rim);
  EXPECT_THROW(pictures.writeLines(folder.path("nowhere/a.png")), FileError);
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
