// SPDX-License-Identifier: BSD-3-Clause
// Checks toolpath files against the raw scan or a mesh.
#include "judging/figures_table.h"
#include "judging/judged_scan.h"
#include "terminal/failure.h"
#include "terminal/program_main.h"
#include "terminal/vocabulary.h"
#include "verify/outputs.h"
#include "verify/verify_job.h"

#include "planning/plan_regions.h"
#include <pcl_spiral/io/file_error.h>

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

/** Judges a path by one region, and shows the figures. \return whether all limits hold */
bool
judgeAndShow(const VerifyJob& job, const JudgedScan& scan, const std::string& file, std::size_t region, PathJudge& judge,
             VerifyOutputs& outputs)
{
  const FiledPath filed = readFiledPath(file, job);
  const JudgedPart& part = judge.parts()[region];
  JudgedPath judged;
  judged.verification.path = file;
  inRegion(part.region, [&] {
    ProgressBar bar(job.quiet);
    judge.setProgress([&bar](double share, const std::string& stage) { return bar.update(share, stage); });
    if (part.cloud)
      require(job.scan(), judge.makeReference(region));
    bar.clear();
    require(file, judge.judge(filed.path, region, judged));
  });
  if (!job.quiet) {
    std::cout << shiftLine();
    if (part.cloud)
      std::cout << sideLine(scan.side, judged.verification.side) << '\n';
    printFigures(inScan(judged.verification));
  }
  else
    for (const Diagnostic& broken : judged.verification.broken)
      std::cerr << "pcl_spiral_verify: " << inWords(Diagnostic(nameOf(judged.verification), ": ", broken)) << '\n';
  const bool alone = job.paths.size() == 1 && judge.parts().size() == 1;
  warn(job, ofRegion(alone ? std::string() : nameOf(judged.verification), warningsOf(judged.verification)));
  outputs.take(scan.input, part, judged, filed);
  return judged.verification.broken.empty();
}

/** How far the tools of the paths lean, for the points near keep-outs, which are left to them; degrees. */
double
toolLean(const VerifyJob& job, const JudgedInput& input)
{
  double most = 0.0;
  for (const std::string& file : job.part.keep_outs.empty() ? std::vector<std::string>() : job.paths) {
    double lean = 0.0;
    bool of_scan = false;
    const Status status = toolLean(input, readFiledPath(file, job).path, lean, of_scan);
    require(of_scan ? job.scan() : file, status);
    most = std::max(most, lean);
  }
  return most;
}

/** Judges every path by every region. \return whether all limits hold */
bool
run(const VerifyJob& job)
{
  VerifyOutputs outputs(job);
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // errors are reported below, once
  JudgedScan scan = readJudged(job);
  scan.input.limits = job.limits;
  if (!job.raw_scan.empty()) {
    scan.input.raw = readCloud(job.raw_scan, readAsScan(job.read)).cloud;
    scan.input.raw_name = job.raw_scan;
  }
  PathJudge judge;
  {
    ProgressBar bar(job.quiet);
    scan.input.progress = [&bar](double share, const std::string& stage) { return bar.update(share, stage); };
    require(job.scan(), judge.prepare(scan.input, toolLean(job, scan.input)));
  }
  Diagnostics warnings = scan.warnings;
  for (const JudgedPart& part : judge.parts())
    for (const Diagnostic& warning : ofRegion(part.region, part.chosen.warnings))
      warnings.push_back(warning);
  warn(job, warnings);
  bool all_hold = true;
  for (const std::string& file : job.paths)
    for (std::size_t region = 0; region < judge.parts().size(); ++region)
      all_hold = judgeAndShow(job, scan, file, region, judge, outputs) && all_hold;
  outputs.finish(warnings);
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
