// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include "job_check.h"
#include "passes/pass_files.h"
#include "passes/pass_summary.h"
#include "report/picture_files.h"
#include "terminal/file_names.h"
#include "terminal/terminal.h"
#include "terminal/vocabulary.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/pass_report_writer.h>
#include <pcl_spiral/visualization/pass_picture.h>
#include <pcl_spiral/visualization/ridge_picture.h>

#include <cstdio>
#include <filesystem>

using namespace pcl_spiral;

namespace {

std::string
titleOf(const Job& job)
{
  return titleWithShift(std::filesystem::path(job.rail.empty() ? job.scan : job.rail).filename().string());
}

PassScene
rowScene(const Job& job, const Result& result)
{
  PassScene scene;
  scene.title = titleOf(job);
  scene.cloud = result.cloud;
  scene.mesh = result.mesh;
  scene.path = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(joinedPasses(result.passes).path);
  scene.cutter = job.cutter;
  scene.step_over = result.rows.largest_step;
  return scene;
}

/** Draws as many files as filesOf names. */
void
writePictures(const Job& job, const Result& result, const OutputFiles& files, std::size_t& next)
{
  writePasses(files.temporary(next++), rowScene(job, result));
  const RidgeScene scene{titleOf(job), result.ridge, result.rail, result.generator, result.cloud};
  writeRidgeLines(files.temporary(next++), scene);
  writeRidgeNormals(files.temporary(next++), scene);
  if (result.program)
    writeRotaryAngles(files.temporary(next++), titleOf(job), *result.program);
}

void
printRidge(const Job& job, const Result& result)
{
  const RidgeReport& r = result.ridge->report();
  const Eigen::Vector3d meeting = inScan(r.meeting_place);
  const Eigen::Vector3d worst = result.found ? inScan(result.found->largest_place) : Eigen::Vector3d();
  if (result.found)
    std::printf("scan            %s: %zu points; off the ridge by %.3g mm rms, %.3g at most at (%.1f, %.1f, %.1f); its noise is %.3g mm\n",
                job.scan.c_str(), result.cloud->size(), result.found->misfit, result.found->largest_misfit, worst.x(), worst.y(), worst.z(),
                result.found->noise);
  const auto known = [&](double error) { return result.found ? std::string() : Diagnostic(", measured to ", error, " mm").text(); };
  std::printf("rail            %zu points, %.1f mm%s%s; slope up to %.1f degrees\n", r.rail_points, r.rail_length, r.closed ? " round" : "",
              known(r.rail_error).c_str(), r.largest_slope);
  std::printf("generator       %zu points, %.2f mm%s; meets the rail at (%.1f, %.1f, %.1f), %.3g mm off\n", r.generator_points,
              r.generator_length, known(r.generator_error).c_str(), meeting.x(), meeting.y(), meeting.z(), r.meeting_distance);
  std::printf("                its chord keeps %.2f degrees; its plane is %.2f degrees off the rail's normal plane\n", r.chord_angle,
              r.tilt);
  std::printf("rows            %zu, %.4g mm apart at most, %zu points\n", result.rows.rows, result.rows.largest_step, result.rows.points);
}

/** The pictures of a page. */
void
drawPage(const Job& job, const Result& result, PictureFiles& pictures)
{
  pictures.drawPasses(rowScene(job, result));
  if (result.program)
    pictures.drawProgram(titleOf(job), *result.program);
}

void
writeReport(const Job& job, const Result& result, const std::string& output, const std::string& file)
{
  RunFiles files{job.scan, job.read.unit, job.read.origin, filesOf(job), {}, job.options};
  files.shift = scanShift();
  files.words = programWords();
  RidgeRun run{
      {job, job.feed, result.program, result.motion}, job.rail, job.generator, job.ridge, job.rows, job.through, job.half_width, job.ring};
  if (extensionOf(output) == ".json")
    return writeRidgeReportJSON(file, files, run, result, result);
  PictureFiles pictures;
  drawPage(job, result, pictures);
  run.scene = reportScene(result, job.feed, result.program, result.motion);
  writeRidgeReportHTML(file, {titleOf(job), madeBy("pcl_spiral_ridge"), job.command}, files, run, result, result,
                       pictures.forReport({PictureKind::Passes, PictureKind::Rotary}));
}

} // namespace

void
writeOutputs(const Job& job, const Result& result, OutputFiles& files)
{
  writeAll(job, files, [&](const std::string& output, std::size_t& next) {
    if (extensionOf(output) == ".png")
      writePictures(job, result, files, next);
    else if (extensionOf(output) == ".json" || extensionOf(output) == ".html")
      writeReport(job, result, output, files.temporary(next++));
    else
      writePassFile(job, result, titleOf(job), output, files.temporary(next++));
  });
}

void
printSummary(const Job& job, const Result& result, double seconds)
{
  printRidge(job, result);
  printPasses(job, result, filesOf(job), seconds);
}
