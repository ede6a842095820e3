// SPDX-License-Identifier: BSD-3-Clause
// RidgePlanner on a die that is known exactly: the ball touches it and never cuts into it, from measured lines and from a scan; what
// has no meaning is refused, and nothing is left of an older plan.
#include <pcl_spiral/planning/ridge_planner.h>

#include "support/ridges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace ridge_planner_test {
namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Planner = RidgePlanner<pcl::PointXYZ>;

constexpr double radius = 6.0; // mm

const test::ExactRidge&
die()
{
  static const test::ExactRidge ridge = test::dieRidge();
  return ridge;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
scan()
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int i = 0; i <= 800; ++i)
    for (int k = 0; k <= 32; ++k) {
      const Eigen::Vector3f p = die().position(i / 800.0, k / 32.0).cast<float>();
      cloud->emplace_back(p.x(), p.y(), p.z());
    }
  return cloud;
}

void
setRows(Planner& planner)
{
  RidgeRowSettings rows;
  rows.step_over = 4.0;
  rows.point_spacing = 3.0;
  planner.setRowSettings(rows);
  planner.setQuiet(true);
}

void
setBall(Planner& planner)
{
  PassSettings tool;
  tool.cutter = CutterShape::ball(radius);
  planner.setPassSettings(tool);
}

void
setLines(Planner& planner)
{
  planner.setMeasuredLines(die().railPoints(300), die().generatorPoints(0.37, 100));
}

void
setRough(Planner& planner)
{
  planner.setInputCloud(scan());
  planner.setRoughPoints({die().position(0.05, 0.5), die().position(0.35, 0.5), die().position(0.65, 0.5), die().position(0.95, 0.5)});
  planner.setHalfWidth(9.0);
}

} // namespace

TEST(RidgePlanner, TheBallTouchesTheDieAndDoesNotCutIntoIt)
{
  for (const bool measured : {true, false}) {
    Planner planner;
    setRows(planner);
    setBall(planner);
    measured ? setLines(planner) : setRough(planner);
    std::vector<ToolPoses> passes;
    planner.compute(passes);
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    ASSERT_GE(passes.size(), 4U);
    std::size_t judged = 0;
    for (const ToolPoses& pass : passes)
      for (std::size_t i = 0; i < pass.size(); i += 7) {
        const Vector3d centre = pass[i].tip + radius * pass[i].axis;
        ASSERT_NEAR(die().distance(centre), radius, measured ? 0.02 : 0.06) << measured << " " << pass[i].contact.transpose();
        ++judged;
      }
    EXPECT_GT(judged, 50U);
    EXPECT_EQ(planner.getPlan().found.has_value(), !measured);
    EXPECT_EQ(planner.getPlan().mesh != nullptr, measured);
  }
}

TEST(RidgePlanner, TheSameForEveryNumberOfThreads)
{
  std::vector<ToolPoses> first;
  for (const unsigned int threads : {1U, 3U}) {
    Planner planner;
    setRows(planner);
    setBall(planner);
    setLines(planner);
    planner.setNumberOfThreads(threads);
    std::vector<ToolPoses> passes;
    planner.compute(passes);
    ASSERT_TRUE(planner.getStatus().ok());
    if (!first.empty())
      ASSERT_EQ(passes.size(), first.size());
    for (std::size_t k = 0; k < first.size(); ++k) {
      ASSERT_EQ(passes[k].size(), first[k].size());
      for (std::size_t i = 0; i < first[k].size(); ++i)
        ASSERT_TRUE(first[k][i].tip == passes[k][i].tip && first[k][i].axis == passes[k][i].axis);
    }
    first = passes;
  }
}

