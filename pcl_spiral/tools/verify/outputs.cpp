// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include "judging/judged_scene.h"
#include "terminal/file_names.h"
#include "terminal/scan_places.h"
#include "terminal/terminal.h"
#include "terminal/vocabulary.h"
#include "verify/least_gouge.h"
#include "verify/scene_files.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/scene_writer.h>
#include <pcl_spiral/io/stock_writer.h>
#include <pcl_spiral/io/toolpath_writer.h>

#include <algorithm>
#include <filesystem>

using namespace pcl_spiral;

namespace {

bool
writes(const VerifyJob& job, const std::string& extension)
{
  return std::any_of(job.outputs.begin(), job.outputs.end(), [&](const std::string& output) { return extensionOf(output) == extension; });
}

} // namespace

VerifyOutputs::VerifyOutputs(const VerifyJob& job) : job_(job), files_(filesOf(job))
{
  for (const std::string& output : job.outputs)
    requireDisplay(output);
}

void
VerifyOutputs::take(const JudgedInput& input, const JudgedPart& part, const JudgedPath& judged, const FiledPath& filed)
{
  const ReferenceSurface& surface = *part.reference;
  if (const ReferenceMesh* mesh = surface.mesh()) {
    const SurfaceMesh& faces = *input.settings.mesh;
    mesh_ = JudgedMesh{faces.report(), faces.settings(), mesh->faceCount(), mesh->spacing()};
  }
  const bool report = writes(job_, ".html");
  if (report)
    addToScene(input, part, judged, filed.feed, filed.path.program);
  if (report || writes(job_, ".png")) {
    const VerificationScene scene = judgedScene(part.cloud, judged.path, input.settings, surface, judged.verification, judged.heights);
    if (report)
      pictures_.drawPath(scene.part, false);
    pictures_.drawJudging(scene);
    report_pictures_.push_back(
        pictures_.forReport({PictureKind::Spiral, PictureKind::Deviation, PictureKind::Stock, PictureKind::Histogram}));
  }
  std::size_t file = 0;
  for (const std::string& output : job_.outputs) {
    const std::string extension = extensionOf(output);
    if (extension == ".vtp")
      writeToolpath(files_.temporary(file), *judged.path, {job_.settings.cutter.radius, 0.0, judged.tips, {}, scanShift()},
                    {filed.feed, judged.heights.deviation, judged.heights.scallop});
    else if (extension == ".glb" || extension == ".gltf")
      writeScene(files_.temporary(file), cutScene(surface, judged));
    else if (extension == ".pvd")
      writeCutSeries(job_, surface, judged, filed, files_, file);
    file += filesOf(output).size();
  }
  if (!job_.stock.empty())
    append(stockMesh(surface, judged.heights.stock), left_);
  verifications_.push_back(judged.verification);
}

CutScene
VerifyOutputs::cutScene(const ReferenceSurface& surface, const JudgedPath& judged) const
{
  const RemovalReport& removal = judged.verification.removal;
  return {stockMesh(surface, judged.heights.stock), judged.path, removal.limit, leastGouge(job_.settings.chord_error, removal.fit_noise),
          scanShift()};
}

void
VerifyOutputs::addToScene(const JudgedInput& input, const JudgedPart& part, const JudgedPath& judged, const std::vector<double>& feed,
                          const std::optional<ProgramFile>& program)
{
  if (judged.verification.path != job_.paths.front())
    return;
  const bool first = !scene_;
  if (first)
    scene_ = std::make_unique<SceneBuilder>(job_.settings.cutter, std::vector<ToolSegment>());
  if (!input.settings.mesh)
    scene_->addScan(part.reference->scanned(), &judged.heights);
  else if (first)
    scene_->addFaces(*input.settings.mesh, &judged.heights);
  const ShownPath path{judged.path, judged.tips, passBegins(*judged.path), 0.0, feed, judged.heights.deviation};
  if (const auto& found = judged.verification.program; found && program && part.region.empty())
    scene_->addProgram(*program, *found, path);
  else
    scene_->addPath(path, found ? found->lines : std::vector<std::size_t>());
  scene_->addFigures(judged.verification, job_.settings.chord_error);
}

void
VerifyOutputs::finish(const Diagnostics& warnings)
try {
  VerificationRun run{
      job_.scan(), job_.read.unit, job_.settings.cutter, job_.settings.scallop_height, job_.settings.chord_error, warnings, job_.limits,
      mesh_,       scanShift(),    programWords()};
  if (scene_)
    run.scene = scene_->build();
  const std::string title = std::filesystem::path(job_.paths.front()).filename().string() + (job_.paths.size() > 1 ? " and others" : "");
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
      writeVerificationHTML(files_.temporary(i++), {title, madeBy("pcl_spiral_verify"), job_.command}, run, verifications_,
                            report_pictures_);
    else
      i += filesOf(output).size(); // written when the path was taken
  }
  for (std::size_t k = 0; k < job_.stock.size(); ++k)
    writeStock(files_.temporary(files_.size() - job_.stock.size() + k), left_, scanShift());
  files_.commit();
}
catch (const FileError& error) {
  throw FileError(Diagnostic(files_.asGiven(error.diagnostic()), "; no output has been changed"));
}
