// From a scan to toolpath files: the main program.
#include "judging/figures_table.h"
#include "judging/judge.h"
#include "program/free_leads.h"
#include "program/machine_moves.h"
#include "program/program_check.h"
#include "terminal/setter_names.h"
#include "terminal/terminal.h"
#include "toolpath/command_line.h"
#include "toolpath/console.h"
#include "toolpath/job_check.h"
#include "toolpath/outputs.h"

#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/output_files.h>
#include <pcl_spiral/toolpath/spiral_toolpath_generator.h>

#include <pcl/console/print.h>

#include <chrono>
#include <iostream>
#include <optional>

using namespace pcl_spiral;

namespace {

constexpr int failed_on_data = 1;
constexpr int bad_usage = 2;

void
warn(const Job& job, const std::vector<std::string>& warnings)
{
  if (!job.quiet)
    for (const std::string& warning : warnings)
      std::cerr << "pcl_spiral_toolpath: warning: " << warning << '\n';
}

void
require(const Job& job, const Status& status)
{
  if (status.code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (status.code() == StatusCode::InvalidArgument)
    throw UsageError(job.scan + ": " + inOptions(status.message()));
  if (!status.ok())
    throw FileError(job.scan, inOptions(status.message()));
}

/** Whether the planner's surface has all points that a path is to be judged by: none was filtered out. */
bool
judgedByTheSameSurface(const SpiralSettings& settings)
{
  return settings.thinning == 0.0 && settings.outlier_neighbours == 0;
}

/** The surface that the planner and the judge share. */
Surface::ConstPtr
surfaceOf(const Job& job, const Scan& scan, ProgressBar& bar)
{
  ScannedSurface<pcl::PointXYZ> scanned;
  scanned.setInputCloud(scan.cloud);
  if (job.settings.view_point)
    scanned.setViewPoint(*job.settings.view_point);
  scanned.setFlipNormals(job.settings.flip_normals);
  scanned.setLargestPart(job.settings.largest_part);
  scanned.setNumberOfThreads(job.settings.threads);
  scanned.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(0.25 * share, stage); });
  Surface::ConstPtr surface;
  scanned.compute(surface);
  require(job, scanned.getStatus());
  return surface;
}

Result
compute(const Job& job)
{
  ProgressBar bar(job.quiet);
  bar.update(0.0, "reading " + job.scan);
  Result result;
  std::vector<StageCost> stages;
  StageClock clock(stages);
  result.scan = readCloud(job.scan, job.read);
  result.scan.warnings = inOptions(result.scan.warnings);
  clock.end("reading");
  if (cancelled())
    throw Cancelled();
  if (job.verify && judgedByTheSameSurface(job.settings)) {
    result.surface = surfaceOf(job, result.scan, bar);
    clock.end("surface");
  }
  SpiralToolpathGenerator<pcl::PointXYZ> generator;
  generator.setInputCloud(result.scan.cloud);
  if (result.surface)
    generator.setInputSurface(result.surface);
  generator.setSettings(job.settings);
  generator.setProgressCallback(
      [&bar](double share, const std::string& stage) { return bar.update(share, stage); });
  generator.compute(*result.path);
  bar.clear();
  require(job, generator.getStatus());
  result.report = generator.getReport();
  result.report.warnings = inOptions(result.report.warnings);
  if (result.surface)
    result.report.passes += result.surface->counts().passes;
  result.report.stages.insert(result.report.stages.begin(), stages.begin(), stages.end());
  return result;
}

void
verify(const Job& job, Result& result)
{
  ProgressBar bar(job.quiet);
  const SpiralSettings& s = job.settings;
  const JudgeSettings settings{s.tool_radius, s.scallop_height, s.chord_error, s.view_point, s.flip_normals, s.threads,
                               result.surface};
  std::shared_ptr<const ReferenceSurface> reference;
  Verification verification;
  const Status status = judgePath(result.scan.cloud, result.path, settings,
                                  [&bar](double share, const std::string& stage) { return bar.update(share, stage); },
                                  reference, verification, result.heights);
  bar.clear();
  if (cancelled())
    throw Cancelled();
  if (!status.ok())
    throw FileError(job.scan, "the path was made but could not be judged: " + inOptions(status.message()));
  if (!result.surface)
    result.report.passes += reference->scanned().counts().passes;
  result.verification = std::move(verification);
}

void
layOnMachine(const Job& job, const Machine& machine, Result& result)
{
  constexpr double deviations = 5.0; // of the noise: no point stands further off the surface
  StageClock clock(result.report.stages);
  const SpiralSettings& s = job.settings;
  result.program = makeProgram(job.program, machine, s.feed, s.tool_radius, ballPasses(*result.path, s.tool_radius),
                               result.report.warnings);
  LedTool tool;
  tool.cutter = CutterShape::ball(s.tool_radius);
  tool.tolerance = s.chord_error + deviations * result.report.noise;
  tool.threads = s.threads;
  requireFreeLeads(job.scan, result.scan.cloud, tool, *result.program, job.program.accept_collisions, job.quiet,
                   result.report.warnings);
  clock.end("machine");
}

void
run(const Job& job)
{
  const auto start = std::chrono::steady_clock::now();
  checkJob(job);
  OutputFiles files(filesOf(job));
  for (const std::string& output : job.outputs)
    requireDisplay(output);
  if (!job.verbose)
    pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); // what fails is said below, once
  const std::optional<Machine> machine = hasProgram(job.program, job.outputs) ? std::optional(machineOf(job.program)) : std::nullopt;
  Result result = compute(job);
  if (machine)
    layOnMachine(job, *machine, result);
  if (job.verify)
    verify(job, result);
  warn(job, result.scan.warnings);
  warn(job, result.report.warnings);
  if (result.verification)
    warn(job, warningsOf(*result.verification));
  writeOutputs(job, result, files);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!job.quiet)
    printSummary(job, result, seconds.count());
  if (!job.quiet && result.verification)
    printFigures(*result.verification);
}

} // namespace

int
main(int argc, char** argv)
{
  catchSignals();
  try {
    const Job job = parseCommandLine(argc, argv);
    if (job.help)
      printHelp(std::cout);
    else if (job.version)
      std::cout << "pcl_spiral_toolpath " PCL_SPIRAL_VERSION "\n";
    else
      run(job);
    return 0;
  }
  catch (const UsageError& error) {
    std::cerr << "pcl_spiral_toolpath: " << error.what()
              << "\npcl_spiral_toolpath --help lists the options\n";
    return bad_usage;
  }
  catch (const std::exception& error) {
    std::cerr << "pcl_spiral_toolpath: " << inOptions(error.what()) << '\n';
    return failed_on_data;
  }
}
