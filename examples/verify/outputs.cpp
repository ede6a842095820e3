#include "outputs.h"

#include "terminal/file_names.h"
#include "terminal/terminal.h"

#include <pcl_spiral/io/toolpath_writer.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace pcl_spiral;

namespace {

bool
writes(const VerifyJob& job, const std::string& extension)
{
  return std::any_of(job.outputs.begin(), job.outputs.end(),
                     [&](const std::string& output) { return extensionOf(output) == extension; });
}

/** Of the planner's report what the pictures need, from the path and the scan's surface. */
SpiralReport
reportOf(const JudgedPath& judged, const ReferenceSurface& surface, const JudgeSettings& settings)
{
  SpiralReport report;
  report.loops = surface.loops();
  for (BoundaryLoop& loop : report.loops)
    loop.indices.clear(); // of the surface's points, not of the scan's
  report.turns = static_cast<std::size_t>(std::max(1L, std::lround(judged.path->back().turn)));
  const RemovalFigures& removal = judged.verification.removal;
  const double on_plane = std::sqrt(8.0 * settings.tool_radius * settings.scallop_height);
  const double mean = removal.area > 0.0 ? removal.area / removal.path_length : on_plane;
  report.path_length = removal.path_length;
  report.smallest_step_over = report.largest_step_over = mean;
  return report;
}

VerificationScene
sceneOf(const VerifyJob& job, const Scan& scan, const ReferenceSurface& surface, const JudgedPath& judged)
{
  VerificationScene scene;
  scene.part.title = std::filesystem::path(judged.verification.path).filename().string();
  scene.part.cloud = scan.cloud;
  scene.part.path = judged.path;
  scene.part.settings.tool_radius = job.settings.tool_radius;
  scene.part.settings.scallop_height = job.settings.scallop_height;
  scene.part.settings.chord_error = job.settings.chord_error;
  scene.part.settings.view_point = job.settings.view_point;
  scene.part.settings.flip_normals = job.settings.flip_normals;
  scene.part.report = reportOf(judged, surface, job.settings);
  scene.deviation = judged.heights.deviation;
  scene.stock = judged.heights.stock;
  scene.ridges = judged.heights.ridges;
  scene.deviation_figures = judged.verification.deviation;
  scene.removal_figures = judged.verification.removal;
  return scene;
}

} // namespace

VerifyOutputs::VerifyOutputs(const VerifyJob& job) : job_(job), files_(filesOf(job))
{
  for (const std::string& output : job.outputs)
    requireDisplay(output);
}

void
VerifyOutputs::take(const Scan& scan, const ReferenceSurface& surface, const JudgedPath& judged)
{
  const bool report = writes(job_, ".html");
  if (report || writes(job_, ".png")) {
    const VerificationScene scene = sceneOf(job_, scan, surface, judged);
    if (report)
      pictures_.drawPath(scene.part, false);
    pictures_.drawJudging(scene);
    report_pictures_.push_back(pictures_.forReport(
        {PictureKind::Spiral, PictureKind::Deviation, PictureKind::Stock, PictureKind::Histogram}));
  }
  for (std::size_t i = 0; i < files_.size(); ++i)
    if (extensionOf(files_.path(i)) == ".vtp")
      writeToolpath(files_.temporary(i), *judged.path, {job_.settings.tool_radius, 0.0},
                    {judged.feed, judged.heights.deviation, judged.heights.scallop});
  verifications_.push_back(judged.verification);
}

void
VerifyOutputs::finish(const Scan& scan)
{
  const VerificationRun run{job_.scan,
                            job_.read.unit,
                            job_.settings.tool_radius,
                            job_.settings.scallop_height,
                            job_.settings.chord_error,
                            scan.warnings,
                            job_.limits};
  const std::string title = std::filesystem::path(job_.paths.front()).filename().string() +
                            (job_.paths.size() > 1 ? " and others" : "");
  std::size_t i = 0;
  for (const std::string& output : job_.outputs) {
    const std::string extension = extensionOf(output);
    if (cancelled())
      throw Cancelled();
    if (extension == ".png")
      for (const PictureName& picture : verifyPictures())
        pictures_.copy(picture.kind, files_.temporary(i++));
    else if (extension == ".json")
      writeVerificationJSON(files_.temporary(i++), run, verifications_);
    else if (extension == ".html")
      writeVerificationHTML(files_.temporary(i++), {title, madeBy("pcl_spiral_verify"), job_.command}, run,
                            verifications_, report_pictures_);
    else
      ++i; // written when the path was taken
  }
  files_.commit();
}
