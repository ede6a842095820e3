// SPDX-License-Identifier: BSD-3-Clause
// A refused plan names the change that gives a path, tried by the planner itself: scans for which it is known which one that is.
#include "planning/changes_tried.h"
#include "planning/input_tables.h"
#include "planning/lacking_points.h"
#include "planning/proposed_value.h"
#include "planning/single_change.h"

#include "support/spiral_jobs.h"
#include "support/tight_parts.h"

#include <pcl_spiral/spiral/impl/stage_reports.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <variant>

namespace changes_that_help_test {
namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;
using Path = pcl::PointCloud<ToolpathPoint>;

void
prepare(const ScanPtr& scan, Spiral& planner)
{
  planner.setInputCloud(scan);
  planner.setToolRadius(3.0);
  planner.setScallopHeight(0.05);
  planner.setQuiet(true);
}

/** What a search adds to the refusal. */
std::string
added(Spiral& planner)
{
  planner.setRemedyTries(0);
  planner.compute();
  EXPECT_FALSE(planner.getStatus().ok());
  const std::string refusal = planner.getStatus().message();
  planner.setRemedyTries(3);
  planner.compute();
  EXPECT_FALSE(planner.getStatus().ok());
  EXPECT_TRUE(planner.getPlan().path->empty());
  EXPECT_EQ(planner.getStatus().message().substr(0, refusal.size()), refusal);
  return planner.getStatus().message().substr(refusal.size());
}

/** The last setting that the refusal names. */
std::string
lastNamed(const Spiral& planner)
{
  const std::vector<std::string> settings = planner.getStatus().diagnostic().settings();
  return settings.empty() ? "" : settings.back();
}

/** Two plates side by side, the second with a hole. */
ScanPtr
plateBesidePlateWithHole()
{
  const ScanPtr scan = plateWithout([](double x, double y) { return std::hypot(x, y) < 5.0; });
  addSheet(
      12.0, 12.0, 0.8, [](double u, double v) { return std::hypot(u, v) < 4.0 ? Vector3d::Constant(NAN) : Vector3d(u + 60.0, v, 0.0); },
      *scan);
  return scan;
}

} // namespace

TEST(ChangesThatHelp, TheOneIsNamedWithTheLengthOfItsPath)
{
  const ScanPtr ring = plateWithout([](double x, double y) { return std::hypot(x, y) < 5.0; });
  Spiral refused, changed;
  prepare(ring, refused);
  refused.setHoleSize(6.0);
  refused.setHoleHandling(HoleHandling::Refuse);
  EXPECT_NE(added(refused).find("one gives a path of"), std::string::npos) << refused.getStatus().message();
  EXPECT_EQ(lastNamed(refused), "setHoleHandling");
  prepare(ring, changed);
  changed.setHoleSize(6.0);
  changed.compute();
  ASSERT_TRUE(changed.getStatus().ok());
  const std::vector<double> numbers = refused.getStatus().diagnostic().numbers();
  EXPECT_NE(std::find(numbers.begin(), numbers.end(), std::round(changed.getReport().path_length)), numbers.end())
      << changed.getReport().path_length << " mm: " << refused.getStatus().message();
}

TEST(ChangesThatHelp, TheRadiusNamedFitsAGroove)
{
  const double fillet = 2.0;
  const ScanPtr groove = valley(0.7, fillet, 9.0, 9.0).scan(0.4, 0.0, 11);
  const auto statusWith = [&](double radius) {
    Spiral planner;
    prepare(groove, planner);
    planner.setToolRadius(radius);
    planner.setTightHandling(TightHandling::Refuse);
    planner.setRemedyTries(0);
    planner.compute();
    return planner.getStatus();
  };
  PlanInput input;
  input.settings.tool_radius = 3.0;
  input.settings.tight = TightHandling::Refuse;
  const std::vector<SingleChange> changes = singleChanges(input, {statusWith(3.0), false});
  const auto ball = std::find_if(changes.begin(), changes.end(), [](const SingleChange& c) { return c.input.settings.tool_radius < 3.0; });
  ASSERT_NE(ball, changes.end());
  EXPECT_TRUE(ball->named);
  const double named = ball->input.settings.tool_radius;
  EXPECT_LE(named, fillet);
  EXPECT_GT(1.3 * named, fillet);
  EXPECT_TRUE(statusWith(named).ok()) << statusWith(named).message();
  EXPECT_FALSE(statusWith(1.3 * named).ok());
}

