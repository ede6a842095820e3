// SPDX-License-Identifier: BSD-3-Clause
// A refused plan names the change that gives a path, tried by the planner itself: scans for which it is known which one that is.
#include "planning/single_change.h"
#include "planning/told_values.h"

#include "support/spiral_jobs.h"
#include "support/tight_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

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

TEST(ChangesThatHelp, TheRadiusToldFitsAGroove)
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
  const double told = ball->input.settings.tool_radius;
  EXPECT_LE(told, fillet);
  EXPECT_GT(1.3 * told, fillet);
  EXPECT_TRUE(statusWith(told).ok()) << statusWith(told).message();
  EXPECT_FALSE(statusWith(1.3 * told).ok());
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

TEST(ChangesThatHelp, LessThanNoSearchIsRefused)
{
  Spiral planner;
  prepare(plate(), planner);
  planner.setRemedyTries(-1);
  planner.compute();
  EXPECT_EQ(planner.getStatus().code(), StatusCode::InvalidArgument);
  EXPECT_EQ(lastNamed(planner), "setRemedyTries");
}

TEST(ChangesThatHelp, ValuesAreReadByTheirWords)
{
  const Vector3d a(1, 5, 0), b(3, 2, 1), c(9, 9, 9);
  const Diagnostic said("2 things at ", Place(c), ": from ", Place(a), " to ", Place(b), ", hollow with radius ", 1.5,
                        " {mm}: a radius of ", 1.234, " {mm} fits; ", 7.0, " {mm2} at ", Place(b));
  EXPECT_EQ(numberBehind(said, {"a radius of "}), 1.234);
  EXPECT_EQ(numberBehind(said, {"thin to ", "hollow with radius "}), 1.5);
  EXPECT_EQ(numberBehind(said, {"thin to "}), 0.0);
  ASSERT_EQ(extentsOf(said).size(), 1U);
  EXPECT_EQ(extentsOf(said)[0].min(), Vector3d(1, 2, 0));
  EXPECT_EQ(extentsOf(said)[0].max(), Vector3d(3, 5, 1));
  ASSERT_EQ(placesBehind(said, "{mm2} at ").size(), 1U);
  EXPECT_EQ(placesBehind(said, "{mm2} at ")[0], b);
  EXPECT_TRUE(uprightPrism(extentsOf(said)[0]).contains({2, 3, 77}));
  EXPECT_FALSE(uprightPrism(extentsOf(said)[0]).contains({0.5, 3, 0}));
  EXPECT_NEAR(roundedDown(1.2399), 1.23, 1e-12);
  EXPECT_NEAR(roundedDown(0.7 * 5.0), 3.5, 1e-12);
  EXPECT_LE(roundedDown(1.9999e-3), 1.9999e-3);
}

} // namespace changes_that_help_test
