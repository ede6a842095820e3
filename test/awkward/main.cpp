// SPDX-License-Identifier: BSD-3-Clause
// Awkward scans from random parts that are known exactly: every path that is written must be right, and every refusal must say why and
// name a remedy that leads to a right path.
// Exit code 1 if one is wrong, 2 for a wrong command.
#include "scene.h"
#include "trial.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

using namespace pcl_spiral::awkward;

namespace {

struct Command {
  std::vector<std::string> kinds = pcl_spiral::awkward::kinds();
  std::uint64_t seed = 1, first = 0, count = 1;
  double size = 1.0; ///< of the parts: smaller ones are soon done
  std::string keep;  ///< folder for the files
};

bool
take(const std::string& name, const char* value, Command& command)
{
  if (name == "--kind")
    command.kinds = {value};
  else if (name == "--seed")
    command.seed = std::strtoull(value, nullptr, 10);
  else if (name == "--first")
    command.first = std::strtoull(value, nullptr, 10);
  else if (name == "--count")
    command.count = std::strtoull(value, nullptr, 10);
  else if (name == "--size")
    command.size = std::strtod(value, nullptr);
  else if (name == "--keep")
    command.keep = value;
  else
    return false;
  const std::vector<std::string> all = kinds();
  return command.size > 0.4 && std::all_of(command.kinds.begin(), command.kinds.end(),
                                           [&](const std::string& kind) { return std::find(all.begin(), all.end(), kind) != all.end(); });
}

int
usage()
{
  std::fprintf(stderr, "usage: pcl_spiral_awkward [--kind NAME] [--seed N] [--first N] [--count N] [--size SHARE] [--keep FOLDER]\nkinds:");
  for (const std::string& kind : kinds())
    std::fprintf(stderr, " %s", kind.c_str());
  std::fprintf(stderr, "\n--size 0.6 makes the parts smaller, at least 0.5; --keep copies scans and paths there\n");
  return 2;
}

} // namespace

int
main(int argc, char** argv)
{
  Command command;
  for (int i = 1; i < argc; i += 2)
    if (i + 1 == argc || !take(argv[i], argv[i + 1], command))
      return usage();
  std::map<std::string, Counts> counts;
  for (std::uint64_t index = command.first; index < command.first + command.count; ++index)
    for (const std::string& kind : command.kinds) {
      const ScratchFolder folder;
      const Scene scene = makeScene(kind, command.seed, index, command.size);
      writeScan(scene, folder);
      for (const Step& step : scene.steps) {
        tryStep(scene, step, folder, counts[kind]);
        if (!command.keep.empty())
          std::filesystem::copy(folder.root(), command.keep,
                                std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
        std::filesystem::remove(folder.path("path.csv"));
      }
    }
  std::size_t wrong = 0;
  std::printf("kind     paths refusals dead ends wrong\n");
  for (const auto& [kind, count] : counts) {
    std::printf("%-8s %5zu %8zu %9zu %5zu\n", kind.c_str(), count.paths, count.refusals, count.dead_ends, count.wrong);
    wrong += count.wrong;
  }
  return wrong == 0 ? 0 : 1;
}