/** Its radius is that of the fit: a ball that fits this need not give a path. */
TEST(ChangesThatHelp, NoRadiusIsNamedForAnInnerEdge)
{
  for (const double angle : {80.0, 110.0, 140.0}) {
    const ScanPtr scan(new pcl::PointCloud<pcl::PointXYZ>);
    const double half = 0.5 * angle * M_PI / 180.0;
    for (int i = -24; i <= 24; ++i)
      for (int k = -24; k <= 24; ++k)
        scan->emplace_back(static_cast<float>(0.5 * i * std::sin(half)), 0.5F * static_cast<float>(k),
                           static_cast<float>(0.5 * std::abs(i) * std::cos(half)));
    const auto planWith = [&](double radius, Spiral& planner) {
      prepare(scan, planner);
      planner.setToolRadius(radius);
      planner.setViewPoint({0.0, 0.0, 500.0});
      planner.setTightHandling(TightHandling::Refuse);
      planner.setRemedyTries(0);
      planner.compute();
      return planner.getStatus();
    };
    Spiral large;
    const Status refusal = planWith(6.0, large);
    ASSERT_FALSE(refusal.ok()) << angle;
    const std::vector<Proposed> proposals = refusal.diagnostic().proposed();
    EXPECT_EQ(proposals.empty(), angle < 95.0) << angle << ": " << refusal.message();
    for (const Proposed& proposed : proposals) {
      Spiral fitting;
      const Status status = planWith(std::get<double>(proposed.value), fitting);
      EXPECT_TRUE(status.ok()) << angle << ": " << refusal.message() << "\n  then: " << status.message();
    }
    for (const SingleChange& change : singleChanges(large.input(), {refusal, true}))
      EXPECT_TRUE(!proposals.empty() || change.input.settings.tool_radius == 6.0) << angle << ": " << change.words.all();
  }
}

/** Between points farther apart than it is wide, a ball would cut what they do not show. */
TEST(ChangesThatHelp, ABallThatPassesBetweenThePointsIsNotNamed)
{
  const ScanPtr scan = plate(); // points 0.8 apart
  for (const double radius : {0.3, 3.0}) {
    Spiral planner;
    prepare(scan, planner);
    planner.setToolRadius(radius);
    planner.setScallopHeight(0.02 * radius);
    planner.compute();
    ASSERT_TRUE(planner.getStatus().ok()) << planner.getStatus().message();
    EXPECT_EQ(isClear(planner.getPlan()), radius > 0.5) << "radius " << radius;
  }
}

TEST(ChangesThatHelp, TwoTogetherWhereNoneIsEnough)
{
  Spiral planner;
  prepare(plateBesidePlateWithHole(), planner);
  planner.setHoleSize(6.0);
  planner.setHoleHandling(HoleHandling::Refuse);
  EXPECT_NE(added(planner).find("two together give a path of"), std::string::npos) << planner.getStatus().message();
  const std::vector<std::string> named = planner.getStatus().diagnostic().settings();
  ASSERT_GE(named.size(), 2U);
  EXPECT_EQ(named[named.size() - 2], "setPartAt");
  EXPECT_EQ(named.back(), "setHoleHandling");
}

TEST(ChangesThatHelp, OfSeparatePartsThatWhichCanBeCut)
{
  const ScanPtr scan = plateWithout([](double x, double y) { return std::abs(x) > 15.0 || std::abs(y) > 15.0; }, 15.0);
  addSheet(
      8.0, 8.0, 0.8, [](double u, double v) { return Vector3d(u + 60.0, v, 0.0); }, *scan);
  Spiral planner;
  prepare(scan, planner);
  EXPECT_NE(added(planner).find("one gives a path of"), std::string::npos) << planner.getStatus().message();
  EXPECT_EQ(lastNamed(planner), "setPartAt");
  EXPECT_LT(planner.getStatus().diagnostic().places().back().head<2>().norm(), 22.0); // the larger one
}

TEST(ChangesThatHelp, AnEvenScanIsNotSaidToLackPoints)
{
  const ScanPtr strip(new pcl::PointCloud<pcl::PointXYZ>); // two points wide
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 2; ++k)
      strip->emplace_back(0.9f * static_cast<float>(i) + 0.1f * static_cast<float>((7 * i + k) % 3), 0.9f * static_cast<float>(k), 0.0f);
  Spiral planner;
  prepare(strip, planner);
  const std::string words = added(planner);
  EXPECT_EQ(words.find("gives a path of"), std::string::npos);
  EXPECT_EQ(words.find("What the scan lacks"), std::string::npos) << "its points are even: " << planner.getStatus().message();
}

