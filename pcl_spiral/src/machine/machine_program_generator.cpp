// SPDX-License-Identifier: BSD-3-Clause
#include "block_times.h"
#include "half_turn.h"
#include "limit_check.h"
#include "stay_down_links.h"
#include "tiny_moves.h"
#include "tool_leads.h"
#include "turn_passes.h"

#include "choice_words.h"
#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/machine/impl/block_spacing.h>
#include <pcl_spiral/machine/machine_program_generator.h>

#include <pcl/console/print.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double held_share = 0.1; ///< of the tolerance of blocks: for linear axes that stay during a turn

/** The tool direction at the pole, fixed in the workpiece. */
Eigen::Vector3d
upOf(const Machine& machine)
{
  const Eigen::Vector3d& d = machine.rotary[0].direction;
  return std::abs(d.z()) > 0.5 ? Eigen::Vector3d(std::copysign(1.0, d.z()) * d) : Eigen::Vector3d::UnitZ();
}

/** A pass on the machine, in runs within the range of the first axis. */
struct MachinePass {
  MachineLocations path;
  std::vector<TurnPass> turns;
};

/** The direction of travel at location \p i of a pass; zero if there is none. */
Eigen::Vector3d
travelAt(const MachineLocations& path, std::size_t i, bool ahead)
{
  const std::size_t to = ahead ? std::min(i + 1, path.size() - 1) : i, from = ahead ? i : i == 0 ? 0 : i - 1;
  const Eigen::Vector3d way = path[to].pose.contact - path[from].pose.contact;
  return way.norm() > 0.0 ? Eigen::Vector3d(way.normalized()) : way;
}

bool
samePose(const ProgramBlock& a, const ProgramBlock& b)
{
  return (a.tip - b.tip).norm() < 1e-9 && std::abs(a.angles.first - b.angles.first) < 1e-12 &&
         std::abs(a.angles.second - b.angles.second) < 1e-12;
}

void
addPass(const Kinematics& kinematics, const ProgramSettings& settings, const ToolLeads& leads, const MachineLocations& path,
        const TurnPass& pass, std::size_t number, bool may_link, MachineProgram& program)
{
  std::vector<ProgramBlock>& blocks = program.blocks;
  const auto located = [&](std::size_t i) {
    MachineLocation location = path[i];
    location.angles.first += pass.shift;
    return location;
  };
  const std::size_t first =
      addEntry(kinematics, settings, leads, leads.entry(located(pass.first), travelAt(path, pass.first, true)), may_link, program);
  for (std::size_t i = pass.first + 1; i <= pass.last; ++i) {
    const MachineLocation at = located(i);
    blocks.push_back(blockTo(kinematics, at.pose.tip, at, BlockSection::Cut, false));
  }
  const std::vector<ProgramBlock> exit = leads.exit(located(pass.last), travelAt(path, pass.last, false));
  blocks.insert(blocks.end(), exit.begin(), exit.end());
  for (std::size_t i = first; i < blocks.size(); ++i)
    blocks[i].pass = number;
}

