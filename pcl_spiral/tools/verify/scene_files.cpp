// SPDX-License-Identifier: BSD-3-Clause
#include "scene_files.h"

#include "planning/playback.h"
#include "terminal/scan_places.h"
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/scene_writer.h>

#include <cstdio>
#include <filesystem>

using namespace pcl_spiral;

namespace {

constexpr int moments = 25;

PlaybackInput
playedPath(const VerifyJob& job, const JudgedPath& judged, const FiledPath& filed)
{
  PlaybackInput input;
  input.path = judged.path;
  input.tips = judged.tips;
  input.cutter = job.settings.cutter;
  input.program = filed.path.program;
  input.machine = filed.path.program ? filed.path.program->program.machine : xyzacTrunnion();
  if (judged.verification.program)
    input.lines = judged.verification.program->lines;
  const std::optional<ControlKind> control = filed.path.program ? filed.path.program->control : std::nullopt;
  input.control = controlModel(control.value_or(ControlKind::LinuxCNC), input.machine);
  if (!filed.feed.empty() && filed.feed.front() > 0.0)
    input.feed = filed.feed.front();
  return input;
}

} // namespace

std::vector<std::string>
seriesFiles(const std::string& output)
{
  const std::filesystem::path path(output);
  std::vector<std::string> files{output};
  for (int i = 0; i < moments; ++i) {
    char number[16];
    std::snprintf(number, sizeof(number), "_%02d.vtp", i);
    files.push_back((path.parent_path() / (path.stem().string() + number)).string());
  }
  return files;
}

void
writeCutSeries(const VerifyJob& job, const ReferenceSurface& surface, const JudgedPath& judged, const FiledPath& filed, OutputFiles& files,
               std::size_t first)
{
  PlaybackInput input = playedPath(job, judged, filed);
  const StockMesh mesh = stockMesh(surface, judged.heights.stock);
  PlaybackTime time;
  StockFalls falls;
  Status status = playbackTime(input, time);
  if (status.ok())
    status = playbackStock(input, mesh, judged.verification.removal, falls);
  if (!status.ok())
    throw FileError(files.path(first), Diagnostic("not written: ", status.diagnostic()));
  std::vector<std::string> names;
  std::vector<double> seconds;
  for (int i = 0; i < moments; ++i) {
    const MotionFrame frame = time.track.at(time.track.seconds() * i / (moments - 1));
    CutMoment moment{frame.seconds, {}, frame.tip, frame.axis};
    for (std::size_t place = 0; place < falls.places(); ++place)
      moment.heights.push_back(falls.heightAfter(place, movesAfter(time, frame.seconds)));
    const std::size_t file = first + 1 + static_cast<std::size_t>(i);
    writeMoment(files.temporary(file), mesh, moment, shank_radii * job.settings.cutter.radius, scanShift());
    names.push_back(std::filesystem::path(files.path(file)).filename().string());
    seconds.push_back(frame.seconds);
  }
  writeSeries(files.temporary(first), names, seconds);
}