TEST(ChangesThatHelp, TheSearchCanBeStopped)
{
  Spiral planner;
  prepare(plateBesidePlateWithHole(), planner);
  planner.setHoleSize(6.0);
  planner.setHoleHandling(HoleHandling::Refuse);
  int after = 0;
  planner.setProgressCallback([&after](double share, const std::string& stage) {
    EXPECT_LE(share, 1.0);
    after += after > 0 || stage.rfind("trying change", 0) == 0 ? 1 : 0;
    return after == 0;
  });
  planner.compute();
  EXPECT_EQ(after, 1) << "it is not called again";
  EXPECT_EQ(planner.getStatus().code(), StatusCode::InvalidInput); // the refusal stays
  EXPECT_NE(planner.getStatus().message().find("was stopped"), std::string::npos);
}

TEST(ChangesThatHelp, TheSearchIsBoundedAndTheSameForAnyThreads)
{
  std::set<std::string> words;
  for (const unsigned int threads : {1U, 2U}) {
    Spiral planner;
    prepare(plateBesidePlateWithHole(), planner);
    planner.setHoleSize(6.0);
    planner.setHoleHandling(HoleHandling::Refuse);
    planner.setNumberOfThreads(threads);
    planner.setRemedyTries(1);
    std::set<std::string> stages;
    planner.setProgressCallback([&stages](double, const std::string& stage) {
      if (stage.rfind("trying change", 0) == 0)
        stages.insert(stage);
      return true;
    });
    planner.compute();
    EXPECT_FALSE(planner.getStatus().ok());
    EXPECT_GE(stages.size(), 1U);
    EXPECT_LE(stages.size(), 3U); // each costs a third of a path at least
    words.insert(planner.getStatus().message());
  }
  EXPECT_EQ(words.size(), 1U);
}

TEST(ChangesThatHelp, WhatTheBoundLeftUntriedIsSaidWithTheNextBound)
{
  const ScanPtr five(new pcl::PointCloud<pcl::PointXYZ>); // plates, each with a hole
  for (int i = 0; i < 5; ++i)
    addSheet(
        10.0, 10.0, 0.8,
        [i](double u, double v) { return std::hypot(u, v) < 4.0 ? Vector3d::Constant(NAN) : Vector3d(u + 60.0 * i, v, 0.0); }, *five);
  Spiral planner;
  prepare(five, planner);
  planner.setHoleSize(6.0);
  planner.setHoleHandling(HoleHandling::Refuse);
  const auto messageOf = [&planner](int tries) {
    planner.setRemedyTries(tries);
    planner.compute();
    return planner.getStatus().message();
  };
  const std::string bounded = messageOf(1);
  EXPECT_NE(bounded.find("none gives a path: setPartAt"), std::string::npos) << bounded;
  EXPECT_NE(bounded.find(". The search ended after setRemedyTries 1; setRemedyTries 4 tries more"), std::string::npos) << bounded;
  EXPECT_EQ(planner.getStatus().diagnostic().given().back().setting, "setRemedyTries");
  EXPECT_NE(messageOf(2).find("two together give a path of"), std::string::npos) << planner.getStatus().message();
}

TEST(ChangesThatHelp, AListOfChangesInVainHasThoseOfTwoTogether)
{
  PlanInput input;
  input.cloud = plate();
  input.settings.hole_size = 6.0;
  const Status refusal(StatusCode::Failed,
                       Diagnostic("a hole ({setHoleSize}), and {setScallopHeight} ", Proposed("setScallopHeight", 0.2)));
  const auto refuse = [](const PlanInput&, SpiralPlan&) {
    return Status(StatusCode::Failed, Diagnostic("too long: {setChordError} ", Proposed("setChordError", 0.4)));
  };
  EXPECT_EQ(
      changeThatHelps(input, refusal, {}, refuse).text(),
      ". Of changes that were tried, none gives a path: without setHoleSize; setScallopHeight 0.2; nor do two together: setChordError "
      "0.4, without setHoleSize; setScallopHeight 0.2 and setChordError 0.4");
}

