// SPDX-License-Identifier: BSD-3-Clause
// Setters, getters and callbacks with their former names: they forward, with a compiler warning that is switched off here.
#include <pcl_spiral/geodesic/geodesic_path.h>
#include <pcl_spiral/search/elliptic_gabriel_graph.h>
#include <pcl_spiral/spiral/radial_lines.h>
#include <pcl_spiral/surface/mls_projector.h>
#include <pcl_spiral/surface/surface_preparation.h>

#include <gtest/gtest.h>

#include <cmath>

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

using namespace pcl_spiral;
using Lines = RadialLines<pcl::PointXYZ>;

namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr
grid()
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i < 2500; ++i) {
    const float x = static_cast<float>(i % 50), y = static_cast<float>(i / 50);
    cloud->emplace_back(x + 0.2f * std::sin(7.0f * y), y + 0.2f * std::sin(5.0f * x), 0.0f);
  }
  return cloud;
}

/** Whether compute calls the callback that \p set sets, and whether the callback cancels it. */
template <typename Set>
bool
cancels(const Set& set)
{
  Lines lines;
  lines.setQuiet(true);
  lines.setInputCloud(grid());
  set(lines);
  std::vector<RadialLine> found;
  lines.compute(found);
  return lines.getStatus().code() == StatusCode::Cancelled;
}

} // namespace

TEST(FormerNames, GettersForward)
{
  MLSProjector<pcl::PointXYZ, pcl::PointNormal> projector;
  projector.setNeighbours(17);
  EXPECT_EQ(projector.getNeighbours(), 17);
  EXPECT_EQ(projector.getKSearch(), 17);
  GeodesicPath<pcl::PointXYZ> geodesic;
  geodesic.setFitNeighbours(18);
  EXPECT_EQ(geodesic.getFitNeighbours(), 18);
  EllipticGabrielGraph<pcl::PointXYZ> egg;
  egg.setNumberOfCandidates(19);
  EXPECT_EQ(egg.getNumberOfCandidates(), 19);
  SurfacePreparation<pcl::PointXYZ> preparation;
  preparation.setNumberOfNeighbours(20);
  EXPECT_EQ(preparation.getNumberOfNeighbours(), 20);
  EXPECT_EQ(preparation.getSurfaceGraph().size(), 0u) << "before the first run";
  pcl::PointCloud<pcl::PointXYZ> clean;
  preparation.setInputCloud(grid());
  preparation.filter(clean);
  EXPECT_EQ(preparation.getSurfaceGraph().size(), clean.size());
}

TEST(FormerNames, ACallbackOfTheShareAloneOrOfBothIsTaken)
{
  EXPECT_TRUE(cancels([](Lines& l) { l.setProgressCallback([](double) { return false; }); }));
  EXPECT_TRUE(cancels([](Lines& l) { l.setProgressCallback([](double, const std::string&) { return false; }); }));
  EXPECT_TRUE(cancels([](Lines& l) { l.setProgressCallback([](auto) { return false; }); }));
  EXPECT_TRUE(cancels([](Lines& l) { l.setProgressCallback([](auto...) { return false; }); }));
  EXPECT_TRUE(cancels([](Lines& l) { l.setProgressCallback(std::function<bool(double)>([](double) { return false; })); }));
  EXPECT_TRUE(cancels([](Lines& l) { l.setProgressCallback(ProgressCallback([](double, const std::string&) { return false; })); }));
  EXPECT_FALSE(cancels([](Lines& l) { l.setProgressCallback(std::function<bool(double)>()); }));
  EXPECT_FALSE(cancels([](Lines& l) { l.setProgressCallback(nullptr); }));
  EXPECT_FALSE(cancels([](Lines& l) { l.setProgressCallback({}); }));
}
