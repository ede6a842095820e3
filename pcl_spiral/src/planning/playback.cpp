// SPDX-License-Identifier: BSD-3-Clause
#include "planning/playback.h"

#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/machine/motion_time.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr double least_shallow = 0.2; // in scallop heights: where rays start, as those of the judge

/** The tool at each point of the path; a ball without axes stands along the normals. */
ToolPoses
posesOn(const PlaybackInput& input)
{
  ToolPoses poses = ballPoses(*input.path, input.cutter.radius);
  const CutterProfile profile(input.cutter);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ToolPose& pose = poses[i];
    if (!pose.axis.allFinite() || pose.axis.norm() < 0.5)
      pose.axis = pose.normal;
    pose.tip = input.tips.empty() ? profile.locate(pose.contact, pose.normal, pose.axis).tip : input.tips[i];
  }
  return poses;
}

Status
makeProgram(const PlaybackInput& input, const ToolPoses& poses, MachineProgram& program)
{
  MachineProgramGenerator generator;
  generator.setMachine(input.machine);
  generator.setQuiet(true);
  std::vector<ToolPoses> passes;
  for (const PassRange& pass : passRanges(passBegins(*input.path), poses.size()))
    passes.emplace_back(poses.begin() + static_cast<std::ptrdiff_t>(pass.begin), poses.begin() + static_cast<std::ptrdiff_t>(pass.end));
  generator.setInputPasses(passes);
  ProgramSettings settings;
  settings.feed = input.feed;
  settings.ball_radius = isBall(input.cutter) ? input.cutter.radius : 0.0;
  generator.setSettings(settings);
  generator.compute(program);
  return generator.getStatus();
}

/** Of a path that became a program: by the way of the contacts, pass by pass. */
std::vector<double>
reachedByWay(const PlaybackInput& input, const ToolPoses& poses, const MotionTrack& track)
{
  const std::vector<ProgramBlock>& blocks = track.program().blocks;
  const std::vector<std::size_t> begins = passBegins(*input.path);
  std::vector<double> reached;
  constexpr double rounding = 1e-9; // of the way of a pass
  std::size_t block = 0, pass = 0;
  double way = 0.0, begin = 0.0; // along the pass, and arc length where it begins
  const auto cuts = [&](std::size_t b) { return blocks[b].section == BlockSection::Cut && blocks[b].pass == pass; };
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const bool first = i == 0 || beginsPass(begins, i);
    if (i > 0 && first)
      ++pass;
    way = first ? 0.0 : way + (poses[i].contact - poses[i - 1].contact).norm();
    const auto isHere = [&] { return cuts(block) && (first || blocks[block].arc_length >= begin + way * (1.0 - rounding)); };
    while (block + 1 < blocks.size() && blocks[block + 1].pass <= pass && !isHere())
      ++block;
    const double before = block > 0 ? blocks[block - 1].arc_length : 0.0, made = blocks[block].arc_length - before;
    if (first)
      begin = before;
    const double share = made > 0.0 ? std::clamp((begin + way - before) / made, 0.0, 1.0) : 1.0;
    reached.push_back(track.secondsIn(block, first ? 0.0 : share));
  }
  return reached;
}

/** Of the points of a program that was read back: by the way of the tip in their blocks. */
std::vector<double>
reachedByLine(const PlaybackInput& input, const ToolPoses& poses, const std::vector<std::size_t>& lines, const MotionTrack& track)
{
  const std::vector<ProgramBlock>& blocks = track.program().blocks;
  std::vector<double> reached;
  std::size_t block = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    while (block + 1 < blocks.size() && lines[block] != input.lines[i])
      ++block;
    const bool last = i + 1 == poses.size() || input.lines[i + 1] != input.lines[i];
    const Eigen::Vector3d from = block > 0 ? blocks[block - 1].tip : blocks[block].tip;
    const double way = (blocks[block].tip - from).norm();
    reached.push_back(track.secondsIn(block, last || !(way > 0.0) ? 1.0 : std::min(1.0, (poses[i].tip - from).norm() / way)));
  }
  return reached;
}

/** Makes leads of the feed blocks on which no point of the path is. */
void
markLeads(const std::vector<std::size_t>& on_path, const std::vector<std::size_t>& lines, MachineProgram& program)
{
  std::size_t next = 0;
  for (std::size_t b = 0; b < program.blocks.size(); ++b) {
    while (next < on_path.size() && on_path[next] < lines[b])
      ++next;
    ProgramBlock& block = program.blocks[b];
    if (block.section == BlockSection::Cut && (next == on_path.size() || on_path[next] != lines[b]))
      block.section = BlockSection::LeadIn;
  }
}

} // namespace

Status
playbackTime(const PlaybackInput& input, PlaybackTime& time)
{
  const ToolPoses poses = posesOn(input);
  MachineProgram program;
  if (input.program) {
    program = input.program->program;
    time.lines = input.program->lines;
    if (time.lines.empty()) { // a program without text, whose blocks the judge counts
      time.lines.resize(program.blocks.size());
      std::iota(time.lines.begin(), time.lines.end(), std::size_t{1});
    }
    markLeads(input.lines, time.lines, program);
  }
  else if (const Status status = makeProgram(input, poses, program); !status.ok())
    return status;
  const std::optional<MotionTime> motion = motionTime(program, input.control, input.program ? input.program->tolerance : std::nullopt);
  if (!motion || program.blocks.empty())
    return {StatusCode::InvalidInput, "the program has no blocks, or a block without a finite place or time, so that it cannot be played"};
  time.track = MotionTrack(std::move(program), *motion, input.program && input.program->axis_arcs);
  time.reached = input.program ? reachedByLine(input, poses, time.lines, time.track) : reachedByWay(input, poses, time.track);
  for (std::size_t i = 1; i < time.reached.size(); ++i)
    time.reached[i] = std::max(time.reached[i], time.reached[i - 1]);
  return Status::success();
}

std::size_t
movesAfter(const PlaybackTime& time, double seconds)
{
  const auto next = std::upper_bound(time.reached.begin(), time.reached.end(), seconds);
  const auto points = static_cast<std::size_t>(next - time.reached.begin());
  return points > 0 ? points - 1 : 0;
}

Status
playbackStock(const PlaybackInput& input, const StockMesh& mesh, const RemovalFigures& judged, StockFalls& falls,
              const std::function<bool(double)>& progress)
{
  CutterPath path;
  std::unique_ptr<CutterSweep> sweep;
  if (const Status status = readCutterPath(input.path, path); !status.ok())
    return status;
  if (const Status status = makeSweep(path, input.cutter, input.tips, sweep); !status.ok())
    return status;
  StockFallSettings settings;
  settings.reach = judged.reach;
  settings.shallow = std::max(settings.shallow, least_shallow * judged.limit);
  falls = stockFalls(mesh, *sweep, settings, progress);
  return Status::success();
}

} // namespace pcl_spiral