/** Angles, blocks and runs of the pass after \p before; its arc lengths and turns continue from there. */
Status
layPass(const Kinematics& kinematics, const ProgramSettings& settings, const ToolPoses& poses, const std::vector<MachinePass>& before,
        MachinePass& pass, ProgramReport& report)
{
  RotaryPath rotary;
  const double cone = settings.ball_radius > 0.0 ? settings.pole_cone * degree : 0.0; // any other tool would be tilted off its path
  if (const Status status = rotaryPath(kinematics, poses, {settings.feed, settings.ball_radius, cone}, rotary); !status.ok())
    return status;
  if (!before.empty()) {
    const MachineLocation& last = before.back().path.back();
    const double begin = rotary.locations.front().angles.first, turn = nearestTurn(begin, last.angles.first) - begin;
    for (MachineLocation& location : rotary.locations) {
      location.arc_length += last.arc_length;
      location.angles.first += turn;
    }
    for (PoleZone& zone : rotary.poles) {
      zone.begin += last.arc_length;
      zone.end += last.arc_length;
    }
  }
  const BlockTolerance block{(1.0 - held_share) * settings.block.tip, settings.block.axis};
  const MachineLocations split = splitBlocks(kinematics, rotary.branch, rotary.locations, block);
  MachineLocations().swap(rotary.locations); // as large as the path
  pass.path = thinnedBlocks(kinematics, split, settings.thinning);
  if (before.empty())
    report.branch = rotary.branch;
  report.poles.insert(report.poles.end(), rotary.poles.begin(), rotary.poles.end());
  report.split_blocks += split.size() - poses.size();
  report.thinned_poses += split.size() - pass.path.size();

  std::size_t failed = 0;
  const RotaryAxis& first = kinematics.machine().rotary[0];
  pass.turns = turnPasses(pass.path, first, failed);
  if (pass.turns.empty())
    return {StatusCode::Failed,
            Diagnostic("at ", pass.path[failed].arc_length, " {mm} of the path ", first.letter, " is at ",
                       pass.path[failed].angles.first / degree, " {degrees}, plus or minus whole turns, and would leave its limits of ",
                       first.range.lower / degree, " to ", first.range.upper / degree,
                       " {degrees}; turn the part, or use a machine with a larger range of ", first.letter)};
  return Status::success();
}

/** The block above \p at at the machine's height of the retract. */
ProgramBlock
retracted(const Kinematics& kinematics, const ProgramBlock& at, BlockSection section)
{
  ProgramBlock block = at;
  block.section = section;
  block.rapid = true;
  block.machine.z() += *kinematics.machine().retract_z - kinematics.gaugePoint(at.machine).z();
  block.tip = kinematics.tipOf(block.machine, at.angles);
  return block;
}

/** Where the machine has a height for the retract, the program begins and ends there. */
void
addRetracts(const Kinematics& kinematics, std::vector<ProgramBlock>& blocks)
{
  if (!kinematics.machine().retract_z)
    return;
  blocks.insert(blocks.begin(), retracted(kinematics, blocks.front(), BlockSection::Start));
  blocks.push_back(retracted(kinematics, blocks.back(), BlockSection::End));
}

void
reportAngles(MachineProgram& program)
{
  ProgramReport& report = program.report;
  bool begun = false;
  for (std::size_t i = 1; i < program.blocks.size(); ++i) {
    const ProgramBlock& block = program.blocks[i];
    const RotaryAngles &to = block.angles, &from = program.blocks[i - 1].angles;
    if (block.section != BlockSection::Cut)
      continue;
    report.largest_turn = std::max({report.largest_turn, std::abs(to.first - from.first), std::abs(to.second - from.second)});
    ++report.cut_blocks;
    report.first_travel += std::abs(to.first - from.first);
    const auto widen = [begun](double& lowest, double& highest, double value) {
      lowest = begun ? std::min(lowest, value) : value;
      highest = begun ? std::max(highest, value) : value;
    };
    widen(report.lowest_first, report.highest_first, to.first);
    widen(report.lowest_second, report.highest_second, to.second);
    begun = true;
  }
}

} // namespace

