// SPDX-License-Identifier: BSD-3-Clause
// Time and memory of the stages of a run: in the report, on the terminal.
#include "cap_scan.h"
#include "run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <sstream>

namespace stages_test {

namespace {

using Json = nlohmann::ordered_json; // keeps the order of the file
using Names = std::vector<std::string>;

const Names radial_chain{"reading",   "surface", "boundaries", "reach of the ball", "radial lines", "spiral", "projection",
                         "tool axis", "path",    "writing"};
const Names scallop_chain{"reading",         "surface",       "boundaries", "reach of the ball",
                          "step-over field", "scallop loops", "linking",    "coverage",
                          "projection",      "tool axis",     "path",       "writing"};

struct MadeRun {
  RunResult result;
  Json report;
  double seconds = 0.0; ///< measured from outside
};

MadeRun
makePath(ScratchFolder& folder, const Names& more)
{
  writeText(folder.path("cap.xyz"), capScan(20000));
  Names arguments{"cap.xyz", "--tool-radius", "3", "--scallop", "0.1", "-o", "a.json", "-o", "a.csv"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  MadeRun made;
  const auto begin = std::chrono::steady_clock::now();
  made.result = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments, folder), folder);
  made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_EQ(made.result.code, 0) << made.result.err;
  made.report = Json::parse(readText(folder.path("a.json")));
  return made;
}

Names
namesOf(const Json& stages)
{
  Names names;
  for (const auto& [name, value] : stages.items())
    names.push_back(name);
  return names;
}

} // namespace

class StagesOf : public ::testing::TestWithParam<std::pair<const char*, Names>> {};

TEST_P(StagesOf, ReportHasTimeAndMemoryOfTheWholeRun)
{
  const Names& chain = GetParam().second;
  ScratchFolder folder;
  const MadeRun made = makePath(folder, {"--method", GetParam().first});
  const Json& seconds = made.report.at("seconds");
  EXPECT_EQ(namesOf(seconds.at("stages")), chain) << "in the order they ran, the writing of the path among them";
  double sum = 0.0;
  for (const auto& [name, value] : seconds.at("stages").items()) {
    EXPECT_GE(value.get<double>(), 0.0) << name;
    sum += value.get<double>();
  }
  EXPECT_NEAR(seconds.at("total").get<double>(), sum, 1e-9);
  EXPECT_LT(sum, made.seconds);
  EXPECT_GT(sum, 0.3 * made.seconds) << "the stages are what takes time";

  const Json& memory = made.report.at("memory");
  ASSERT_EQ(namesOf(memory.at("stages")), chain);
  double before = 0.0;
  for (const auto& [name, value] : memory.at("stages").items()) {
    const double resident = value.at("resident").get<double>(), peak = value.at("peak").get<double>();
    EXPECT_GT(resident, 1.0) << name;
    EXPECT_LE(resident, peak + 1.0) << name;
    EXPECT_GE(peak, before - 1.0) << name << ": a peak never falls, but by what the system counts late";
    before = peak;
  }
  EXPECT_EQ(memory.at("peak").get<double>(), before);
  const double counted = 1e-6 * static_cast<double>(made.result.peak_memory);
  EXPECT_NEAR(before, counted, 0.1 * counted) << "as the system counted from outside";
  EXPECT_EQ(made.report.at("units").at("memory"), "MB");
}

TEST_P(StagesOf, VerboseShowsThemAsATable)
{
  ScratchFolder folder;
  const MadeRun made = makePath(folder, {"--verbose", "--verify", "--method", GetParam().first});
  std::istringstream out(made.result.out);
  std::string line;
  while (std::getline(out, line) && line.find("peak MB") == std::string::npos)
    ;
  double percent = 0.0;
  Names names;
  while (std::getline(out, line) && line.rfind("  ", 0) == 0) {
    names.push_back(line.substr(2, line.find("  ", 2) - 2));
    std::istringstream values(line.substr(2 + names.back().size()));
    double seconds = -1.0, share = -1.0, resident = -1.0, peak = -1.0;
    ASSERT_TRUE(values >> seconds >> share) << line;
    percent += share;
    const Json& stages = made.report.at("seconds").at("stages");
    if (!stages.contains(names.back()))
      continue;
    EXPECT_NEAR(seconds, stages.at(names.back()).get<double>(), 0.0051) << line;
    ASSERT_TRUE(values >> resident >> peak) << line;
    EXPECT_NEAR(peak, made.report.at("memory").at("stages").at(names.back()).at("peak").get<double>(), 0.51) << line;
  }
  Names expected = GetParam().second;
  expected.insert(expected.end(), {"judging", "the rest"});
  EXPECT_EQ(names, expected) << made.result.out;
  EXPECT_NEAR(percent, 100.0, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Methods, StagesOf,
                         ::testing::Values(std::make_pair("radial", radial_chain), std::make_pair("constant-scallop", scallop_chain)));

TEST(Stages, SaidOnlyWhenAskedFor)
{
  ScratchFolder folder;
  EXPECT_EQ(makePath(folder, {}).result.out.find("peak MB"), std::string::npos);
  EXPECT_EQ(makePath(folder, {"--quiet", "--verbose"}).result.out, "");
}

} // namespace stages_test
