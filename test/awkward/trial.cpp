// SPDX-License-Identifier: BSD-3-Clause
#include "trial.h"

#include "judge.h"
#include "remedies.h"

#include "command_line/run_program.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iomanip>
#include <sstream>

namespace pcl_spiral::awkward {
namespace {

using Arguments = std::vector<std::string>;

constexpr int most_remedies = 4; // one after the other

RunResult
run(const Scene& scene, const Arguments& more, const ScratchFolder& folder)
{
  Arguments arguments{scene.file, "--tool-radius", std::to_string(scene.radius), "--scallop", std::to_string(scene.scallop),
                      "-o",       "path.csv"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return endOf(startProgram(PCL_SPIRAL_TOOLPATH_PROGRAM, arguments, folder), folder);
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

/** What a user tries after a refusal. */
class Followed {
public:
  Followed(const Scene& scene, const ScratchFolder& folder) : scene_(scene), folder_(folder) {}

  /** Tries each remedy of \p said, the first refusal; of later refusals only until one leads to a path. */
  void follow(const Scene& scene, const Arguments& arguments, const std::string& said, const std::string& chain, int depth)
  {
    const std::vector<Remedy> remedies = remediesOf(scene_, arguments, said, "r" + std::to_string(tried_.size()) + "_", folder_);
    const std::size_t so_far = paths_;
    for (const Remedy& remedy : remedies) {
      if (remedy.name == "--tilt 0" && std::find(arguments.begin(), arguments.end(), "--tilt") != arguments.end())
        continue; // done before
      if (depth > 0 && paths_ > so_far)
        return;
      const std::size_t before = paths_;
      tryOne(scene, arguments, remedy, chain + " > " + remedy.name, depth);
      if (depth == 0 && paths_ == before)
        ++dead_ends_;
    }
  }

  const std::vector<std::string>& tried() const { return tried_; }
  std::size_t paths() const { return paths_; }
  std::size_t deadEnds() const { return dead_ends_; }
  std::vector<std::string> faults() const
  {
    std::vector<std::string> all = faults_;
    if (paths_ == 0)
      all.push_back("no remedy leads to a path");
    return all;
  }

private:
  void tryOne(const Scene& refused, Arguments arguments, const Remedy& remedy, const std::string& chain, int depth)
  {
    if (const auto before = std::find(arguments.begin(), arguments.end(), "--part-at");
        remedy.name == "--part-at" && before != arguments.end())
      arguments.erase(before, before + 2); // another place
    arguments.insert(arguments.end(), remedy.arguments.begin(), remedy.arguments.end());
    Scene scene = refused;
    if (remedy.radius > 0.0)
      scene.radius = remedy.radius;
    if (remedy.scallop > 0.0)
      scene.scallop = remedy.scallop;
    const RunResult result = run(scene, arguments, folder_);
    tried_.push_back(chain + ": " + (result.code == 0 ? "path" : "refused"));
    if (result.code == 0) {
      ++paths_;
      for (const std::string& fault : faultsOf(scene, folder_.path("path.csv"), told(chain, "--keep-out")))
        faults_.push_back(chain + ": " + fault + "\n" + result.out + result.err);
      return;
    }
    tried_.back() += "\n" + result.err;
    if (depth + 1 < most_remedies)
      follow(scene, arguments, result.err, chain, depth + 1);
  }

  const Scene& scene_;
  const ScratchFolder& folder_;
  std::vector<std::string> tried_, faults_;
  std::size_t paths_ = 0, dead_ends_ = 0;
};

void
print(const Scene& scene, const Step& step, bool path, const std::vector<std::string>& faults, double seconds)
{
  std::printf("%-14s %-8s %6.1f s", scene.name.c_str(), path ? "path" : "refusal", seconds);
  for (const std::string& argument : step.arguments)
    std::printf(" %s", argument.c_str());
  std::printf("%s\n", faults.empty() ? "" : "  WRONG");
  for (const std::string& fault : faults)
    std::printf("    %s\n", fault.c_str());
}

} // namespace

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

void
tryStep(const Scene& scene, const Step& step, const ScratchFolder& folder, Counts& counts)
{
  const auto begin = std::chrono::steady_clock::now();
  const RunResult result = run(scene, step.arguments, folder);
  const std::string said = result.out + result.err;
  const bool path = result.code == 0;
  std::vector<std::string> faults;
  if (!path && result.code != 1 && result.code != 2)
    faults.push_back("exit code " + std::to_string(result.code));
  if (path && step.outcome == Outcome::Refusal)
    faults.push_back("a path where a refusal was expected");
  if (!path && step.outcome == Outcome::Path)
    faults.push_back("refused");
  if (path)
    for (const std::string& fault : faultsOf(scene, folder.path("path.csv"), !scene.keep_out.empty()))
      faults.push_back(fault);
  if (!path || step.outcome != Outcome::PathOrRefusal)
    for (const std::string& word : step.words)
      if (!told(said, word))
        faults.push_back("not said: " + word);
  Followed followed(scene, folder);
  if (!path) {
    followed.follow(scene, step.arguments, result.err, "", 0);
    for (const std::string& fault : followed.faults())
      faults.push_back(fault);
  }
  print(scene, step, path, faults, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  if (!faults.empty())
    std::printf("%s\n", said.c_str());
  if (!faults.empty() || followed.deadEnds() > 0)
    for (const std::string& tried : followed.tried())
      std::printf("   %s\n", tried.c_str());
  std::fflush(stdout);
  counts.dead_ends += followed.deadEnds();
  ++(!faults.empty() ? counts.wrong : path ? counts.paths : counts.refusals);
}

} // namespace pcl_spiral::awkward
