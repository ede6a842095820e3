// The acceptance table: run one case by name. Exit code 1 when a limit is broken, 2 for a wrong command.
#include "cases.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <string>

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
  all["random"] = judgeRandom;
  all["properties"] = judgeProperties;
  return all;
}

int
usage()
{
  std::fprintf(stderr, "usage: pcl_spiral_acceptance CASE [--seed N] [--threads N] [--first N] [--count N]\ncases:");
  for (const auto& [name, judge] : cases())
    std::fprintf(stderr, " %s", name.c_str());
  std::fprintf(stderr, "\n");
  return 2;
}

} // namespace

int
main(int argc, char** argv)
{
  Options options;
  if (argc < 2 || argc % 2 != 0)
    return usage();
  for (int i = 2; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--seed") == 0)
      options.seed = std::strtoull(argv[i + 1], nullptr, 10);
    else if (std::strcmp(argv[i], "--threads") == 0)
      options.threads = std::atoi(argv[i + 1]);
    else if (std::strcmp(argv[i], "--first") == 0)
      options.first = std::strtoull(argv[i + 1], nullptr, 10);
    else if (std::strcmp(argv[i], "--count") == 0)
      options.count = std::strtoull(argv[i + 1], nullptr, 10);
    else
      return usage();
  }
  const auto all = cases();
  const auto found = all.find(argv[1]);
  if (found == all.end())
    return usage();
  const int broken = found->second(options);
  std::printf("%s: %s\n", argv[1], broken == 0 ? "all limits hold" : "LIMITS BROKEN");
  return broken == 0 ? 0 : 1;
}
