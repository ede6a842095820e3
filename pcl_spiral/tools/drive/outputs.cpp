// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"
#include "drive_report.h"
#include "job_check.h"
#include "pass_scene.h"
#include "passes/pass_files.h"
#include "passes/pass_summary.h"
#include "terminal/file_names.h"

#include "io/setting_names.h"
#include <pcl_spiral/visualization/pass_picture.h>

#include <cstdio>
#include <filesystem>

using namespace pcl_spiral;

namespace {

std::string
titleOf(const Job& job)
{
  return titleWithShift(std::filesystem::path(job.scan).filename().string());
}

/** Draws the passes, and the angles of a program: as many files as filesOf names. */
void
writePictures(const Job& job, const Result& result, const OutputFiles& files, std::size_t& next)
{
  ToolpathMotion motion;
  writePasses(files.temporary(next++), passScene(job, result, titleOf(job), joinedPasses(job, result, motion)));
  if (result.program)
    writeRotaryAngles(files.temporary(next++), titleOf(job), *result.program);
}

void
writeOne(const Job& job, const Result& result, const std::string& output, const std::string& file)
{
  if (extensionOf(output) == ".json")
    writeDriveReport(file, job, result);
  else
    writePassFile(job, result, titleOf(job), output, file);
}

} // namespace

void
writeOutputs(const Job& job, const Result& result, OutputFiles& files)
{
  writeAll(job, result, "use a drive path of one pass (--drive helix, curve)", files, [&](const std::string& output, std::size_t& next) {
    if (extensionOf(output) == ".png")
      writePictures(job, result, files, next);
    else
      writeOne(job, result, output, files.temporary(next++));
  });
}

void
printSummary(const Job& job, const Result& result, double seconds)
{
  if (result.mesh)
    std::printf("mesh            %s: %zu faces, %zu vertices\n", job.scan.c_str(), result.mesh->faceCount(), result.mesh->vertexCount());
  else
    std::printf("scan            %s: %zu points\n%s\n", job.scan.c_str(), result.scan.cloud->size(),
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
  printPasses(job, result, filesOf(job), seconds);
}
