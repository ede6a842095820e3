// SPDX-License-Identifier: BSD-3-Clause
// The acceptance table: runs one case by name. Exit code 1 if a limit is broken, 2 for a wrong command.
#include "cases.h"
#include "outline_rows.h"

#include "io/setting_names.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <string>

using namespace pcl_spiral;
using namespace pcl_spiral::acceptance;

namespace {

std::map<std::string, std::function<int(const Options&)>>
cases()
{
  std::map<std::string, std::function<int(const Options&)>> all;
  for (const Job& row : jobs()) {
    all[row.name] = [row](const Options& options) { return judge(row, options); };
    all[row.name + "_invariance"] = [row](const Options& options) { return judgeInvariance(row, options); };
  }
  for (const Job& row : secondCloudJobs())
    all[row.name] = [row](const Options& options) { return judgeBySecondCloud(row, options); };
  all["bowl_refusal"] = judgeRefusal;
  all["bad_input"] = judgeBadInput;
  all["geodesics"] = judgeGeodesics;
  all["loops"] = judgeLoops;
  all["lines"] = judgeLines;
  all["uneven"] = judgeUneven;
  all["passes"] = judgePasses;
  all["outliers"] = judgeOutliers;
  all["noise"] = judgeNoise;
  all["field"] = judgeField;
  all["time"] = judgeTime;
  all["meshes"] = judgeMeshes;
  all["noisy_meshes"] = judgeNoisyMeshes;
  all["mesh_rows"] = judgeMeshRows;
  all["outlines"] = judgeOutlines;
  all["random"] = judgeRandom;
  all["alarms"] = judgeAlarms;
  all["steps"] = judgeSteps;
  all["properties"] = judgeProperties;
  return all;
}

int
usage()
{
  std::fprintf(
      stderr,
      "usage: pcl_spiral_acceptance CASE [--seed N] [--threads N] [--first N] [--count N]\n"
      "       pcl_spiral_acceptance random [--method %s] [--seed N] [--first N] [--count N]\n"
      "       pcl_spiral_acceptance outlines [--method %s] [--only NAME,NAME] [--variation N]\n"
      "         [--scallop MM] [--points N] [--size SCALE] [--picture FOLDER] [--places 0|1] [--one-way 0|1] [--seed N] [--threads N]\n"
      "cases:",
      choiceList<SpiralMethod>().c_str(), choiceList<SpiralMethod>().c_str());
  for (const auto& [name, judge] : cases())
    std::fprintf(stderr, " %s", name.c_str());
  std::fprintf(stderr, "\noutlines:");
  for (const OutlineRow& row : outlineRows())
    std::fprintf(stderr, " %s", row.name.c_str());
  std::fprintf(stderr, "\n");
  return 2;
}

/** Reads one option; false if there is none of that name. */
bool
take(const std::string& name, const char* value, Options& options)
{
  const std::map<std::string, std::uint64_t*> counts{
      {"--seed", &options.seed}, {"--first", &options.first}, {"--count", &options.count}, {"--variation", &options.variation}};
  const std::map<std::string, double*> numbers{{"--scallop", &options.scallop}, {"--size", &options.size}};
  const std::map<std::string, std::string*> words{
      {"--method", &options.method}, {"--only", &options.only}, {"--picture", &options.picture}};
  if (counts.count(name) > 0)
    *counts.at(name) = std::strtoull(value, nullptr, 10);
  else if (numbers.count(name) > 0)
    *numbers.at(name) = std::strtod(value, nullptr);
  else if (words.count(name) > 0)
    *words.at(name) = value;
  else if (name == "--threads")
    options.threads = std::atoi(value);
  else if (name == "--places")
    options.places = std::strcmp(value, "1") == 0;
  else if (name == "--one-way")
    options.one_way = std::strcmp(value, "1") == 0;
  else if (name == "--points")
    options.points = std::strtoull(value, nullptr, 10);
  else
    return false;
  return true;
}

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  if (argc < 2 || argc % 2 != 0)
    return usage();
  for (int i = 2; i + 1 < argc; i += 2)
    if (!take(argv[i], argv[i + 1], options))
      return usage();
  const auto all = cases();
  const auto found = all.find(argv[1]);
  if (found == all.end())
    return usage();
  const int broken = found->second(options);
  std::printf("%s: %s\n", argv[1], broken == 0 ? "all limits hold" : "LIMITS BROKEN");
  return broken == 0 ? 0 : 1;
}
