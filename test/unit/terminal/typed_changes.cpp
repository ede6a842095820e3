// SPDX-License-Identifier: BSD-3-Clause
// A change that a refusal names can be typed as it stands: the options' reader makes the input of it that the planner tried.
#include "planning/plan_regions.h"
#include "planning/single_change.h"
#include "support/typed_words.h"
#include "terminal/idle_options.h"
#include "terminal/vocabulary.h"
#include "toolpath/command_line.h"

#include <pcl_spiral/spiral/impl/settings_check.h>

#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace typed_changes_test {
namespace {

using namespace pcl_spiral;
using Eigen::Vector3d;
using Words = std::vector<std::string>;

const Words usual{"pcl_spiral_toolpath", "scan.xyz", "-o",       "path.csv", "--tool-radius",  "5",
                  "--scallop",           "0.1",      "--holder", "6,40",     "--flank-length", "20"};

Job
parsed(const Words& words)
{
  std::vector<const char*> arguments;
  for (const std::string& word : words)
    arguments.push_back(word.c_str());
  return parseCommandLine(static_cast<int>(arguments.size()), arguments.data());
}

/** The input of a planner, in the coordinates of the scan. */
PlanInput
inputOf(const Job& job)
{
  PlanInput input;
  input.settings = job.settings;
  input.choice = choiceOf(job.part, job.read);
  input.regions = planRegions(regionsOf(job.part, job.regions, job.read), job.read);
  chooseOnly(input.regions, input.choice);
  input.ball_closing = job.ball_closing;
  input.flank_length = job.flank_length;
  input.asked = askedNames(job.given);
  return input;
}

void
expectSame(const PlanInput& a, const PlanInput& b, const std::string& words)
{
  SpiralSettings of_a = a.settings, of_b = b.settings;
  const std::vector<Setting> table_a = settingTable(of_a), table_b = settingTable(of_b);
  for (std::size_t i = 0; i < table_a.size(); ++i)
    EXPECT_EQ(textOf(table_a[i]), textOf(table_b[i])) << table_a[i].name << " by " << words;
  EXPECT_EQ(a.ball_closing, b.ball_closing) << words;
  EXPECT_NEAR(a.flank_length, b.flank_length, 1e-9) << words;
  EXPECT_EQ(a.choice.clusters, b.choice.clusters) << words;
  ASSERT_EQ(a.choice.part_at.has_value(), b.choice.part_at.has_value()) << words;
  if (a.choice.part_at)
    EXPECT_LT((*a.choice.part_at - *b.choice.part_at).norm(), 1e-3) << words; // as shown
  ASSERT_EQ(a.choice.keep_outs.size(), b.choice.keep_outs.size()) << words;
  for (std::size_t k = 0; k < a.choice.keep_outs.size(); ++k) {
    const std::vector<Vector3d> corners = a.choice.keep_outs[k].outline(1e9), others = b.choice.keep_outs[k].outline(1e9);
    ASSERT_EQ(corners.size(), others.size()) << words;
    for (std::size_t i = 0; i < corners.size(); ++i)
      EXPECT_LT((corners[i] - others[i]).norm(), 1e-4) << words; // twelve digits of inches
  }
}

/** Types each change of the input of \p command that a refusal may name; the options that they have. */
std::set<std::string>
typeEach(const Words& command)
{
  PlanInput input = inputOf(parsed(command));
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int i = 0; i < 100; ++i)
    cloud->emplace_back(static_cast<float>(i), 0.0F, 0.0F);
  cloud->sensor_origin_.head<3>() = Eigen::Vector3f(0.0F, 0.0F, 500.0F);
  input.cloud = cloud;
  const Diagnostic said(
      "at ", Place({1.23456, 2.0, 3.0}), " parts ", Proposed("setPartAt", Vector3d(-12.3456, 7.0, 0.0004)), " and ",
      Proposed("setPartAt", Vector3d(-1.0, 0.0, 0.0)), ", things ",
      Proposed("addKeepOut", Vector3d(-3.00004, 1.0, 2.0), Vector3d(4.5, 6.78912, 2.0)), " and ",
      Proposed("addKeepOut", Vector3d(40.0, 1.0, 2.0), Vector3d(44.0, 6.0, 2.0)), ", thin to ", Proposed("setThinning", 0.123456),
      ", a radius of ", Proposed("setToolRadius", 1.98765), ", ", Proposed("setFlankLength", 33.321),
      " ({setMethod}, {setSense}, {setScallopHeight}, {setTiltAngle}, {setBoundaryMode}, {setHoleHandling}, {setHoleSize}, "
      "{setPartAt}, {addKeepOut}, {setGapHandling}, {setClusterHandling(ClusterHandling::Ride)})");
  std::set<std::string> options;
  for (const SingleChange& change : singleChanges(input, {{StatusCode::Failed, said}, true})) {
    if (!checkSettings(change.input.settings).ok())
      continue; // two settings that the library refuses together: there is no path
    const std::string words = inWords(change.words.all());
    expectSame(inputOf(parsed(test::typedChange(command, words))), change.input, words);
    std::istringstream text(words);
    for (std::string word; text >> word;)
      if (word.rfind("--", 0) == 0)
        options.insert(word.substr(0, word.find(',')));
  }
  return options;
}

} // namespace

