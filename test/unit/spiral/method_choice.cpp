// SPDX-License-Identifier: BSD-3-Clause
// SpiralMethod::Shortest: the method it chooses, and the accuracy of its predictions.
#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/spiral/impl/stage_reports.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

namespace method_choice_test {

namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Generator = SpiralToolpathGenerator<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;

Generator
generatorOf(const Region& region, std::size_t count)
{
  Generator generator;
  generator.setInputCloud(toCloud(sampleUniform(*ball(400.0, region), count, 11).points));
  generator.setToolRadius(5.0);
  generator.setScallopHeight(0.1);
  generator.setQuiet(true);
  return generator;
}

SpiralReport
made(Generator& generator)
{
  Path path;
  generator.compute(path);
  EXPECT_TRUE(generator.getStatus().ok()) << generator.getStatus().message();
  return generator.getReport();
}

const Region disc({circle({0, 0}, 70.0)});
const Region oval({ellipse(90.0, 45.0)});
const Region ring({circle({0, 0}, 70.0), circle({0, 0}, 30.0)});

TEST(MethodChoice, ADiscIsCutInTurnsAnOvalAlongItsRim)
{
  Generator round = generatorOf(disc, 8000), flat_round = generatorOf(oval, 8000);
  round.setScallopHeight(0.005); // 150 turns: with few turns, those along the rim make the radial path longer
  EXPECT_EQ(made(round).method, SpiralMethod::Radial);
  EXPECT_EQ(made(flat_round).method, SpiralMethod::ConstantScallop);
}

TEST(MethodChoice, CornersAndSeveralHolesAskForConstantScallop)
{
  Generator square = generatorOf(Region({rectangle(110.0, 110.0)}), 8000);
  EXPECT_EQ(made(square).method, SpiralMethod::ConstantScallop);
  Generator holes = generatorOf(Region({circle({0, 0}, 70.0), circle({-30, 0}, 16.0), circle({30, 0}, 16.0)}), 8000);
  EXPECT_EQ(made(holes).method, SpiralMethod::ConstantScallop);
}

TEST(MethodChoice, LengthsAreForeseenWithinThreePercent)
{
  for (const Region& region : {disc, oval, ring}) {
    Generator generator = generatorOf(region, 8000);
    const SpiralReport chosen = made(generator);
    generator.setMethod(SpiralMethod::Radial);
    const double radial = made(generator).path_length;
    generator.setMethod(SpiralMethod::ConstantScallop);
    const double scallop = made(generator).path_length;
    std::printf("  radial %.0f foreseen %.0f, constant scallop %.0f foreseen %.0f\n", radial, chosen.foreseen_radial, scallop,
                chosen.foreseen_scallop);
    EXPECT_NEAR(chosen.foreseen_radial, radial, 0.03 * radial);
    EXPECT_NEAR(chosen.foreseen_scallop, scallop, 0.03 * scallop);
    EXPECT_LE(chosen.path_length, 1.025 * std::min(radial, scallop));
  }
}

TEST(MethodChoice, SharpTurnsCountWhereTheMachineIsFastAndSoft)
{
  Generator generator = generatorOf(Region({ellipse(72.0, 68.0)}), 8000);
  generator.setFeed(1000.0);
  EXPECT_EQ(made(generator).method, SpiralMethod::ConstantScallop);
  generator.setFeed(20000.0);
  generator.setAcceleration(300.0);
  EXPECT_EQ(made(generator).method, SpiralMethod::Radial);
}

TEST(MethodChoice, SettingsOfLinesAskForRadial)
{
  Generator generator = generatorOf(oval, 8000);
  generator.setCenter({5.0, 0.0, 400.0});
  EXPECT_EQ(made(generator).method, SpiralMethod::Radial);
  generator.clearCenter();
  generator.setPitch(Pitch::AlongLine);
  EXPECT_EQ(made(generator).method, SpiralMethod::Radial);
}

TEST(MethodChoice, ConstantScallopRefusesSettingsOfLines)
{
  Generator generator = generatorOf(oval, 8000);
  generator.setMethod(SpiralMethod::ConstantScallop);
  generator.setCenter({5.0, 0.0, 400.0});
  Path path;
  generator.compute(path);
  EXPECT_EQ(generator.getStatus().code(), StatusCode::InvalidArgument);
  EXPECT_NE(generator.getStatus().message().find("setCenter"), std::string::npos);
}

TEST(MethodChoice, OnlyAFailureOfTheRadialMethodLeadsToConstantScallop)
{
  EXPECT_EQ(whyNotRadial({StatusCode::Cancelled, "cancelled"}, SpiralTurns()), Diagnostic());
  EXPECT_EQ(whyNotRadial({StatusCode::InvalidArgument, "too large"}, SpiralTurns()), Diagnostic());
  EXPECT_EQ(whyNotRadial({StatusCode::Failed, "no radial lines were found"}, SpiralTurns()), Diagnostic("no radial lines were found"));
  SpiralTurns turns;
  for (const double x : {0.0, 1.0, 2.0, 3.0})
    turns.curve.push_back({{x, 0.0, 0.0}, x});
  EXPECT_EQ(whyNotRadial(Status::success(), turns), Diagnostic());
}

} // namespace

} // namespace method_choice_test
