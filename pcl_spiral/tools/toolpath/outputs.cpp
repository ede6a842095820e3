// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include "job_check.h"
#include "program/exchange_files.h"
#include "program/machine_moves.h"
#include "program/program_check.h"
#include "terminal/file_names.h"
#include "terminal/scan_places.h"
#include "terminal/terminal.h"
#include "terminal/vocabulary.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/io/reach_map_writer.h>
#include <pcl_spiral/io/report_writer.h>
#include <pcl_spiral/io/stock_writer.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <algorithm>
#include <filesystem>

using namespace pcl_spiral;

namespace {

bool
hasPictures(const std::string& output)
{
  return extensionOf(output) == ".png" || extensionOf(output) == ".html";
}

/** The map of the largest balls as a picture of its own, or in a page. */
bool
drawsReach(const Job& job)
{
  const auto isPage = [](const std::string& output) { return extensionOf(output) == ".html"; };
  return !job.reach.empty() && (hasPictures(job.reach) || std::any_of(job.outputs.begin(), job.outputs.end(), isPage));
}

/** Warnings of the reader and of choosing the part. */
Diagnostics
readingWarnings(const Result& result)
{
  Diagnostics warnings = result.reading;
  warnings.insert(warnings.end(), result.plan.part.warnings.begin(), result.plan.part.warnings.end());
  return warnings;
}

const std::vector<PictureKind> judging_kinds{PictureKind::Deviation, PictureKind::Stock, PictureKind::Histogram};

/** The pictures of the run, and those of the check of each region. */
struct Pictures {
  PictureFiles files;
  std::vector<std::vector<ReportPicture>> of_regions;
};

/** The points of the part, and those of strips that are not cut: the surface without a path on it. */
pcl::PointCloud<pcl::PointXYZ>::ConstPtr
withStrips(const SpiralPlan& plan)
{
  if (plan.part.strips.empty())
    return plan.cloud;
  const auto all = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*plan.cloud);
  for (const UncutStrip& strip : plan.part.strips)
    for (const Eigen::Vector3f& p : strip.points)
      all->emplace_back(p.x(), p.y(), p.z());
  return all;
}

VerificationScene
sceneOf(const SpiralPlan& plan, const Judged& judged, const std::string& title)
{
  VerificationScene scene;
  scene.part = {title,
                judged.heights.points ? judged.heights.points : withStrips(plan),
                plan.mesh ? plan.mesh->mesh : nullptr,
                plan.path,
                plan.settings,
                plan.report,
                plan.regions.empty() ? plan.part.keep_outs : plan.regions.front().part.keep_outs};
  return scene;
}

void
drawJudging(const SpiralPlan& plan, const Judged& judged, const std::string& title, PictureFiles& pictures)
{
  if (!judged.verification)
    return;
  VerificationScene scene = sceneOf(plan, judged, title);
  scene.deviation = judged.heights.deviation;
  scene.stock = judged.heights.stock;
  scene.ridges = judged.heights.ridges;
  scene.deviation_figures = judged.verification->deviation;
  scene.removal_figures = judged.verification->removal;
  pictures.drawJudging(scene);
}

void
draw(const Result& result, const std::string& title, Pictures& pictures)
{
  pictures.files.drawPath(sceneOf(result.plan, result.judged, title).part, true);
  if (result.program)
    pictures.files.drawProgram(title, *result.program);
  drawJudging(result.plan, result.judged, title, pictures.files);
  for (std::size_t k = 0; k < result.regions.size(); ++k) {
    const SpiralPlan& region = result.plan.regions[k];
    drawJudging(region, result.regions[k], region.region, pictures.files);
    const bool judged = result.regions[k].verification.has_value();
    pictures.of_regions.push_back(judged ? pictures.files.forReport(judging_kinds) : std::vector<ReportPicture>());
  }
}

ReachScene
sceneOf(const Result& result, const ReachMap& map, const std::string& title)
{
  ReachScene scene;
  scene.part = sceneOf(result.plan, result.judged, title).part;
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const Eigen::Vector3d& p : map.places)
    cloud->emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
  scene.part.cloud = cloud;
  scene.radii = map.radii;
  scene.largest = map.largest;
  return scene;
}

bool
isReport(const std::string& output)
{
  return extensionOf(output) == ".json" || extensionOf(output) == ".html";
}