/** A command names at most what a command takes. */
TEST(ChangesThatHelp, NoMoreTriesAreProposedThanMayBeGiven)
{
  PlanInput input;
  input.cloud = plate();
  const Status refusal(StatusCode::Failed, Diagnostic("{setScallopHeight} ", Proposed("setScallopHeight", 0.2)));
  const auto spend = [](const PlanInput& with, SpiralPlan&) {
    *with.paths_left = 0.0;
    return Status(StatusCode::Failed, Diagnostic("too long: {setChordError} ", Proposed("setChordError", 0.4)));
  };
  input.remedy_tries = 400000000;
  const Diagnostic words = changeThatHelps(input, refusal, {}, spend);
  ASSERT_FALSE(words.given().empty()) << words;
  EXPECT_EQ(std::get<double>(words.given().back().value), most_remedy_tries) << words;
}

TEST(ChangesThatHelp, APathIsTheSameWithoutASearch)
{
  Path with, without;
  for (const int paths : {0, 3}) {
    Spiral planner;
    prepare(plate(), planner);
    planner.setRemedyTries(paths);
    planner.setProgressCallback([](double, const std::string& stage) {
      EXPECT_NE(stage.rfind("trying change", 0), 0U);
      return true;
    });
    planner.compute(paths == 0 ? without : with);
    ASSERT_TRUE(planner.getStatus().ok());
  }
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t i = 0; i < with.size(); ++i)
    ASSERT_EQ(with[i].getVector3fMap(), without[i].getVector3fMap());
}

TEST(ChangesThatHelp, LessThanNoSearchIsRefusedAndMoreThanIsCounted)
{
  for (const int paths : {-1, 1000000001}) {
    Spiral planner;
    prepare(plate(), planner);
    planner.setRemedyTries(paths);
    planner.compute();
    EXPECT_EQ(planner.getStatus().code(), StatusCode::InvalidArgument);
    EXPECT_EQ(lastNamed(planner), "setRemedyTries");
    EXPECT_NE(planner.getStatus().message().find("must be from 0 to 1000000000 paths"), std::string::npos) << planner.getStatus().message();
  }
}

/** The changes that a refusal names, as a user gives them. */
std::vector<std::string>
wordsOf(const PlanInput& input, const Diagnostic& said)
{
  std::vector<std::string> words;
  for (const SingleChange& change : singleChanges(input, {{StatusCode::Failed, said}, false}))
    words.push_back(change.words.all().text());
  return words;
}

TEST(ChangesThatHelp, EveryNumberThatIsProposedIsTriedWhateverTheSentence)
{
  const PlanInput input;
  PlanInput tables;
  std::size_t count = 0;
  for (const Setting& setting : settingTable(tables.settings) + settingTable(tables))
    if (std::holds_alternative<double*>(setting.target) && setting.range.takes(0.123) && textOf(setting) != "0.123") {
      ++count;
      EXPECT_EQ(wordsOf(input, Diagnostic("anything: ", Proposed(setting.setter, 0.123))),
                std::vector<std::string>{setting.setter + " 0.123"});
    }
  EXPECT_GE(count, 20U);
  EXPECT_EQ(wordsOf(input, Diagnostic(Proposed("setMethod", "radial"))), std::vector<std::string>{"setMethod radial"});
  EXPECT_TRUE(wordsOf(input, Diagnostic("a radius of ", 1.0, " {mm}, thin to ", 2.0, " {mm} at ", Place({1, 2, 3}))).empty());
}

TEST(ChangesThatHelp, ASettingThatIsChangedTwiceIsOneChange)
{
  const ChangeWords half{Diagnostic(Given("setToolRadius", 3.0))}, quarter{Diagnostic(Given("setToolRadius", 1.5))};
  const ChangeWords kept_out{Diagnostic(Given("addKeepOut", 1.0))}, usual{{}, "without {setMethod}"};
  EXPECT_EQ(together(half, quarter).all().text(), "setToolRadius 1.5");
  EXPECT_EQ(together(half, quarter).changes, 1);
  EXPECT_EQ(together(usual, {Diagnostic(Given("setMethod", "radial"))}).all().text(), "setMethod radial");
  EXPECT_EQ(together(kept_out, kept_out).all().text(), "addKeepOut 1 and addKeepOut 1");
  EXPECT_EQ(together(kept_out, kept_out).changes, 2);
}

