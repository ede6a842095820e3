// SPDX-License-Identifier: BSD-3-Clause
#include "judged_program.h"
#include "scan_reference.h"

#include "terminal/file_names.h"
#include "terminal/terminal.h"

#include "machine/limit_check.h"
#include "verify/program_pace.h"
#include "verify/program_path.h"
#include <pcl_spiral/collision/impl/way_check.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/machine_reader.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/machine/impl/tool_pose.h>
#include <pcl_spiral/surface/scanned_surface.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>
#include <pcl_spiral/verify/lead_check.h>

#include <algorithm>

using namespace pcl_spiral;

namespace {

Diagnostic
textOfCollision(const LeadFigures& figures, const ProgramFile& read)
{
  const LeadCollision& deepest = figures.deepest;
  const bool rapid = read.program.blocks[deepest.block].rapid;
  return Diagnostic("line ", read.lines[deepest.block], ": on this ", rapid ? "rapid move " : "feed move off the path ",
                    deepest.part == ToolPart::Cutter ? "the cutter" : "a shank as wide as the cutter", " would be ", deepest.depth,
                    " mm deep in the scan at ", Place(deepest.place), ", the tip at ", Place(deepest.tip), "; ", figures.collided, " of ",
                    figures.moves, " moves that do not cut collide");
}

/** What the tool would hit where it does not cut. */
void
checkOtherMoves(const VerifyJob& job, const JudgedPart& part, const ReferenceSurface& reference, const ProgramFile& read,
                Verification& verification)
{
  ProgressBar bar(job.quiet);
  LeadCheck<pcl::PointXYZ> check;
  check.setInputCloud(part.whole);
  check.setCutter(job.settings.cutter);
  check.setTolerance(gougeTolerance(job.settings.chord_error, reference.noise()));
  check.setLargestEcho(largest_echo);
  check.setNumberOfThreads(job.settings.threads);
  check.setProgressCallback([&bar](double share, const std::string&) { return bar.update(share, "moves that do not cut"); });
  check.compute(read.program);
  bar.clear();
  if (cancelled())
    throw Cancelled();
  if (!check.getStatus().ok())
    throw FileError(job.scan, check.getStatus().diagnostic());
  ProgramFigures& program = *verification.program;
  program.leads = check.getObstacleFigures();
  if (program.leads.collided > 0)
    program.faults.push_back(textOfCollision(program.leads, read));
  else if (check.getFigures().collided > 0)
    verification.program->warnings.push_back(
        Diagnostic(textOfCollision(check.getFigures(), read), ": only single points off the surface are there, usually false echoes"));
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
checkPace(const VerifyJob& job, const ProgramFile& read, const ProgramPath& path, Verification& verification)
{
  const std::vector<HurriedBlock> hurried = hurriedBlocks(read.program, job.settings.cutter.corner_radius, contactsOf(path, read.program));
  if (!hurried.empty())
    verification.program->warnings.push_back(
        Diagnostic("line ", read.lines[hurried.front().block], ": the cutter moves ", hurried.front().times,
                   " times as fast as on the lines before and after",
                   hurried.size() > 1 ? Diagnostic(", and so on ", hurried.size() - 1, " other lines") : Diagnostic(),
                   ": perhaps a block is missing before it; write the program again"));
}

} // namespace

bool
isProgramFile(const std::string& file)
{
  const std::string extension = extensionOf(file);
  return isProgramExtension(extension) || extension == ".apt" || extension == ".cls";
}

void
readJudgedProgram(const VerifyJob& job, const JudgedPart& part, const std::string& file, const JudgedPasses& passes,
                  std::shared_ptr<const ReferenceSurface>& reference, JudgedPath& judged)
{
  const std::optional<Machine> machine = job.machine_file.empty() ? std::nullopt : std::optional(readMachine(job.machine_file));
  ProgramFile read = readProgram(file, machine, job.dialect);
  if (!reference)
    reference = scanReference(job, part);
  ProgramPathSettings settings;
  settings.cutter = job.settings.cutter;
  settings.tolerance = 0.2 * job.settings.chord_error;
  settings.air = std::max(20.0 * job.settings.scallop_height, 10.0 * reference->noise());
  settings.axis_arcs = read.axis_arcs;
  const ProgramPath path = passes.all ? pathOf(*reference, settings, passes.all->of(passes.region, read.program), read.program)
                                      : programPath(*reference, settings, read.program);
  ProgramFigures program;
  program.language = read.language;
  program.blocks = read.program.blocks.size();
  program.passes = path.passes;
  for (const std::size_t block : path.blocks)
    program.lines.push_back(read.lines[block]);
  if (const Status status = checkLimits(Kinematics(read.program.machine), read.program.blocks, read.lines); !status.ok()) {
    if (read.by_vectors)
      program.warnings.push_back(Diagnostic("if the control turns the rotary axes the nearest way from home: ", status.diagnostic()));
    else
      program.faults.push_back(status.diagnostic());
  }
  if (read.still_line > 0)
    program.warnings.push_back(Diagnostic("line ", read.still_line,
                                          ": the tool feeds with the spindle off: no M3 or M4 is before it, unless a "
                                          "line of your shop starts it; write M3 with a speed"));
  judged.verification.program = std::move(program);
  checkOtherMoves(job, part, *reference, read, judged.verification);
  checkPace(job, read, path, judged.verification);
  if (path.path.empty()) {
    Diagnostic all;
    for (const Diagnostic& fault : judged.verification.program->faults)
      all += "; " + fault;
    throw FileError(file, Diagnostic("the cutter stays more than ", settings.air,
                                     " mm above the scan on all of its feed moves: check work_zero and "
                                     "tool_length of the machine file, and --origin of the scan",
                                     all));
  }
  *judged.path = path.path;
  if (!isBall(job.settings.cutter))
    judged.tips = path.tips;
}
