// SPDX-License-Identifier: BSD-3-Clause
// What the generator says has every place, number with unit, and setting as a field: nothing of them is typed into its sentences.
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <regex>
#include <set>

namespace said_as_data_test {

using namespace pcl_spiral;
using Generator = SpiralToolpathGenerator<pcl::PointXYZ>;

namespace {

/** Points every millimetre on z = \p height(x, y) over a square of \p half to either side. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
cloudOf(double half, const std::function<double(double, double)>& height)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (double x = -half; x <= half; x += 1.0)
    for (double y = -half; y <= half; y += 1.0)
      cloud->emplace_back(static_cast<float>(x), static_cast<float>(y), static_cast<float>(height(x, y)));
  return cloud;
}

double
dome(double x, double y)
{
  return -(x * x + y * y) / 200.0;
}

double
valley(double x, double)
{
  return std::abs(x) < 8.0 ? 10.0 - std::sqrt(100.0 - x * x) : 4.0; // hollow with radius 10
}

/** Expects that the words of \p said, without its fields, name no setting, no unit and no place. */
void
expectData(const Diagnostic& said)
{
  const std::string words = std::regex_replace(said.id(), std::regex("\\{[^{}]*\\}|\\(0, 0, [01]\\)"), "#"); // or an example
  const std::regex typed("(set|add|clear)[A-Z][a-z]|\\b(mm2?|degrees)\\b|\\(-?[0-9.]+, -?[0-9.]+, -?[0-9.]+\\)");
  EXPECT_FALSE(std::regex_search(words, typed)) << words;
  for (const std::string& name : said.names())
    EXPECT_FALSE(std::regex_search(name, typed)) << name << " in " << said;
}

} // namespace

TEST(SaidAsData, RefusedSettings)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::function<void(Generator&)>> bad{
      [](Generator& g) { g.setToolRadius(-1.0); },
      [](Generator& g) { g.setScallopHeight(0.0); },
      [](Generator& g) { g.setScallopHeight(9.0); },
      [](Generator& g) { g.setChordError(-0.1); },
      [](Generator& g) { g.setMaxStep(-2.0); },
      [](Generator& g) { g.setTiltAngle(95.0); },
      [](Generator& g) { g.setLeadAngle(-91.0); },
      [](Generator& g) {
        g.setFixedAxis({0.0, 0.0, 0.0});
      },
      [](Generator& g) {
        g.setFixedAxis({1.0, 0.0, 0.0});
      },
      [](Generator& g) { g.setMaxAxisRate(0.0); },
      [](Generator& g) { g.setAxisSmoothing(-1.0); },
      [](Generator& g) { g.setAxisDeviation(100.0); },
      [nan](Generator& g) {
        g.setCenter({nan, 0.0, 0.0});
      },
      [](Generator& g) {
        g.setMethod(SpiralMethod::Radial), g.setCenter({0.0, 0.0, 50.0});
      },
      [](Generator& g) {
        g.setMethod(SpiralMethod::Radial), g.setCenter({19.5, 0.0, -1.9});
      },
      [](Generator& g) {
        g.setMethod(SpiralMethod::ConstantScallop), g.setCenter({0.0, 0.0, 0.0});
      },
      [nan](Generator& g) {
        g.setStartPoint({nan, 0.0, 0.0});
      },
      [](Generator& g) { g.setFeed(0.0); },
      [](Generator& g) { g.setAcceleration(-1.0); },
      [](Generator& g) { g.setLeastTurnRadius(-1.0); },
      [](Generator& g) { g.setRimOverhang(-100.0); },
      [](Generator& g) { g.setHoleSize(-1.0); },
      [](Generator& g) { g.setHoleMargin(-1.0); },
      [](Generator& g) { g.setThinning(-1.0); },
      [](Generator& g) { g.setThinning(19.0); },
      [](Generator& g) {
        g.setPartAt({500.0, 0.0, 0.0});
      },
      [](Generator& g) { g.setOutlierRemoval(1000000, 1.0); },
      [](Generator& g) { g.setNumberOfThreads(1000000); },
      [](Generator& g) { g.setBoundaryMode(BoundaryMode::TwoBoundaries); },
  };
  std::set<std::string> kinds;
  std::size_t refused = 0;
  for (const auto& set : bad) {
    Generator generator;
    generator.setInputCloud(cloudOf(20.0, dome));
    generator.setToolRadius(5.0);
    generator.setScallopHeight(0.2);
    generator.setQuiet(true);
    set(generator);
    pcl::PointCloud<ToolpathPoint> path;
    generator.compute(path);
    expectData(generator.getStatus().diagnostic());
    for (const Diagnostic& warning : generator.getReport().warnings)
      expectData(warning);
    refused += generator.getStatus().ok() ? 0 : 1;
    kinds.insert(generator.getStatus().diagnostic().id());
  }
  EXPECT_GE(refused, 25U);
  EXPECT_GE(kinds.size(), 22U) << "each fault has a sentence of its own, whatever its values";
}

TEST(SaidAsData, RefusedScansAndWarnings)
{
  const auto two = cloudOf(20.0, dome);
  const auto small = cloudOf(6.0, dome);
  for (const pcl::PointXYZ& p : *small)
    two->emplace_back(p.x + 60.0F, p.y, p.z);
  const auto upside = cloudOf(20.0, [](double x, double y) { return 3.0 * x + 0.2 * y; });
  std::size_t places = 0;
  for (const auto& cloud : {cloudOf(20.0, valley), two, upside, cloudOf(1.0, dome), pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>()})
    for (const TightHandling tight : {TightHandling::Ride, TightHandling::Refuse}) {
      Generator generator;
      generator.setInputCloud(cloud);
      generator.setToolRadius(14.0);
      generator.setScallopHeight(0.3);
      generator.setTightHandling(tight);
      generator.setQuiet(true);
      pcl::PointCloud<ToolpathPoint> path;
      generator.compute(path);
      expectData(generator.getStatus().diagnostic());
      places += generator.getStatus().diagnostic().places().size();
      for (const Diagnostic& warning : generator.getReport().warnings) {
        expectData(warning);
        places += warning.places().size();
      }
    }
  EXPECT_GE(places, 4U);
}

} // namespace said_as_data_test