TEST(ChangesThatHelp, KeepOutsAreTriedTogetherAndPartsOneByOne)
{
  const PlanInput input;
  const Diagnostic said(Proposed("addKeepOut", {3.0, 2.0, 1.0}, {1.0, 5.00001, 0.0}), " {addKeepOut} ",
                        Proposed("addKeepOut", {7.0, 7.0, 0.0}, {8.0, 8.0, 0.0}), " {setPartAt} ", Proposed("setPartAt", Vector3d(1, 2, 3)),
                        Proposed("setPartAt", Vector3d(4, 5, 6)));
  EXPECT_EQ(wordsOf(input, said), (std::vector<std::string>{"setPartAt (1, 2, 3)", "setPartAt (4, 5, 6)",
                                                            "addKeepOut from (1, 2, 0) to (3, 5.001, 1) and addKeepOut from (7, 7, 0) to "
                                                            "(8, 8, 0)"}));
  const std::vector<Prism> kept_out = singleChanges(input, {{StatusCode::Failed, said}, false}).back().input.choice.keep_outs;
  ASSERT_EQ(kept_out.size(), 2U);
  EXPECT_TRUE(kept_out[0].contains({2, 3, 77}));
  EXPECT_FALSE(kept_out[0].contains({0.5, 3, 0}));
}

TEST(ChangesThatHelp, TheClosingIsNotTriedBesideWhatItRefuses)
{
  const auto isTried = [](const std::function<void(PlanInput&)>& change) {
    PlanInput input;
    input.cloud = plate();
    input.settings.tool_radius = 3.0;
    input.settings.scallop_height = 0.05;
    input.settings.view_point = Vector3d(0.0, 0.0, 500.0);
    change(input);
    const bool is_tried = wordsOf(input, "anything") == std::vector<std::string>{"setBallClosing(true), with a fixed tool axis"};
    PlanInput closed = input;
    closed.ball_closing = true;
    closed.remedy_tries = 0;
    SpiralPlan plan;
    const Status status = planSpiral(closed, plan);
    EXPECT_NE(status.code() == StatusCode::InvalidArgument, is_tried) << status.message();
    return is_tried;
  };
  EXPECT_TRUE(isTried([](PlanInput&) {}));
  EXPECT_FALSE(isTried([](PlanInput& i) { i.choice.keep_outs = {box(40.0, 42.0, 0.0, 4.0)}; }));
  EXPECT_FALSE(isTried([](PlanInput& i) { i.choice.clusters = ClusterHandling::Ride; }));
  EXPECT_FALSE(isTried([](PlanInput& i) { i.settings.thinning = 1.0; }));
  EXPECT_FALSE(isTried([](PlanInput& i) { i.settings.tight = TightHandling::Refuse; }));
  EXPECT_FALSE(isTried([](PlanInput& i) { i.settings.flip_normals = true; }));
}

TEST(ChangesThatHelp, TheClosingIsNotTriedBesideWhatJudgesByTheSurfaceOfTheScan)
{
  PlanInput input;
  input.cloud = plate();
  input.settings.tool_radius = 3.0;
  input.settings.scallop_height = 0.05;
  input.settings.view_point = Vector3d(0.0, 0.0, 500.0);
  const std::vector<std::string> tried{"setBallClosing(true), with a fixed tool axis"};
  for (const char* name : {"verify", "stock", "max_gouge", "max_scallop", "max_deviation", "max_uncut", "raw_scan", "reach"}) {
    input.asked = {name};
    EXPECT_TRUE(wordsOf(input, "anything").empty()) << name;
  }
  input.asked = {"tool_radius", "flank_length", "machine"};
  EXPECT_EQ(wordsOf(input, "anything"), tried);
  input.asked = {"tilt"};
  input.settings.tilt_angle = 5.0;
  EXPECT_EQ(wordsOf(input, "anything"), std::vector<std::string>{tried.front() + ", without setTiltAngle"});
}

TEST(ChangesThatHelp, TheKeepOutThatIsEnteredGrows)
{
  PlanInput input;
  input.choice.keep_outs = {box(-1.0, 1.0, -2.0, 2.0), box(20.0, 22.0, 0.0, 4.0)};
  const Diagnostic said("by ", Proposed("addKeepOut", 0.5), " {mm} at ", Place({19.8, 1.0, 9.0}), " ({addKeepOut})");
  const std::vector<SingleChange> changes = singleChanges(input, {{StatusCode::Failed, said}, false});
  ASSERT_EQ(changes.size(), 1U);
  const std::vector<Prism>& kept_out = changes[0].input.choice.keep_outs;
  ASSERT_EQ(kept_out.size(), 3U);
  for (const Vector3d& corner : input.choice.keep_outs[1].outline(100.0))
    EXPECT_TRUE(kept_out[2].contains(corner));
  EXPECT_TRUE(kept_out[2].contains({19.45, 1.0, 0.0}));
  EXPECT_FALSE(kept_out[2].contains({18.9, 1.0, 0.0}));
  EXPECT_FALSE(kept_out[2].contains({0.0, 0.0, 0.0}));
}

