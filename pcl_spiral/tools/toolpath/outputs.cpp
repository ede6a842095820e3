// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include "job_check.h"
#include "program/machine_moves.h"
#include "program/program_check.h"
#include "reach_map.h"
#include "terminal/file_names.h"
#include "terminal/scan_places.h"
#include "terminal/terminal.h"

#include "io/report/report_writer.h"
#include "io/write/stock_files.h"
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

using namespace pcl_spiral;

namespace {

bool
hasPictures(const std::string& output)
{
  return extensionOf(output) == ".png" || extensionOf(output) == ".html";
}

void
draw(const Result& result, const std::string& title, PictureFiles& pictures)
{
  VerificationScene scene;
  scene.part = {title,
                result.heights.points ? result.heights.points : result.scan.cloud,
                result.mesh ? result.mesh->mesh : nullptr,
                result.path,
                result.settings,
                result.report};
  pictures.drawPath(scene.part, true);
  if (result.program)
    pictures.drawProgram(title, *result.program);
  if (!result.verification)
    return;
  scene.deviation = result.heights.deviation;
  scene.stock = result.heights.stock;
  scene.ridges = result.heights.ridges;
  scene.deviation_figures = result.verification->deviation;
  scene.removal_figures = result.verification->removal;
  pictures.drawJudging(scene);
}

bool
isReport(const std::string& output)
{
  return extensionOf(output) == ".json" || extensionOf(output) == ".html";
}

void
writeReport(const Job& job, const Result& result, const std::string& title, PictureFiles& pictures, const std::string& file)
{
  RunFiles run{job.scan, job.read.unit, job.read.origin, filesOf(job), result.scan.warnings, {}, job.options};
  run.shift = scanShift();
  run.warnings = inScan(run.warnings);
  if (result.mesh)
    run.mesh = RunMesh{result.mesh->counts, result.mesh->spacing};
  const std::optional<Verification> judged = result.verification ? std::optional(inScan(*result.verification)) : std::nullopt;
  const Verification* const verification = judged ? &*judged : nullptr;
  SpiralSettings settings = result.settings;
  for (std::optional<Eigen::Vector3d>* place : {&settings.centre, &settings.start_point, &settings.view_point})
    if (*place)
      *place = inScan(**place);
  const SpiralReport report = inScan(result.report);
  if (extensionOf(file) == ".json")
    writeReportJSON(file, run, settings, report, verification);
  else
    writeReportHTML(file, {title, madeBy("pcl_spiral_toolpath"), job.command}, run, settings, report,
                    pictures.forReport({PictureKind::Spiral, PictureKind::Lines, PictureKind::Rotary}), verification,
                    pictures.forReport({PictureKind::Deviation, PictureKind::Stock, PictureKind::Histogram}));
}

/** A program, CLDATA or robot frames. */
void
writeMoves(const Job& job, const Result& result, const std::string& title, const std::string& output, const std::string& file)
{
  if (extensionOf(output) == ".yaml")
    return writeRobotFrames(file, *result.path);
  if (isProgram(output))
    return writeProgramFile(job.program, *result.program, title, output, file);
  writeAPT(file, ballPoses(*result.path, job.settings.tool_radius),
           {title, ballCutter(job.settings.tool_radius), job.program.header.spindle_speed, job.settings.feed});
}

} // namespace

std::vector<std::string>
warningsOf(const Result& result)
{
  std::vector<std::string> warnings = result.scan.warnings;
  warnings.insert(warnings.end(), result.report.warnings.begin(), result.report.warnings.end());
  if (!result.verification)
    return warnings;
  const std::vector<std::string> judged = warningsOf(*result.verification);
  warnings.insert(warnings.end(), judged.begin(), judged.end());
  return warnings;
}

void
writeOutputs(const Job& job, Result& result, OutputFiles& files)
try {
  for (const std::string& output : job.outputs)
    requireOnePass(result.report.pass_begins.size() + 1, output, "leave --one-way out");
  const ToolpathMotion motion{job.settings.tool_radius, job.settings.feed, {}, result.report.pass_begins, scanShift()};
  const PathValues values{{}, result.heights.deviation, result.heights.scallop};
  const std::string title = titleWithShift(std::filesystem::path(job.scan).filename().string());
  PictureFiles pictures;
  StageClock clock(result.report.stages);
  if (std::any_of(job.outputs.begin(), job.outputs.end(), hasPictures)) {
    draw(result, title, pictures);
    clock.end("pictures");
  }
  std::vector<std::string> reports;
  std::size_t i = 0;
  for (const std::string& output : job.outputs) {
    if (cancelled())
      throw Cancelled();
    if (extensionOf(output) == ".png")
      for (const PictureName& picture : picturesOf(job))
        pictures.copy(picture.kind, files.temporary(i++));
    else if (isReport(output))
      reports.push_back(files.temporary(i++));
    else if (isProgram(output) || isExchange(output))
      writeMoves(job, result, title, output, files.temporary(i++));
    else
      writeToolpath(files.temporary(i++), *result.path, motion, values);
  }
  if (!job.reach.empty())
    writeReachMap(job, *result.surface, files.temporary(i++));
  for (std::size_t k = 0; k < job.stock.size(); ++k)
    writeStock(files.temporary(i++), result.left, scanShift());
  clock.end("writing");
  for (const std::string& report : reports) {
    if (cancelled())
      throw Cancelled();
    writeReport(job, result, title, pictures, report);
  }
  if (cancelled())
    throw Cancelled();
  files.commit();
}
catch (const FileError& error) {
  throw std::runtime_error(files.asGiven(error.what()) + "; no output has been changed");
}
