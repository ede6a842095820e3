// SPDX-License-Identifier: BSD-3-Clause
// Awkward scans from random parts that are known exactly: every path that is written must be right, and every refusal must say why.
// Exit code 1 if one is wrong, 2 for a wrong command.
#include "judge.h"
#include "scene.h"

#include "command_line/run_program.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iomanip>
#include <map>
#include <sstream>

using namespace pcl_spiral::awkward;

namespace {

/** The scan in its file. */
void
writeScan(const Scene& s, const ScratchFolder& folder)
{
  const std::size_t count = s.scan.points.size();
  const bool ply = s.file == "scan.ply";
  std::ostringstream text;
  text << std::setprecision(12);
  if (ply)
    text << "ply\nformat ascii 1.0\nelement vertex " << count << "\nproperty float x\nproperty float y\nproperty float z\n"
         << "property float nx\nproperty float ny\nproperty float nz\nend_header\n";
  if (s.file == "scan.pcd")
    text << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << count << "\nHEIGHT 1\nVIEWPOINT "
         << s.view_point.transpose() << " 1 0 0 0\nPOINTS " << count << "\nDATA ascii\n";
  for (std::size_t i = 0; i < count; ++i) {
    text << (s.motion * s.scan.points[i] / s.unit).transpose();
    if (ply)
      text << ' ' << (s.motion.linear() * s.scan.normals[i]).transpose();
    text << '\n';
  }
  writeText(folder.path(s.file), text.str());
  std::ostringstream loop;
  loop << std::setprecision(12);
  for (const Eigen::Vector2d& p : s.keep_out)
    loop << (s.motion * Eigen::Vector3d(p.x(), p.y(), 0.0) / s.unit).head<2>().transpose() << '\n';
  if (!s.keep_out.empty())
    writeText(folder.path("keep.txt"), loop.str());
}

/** Whether \p text holds one of the choices of \p word, such as "sheet|part". */
bool
told(const std::string& text, const std::string& word)
{
  std::istringstream choices(word);
  for (std::string choice; std::getline(choices, choice, '|');)
    if (text.find(choice) != std::string::npos)
      return true;
  return false;
}

/** What is wrong with one run; prints what the program said if something is. */
bool
holds(const Scene& scene, const Step& step, const ScratchFolder& folder)
{
  std::vector<std::string> arguments{scene.file, "--tool-radius", std::to_string(scene.radius), "--scallop", std::to_string(scene.scallop),
                                     "-o",       "path.csv"};
  arguments.insert(arguments.end(), step.arguments.begin(), step.arguments.end());
  const RunResult run = endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments, folder), folder);
  const std::string said = run.out + run.err;
  std::vector<std::string> faults;
  if (run.code != 0 && run.code != 1 && run.code != 2)
    faults.push_back("exit code " + std::to_string(run.code));
  if (run.code == 0 && step.outcome == Outcome::Refusal)
    faults.push_back("a path where a refusal was expected");
  if (run.code != 0 && step.outcome == Outcome::Path)
    faults.push_back("refused");
  if (run.code == 0)
    for (const std::string& fault : faultsOf(scene, folder.path("path.csv")))
      faults.push_back(fault);
  if (run.code != 0 || step.outcome != Outcome::PathOrRefusal)
    for (const std::string& word : step.words)
      if (!told(said, word))
        faults.push_back("not said: " + word);
  std::printf("%-14s %-9s", scene.name.c_str(), run.code == 0 ? "path" : "refusal");
  for (const std::string& argument : step.arguments)
    std::printf(" %s", argument.c_str());
  std::printf("%s\n", faults.empty() ? "" : "  WRONG");
  for (const std::string& fault : faults)
    std::printf("    %s\n", fault.c_str());
  if (!faults.empty())
    std::printf("%s\n", said.c_str());
  std::fflush(stdout);
  return faults.empty();
}

struct Command {
  std::vector<std::string> kinds = pcl_spiral::awkward::kinds();
  std::uint64_t seed = 1, first = 0, count = 1;
  std::string keep; ///< folder for the files of the first case
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
  else if (name == "--keep")
    command.keep = value;
  else
    return false;
  const std::vector<std::string> all = kinds();
  return std::all_of(command.kinds.begin(), command.kinds.end(),
                     [&](const std::string& kind) { return std::find(all.begin(), all.end(), kind) != all.end(); });
}

int
usage()
{
  std::fprintf(stderr, "usage: pcl_spiral_awkward [--kind NAME] [--seed N] [--first N] [--count N] [--keep FOLDER]\nkinds:");
  for (const std::string& kind : kinds())
    std::fprintf(stderr, " %s", kind.c_str());
  std::fprintf(stderr, "\n--keep copies scans and paths there\n");
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
  std::size_t runs = 0, wrong = 0;
  for (std::uint64_t index = command.first; index < command.first + command.count; ++index)
    for (const std::string& kind : command.kinds) {
      const ScratchFolder folder;
      const Scene scene = makeScene(kind, command.seed, index);
      writeScan(scene, folder);
      for (const Step& step : scene.steps) {
        ++runs;
        wrong += !holds(scene, step, folder);
        if (!command.keep.empty())
          std::filesystem::copy(folder.root(), command.keep,
                                std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
        std::filesystem::remove(folder.path("path.csv"));
      }
    }
  std::printf("%zu runs, %zu wrong\n", runs, wrong);
  return wrong == 0 ? 0 : 1;
}