/** It has no box about it: then a keep-out about the place is tried. */
TEST(ChangesThatHelp, NoOtherKeepOutGrowsForOneThatLeans)
{
  PlanInput input;
  input.settings.tool_radius = 3.0;
  const Prism leaning({{20.0, 0.0, 0.0}, {22.0, 0.0, 0.0}, {22.0, 4.0, 0.0}, {20.0, 4.0, 0.0}}, {1.0, 0.0, 2.0});
  input.choice.keep_outs = {box(-1.0, 1.0, -2.0, 2.0), leaning};
  const Diagnostic said("by ", Proposed("addKeepOut", 0.5), " {mm} at ", Place({24.0, 1.0, 9.0}), " ({addKeepOut})");
  EXPECT_LT(leaning.distance({24.0, 1.0, 9.0}), 1.0);
  EXPECT_EQ(wordsOf(input, said),
            (std::vector<std::string>{"addKeepOut from (18, -5, 9) to (30, 7, 9)", "addKeepOut from (12, -11, 9) to (36, 13, 9)",
                                      "setToolRadius 2.1", "setToolRadius 1.5"}));
}

TEST(ChangesThatHelp, ValuesAreTriedAsTheyAreShown)
{
  EXPECT_NEAR(roundedDown(1.2399), 1.23, 1e-12);
  EXPECT_NEAR(roundedDown(0.7 * 5.0), 3.5, 1e-12);
  EXPECT_LE(roundedDown(1.9999e-3), 1.9999e-3);
  const Diagnostic parts("{setPartAt} ", Proposed("setPartAt", Vector3d(1.23456, -2.00049, 3.0)));
  const PlanInput changed = singleChanges(PlanInput(), {{StatusCode::Failed, parts}, false}).front().input;
  ASSERT_TRUE(changed.choice.part_at.has_value());
  EXPECT_LT((*changed.choice.part_at - Vector3d(1.235, -2.0, 3.0)).norm(), 1e-12);
  EXPECT_EQ(wordsOf(PlanInput(), Diagnostic(Proposed("setFlankLength", 20.01))), std::vector<std::string>{"setFlankLength 20.1"});
}

TEST(ChangesThatHelp, ALongerToolIsTriedWhereTheHolderCollides)
{
  Spiral planner;
  prepare(disc(), planner);
  planner.setHolder({ToolSegment::cylinder(8.0, 30.0, "chuck")});
  planner.setFlankLength(4.0);
  planner.setTiltAngle(-70.0);
  planner.setRemedyTries(0);
  planner.compute();
  ASSERT_FALSE(planner.getStatus().ok());
  const std::vector<Proposed> proposed = planner.getStatus().diagnostic().proposed();
  ASSERT_EQ(proposed.size(), 1U) << planner.getStatus().message();
  EXPECT_EQ(proposed[0].setting, "setFlankLength");
  EXPECT_GT(std::get<double>(proposed[0].value), 4.0);
  EXPECT_EQ(proposedButNotTried(planner), "");
}

TEST(ChangesThatHelp, ARefusalWithoutACandidateSaysSoAndPlansNothing)
{
  const ScanPtr few(new pcl::PointCloud<pcl::PointXYZ>);
  for (int i = 0; i < 40; ++i)
    few->emplace_back(0.9F * static_cast<float>(i % 7), 0.9F * static_cast<float>(i / 7), 0.0F);
  few->sensor_origin_.head<3>() = Eigen::Vector3f(0.0F, 0.0F, 500.0F); // the side is known
  Spiral planner;
  prepare(few, planner);
  planner.setProgressCallback([](double, const std::string& stage) {
    EXPECT_NE(stage.rfind("trying change", 0), 0U);
    return true;
  });
  planner.compute();
  ASSERT_EQ(planner.getStatus().code(), StatusCode::InvalidInput) << planner.getStatus().message();
  EXPECT_NE(planner.getStatus().message().find("There is no single change of the settings to try"), std::string::npos)
      << planner.getStatus().message();
  planner.setToolRadius(-1.0); // a bad number is refused at once, with its remedy alone
  planner.compute();
  EXPECT_EQ(planner.getStatus().code(), StatusCode::InvalidArgument);
  EXPECT_EQ(planner.getStatus().message().find("single change"), std::string::npos);
}

