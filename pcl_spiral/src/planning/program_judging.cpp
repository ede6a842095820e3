// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/impl/path_judge.h>

#include "core/angle_between.h"
#include "machine/limit_check.h"
#include "planning/region_passes.h"
#include "verify/program_pace.h"
#include "verify/program_path.h"
#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/core/impl/tolerances.h>
#include <pcl_spiral/machine/impl/tool_pose.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>
#include <pcl_spiral/verify/impl/reference_surface.h>
#include <pcl_spiral/verify/lead_check.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double share_of_reference = 0.2, share_of_reading_program = 0.3; // of the progress; the rest is for judging
constexpr double share_of_tolerance = 0.2;                     // of the chord error, that the way between the points of the path may be off
constexpr double scallops_in_air = 20.0, noises_in_air = 10.0; // a cutter higher than this above the scan does not cut

Diagnostic
textOfCollision(const LeadReport& figures, const ProgramFile& read)
{
  const LeadCollision& deepest = figures.deepest;
  const bool rapid = read.program.blocks[deepest.block].rapid;
  return Diagnostic("line ", read.lines[deepest.block], ": on this ", rapid ? "rapid move " : "feed move off the path ",
                    deepest.part == ToolPart::Cutter ? "the cutter" : "a shank as wide as the cutter", " would be ", deepest.depth,
                    " {mm} deep in the scan at ", Place(deepest.place), ", the tip at ", Place(deepest.tip), "; ", figures.collided, " of ",
                    figures.moves, " moves that do not cut collide");
}

/** The cutting way of the blocks \p own of \p program, which learns where the leads are. */
ProgramPath
pathOf(const ReferenceSurface& reference, const ProgramPathSettings& settings, const std::vector<std::size_t>& own, MachineProgram& program)
{
  MachineProgram some = program;
  some.blocks.clear();
  for (const std::size_t block : own)
    some.blocks.push_back(program.blocks[block]);
  ProgramPath path = programPath(reference, settings, some);
  for (std::size_t i = 0; i < own.size(); ++i)
    program.blocks[own[i]].section = some.blocks[i].section;
  for (std::size_t& block : path.blocks)
    block = own[block];
  return path;
}

std::vector<BlockContact>
contactsOf(const ProgramPath& path, const MachineProgram& program)
{
  std::vector<BlockContact> contacts(program.blocks.size());
  for (std::size_t i = 1; i < path.path.size(); ++i) {
    const Eigen::Vector3d before = path.path[i - 1].getNormalVector3fMap().cast<double>();
    BlockContact& contact = contacts[path.blocks[i]];
    contact.way += path.path[i].arc_length - path.path[i - 1].arc_length;
    contact.turn += angleBetween(before, path.path[i].getNormalVector3fMap().cast<double>());
  }
  return contacts;
}

/** Warns where a block seems to be missing. */
void
checkPace(const CutterShape& cutter, const ProgramFile& read, const ProgramPath& path, Diagnostics& warnings)
{
  const std::vector<HurriedBlock> hurried = hurriedBlocks(read.program, cutter.corner_radius, contactsOf(path, read.program));
  if (!hurried.empty())
    warnings.push_back(Diagnostic("line ", read.lines[hurried.front().block], ": the cutter moves ", hurried.front().times,
                                  " times as fast as on the lines before and after",
                                  hurried.size() > 1 ? Diagnostic(", and so on ", hurried.size() - 1, " other lines") : Diagnostic(),
                                  ": perhaps a block is missing before it; write the program again"));
}

/** Warnings and faults that the text of a program shows. */
void
checkText(const ProgramFile& read, ProgramFileReport& figures)
{
  if (const Status status = checkLimits(Kinematics(read.program.machine), read.program.blocks, read.lines); !status.ok()) {
    if (read.by_vectors)
      figures.warnings.push_back(Diagnostic("if the control turns the rotary axes the nearest way from home: ", status.diagnostic()));
    else
      figures.faults.push_back(status.diagnostic());
  }
  if (read.still_line > 0)
    figures.warnings.push_back(Diagnostic("line ", read.still_line,
                                          ": the tool feeds with the spindle off: no M3 or M4 is before it, unless a "
                                          "line of your shop starts it; write M3 with a speed"));
}

} // namespace

Status
PathJudge::checkOtherMoves(const ProgramFile& read, const JudgedPart& part, ProgramFileReport& figures) const
{
  LeadCheck<pcl::PointXYZ> check;
  check.setInputCloud(input_.cloud);
  check.setCutter(input_.settings.cutter);
  check.setTolerance(gougeTolerance(input_.settings.chord_error, part.reference->noise()));
  check.setLargestEcho(largest_echo);
  check.setNumberOfThreads(input_.settings.threads);
  check.setQuiet(true);
  check.setProgressCallback(withStage(partOf(input_.progress, share_of_reference, share_of_reading_program, "moves that do not cut")));
  check.compute(read.program);
  if (!check.getStatus().ok())
    return check.getStatus();
  figures.leads = check.getObstacleReport();
  if (figures.leads.collided > 0)
    figures.faults.push_back(textOfCollision(figures.leads, read));
  else if (check.getReport().collided > 0)
    figures.warnings.push_back(
        Diagnostic(textOfCollision(check.getReport(), read), ": only single points off the surface are there, usually false echoes"));
  return Status::success();
}

Status
PathJudge::readProgram(const ProgramFile& file, std::size_t region, JudgedPath& judged)
{
  if (const Status status = makeReference(region, 0.0, share_of_reference); !status.ok())
    return status;
  const JudgedPart& part = parts_[region];
  const CutterShape& cutter = input_.settings.cutter;
  ProgramFile read = file;
  if (read.lines.empty()) {
    read.lines.resize(read.program.blocks.size());
    std::iota(read.lines.begin(), read.lines.end(), std::size_t{1});
  }
  ProgramPathSettings settings;
  settings.cutter = cutter;
  settings.tolerance = share_of_tolerance * input_.settings.chord_error;
  settings.air = std::max(scallops_in_air * input_.settings.scallop_height, noises_in_air * part.reference->noise());
  settings.axis_arcs = read.axis_arcs;
  const ProgramPath path = passes_ ? pathOf(*part.reference, settings, passes_->blocksOf(region, read.program), read.program)
                                   : programPath(*part.reference, settings, read.program);
  judged.verification.program = ProgramFileReport();
  ProgramFileReport& figures = *judged.verification.program;
  figures.language = read.language;
  figures.blocks = read.program.blocks.size();
  figures.passes = path.passes;
  for (const std::size_t block : path.blocks)
    figures.lines.push_back(read.lines[block]);
  if (read.control && region == 0)
    figures.motion = studyMotion(read.program, controlModel(*read.control, read.program.machine), read.tolerance);
  checkText(read, figures);
  if (const Status status = checkOtherMoves(read, part, figures); !status.ok())
    return status;
  checkPace(cutter, read, path, figures.warnings);
  if (path.path.empty()) {
    Diagnostic all;
    for (const Diagnostic& fault : figures.faults)
      all += "; " + fault;
    return {StatusCode::InvalidInput, Diagnostic("the cutter stays more than ", settings.air,
                                                 " {mm} above the scan on all of its feed moves: check work_zero and tool_length of the "
                                                 "machine, and the zero of the scan ({ReadOptions::origin})",
                                                 all)};
  }
  *judged.path = path.path;
  if (!isBall(cutter))
    judged.tips = path.tips;
  return Status::success();
}

} // namespace pcl_spiral