std::vector<Setting>
settingTable(ProgramSettings& s)
{
  const NumberRange length = NumberRange::above(0.0), none_or_more = NumberRange::from(0.0);
  return {
      Setting("lead_in", "ProgramSettings::lead", "kind of lead", "how the tool moves to the path and leaves it", "arc", s.lead),
      Setting("lead_length", "ProgramSettings::lead_length", "lead length", "length of the lead, or radius of the arc", "5", s.lead_length)
          .in("mm", length),
      Setting("clearance", "ProgramSettings::clearance", "clearance", "the feed begins at this distance from the lead, along the tool axis",
              "3", s.clearance)
          .in("mm", length),
      Setting("rapid_height", "ProgramSettings::rapid_height", "rapid height",
              "height of rapids above the highest tip, and above the scan if the part is chosen", "100", s.rapid_height)
          .in("mm", length),
      Setting(
          "stay_down", "ProgramSettings::stay_down", "largest length of links",
          "go from pass to pass near the surface, at the height of the leads, if the way is at most this long and everything in the scan "
          "is at least half of the lead length away; else the tool retracts",
          "20", s.stay_down)
          .in("mm", none_or_more)
          .zeroFor("no links"),
      Setting("plunge_feed", "ProgramSettings::plunge_feed", "plunge feed", "feed of the way down to the lead", "500", s.plunge_feed)
          .in("mm/min", none_or_more)
          .zeroFor("the feed"),
      Setting("lead_feed", "ProgramSettings::lead_feed", "lead feed", "feed of leads to the path and off it", "400", s.lead_feed)
          .in("mm/min", none_or_more)
          .zeroFor("the feed"),
      Setting("link_feed", "ProgramSettings::link_feed", "link feed", "feed of links that stay down between passes", "3000", s.link_feed)
          .in("mm/min", none_or_more)
          .zeroFor("the feed"),
      Setting("pole_cone", "ProgramSettings::pole_cone", "pole cone",
              "blends tool axes within this angle of the direction of the rotary axis, where that axis would turn too fast", "2",
              s.pole_cone)
          .in("degrees", none_or_more.below(90.0)),
  };
}

ToolPoses
ballPoses(const pcl::PointCloud<ToolpathPoint>& path, double ball_radius)
{
  ToolPoses poses;
  poses.reserve(path.size());
  for (const ToolpathPoint& point : path) {
    ToolPose pose;
    pose.contact = point.getVector3fMap().cast<double>();
    pose.normal = point.getNormalVector3fMap().cast<double>().normalized();
    pose.axis = point.getAxisVector3fMap().cast<double>().normalized();
    pose.tip = pose.contact + ball_radius * (pose.normal - pose.axis);
    poses.push_back(pose);
  }
  return poses;
}

std::vector<ToolPoses>
ballPasses(const pcl::PointCloud<ToolpathPoint>& path, double ball_radius)
{
  const ToolPoses poses = ballPoses(path, ball_radius);
  std::vector<ToolPoses> passes;
  for (const PassRange& pass : passRanges(passBegins(path), poses.size()))
    passes.emplace_back(poses.begin() + static_cast<std::ptrdiff_t>(pass.begin), poses.begin() + static_cast<std::ptrdiff_t>(pass.end));
  return passes;
}

void
MachineProgramGenerator::setInputPath(const pcl::PointCloud<ToolpathPoint>& path, double ball_radius)
{
  setInputPasses(ballPasses(path, ball_radius));
  path_radius_ = ball_radius;
}

Status
MachineProgramGenerator::check(const ProgramSettings& s) const
{
  if (const Status status = checkMachine(machine_); !status.ok())
    return status;
  if (passes_.empty())
    return {StatusCode::InvalidInput, "no path was given; call {setInputPath}, {setInputPoses} or {setInputPasses}"};
  if (settings_.ball_radius > 0.0 && s.ball_radius != settings_.ball_radius)
    return {StatusCode::InvalidArgument,
            Diagnostic("the ball radius is ", s.ball_radius, " {mm} in {setInputPath} and ", settings_.ball_radius,
                       " {mm} in {setSettings}: give the same, or 0 {mm} in {setSettings}")};
  const auto require = [](bool holds, const char* what, double value, const char* rule) {
    return holds ? Diagnostic() : Diagnostic("the ", what, " is ", value, "; ", rule);
  };
  for (const Diagnostic& fault :
       {rangeFault(s), require(s.feed > 0.0 && std::isfinite(s.feed), "feed", s.feed, "it must be above 0 {mm/min}"),
        require(s.ball_radius >= 0.0 && std::isfinite(s.ball_radius), "ball radius", s.ball_radius, "it must not be below 0 {mm}"),
        require(s.block.tip >= BlockTolerance::least_tip, "block tolerance", s.block.tip, "it must be 0.0001 {mm} or more"),
        require(s.block.axis >= BlockTolerance::least_axis, "block tolerance of the axis", s.block.axis / degree,
                "it must be 0.00006 {degrees} or more"),
        require(s.thinning.tip >= 0.0 && s.thinning.axis >= 0.0, "thinning tolerance", std::min(s.thinning.tip, s.thinning.axis),
                "it must not be below 0"),
        require(s.clear_box.isEmpty() || s.clear_box.sizes().allFinite(), "size of the box to clear", s.clear_box.sizes().maxCoeff(),
                "it must be finite")})
    if (!fault.empty())
      return {StatusCode::InvalidArgument, fault};
  return Status::success();
}

