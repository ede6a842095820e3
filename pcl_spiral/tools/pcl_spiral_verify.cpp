// SPDX-License-Identifier: BSD-3-Clause
// Checks toolpath files against the raw scan or a mesh.
#include "judging/figures_table.h"
#include "judging/path_contacts.h"
#include "judging/tip_check.h"
#include "terminal/program_main.h"
#include "terminal/scan_places.h"
#include "terminal/terminal.h"
#include "terminal/vocabulary.h"
#include "verify/judged_program.h"
#include "verify/outputs.h"
#include "verify/scan_reference.h"
#include "verify/verify_job.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>

#include <pcl/console/print.h>

#include <iostream>

using namespace pcl_spiral;

namespace {

constexpr int failed = 1;

void
warn(const VerifyJob& job, const Diagnostics& warnings)
{
  if (!job.quiet)
    for (const Diagnostic& warning : warnings)
      std::cerr << "pcl_spiral_verify: warning: " << inWords(warning) << '\n';
}

/** \p reference is made from the scan if it is null and the file has no contacts. */
void
readPath(const VerifyJob& job, const JudgedPart& part, const std::string& file, const JudgedPasses& passes,
         std::shared_ptr<const ReferenceSurface>& reference, JudgedPath& judged)
{
  ToolpathFile read = readToolpath(file, scanShift());
  if (!read.has_contacts) {
    if (part.mesh)
      throw FileError(file, "holds tips and axes without contacts, and is judged by a scan: leave --mesh out, so that the vertices of the "
                            "mesh are the scan");
    if (passes.all)
      throw FileError(file, "holds tips and axes without contacts: give one region at a time");
    if (!reference)
      reference = scanReference(job, part);
    findContacts(*reference, job.settings.cutter, read);
  }
  else if (const Diagnostic warning = checkTips(read, job.settings.cutter, judged.verification); !warning.empty())
    warn(job, {Diagnostic(nameOf(judged.verification), ": ", warning)});
  if (passes.all)
    read = passes.all->of(passes.region, read);
  if (passes.all && read.path.empty())
    throw FileError(file, "no pass of the path is on this region; give the regions that the path was made for");
  *judged.path = std::move(read.path);
  judged.feed = std::move(read.feed);
  if (!isBall(job.settings.cutter))
    judged.tips = std::move(read.tips);
}

/** \p reference is the fit to the scan or the mesh, made for the first path. */
JudgedPath
judge(const VerifyJob& job, const JudgedPart& part, const std::string& file, const JudgedPasses& passes,
      std::shared_ptr<const ReferenceSurface>& reference)
{
  JudgedPath judged;
  judged.verification.path = file;
  judged.verification.region = part.region;
  if (isProgramFile(file))
    readJudgedProgram(job, part, file, passes, reference, judged);
  else
    readPath(job, part, file, passes, reference, judged);
  ProgressBar bar(job.quiet);
  JudgeSettings settings = job.settings;
  settings.mesh = part.mesh;
  settings.tips = judged.tips;
  settings.normals = part.side.normals;
  settings.view_point = part.side.view_point;
  settings.part_at = part.chosen.part_at;
  settings.clusters = job.part.clusters;
  settings.sample_spacing = job.mesh ? job.mesh->sample_spacing : 0.0;
  if (part.mesh && part.mesh->counts().closed) // only the faces that the path touches are judged
    reference.reset();
  const Status status = judgePath(
      part.cloud, judged.path, settings, [&](double share, const std::string& stage) { return bar.update(share, stage); }, reference,
      judged.verification, judged.heights);
  bar.clear();
  if (cancelled())
    throw Cancelled();
  if (!status.ok())
    throw FileError(file, status.diagnostic());
  std::optional<RawScanFigures> raw;
  if (!job.raw_scan.empty())
    raw = rawScanFigures(job.raw_scan, job.read, reference->scanned());
  const JudgedSurroundings around{part.chosen.keep_outs, part.chosen.kept_out, part.chosen.beside, part.mesh ? nullptr : part.whole};
  addVerdicts(job.limits, around, *reference, judged.path, settings, raw ? &*raw : nullptr, job.raw_scan, judged.verification);
  return judged;
}

/** Judges a path by one region. \return whether all limits hold */
bool
judgeAndShow(const VerifyJob& job, const JudgedPart& part, const std::string& file, const JudgedPasses& passes,
             std::shared_ptr<const ReferenceSurface>& reference, VerifyOutputs& outputs)
{
  const JudgedPath judged = inRegion(part.region, [&] { return judge(job, part, file, passes, reference); });
  if (!job.quiet) {
    std::cout << shiftLine();
    if (!part.mesh)
      std::cout << sideLine(part.side, judged.verification.side) << '\n';
    printFigures(inScan(judged.verification));
  }
  else
    for (const Diagnostic& broken : judged.verification.broken)
      std::cerr << "pcl_spiral_verify: " << inWords(Diagnostic(nameOf(judged.verification), ": ", broken)) << '\n';
  warn(job, warningsOf(judged.verification));
  outputs.take(part, *reference, judged);
  return judged.verification.broken.empty();
}

/** How far the tool of a program leans from the normals of the scan, degrees; \p tool does not lean, so that no place is left out. With
 *  several regions it is the lean that pcl_spiral_toolpath has by default. */
double
programLean(const VerifyJob& job, const std::string& file, const PartTool& tool)
{
  const SpiralSettings usual;
  const std::vector<JudgedPart> parts = readParts(job.scan, job.read, job.mesh, job.settings.view_point,
                                                  {job.part, job.regions, tool, job.settings.flip_normals, job.settings.threads});
  if (parts.size() > 1)
    return usual.tilt_angle + usual.axis_deviation;
  std::shared_ptr<const ReferenceSurface> reference;
  JudgedPath judged;
  readJudgedProgram(job, parts.front(), file, {}, reference, judged);
  return leanOf(*judged.path);
}

/** The tool that the points near keep-outs are left to: it leans as that of the paths. */
PartTool
judgedTool(const VerifyJob& job)
{
  PartTool tool{job.settings.cutter.radius, 0.0};
  if (job.part.keep_outs.empty())
    return tool;
  double most = 0.0;
  for (const std::string& file : job.paths)
    most = std::max(most, isProgramFile(file) ? programLean(job, file, tool) : leanOf(readToolpath(file).path));
  tool.lean = most;
  return tool;
}

/** Judges every path by every region. \return whether all limits hold */
bool
run(const VerifyJob& job)
{
  VerifyOutputs outputs(job);
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // errors are reported below, once
  const std::vector<JudgedPart> parts =
      readParts(job.scan, job.read, job.mesh, job.settings.view_point,
                {job.part, job.regions, judgedTool(job), job.settings.flip_normals, job.settings.threads});
  for (const JudgedPart& part : parts)
    warn(job, part.warnings);
  std::vector<std::shared_ptr<const ReferenceSurface>> references(parts.size());
  for (std::size_t k = 0; parts.size() > 1 && k < parts.size(); ++k)
    references[k] = inRegion(parts[k].region, [&] { return scanReference(job, parts[k]); });
  const auto passes = parts.size() > 1 ? std::make_unique<RegionPasses>(references) : nullptr;
  bool all_hold = true;
  for (const std::string& file : job.paths)
    for (std::size_t k = 0; k < parts.size(); ++k)
      all_hold = judgeAndShow(job, parts[k], file, {passes.get(), k}, references[k], outputs) && all_hold;
  outputs.finish(parts);
  return all_hold;
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("pcl_spiral_verify", argv, [&] {
    const VerifyJob job = parseVerifyCommandLine(argc, argv);
    if (job.help)
      printVerifyHelp(std::cout);
    else if (job.version)
      std::cout << "pcl_spiral_verify " PCL_SPIRAL_VERSION "\n";
    else
      return run(job) ? 0 : failed;
    return 0;
  });
}
