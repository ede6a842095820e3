// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/program_planner.h>

#include "planning/program_warnings.h"
#include "planning/tool_way.h"
#include "verify/blocked_links.h"

#include <pcl_spiral/collision/impl/false_echoes.h>
#include <pcl_spiral/verify/lead_check.h>

#include <pcl/console/print.h>

#include <algorithm>
#include <utility>

namespace pcl_spiral {
namespace {

/** A check of \p scan for \p tool. */
LeadCheck<pcl::PointXYZ>
leadCheckOf(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& scan, const LedTool& tool)
{
  LeadCheck<pcl::PointXYZ> check;
  check.setInputCloud(scan);
  check.setCutter(tool.cutter);
  check.setHolder(tool.holder);
  check.setHolderClearance(tool.holder_clearance);
  check.setTolerance(tool.tolerance);
  check.setLargestEcho(largest_echo);
  check.setNumberOfThreads(tool.threads);
  check.setQuiet(true);
  return check;
}

Diagnostic
textOfCollision(const LedTool& tool, const LeadReport& figures)
{
  return Diagnostic(collisionText(tool, figures.deepest), "; ", figures.collided, " of the ", figures.moves, " moves off the path collide");
}

/** Whether \p section runs at the height of rapids. */
bool
isAbovePart(BlockSection section)
{
  return section == BlockSection::Position || section == BlockSection::Unwind;
}

/** Whether the centre of a ball at its end can stay while the axis turns; its flank may be of any length. */
bool
endsInBall(const CutterShape& cutter)
{
  return cutter.radius > 0.0 && cutter.flank_angle == 0.0 && cutter.corner_radius == cutter.radius;
}

} // namespace

void
ProgramPlanner::setInputPlan(const SpiralPlan& plan)
{
  const ToolWay way = wayOf(plan);
  planned_ = {ballPasses(*plan.path, plan.settings.tool_radius),
              plan.whole,
              way.points,
              way.mesh,
              way.remedy,
              plan.tool,
              !plan.tool.holder.empty(),
              plan.settings.tool_radius,
              plan.settings.feed,
              plan.clearBox()};
}

void
ProgramPlanner::setInputPlan(const PassPlan& plan)
{
  const ToolWay way = wayOf(plan);
  const bool cuts = plan.tool.cutter.radius > 0.0;
  planned_ = {plan.passes,
              cuts ? plan.whole : nullptr,
              way.points,
              way.mesh,
              way.remedy,
              plan.tool,
              cuts && plan.gouges_checked && (way.mesh || way.points),
              endsInBall(plan.tool.cutter) ? plan.tool.cutter.radius : 0.0,
              0.0,
              plan.clearBox()};
}

ProgramSettings
ProgramPlanner::usedSettings() const
{
  ProgramSettings settings = settings_;
  settings.ball_radius = planned_.ball_radius;
  settings.clear_box.extend(planned_.clear_box);
  if (!planned_.whole)
    settings.stay_down = 0.0;
  if (planned_.feed > 0.0)
    settings.feed = planned_.feed;
  return settings;
}

Status
ProgramPlanner::makeLinked(const std::vector<std::size_t>& retracted, MachineProgram& program)
{
  MachineProgramGenerator generator;
  generator.setMachine(machine_);
  generator.setSettings(usedSettings());
  generator.setInputPasses(planned_.passes);
  generator.setRetractedPasses(retracted);
  generator.setQuiet(true);
  generator.compute(program);
  machine_fault_ = !generator.getStatus().ok();
  return generator.getStatus();
}

/** Looks at the moves of \p program that do not cut. Where only single points off the scan's surface are in their way, or collisions are
 *  accepted, that is a warning. */
Status
ProgramPlanner::checkLeads(const MachineProgram& program)
{
  if (!check_leads_)
    return Status::success();
  if (!planned_.whole) {
    if (planned_.tool.cutter.radius > 0.0)
      warnings_.push_back("leads were not checked: the plan has no points of what stands around; let it sample its mesh ({setSampleMesh})");
    return Status::success();
  }
  LeadCheck<pcl::PointXYZ> check = leadCheckOf(planned_.whole, planned_.tool);
  check.setProgressCallback(progress_);
  check.compute(program);
  if (!check.getStatus().ok())
    return check.getStatus();
  const LeadReport &all = check.getReport(), &obstacles = check.getObstacleReport();
  if (all.collided == 0)
    return Status::success();
  if (obstacles.collided == 0)
    warnings_.push_back(textOfCollision(planned_.tool, all) + only_echoes);
  else if (planned_.tool.accepted)
    warnings_.push_back(textOfCollision(planned_.tool, obstacles));
  else
    return {StatusCode::Failed,
            Diagnostic(textOfCollision(planned_.tool, obstacles), ": lean the tool axis another way, ",
                       isAbovePart(obstacles.deepest.section) ? "raise the rapids ({ProgramSettings::rapid_height}), take "
                                                              : "take another {ProgramSettings::lead} or {ProgramSettings::lead_length}, ",
                       "a slimmer or longer tool, or {setAcceptCollisions} to write the output anyway")};
  return Status::success();
}

/** The program, with links near the surface only where they are free. */
Status
ProgramPlanner::make(MachineProgram& program)
{
  if (const Status status = makeLinked({}, program); !status.ok() || program.report.links == 0)
    return status;
  std::vector<std::size_t> blocked;
  LeadCheck<pcl::PointXYZ> check = leadCheckOf(planned_.whole, planned_.tool);
  check.setProgressCallback(progress_);
  const Status status = findBlockedLinks(std::move(check), program, 0.5 * settings_.lead_length, blocked);
  return !status.ok() || blocked.empty() ? status : makeLinked(blocked, program);
}

Status
ProgramPlanner::run(MachineProgram& program)
{
  if (const Status status = make(program); !status.ok())
    return status;
  warnings_ = programWarnings(program);
  if (!planned_.whole && settings_.stay_down > 0.0)
    warnings_.push_back("no link stays near the surface ({ProgramSettings::stay_down}): the plan has no points of what stands around");
  if (!(planned_.tool.cutter.radius > 0.0))
    return checkBeam(program);
  if (const Status status = checkLeads(program); !status.ok() || !planned_.check_holder)
    return status;
  return checkToolWay({planned_.tool, planned_.points, planned_.mesh, planned_.remedy, progress_}, program, warnings_);
}

/** The first and the last two poses of each pass decide how the tool comes and leaves. */
Status
ProgramPlanner::run(PassLinks& links)
{
  ProgramPlanner ends = *this;
  ends.setMachine(xyzacTrunnion());
  for (ToolPoses& pass : ends.planned_.passes)
    if (pass.size() > 4)
      pass.erase(pass.begin() + 2, pass.end() - 2);
  MachineProgram program;
  if (const Status status = ends.make(program); !status.ok()) {
    machine_fault_ = ends.machine_fault_;
    return status;
  }
  const Status status = ends.checkLeads(program);
  warnings_ = ends.warnings_;
  links = linksOf(program);
  return status;
}

Status
ProgramPlanner::run(std::vector<ToolMoves>& moves)
{
  moves = ledPasses(planned_.passes, usedSettings());
  return checkLeads(programOf(moves));
}

template <typename Made>
void
ProgramPlanner::computeBy(Made& made)
{
  made = Made();
  warnings_.clear();
  machine_fault_ = false;
  Made result;
  status_ = Status::unfinished();
  const bool empty = std::all_of(planned_.passes.begin(), planned_.passes.end(), [](const ToolPoses& pass) { return pass.empty(); });
  status_ = empty ? Status(StatusCode::InvalidInput, "there is no plan with a path: call {setInputPlan} with one whose status is ok")
                  : run(result);
  if (!quiet_ && !status_.ok() && status_.code() != StatusCode::Cancelled)
    PCL_ERROR("[pcl_spiral::ProgramPlanner::compute] %s\n", status_.message().c_str());
  if (status_.ok())
    made = std::move(result);
}

void
ProgramPlanner::compute(MachineProgram& program)
{
  computeBy(program);
}

void
ProgramPlanner::compute(std::vector<ToolMoves>& moves)
{
  computeBy(moves);
}

void
ProgramPlanner::compute(PassLinks& links)
{
  computeBy(links);
}

PassLinks
linksOf(const MachineProgram& program)
{
  PassLinks links;
  bool begun = false;
  for (const ProgramBlock& block : program.blocks) {
    if (block.section != BlockSection::Position)
      continue;
    links.height = begun ? std::max(links.height, block.tip.z()) : block.tip.z();
    begun = true;
  }
  return links;
}

} // namespace pcl_spiral
