// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"
#include "job_check.h"
#include "pass_scene.h"
#include "passes/pass_files.h"
#include "passes/pass_summary.h"
#include "report/picture_files.h"
#include "terminal/file_names.h"
#include "terminal/terminal.h"
#include "terminal/vocabulary.h"

#include "io/setting_names.h"
#include <pcl_spiral/io/pass_report_writer.h>

#include <cstdio>
#include <filesystem>

using namespace pcl_spiral;

namespace {

std::string
titleOf(const Job& job)
{
  return titleWithShift(std::filesystem::path(job.scan).filename().string());
}

/** Draws the passes, and the angles of a program. */
void
draw(const Job& job, const Result& result, PictureFiles& pictures)
{
  pictures.drawPasses(passScene(job, result, titleOf(job), joinedPasses(result.passes).path));
  if (result.program)
    pictures.drawProgram(titleOf(job), *result.program);
}

/** Files and options of the run; its warnings are in the result. */
RunFiles
runFiles(const Job& job)
{
  RunFiles files{job.scan, job.read.unit, job.read.origin, filesOf(job), {}, job.options};
  files.shift = scanShift();
  files.words = programWords();
  return files;
}

DriveRun
driveRun(const Job& job, const Result& result)
{
  return {{job, job.feed, result.program, result.motion}, job.drive, !job.no_gouge_check, job.largest_part, job.thinning};
}

/** \p run with the passes in 3-D. */
DriveRun
withScene(DriveRun run, const Result& result)
{
  run.scene = reportScene(result, run.feed, result.program, result.motion);
  return run;
}

} // namespace

void
writeOutputs(const Job& job, const Result& result, OutputFiles& files)
{
  PictureFiles pictures;
  const std::vector<PictureKind> kinds{PictureKind::Passes, PictureKind::Rotary};
  writeAll(job, files, [&](const std::string& output, std::size_t& next) {
    const std::string extension = extensionOf(output);
    if ((extension == ".png" || extension == ".html") && pictures.forReport(kinds).empty())
      draw(job, result, pictures);
    if (extension == ".png") {
      pictures.copy(PictureKind::Passes, files.temporary(next++));
      if (result.program)
        pictures.copy(PictureKind::Rotary, files.temporary(next++));
    }
    else if (extension == ".html")
      writeDriveReportHTML(files.temporary(next++), {titleOf(job), madeBy("pcl_spiral_drive"), job.command}, runFiles(job),
                           withScene(driveRun(job, result), result), result, pictures.forReport(kinds));
    else if (extension == ".json")
      writeDriveReportJSON(files.temporary(next++), runFiles(job), driveRun(job, result), result);
    else
      writePassFile(job, result, titleOf(job), output, files.temporary(next++));
  });
}

void
printSummary(const Job& job, const Result& result, double seconds)
{
  if (result.mesh)
    std::printf("mesh            %s: %zu faces, %zu vertices\n", job.scan.c_str(), result.mesh->faceCount(), result.mesh->vertexCount());
  else
    std::printf("scan            %s: %zu points\n%s\n", job.scan.c_str(), result.cloud->size(),
                sideLine(result.asked_side, result.side).c_str());
  if (result.drive.column)
    std::printf("column          radius %.4g to %.4g mm, covered over %.0f degrees\n", result.drive.column->least_radius,
                result.drive.column->largest_radius, result.drive.column->covered_angle);
  std::printf("drive path      %s: %zu pass%s, %zu drive points, step-over %.4g mm\n", choiceName(job.drive.kind).c_str(),
              result.passes.size(), result.passes.size() == 1 ? "" : "es", result.drive.points, result.drive.step_over);
  if (job.drive.rows == DriveRows::Kept)
    std::printf("rows            %zu that keep the scallop height, %.4g to %.4g mm apart\n", result.drive.rows, result.drive.smallest_step,
                result.drive.step_over);
  if (job.drive.link_rows)
    std::printf("links           %zu rows joined on the surface, %zu not\n", result.drive.links, result.drive.rows_apart);
  for (const PlannedRegion& region : result.regions)
    std::printf("%s: %zu pass%s, %zu locations\n", region.name.c_str(), region.passes, region.passes == 1 ? "" : "es", region.locations);
  printPasses(job, result, filesOf(job), seconds);
}
