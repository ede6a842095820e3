// SPDX-License-Identifier: BSD-3-Clause
// Refused inputs, and a user who does what the messages say, word by word: within three commands there is a path that is right by the raw
// points, or a refusal that says that nothing but another scan helps.
// Exit code 1 if one ends in another way, or in another than --end says; 2 for a wrong command.
#include "refused_input.h"
#include "user.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>

using namespace pcl_spiral::followed;

namespace {

constexpr const char* ends[] = {"at once", "right", "wrong", "reported", "dead end", "loop"};

struct Choice {
  std::vector<std::string> kinds = pcl_spiral::followed::kinds();
  std::uint64_t seed = 1, first = 0, count = 1;
  std::string program = PCL_SPIRAL_TOOLPATH_PROGRAM;
  bool all = false; ///< tell each story, not only the bad ones
  std::string end;  ///< that each must have; empty: any good one

  bool isBad(End reached) const
  {
    if (!end.empty())
      return end != ends[static_cast<int>(reached)];
    return reached == End::Wrong || reached == End::DeadEnd || reached == End::Loop;
  }
};

bool
take(const std::string& name, const char* value, Choice& choice)
{
  if (name == "--kind")
    choice.kinds = {value};
  else if (name == "--seed")
    choice.seed = std::strtoull(value, nullptr, 10);
  else if (name == "--first")
    choice.first = std::strtoull(value, nullptr, 10);
  else if (name == "--count")
    choice.count = std::strtoull(value, nullptr, 10);
  else if (name == "--program")
    choice.program = value;
  else if (name == "--end")
    choice.end = value;
  else if (name == "--stories")
    choice.all = std::string(value) == "all";
  else
    return false;
  const std::vector<std::string> all = kinds();
  const bool has_end = choice.end.empty() || std::find(std::begin(ends), std::end(ends), choice.end) != std::end(ends);
  return has_end && std::find(all.begin(), all.end(), choice.kinds.front()) != all.end();
}

void
print(const RefusedInput& input, const Followed& done, bool whole)
{
  std::printf("%-16s %-8s %zu commands%s, first %.1f s\n", input.name.c_str(), ends[static_cast<int>(done.end)], done.commands,
              done.planner_named ? ", change tried" : "", done.seconds.front());
  if (whole)
    for (const std::string& line : done.story)
      std::printf("    %s\n", line.c_str());
  std::fflush(stdout);
}

} // namespace

int
main(int argc, char** argv)
{
  Choice choice;
  for (int i = 1; i < argc; i += 2)
    if (i + 1 == argc || !take(argv[i], argv[i + 1], choice)) {
      std::fprintf(stderr, "usage: pcl_spiral_followed [--kind NAME] [--seed N] [--first N] [--count N] [--program FILE] [--stories all] "
                           "[--end NAME]\n");
      return 2;
    }
  std::map<std::string, std::map<End, std::size_t>> counts;
  std::size_t bad = 0;
  for (const std::string& kind : choice.kinds)
    for (std::uint64_t index = choice.first; index < choice.first + choice.count; ++index) {
      const ScratchFolder folder;
      const RefusedInput input = makeInput(kind, choice.seed, index);
      const Followed done = follow(input, choice.program, folder);
      const bool is_bad = choice.isBad(done.end);
      ++counts[kind][done.end];
      bad += is_bad ? 1 : 0;
      print(input, done, is_bad || choice.all);
    }
  std::printf("%-9s", "kind");
  for (const char* end : ends)
    std::printf(" %8s", end);
  std::printf("\n");
  for (auto& [kind, of] : counts) {
    std::printf("%-9s", kind.c_str());
    for (int i = 0; i < 6; ++i)
      std::printf(" %8zu", of[static_cast<End>(i)]);
    std::printf("\n");
  }
  return bad == 0 ? 0 : 1;
}