TEST(ChangesThatHelp, WhereKeepOutsLeaveTooLittleASmallerBallIsTried)
{
  const auto scan = plateWithout([](double, double) { return false; }, 12.0);
  const auto keepOut = [&scan](double gap, Spiral& planner) { // a strip is left between the two
    prepare(scan, planner);
    planner.addKeepOut(box(-13.0, 13.0, 0.5 * gap, 13.0));
    planner.addKeepOut(box(-13.0, 13.0, -13.0, -0.5 * gap));
  };
  Spiral some, hardly, none;
  keepOut(11.0, some);
  EXPECT_NE(added(some).find("one gives a path of"), std::string::npos) << some.getStatus().message();
  EXPECT_EQ(lastNamed(some), "setToolRadius");
  keepOut(8.2, hardly);
  EXPECT_NE(added(hardly).find("none gives a path: setToolRadius 2.1; setToolRadius 1.5"), std::string::npos)
      << hardly.getStatus().message();
  keepOut(7.0, none);
  const std::string of_none = added(none);
  EXPECT_EQ(none.getStatus().code(), StatusCode::InvalidInput);
  EXPECT_NE(none.getStatus().message().find("no point is left"), std::string::npos) << none.getStatus().message();
  EXPECT_NE(of_none.find("none gives a path: setToolRadius 2.1; setToolRadius 1.5"), std::string::npos) << of_none;
}

TEST(ChangesThatHelp, WhatIsTooNarrowIsNotToBeCutIntoPieces)
{
  const Status radial{StatusCode::Failed, "no lines"};
  const auto namesPieces = [&radial](const char* scallop) {
    const std::vector<std::string> named = neitherMethod({StatusCode::Failed, scallop}, radial).diagnostic().settings();
    return std::find(named.begin(), named.end(), "PartRegion") != named.end();
  };
  EXPECT_FALSE(namesPieces("the surface is too narrow for the spacing of its points: {scan more densely}"));
  EXPECT_TRUE(namesPieces("the {scan} is no single sheet there"));
}

TEST(ChangesThatHelp, AChangeOfACroppedInputIsTriedWithTheSurfaceBesideIt)
{
  const ScanPtr scan = plateWithout([](double x, double y) { return std::hypot(x, y) < 5.0; }, 25.0);
  Spiral planner;
  prepare(scan, planner);
  planner.setCrop(box(-18.0, 18.0, -18.0, 18.0));
  planner.setHoleSize(6.0);
  planner.setHoleHandling(HoleHandling::Refuse);
  EXPECT_NE(added(planner).find("one gives a path of"), std::string::npos) << planner.getStatus().message();
}

TEST(ChangesThatHelp, OnlyARefusalThatAsksForAScanNamesWhatItLacks)
{
  PlanInput input;
  const ScanPtr scan = plate(20.0, 0.8);
  scan->erase(std::remove_if(scan->begin(), scan->end(), [](const auto& p) { return std::hypot(p.x, p.y) < 6.0F; }), scan->end());
  input.cloud = scan;
  const Place sparse({0.0, 0.0, 0.0}), dense({12.0, 3.0, 0.0});
  for (const char* remedy : {"{scan it again}", "{scan it again, more densely}", "{scan more densely}"}) {
    const Diagnostic lack = lackOf(input, Diagnostic("at ", sparse, ": ", remedy));
    ASSERT_EQ(lack.places().size(), 1U) << remedy;
    EXPECT_EQ(lack.places()[0], sparse.position);
    EXPECT_TRUE(lackOf(input, Diagnostic("at ", dense, ": ", remedy)).empty()) << remedy;
  }
  for (const char* remedy : {"take a longer tool ({setFlankLength})", "crop the {scan} to the part ({setCrop})", "({addKeepOut})"})
    EXPECT_TRUE(lackOf(input, Diagnostic("at ", sparse, ": ", remedy)).empty()) << remedy;
}

} // namespace changes_that_help_test