TEST(TypedChanges, GiveWhatWasTried)
{
  std::set<std::string> options;
  for (const Words& more : {Words{"--tilt", "20", "--boundaries", "all", "--hole-size", "4", "--sense", "cw"},
                            Words{"--holes", "refuse", "--hole-size", "4", "--gaps", "refuse"}}) {
    Words command = usual;
    command.insert(command.end(), more.begin(), more.end());
    setScanFrame(Vector3d::Zero(), readFindingOrigin());
    options.merge(typeEach(command));
  }
  const std::set<std::string> expected{"--ball-closing", "--boundaries", "--clusters", "--flank-length", "--gaps",
                                       "--hole-size",    "--holes",      "--keep-out", "--method",       "--part-at",
                                       "--scallop",      "--sense",      "--thin",     "--tilt",         "--tool-radius"};
  EXPECT_EQ(options, expected);
}

/** The program refuses these beside the closing, and so no message names it. */
TEST(TypedChanges, TheClosingIsNotNamedBesideWhatItRefuses)
{
  const std::vector<Words> refused{{"--verify"},
                                   {"--max-gouge", "0.1"},
                                   {"--max-scallop", "1"},
                                   {"--max-uncut", "1"},
                                   {"--max-deviation", "1"},
                                   {"--raw-scan", "raw.xyz"},
                                   {"--reach", "reach.ply"}};
  for (const Words& more : refused) {
    Words command = usual;
    command.insert(command.end(), more.begin(), more.end());
    EXPECT_EQ(typeEach(command).count("--ball-closing"), 0U) << more.front();
    command.push_back("--ball-closing");
    EXPECT_THROW(parsed(command), UsageError) << more.front();
  }
  EXPECT_EQ(typeEach(usual).count("--ball-closing"), 1U);
}

TEST(TypedChanges, TwoTogetherArePastedAsTheyStand)
{
  const PlanInput input = inputOf(parsed(usual));
  const auto changesOf = [](const PlanInput& of, const Diagnostic& said) { return singleChanges(of, {{StatusCode::Failed, said}, false}); };
  const std::vector<SingleChange> first =
      changesOf(input, Diagnostic("{addKeepOut}: ", Proposed("addKeepOut", Vector3d(-3.0, 1.0, 2.0), Vector3d(4.5, 6.75, 2.0)), ", ",
                                  Proposed("addKeepOut", Vector3d(40.0, 1.0, 2.0), Vector3d(44.0, 6.0, 2.0))));
  ASSERT_EQ(first.size(), 1U);
  const std::vector<SingleChange> second = changesOf(first[0].input, "{setMethod}");
  ASSERT_FALSE(second.empty());
  const ChangeWords both = together(first[0].words, second[0].words);
  const std::string words = inWords(both.all());
  EXPECT_EQ(words, "--keep-out -3,4.5,1,6.75 --keep-out 40,44,1,6 --method radial");
  expectSame(inputOf(parsed(test::typedChange(usual, words))), second[0].input, words);
  EXPECT_EQ(both.changes, 2);
  const ChangeWords largest{"{setLargestPart(true)}"}, closed{"{setBallClosing(true)}", "with a fixed tool axis"},
      usual_holes{{}, "without {setHoleHandling}"};
  EXPECT_EQ(inWords(together(closed, largest).all()), "--ball-closing --largest, with a fixed tool axis");
  EXPECT_EQ(inWords(together(usual_holes, largest).all()), "--largest, without --holes");
  EXPECT_EQ(inWords(together(usual_holes, {{}, "without {setTiltAngle}"}).all()), "without --holes, without --tilt");
}

TEST(TypedChanges, PlacesAreInTheCoordinatesOfTheFile)
{
  Words command = usual;
  const Words more{"--units", "inch", "--origin", "393775,3689071,0"};
  command.insert(command.end(), more.begin(), more.end());
  const Job job = parsed(command);
  setScanFrame(Vector3d(1000.0, 2000.0, 0.0), job.read);
  EXPECT_GE(typeEach(command).size(), 8U);
  setScanFrame(Vector3d::Zero(), readFindingOrigin());
}

} // namespace typed_changes_test