/** The run in 3-D. */
std::shared_ptr<const ReportScene>
sceneOf(const Result& result)
{
  std::vector<Heights> heights;
  std::vector<Verification> figures;
  const auto add = [&](const Judged& judged) {
    if (!judged.verification)
      return;
    heights.push_back(judged.heights);
    figures.push_back(*judged.verification);
  };
  if (result.regions.empty())
    add(result.judged);
  for (const Judged& region : result.regions)
    add(region);
  return reportScene(result.plan, heights, figures, result.program, result.motion);
}

void
writeReport(const Job& job, const Result& result, const std::string& title, const Pictures& pictures, const std::string& file)
{
  RunFiles files{job.scan, job.read.unit, job.read.origin, filesOf(job), readingWarnings(result), job.options};
  files.shift = scanShift();
  files.words = programWords();
  std::vector<Verification> judged;
  if (result.judged.verification)
    judged.push_back(*result.judged.verification);
  for (const Judged& region : result.regions)
    if (region.verification)
      judged.push_back(*region.verification);
  RunReport report = reportOf(result.plan, judged);
  report.motion = result.motion;
  if (extensionOf(file) == ".json")
    return writeReportJSON(file, files, report);
  report.pictures = pictures.files.forReport({PictureKind::Spiral, PictureKind::Lines, PictureKind::Rotary, PictureKind::Reach});
  report.judged = pictures.files.forReport(judging_kinds);
  for (std::size_t k = 0; k < pictures.of_regions.size(); ++k)
    report.regions[k].judged = pictures.of_regions[k];
  report.scene = sceneOf(result);
  writeReportHTML(file, {title, madeBy("pcl_spiral_toolpath"), job.command}, files, report);
}

/** A program, CLDATA or robot frames. */
void
writeMoves(const Job& job, const Result& result, const std::string& title, const std::string& output, const std::string& file)
{
  if (isProgram(output))
    return writeProgramFile(job.program, *result.program, programTexts(job.settings, title), output, file);
  writeExchange(job.program, {title, ballCutter(job.settings.tool_radius), result.moves}, result.program, output, file);
}

} // namespace

Diagnostics
warningsOf(const Result& result)
{
  Diagnostics warnings = readingWarnings(result);
  const Diagnostics& planning = result.plan.report.warnings;
  warnings.insert(warnings.end(), planning.begin(), planning.end());
  if (!result.judged.verification)
    return warnings;
  const Diagnostics judged = warningsOf(*result.judged.verification);
  warnings.insert(warnings.end(), judged.begin(), judged.end());
  return warnings;
}

void
writeOutputs(const Job& job, Result& result, OutputFiles& files)
try {
  const ToolpathMotion motion{job.settings.tool_radius, job.settings.feed, {}, result.plan.report.pass_begins, scanShift()};
  const PathValues values{{}, result.judged.heights.deviation, result.judged.heights.scallop};
  const std::string title = titleWithShift(std::filesystem::path(job.scan).filename().string());
  Pictures pictures;
  StageClock clock(result.plan.report.stages);
  const ReachMap reach = job.reach.empty() ? ReachMap() : reachMap(result.plan);
  const bool draws = std::any_of(job.outputs.begin(), job.outputs.end(), hasPictures);
  if (draws)
    draw(result, title, pictures);
  if (drawsReach(job))
    pictures.files.drawReach(sceneOf(result, reach, title));
  if (draws || drawsReach(job))
    clock.end("pictures");
  std::vector<std::string> reports;
  std::size_t i = 0;
  for (const std::string& output : job.outputs) {
    if (cancelled())
      throw Cancelled();
    if (extensionOf(output) == ".png")
      for (const PictureName& picture : picturesOf(job))
        pictures.files.copy(picture.kind, files.temporary(i++));
    else if (isReport(output))
      reports.push_back(files.temporary(i++));
    else if (isProgram(output) || isExchange(output))
      writeMoves(job, result, title, output, files.temporary(i++));
    else
      writeToolpath(files.temporary(i++), *result.plan.path, motion, values);
  }
  if (hasPictures(job.reach))
    pictures.files.copy(PictureKind::Reach, files.temporary(i++));
  else if (!job.reach.empty())
    writeReachMap(files.temporary(i++), reach, scanShift());
  for (std::size_t k = 0; k < job.stock.size(); ++k)
    writeStock(files.temporary(i++), result.judged.left, scanShift());
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
  throw FileError(Diagnostic(files.asGiven(error.diagnostic()), "; no output has been changed"));
}