Status
MachineProgramGenerator::computeProgram(const ProgramSettings& settings, MachineProgram& program) const
{
  if (const Status status = check(settings); !status.ok())
    return status;
  const Kinematics kinematics(machine_);
  program.machine = kinematics.machine();
  program.feed = settings.feed;
  std::vector<MachinePass> passes;
  for (const ToolPoses& poses : passes_) {
    MachinePass pass;
    if (const Status status = layPass(kinematics, settings, poses, passes, pass, program.report); !status.ok())
      return passes_.size() == 1 ? status : Status(status.code(), Diagnostic("pass ", passes.size() + 1, ": ", status.diagnostic()));
    passes.push_back(std::move(pass));
  }
  const Eigen::Vector3d up = upOf(kinematics.machine());
  double top = -std::numeric_limits<double>::infinity();
  for (const MachinePass& pass : passes)
    for (const MachineLocation& location : pass.path)
      top = std::max(top, location.pose.tip.dot(up));
  for (int corner = 0; corner < 8 && !settings.clear_box.isEmpty(); ++corner)
    top = std::max(top, settings.clear_box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)).dot(up));
  const ToolLeads leads(kinematics, settings, up, top + settings.rapid_height);
  std::size_t locations = 0;
  for (const MachinePass& pass : passes)
    locations += pass.path.size();
  program.blocks.reserve(locations + locations / 8);
  for (std::size_t k = 0; k < passes.size(); ++k)
    for (const TurnPass& turn : passes[k].turns) {
      if (turn.first > 0)
        program.report.unwound_at.push_back(passes[k].path[turn.first].arc_length);
      const bool asked = settings.stay_down > 0.0 && k > 0 && turn.first == 0;
      const bool blocked = asked && std::find(retracted_.begin(), retracted_.end(), k) != retracted_.end();
      program.report.blocked_links += blocked;
      addPass(kinematics, settings, leads, passes[k].path, turn, k, asked && !blocked, program);
    }
  std::vector<MachinePass>().swap(passes); // as large as the program
  program.blocks.erase(std::unique(program.blocks.begin(), program.blocks.end(), samePose), program.blocks.end());
  addRetracts(kinematics, program.blocks);
  setBlockTimes(kinematics, settings, program);
  if (holdTinyMoves(kinematics, held_share * settings.block.tip, program.blocks))
    setBlockTimes(kinematics, settings, program);
  reportAngles(program);
  return checkLimits(kinematics, program.blocks);
}

void
MachineProgramGenerator::compute(MachineProgram& program)
{
  program = MachineProgram();
  ProgramSettings used = settings_;
  if (path_radius_)
    used.ball_radius = *path_radius_;
  status_ = computeProgram(used, program);
  if (status_.ok())
    return;
  program = MachineProgram();
  if (!quiet_)
    PCL_ERROR("[pcl_spiral::MachineProgramGenerator::compute] %s.\n", status_.message().c_str());
}

} // namespace pcl_spiral