TEST(RidgePlanner, WhatHasNoMeaningIsRefusedAndNothingIsLeft)
{
  const auto beam = [](Planner& p) { p.setPassSettings(PassSettings()); };
  const auto rows = [](double RidgeRowSettings::*member) {
    return [member](Planner& p) {
      RidgeRowSettings settings = p.getRowSettings();
      settings.*member = 2.0;
      p.setRowSettings(settings);
    };
  };
  const auto tool = [](const std::function<void(PassSettings&)>& change) {
    return [change](Planner& p) {
      PassSettings settings = p.getPassSettings();
      change(settings);
      p.setPassSettings(settings);
    };
  };
  const std::vector<std::pair<const char*, std::function<void(Planner&)>>> faults{
      {"setMeasuredLines", [](Planner& p) { p.setMeasuredLines({}, {}); }},
      {"setRoughPoints",
       [](Planner& p) {
         p.setRoughPoints({Vector3d::Zero(), Vector3d::UnitX()});
       }},
      {"no scan",
       [](Planner& p) {
         p.setMeasuredLines({}, {});
         p.setRoughPoints({Vector3d::Zero(), Vector3d::UnitX()});
       }},
      {"the rail has 3 different points",
       [](Planner& p) {
         p.setMeasuredLines({Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitY()}, p.getGenerator());
       }},
      {"RidgeRowSettings::stand_off", rows(&RidgeRowSettings::stand_off)},
      {"a spot belongs to a beam", rows(&RidgeRowSettings::spot_size)},
      {"more than one setting defines",
       [](Planner& p) {
         RidgeRowSettings settings = p.getRowSettings();
         settings.tool_radius = radius;
         settings.scallop_height = 0.05;
         p.setRowSettings(settings);
       }},
      {"a beam uses only the measured lines",
       [&](Planner& p) {
         beam(p);
         p.setInputCloud(scan());
       }},
      {"belong to a cutter", tool([](PassSettings& t) {
         t.cutter = CutterShape();
         t.holder = {{7.0, 7.0, 40.0, "shank"}};
       })},
      {"PassSettings::cutter", tool([](PassSettings& t) { t.cutter.corner_radius = 9.0; })},
      {"the cutter's radius is -4", tool([](PassSettings& t) { t.cutter = CutterShape::ball(-4.0); })},
      {"the cutter's radius is nan", tool([](PassSettings& t) { t.cutter = CutterShape::ball(std::nan("")); })},
      {"an overlap belongs to the spot", rows(&RidgeRowSettings::overlap)},
      {"retilt",
       [](Planner& p) {
         PassSettings settings;
         settings.max_retilt = 10.0;
         p.setPassSettings(settings);
       }},
      {"setHalfWidth", [](Planner& p) { p.setHalfWidth(5.0); }},
      {"setClosed", [](Planner& p) { p.setClosed(true); }},
      {"setThinning", [](Planner& p) { p.setThinning(1.0); }},
      {"setLeaveOutStrays", [](Planner& p) { p.setLeaveOutStrays(true); }},
      {"RidgeSettings::measuring_error",
       [](Planner& p) {
         p.setMeasuredLines({}, {});
         setRough(p);
         RidgeSettings ridge;
         ridge.measuring_error = 0.1;
         p.setRidgeSettings(ridge);
       }},
      {"the cutter is another one",
       [](Planner& p) {
         RidgeRowSettings settings;
         settings.tool_radius = 8.0;
         settings.scallop_height = 0.05;
         p.setRowSettings(settings);
       }},
      {"PassSettings::tolerance", tool([](PassSettings& t) { t.tolerance = 0.0; })},
      {"setNumberOfThreads", [](Planner& p) { p.setNumberOfThreads(5000); }},
      {"setIndices",
       [](Planner& p) {
         p.setInputCloud(scan());
         p.setIndices(pcl::make_shared<pcl::Indices>(pcl::Indices{1, 2, 3}));
       }},
  };
  for (const auto& [words, spoil] : faults) {
    Planner planner;
    setRows(planner);
    setBall(planner);
    setLines(planner);
    std::vector<ToolPoses> passes;
    planner.compute(passes);
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    ASSERT_FALSE(passes.empty());
    spoil(planner);
    planner.compute(passes);
    EXPECT_FALSE(planner.getStatus().ok()) << words;
    EXPECT_NE(planner.getStatus().message().find(words), std::string::npos) << planner.getStatus().message();
    EXPECT_TRUE(passes.empty() && planner.getPlan().passes.empty() && !planner.getPlan().ridge);
  }
}

TEST(RidgePlanner, RapidsCrossAboveWhatStandsBesideTheRidge)
{
  Planner planner;
  setRows(planner);
  setBall(planner);
  setRough(planner);
  const auto with_post = scan();
  for (int i = 0; i < 12; ++i)
    for (int k = 0; k < 12; ++k)
      with_post->emplace_back(300.0f + i, 150.0f + k, 250.0f);
  planner.setLargestPart(true);
  planner.setInputCloud(with_post);
  planner.compute();
  ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
  EXPECT_NEAR(planner.getPlan().clearBox().max().z(), 250.0, 1e-3);
  Planner measured;
  setRows(measured);
  setBall(measured);
  setLines(measured);
  measured.compute();
  EXPECT_TRUE(measured.getPlan().clearBox().isEmpty());
}

TEST(RidgePlanner, SaysWhereItFailed)
{
  Planner lines;
  setRows(lines);
  setBall(lines);
  lines.setMeasuredLines({Vector3d::Zero(), Vector3d::UnitX()}, die().generatorPoints(0.37, 100));
  lines.compute();
  EXPECT_EQ(lines.getPlan().fault, RidgeFault::Lines);
  Planner rough;
  setRows(rough);
  setBall(rough);
  setRough(rough);
  rough.setHalfWidth(0.0);
  rough.compute();
  EXPECT_FALSE(rough.getStatus().ok());
  EXPECT_EQ(rough.getPlan().fault, RidgeFault::Scan);
}

TEST(RidgePlanner, CancelledNothingIsLeft)
{
  for (const double at : {0.0, 0.4, 0.8}) {
    Planner planner;
    setRows(planner);
    setBall(planner);
    setRough(planner);
    planner.setProgressCallback([at](double share, const std::string&) { return share < at; });
    planner.compute();
    EXPECT_EQ(planner.getStatus().code(), StatusCode::Cancelled) << at << planner.getStatus().message();
    EXPECT_TRUE(planner.getPlan().passes.empty());
  }
  Planner beam;
  setRows(beam);
  setLines(beam);
  beam.setProgressCallback([](double, const std::string&) { return false; });
  beam.compute();
  EXPECT_EQ(beam.getStatus().code(), StatusCode::Cancelled);
}

} // namespace ridge_planner_test
