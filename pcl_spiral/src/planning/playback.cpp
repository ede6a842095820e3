// SPDX-License-Identifier: BSD-3-Clause
#include "planning/playback.h"

#include "common/freed_memory.h"
#include "planning/way_times.h"
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

/** The tool at point \p i of the path; a ball without axes stands along the normals. */
ToolPose
poseOn(const PlaybackInput& input, const CutterProfile& profile, std::size_t i)
{
  const ToolpathPoint& point = (*input.path)[i];
  ToolPose pose;
  pose.contact = point.getVector3fMap().cast<double>();
  pose.normal = point.getNormalVector3fMap().cast<double>().normalized();
  pose.axis = point.getAxisVector3fMap().cast<double>().normalized();
  if (!pose.axis.allFinite() || pose.axis.norm() < 0.5)
    pose.axis = pose.normal;
  pose.tip = input.tips.empty() ? profile.locate(pose.contact, pose.normal, pose.axis).tip : input.tips[i];
  return pose;
}

Status
makeProgram(const PlaybackInput& input, MachineProgram& program)
{
  MachineProgramGenerator generator;
  generator.setMachine(input.machine);
  generator.setQuiet(true);
  const CutterProfile profile(input.cutter);
  std::vector<ToolPoses> passes;
  for (const PassRange& range : passRanges(passBegins(*input.path), input.path->size())) {
    ToolPoses pass;
    pass.reserve(range.end - range.begin);
    for (std::size_t i = range.begin; i < range.end; ++i)
      pass.push_back(poseOn(input, profile, i));
    passes.push_back(std::move(pass));
  }
  generator.setInputPasses(std::move(passes));
  ProgramSettings settings;
  settings.feed = input.feed;
  settings.ball_radius = isBall(input.cutter) ? input.cutter.radius : 0.0;
  generator.setSettings(settings);
  generator.compute(program);
  return generator.getStatus();
}

/** Of the points of a program that was read back: by the way of the tip in their blocks. */
std::vector<double>
reachedByLine(const PlaybackInput& input, const std::vector<std::size_t>& lines, const MotionTrack& track)
{
  const CutterProfile profile(input.cutter);
  const std::vector<ProgramBlock>& blocks = track.program().blocks;
  std::vector<double> reached;
  std::size_t block = 0;
  for (std::size_t i = 0; i < input.path->size(); ++i) {
    while (block + 1 < blocks.size() && lines[block] != input.lines[i])
      ++block;
    const bool last = i + 1 == input.path->size() || input.lines[i + 1] != input.lines[i];
    const Eigen::Vector3d from = block > 0 ? blocks[block - 1].tip : blocks[block].tip;
    const double way = (blocks[block].tip - from).norm();
    const double share = last || !(way > 0.0) ? 1.0 : std::min(1.0, (poseOn(input, profile, i).tip - from).norm() / way);
    const double then = track.secondsIn(block, share);
    reached.push_back(reached.empty() ? then : std::max(then, reached.back()));
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
playbackTime(PlaybackInput& input, PlaybackTime& time)
{
  MachineProgram program;
  const bool given = input.program.has_value(), axis_arcs = given && input.program->axis_arcs;
  const std::optional<double> tolerance = given ? input.program->tolerance : std::nullopt;
  if (given) {
    program = std::move(input.program->program);
    time.lines = std::move(input.program->lines);
    input.program.reset();
    if (time.lines.empty()) { // a program without text, whose blocks the judge counts
      time.lines.resize(program.blocks.size());
      std::iota(time.lines.begin(), time.lines.end(), std::size_t{1});
    }
    markLeads(input.lines, time.lines, program);
  }
  else if (const Status status = makeProgram(input, program); !status.ok())
    return status;
  const std::optional<MotionTime> motion = motionTime(program, input.control, tolerance);
  if (!motion || program.blocks.empty())
    return {StatusCode::InvalidInput, "the program has no blocks, or a block without a finite place or time, so that it cannot be played"};
  time.track = MotionTrack(std::move(program), *motion, axis_arcs);
  returnFreedMemory();
  time.reached = given ? reachedByLine(input, time.lines, time.track)
                       : timesOnWay(*input.path, passBegins(*input.path), time.track.program().blocks, time.track.ends());
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
playbackStock(const PlaybackInput& input, const StockMesh& mesh, const RemovalReport& judged, StockFalls& falls,
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
