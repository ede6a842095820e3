// SPDX-License-Identifier: BSD-3-Clause
// Refusals of the stages at constant scallop height, each with its remedy; the stages can be cancelled.
#include "support/given_loops.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/spiral/loop_linking.h>
#include <pcl_spiral/spiral/scallop_loops.h>
#include <pcl_spiral/spiral/step_over_field.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace refused_scallop_stages_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

using Point = pcl::PointXYZ;

pcl::PointCloud<Point>::Ptr
disc()
{
  return toCloud(sampleUniform(*flat(Region({circle({0, 0}, 40.0)})), 4000, 3).points);
}

template <typename Stage>
void
setUp(Stage& stage)
{
  stage.setInputCloud(disc());
  stage.setToolRadius(5.0);
  stage.setScallopHeight(0.1);
  stage.setQuiet(true);
}

template <typename Stage, typename Output>
void
expectRefused(Stage& stage, Output& output, const std::string& word)
{
  stage.compute(output);
  EXPECT_FALSE(stage.getStatus().ok()) << word;
  EXPECT_NE(stage.getStatus().message().find(word), std::string::npos) << stage.getStatus().message();
}

/** Of the disc. */
StepOverDistance::ConstPtr
field()
{
  StepOverField<Point> distances;
  setUp(distances);
  StepOverDistance::ConstPtr made;
  distances.compute(made);
  EXPECT_TRUE(made) << distances.getStatus().message();
  return made;
}

} // namespace

TEST(RefusedScallopStages, FieldsOfSettingsThatCannotBe)
{
  StepOverField<Point> distances;
  distances.setQuiet(true);
  StepOverDistance::ConstPtr made;
  expectRefused(distances, made, "tool radius is 0");
  distances.setToolRadius(5.0);
  expectRefused(distances, made, "scallop height is 0");
  distances.setScallopHeight(6.0);
  expectRefused(distances, made, "below the tool radius, which is 5 mm");
  distances.setScallopHeight(0.1);
  expectRefused(distances, made, "setInputCloud");
  distances.setInputCloud(disc());
  distances.setNumberOfThreads(100000);
  expectRefused(distances, made, "setNumberOfThreads");
  distances.setNumberOfThreads(0);
}

TEST(RefusedScallopStages, ABallLargerThanTheScanIsAWarning)
{
  StepOverField<Point> distances;
  setUp(distances);
  distances.setToolRadius(500.0);
  StepOverDistance::ConstPtr made;
  distances.compute(made);
  EXPECT_TRUE(made) << distances.getStatus().message();
  const pcl_spiral::Diagnostics& warnings = distances.getWarnings();
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const pcl_spiral::Diagnostic& w) {
    return w.text().find("less than the tool radius 500 mm: if it is in metres or inches, scale it to mm") != std::string::npos;
  }));
}

TEST(RefusedScallopStages, LoopsThatDoNotBelongToTheSurface)
{
  StepOverField<Point> distances;
  setUp(distances);
  StepOverDistance::ConstPtr made;
  distances.setBoundaryLoops(std::vector<BoundaryLoop>(1));
  expectRefused(distances, made, "0 curve points");
  std::vector<BoundaryLoop> loops = loopsOf(disc());
  loops[0].type = LoopType::Inner;
  distances.setBoundaryLoops(loops);
  expectRefused(distances, made, "none of the loops is an outer one");
  distances.setBoundaryLoops({});
  distances.compute(made);
  EXPECT_TRUE(made) << "the remedy: " << distances.getStatus().message();
}

TEST(RefusedScallopStages, FieldsThatAreNone)
{
  ScallopLoops<Point> closed;
  closed.setQuiet(true);
  ScallopLoopSet set;
  DrivePasses passes;
  expectRefused(closed, set, "tool radius is 0"); // no field: it must be made
  closed.setInputField(std::make_shared<StepOverDistance>());
  expectRefused(closed, set, "the field is empty");
  const auto broken = std::make_shared<StepOverDistance>(*field());
  broken->distance.pop_back();
  closed.setInputField(broken);
  expectRefused(closed, set, "distances, ");
  closed.setInputField(field());
  closed.setNumberOfThreads(100000);
  expectRefused(closed, set, "setNumberOfThreads");
  closed.setNumberOfThreads(0);
  closed.compute(set);
  EXPECT_TRUE(closed.getStatus().ok()) << closed.getStatus().message();
  expectRefused(closed, passes, "tool radius is 0");
  closed.setToolRadius(5.0);
  closed.setScallopHeight(0.1);
  expectRefused(closed, passes, "setInputSurface"); // to put them on
  closed.setTiltAngle(100.0);
  expectRefused(closed, passes, "tilt angle");
}

TEST(RefusedScallopStages, LoopsThatCannotBeLinked)
{
  ScallopLoops<Point> closed;
  closed.setInputField(field());
  ScallopLoopSet set;
  closed.compute(set);
  LoopLinking<Point> linking;
  linking.setQuiet(true);
  LinkedPath path;
  const auto refused = [&](const std::string& word, auto change) {
    std::vector<ScallopLoop> wrong = set.loops;
    change(wrong);
    linking.setInputLoops(wrong);
    expectRefused(linking, path, word);
    EXPECT_TRUE(path.points.empty());
  };
  using Loops = std::vector<ScallopLoop>;
  refused("put the rim first", [](Loops& loops) { std::swap(loops.front(), loops.back()); });
  refused("loop 1 has", [](Loops& loops) { loops[1].metric.pop_back(); });
  refused("call measure", [](Loops& loops) { loops[1].arcs.clear(); });
  refused("at point 2", [](Loops& loops) { loops[1].points[2].x() = NAN; });
  refused("at least three", [](Loops& loops) { loops[2].points.resize(2); });
  linking.setNumberOfThreads(100000);
  refused("setNumberOfThreads", [](Loops&) {});
  linking.setNumberOfThreads(0);
  linking.setInputLoops(set.loops);
  linking.compute(path);
  EXPECT_FALSE(path.points.empty()) << linking.getStatus().message();
}

TEST(RefusedScallopStages, AreCancelled)
{
  const auto expectCancelled = [](auto& stage, auto& output) {
    setUp(stage);
    for (const double at : {0.1, 0.55, 0.7}) {
      stage.setProgressCallback([at](double share, const std::string&) { return share < at; });
      stage.compute(output);
      EXPECT_EQ(stage.getStatus().code(), StatusCode::Cancelled) << at;
    }
  };
  ScallopLoops<Point> loops;
  LoopLinking<Point> linking;
  ScallopLoopSet set;
  DrivePasses passes;
  LinkedPath path;
  expectCancelled(loops, set);
  expectCancelled(loops, passes);
  expectCancelled(linking, path);
  EXPECT_TRUE(set.loops.empty() && passes.empty() && path.points.empty());
}

} // namespace refused_scallop_stages_test
